#!/usr/bin/env python3
"""Meshes of label maps: this program's beside VTK's, in one run.

    label_mesh_peers.py HANDLEBODY_CLI [LABELMAP.nii.gz:LABEL …]

Balls and tori of known surface, then the label maps named. Per mesh: does it pass the certificate, pairs of faces
that intersect, components and genus, smallest and 5 % angle (degrees), volume against that of the voxels (%), mean
and largest distance of the ideal surface (mm; of a label map: from the surface between its voxels), seconds.
Needs VTK's Python bindings and nibabel.
"""
import json
import subprocess
import sys
import tempfile
import time

import nibabel
import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy, numpy_to_vtk


def run(cli, *arguments):
    done = subprocess.run([cli, *arguments], capture_output=True, text=True)
    return done.stdout if done.returncode in (0, 1) else ""


def image_of(mask, spacing):
    image = vtk.vtkImageData()
    image.SetDimensions(*mask.shape)
    image.SetSpacing(*spacing)
    image.GetPointData().SetScalars(numpy_to_vtk(mask.astype(np.uint8).ravel(order="F"), deep=True))
    return image


def flying_edges(image):
    f = vtk.vtkFlyingEdges3D()
    f.SetInputData(image)
    f.SetValue(0, 0.5)
    f.Update()
    return f.GetOutput()


def discrete(image, smoothing):
    f = vtk.vtkDiscreteFlyingEdges3D() if smoothing else vtk.vtkDiscreteMarchingCubes()
    f.SetInputData(image)
    f.SetValue(0, 1)
    f.Update()
    if not smoothing:
        return f.GetOutput()
    s = vtk.vtkWindowedSincPolyDataFilter()  # strong enough to take the steps away
    s.SetInputData(f.GetOutput())
    s.SetNumberOfIterations(60)
    s.SetPassBand(0.01)
    s.BoundarySmoothingOff()
    s.FeatureEdgeSmoothingOff()
    s.NonManifoldSmoothingOn()
    s.NormalizeCoordinatesOn()
    s.Update()
    return s.GetOutput()


def write(poly, path):
    t = vtk.vtkTriangleFilter()
    t.SetInputData(poly)
    w = vtk.vtkXMLPolyDataWriter()
    w.SetInputConnection(t.GetOutputPort())
    w.SetFileName(path)
    w.Write()


def read(path):
    r = vtk.vtkXMLPolyDataReader()
    r.SetFileName(path)
    r.Update()
    poly = r.GetOutput()
    points = vtk_to_numpy(poly.GetPoints().GetData()).astype(float)
    return points, vtk_to_numpy(poly.GetPolys().GetData()).reshape(-1, 4)[:, 1:]


def angles(points, faces):
    p = points[faces]
    out = []
    for i in range(3):
        u, v = p[:, (i + 1) % 3] - p[:, i], p[:, (i + 2) % 3] - p[:, i]
        out.append(np.degrees(np.arctan2(np.linalg.norm(np.cross(u, v), axis=1), (u * v).sum(1))))
    return np.concatenate(out)


def distances(points, faces, ideal):
    p = points[faces]
    area = np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1)
    d = np.abs(ideal(p.mean(axis=1)))
    return (d * area).sum() / area.sum(), d.max()


def report(cli, name, path, seconds, voxels, ideal):
    check = json.loads(run(cli, "check", path, "--json"))
    points, faces = read(path)
    a = angles(points, faces)
    mean, most = distances(points, faces, ideal) if ideal else (float("nan"), float("nan"))
    ok = check["closed"] and check["manifold"] and check["oriented"] and check["self_intersections"] == 0
    genus = sum(check["genus"]) if check["genus"] else None
    print(f"  {name:32s} {'passes' if ok else 'FAILS':7s} manifold {str(check['manifold']):5s} "
          f"intersections {check['self_intersections']:5d} components {check['components']:4d} genus {genus} "
          f"faces {len(faces):7d} angles {a.min():5.1f} {np.percentile(a, 5):5.1f} "
          f"volume {100 * (check['volume_mm3'] / voxels - 1):+6.2f} % "
          f"distance {mean:.3f} {most:.3f} mm {seconds:6.2f} s", flush=True)


def compare(cli, title, mask, spacing, ideal=None):
    print(title)
    mask = np.pad(mask, 2)
    with tempfile.TemporaryDirectory() as folder:
        path, volume = folder + "/m.vtp", folder + "/v.nii.gz"
        affine = np.diag([-spacing[0], -spacing[1], spacing[2], 1.0])  # identity in LPS
        nibabel.save(nibabel.Nifti1Image(mask.astype(np.uint8), affine), volume)
        voxels = mask.sum() * np.prod(spacing)
        at = lambda p: ideal(p - 2 * np.array(spacing)) if ideal else None  # before the padding
        for name, make in (("flying edges", flying_edges), ("discrete marching cubes", lambda i: discrete(i, False)),
                           ("discrete, windowed sinc", lambda i: discrete(i, True))):
            start = time.time()
            poly = make(image_of(mask, spacing))
            seconds = time.time() - start
            write(poly, path)
            report(cli, name, path, seconds, voxels, at if ideal else None)
        start = time.time()
        out = run(cli, "mesh", volume, "-o", path, "--json")
        if out:
            report(cli, "handlebody-cli mesh", path, time.time() - start, voxels, at if ideal else None)
        else:
            print("  handlebody-cli mesh refused")


def drawn(shape, spacing, distance):
    index = np.stack(np.meshgrid(*(np.arange(n) for n in shape), indexing="ij"), -1) * np.array(spacing)
    return distance(index) < 0


def main():
    cli = sys.argv[1]

    def ball(centre, radius):
        return lambda p: np.linalg.norm(p - centre, axis=-1) - radius

    def torus(centre, around, tube):
        return lambda p: np.hypot(np.hypot(*np.moveaxis((p - centre)[..., :2], -1, 0)) - around,
                                  (p - centre)[..., 2]) - tube

    for title, shape, spacing, body in (
            ("ball of 20.3 mm, 1 mm", (46, 46, 46), (1, 1, 1), ball(np.array([22.4, 22.6, 22.3]), 20.3)),
            ("ball of 20.3 mm, 0.8 x 0.8 x 2.5 mm", (58, 58, 20), (0.8, 0.8, 2.5), ball(np.array([22.4, 22.6, 23]), 20.3)),
            ("torus of 15.2 and 5.1 mm, 1 mm", (46, 46, 16), (1, 1, 1), torus(np.array([22.4, 22.6, 7.3]), 15.2, 5.1)),
            ("torus of 12 and 1.5 mm, 1 mm", (32, 32, 8), (1, 1, 1), torus(np.array([15.4, 15.6, 3.3]), 12, 1.5))):
        compare(cli, title, drawn(shape, spacing, body), spacing, body)
    random = np.random.default_rng(1)
    compare(cli, "random voxels, 12³, half of them", random.random((12, 12, 12)) < 0.5, (1, 1, 1))
    for name in sys.argv[2:]:
        path, label = name.rsplit(":", 1)
        image = nibabel.load(path)
        values = np.asarray(image.dataobj)
        compare(cli, name.rsplit("/", 2)[-2] + " " + label, values == int(label),
                tuple(float(s) for s in image.header.get_zooms()[:3]))


main()
