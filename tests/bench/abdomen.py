#!/usr/bin/env python3
"""Five organs of a CT in one session, from clicks and corrections, in every format, and read back: the same voxels.

    abdomen.py HANDLEBODY_CLI VOLUMES [--keep FOLDER]

VOLUMES/ct_abdomen_dicom_j2k is the series. Label maps are read by nibabel (NIfTI), by the lines below (NRRD, MetaImage, 3D Slicer's
segmentation) and by pydicom and our own reader (DICOM), voxel for voxel; meshes are drawn on the grid again (`compare`: Dice 1 is every
voxel), out of 3MF's zip and out of the DICOM element too; tetrahedra must fill the volume of the surface; TetGen and gmsh, where they
are installed, must each fill every surface and all together. A line each; exit code 1 if one differs. Needs numpy, nibabel and pydicom.
"""
import argparse
import gzip
import json
import os
import re
import struct
import subprocess
import sys
import tempfile
import zipfile
import zlib
from xml.etree import ElementTree

import nibabel
import numpy as np
import pydicom

from meshable import MESHERS, read_obj

# Clicks (mm LPS), and what was corrected after a look: more of them inside, and outside.
ORGANS = {
    "liver": ["--seed", "-90.3,-127,-766.5", "--term", "liver", "--background", "52,-166,-770"],
    "spleen": ["--seed", "83.5,-98.6,-790.5", "--term", "spleen", "--background", "26.9,-60.6,-792.5"],
    "stomach": ["--seed", "37.6,-221.7,-782.5", "--seed", "52.2,-192.4,-782.5", "--seed", "47.4,-227.5,-780.5", "--seed", "22.9,-238.3,-798.5",
                "--term", "stomach"],
    "aorta": ["--seed", "7.3,-145.5,-782.5", "--term", "aorta"],
    "back muscle": ["--seed", "26.9,-60.6,-792.5", "--term", "muscle", "--background", "5,-60,-790"],
}
TOGETHER = ["label", "gltf", "nii.gz", "nii", "nrrd", "mha", "seg.nrrd", "seg.dcm", "stl", "vtp", "ply", "obj", "3mf", "stl.dcm", "msh", "vtu", "inp"]
ALONE = ["stl", "vtp", "ply", "obj", "3mf", "stl.dcm", "msh", "vtu", "inp"]


def run(cli, *words):
    done = subprocess.run([cli, *words], capture_output=True, text=True)
    if done.returncode not in (0, 5):
        sys.exit(f"{' '.join(words[:2])}: {done.stderr.strip()}")
    return done


def read_nrrd(path):
    data = open(path, "rb").read()
    head, body = data.split(b"\n\n", 1)
    fields = dict(re.split(r":=|: ", line, maxsplit=1) for line in head.decode().splitlines()[1:] if re.search(":=|: ", line) and line[0] != "#")
    if fields["encoding"] == "gzip":
        body = gzip.decompress(body)
    kind = {"uint8": "u1", "uchar": "u1", "unsigned char": "u1", "uint16": "<u2", "unsigned short": "<u2"}[fields["type"]]
    return np.frombuffer(body, kind).reshape([int(n) for n in fields["sizes"].split()], order="F"), fields


def read_mha(path):
    data = open(path, "rb").read()
    end = data.index(b"\n", data.index(b"ElementDataFile")) + 1
    fields = dict(line.split(" = ", 1) for line in data[:end].decode().splitlines())
    body = zlib.decompress(data[end:]) if fields.get("CompressedData") == "True" else data[end:]
    kind = {"MET_UCHAR": "u1", "MET_USHORT": "<u2"}[fields["ElementType"]]
    return np.frombuffer(body, kind).reshape([int(n) for n in fields["DimSize"].split()], order="F")


def read_seg(path, like, affine):
    """Segment numbers of a DICOM Segmentation on the grid of a label map, whose affine is in RAS."""
    made, out = pydicom.dcmread(path), np.zeros(like.shape, like.dtype)
    to_index = np.linalg.inv(np.diag([-1, -1, 1, 1]) @ affine)
    for pixels, item in zip(made.pixel_array.reshape(-1, made.Rows, made.Columns), made.PerFrameFunctionalGroupsSequence):
        k = to_index @ [*map(float, item.PlanePositionSequence[0].ImagePositionPatient), 1]
        assert np.allclose(k[:2], 0, atol=1e-3), "the planes lie on the grid of the series"
        out[:, :, round(k[2])][pixels.T > 0] = item.SegmentIdentificationSequence[0].ReferencedSegmentNumber
    return out


def stl_of_3mf(path, to):
    """The triangles of all of its objects."""
    root = ElementTree.fromstring(zipfile.ZipFile(path).read("3D/3dmodel.model"))
    name = lambda e: e.tag.rsplit("}")[-1]
    corners = []
    for mesh in (e for e in root.iter() if name(e) == "mesh"):
        points = np.array([[float(v.get(a)) for a in "xyz"] for v in mesh.iter() if name(v) == "vertex"])
        faces = [[int(t.get(a)) for a in ("v1", "v2", "v3")] for t in mesh.iter() if name(t) == "triangle"]
        corners.append(points[faces])
    corners = np.concatenate(corners).astype("<f4")
    record = np.zeros(len(corners), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("none", "<u2")])
    record["corners"] = corners
    open(to, "wb").write(bytes(80) + struct.pack("<I", len(corners)) + record.tobytes())


def stl_of_dicom(path, to):
    """Encapsulated Document, (0042,0011) OB."""
    data = open(path, "rb").read()
    at = data.rindex(b"\x42\x00\x11\x00OB\0\0")
    length = struct.unpack_from("<I", data, at + 8)[0]
    open(to, "wb").write(data[at + 12:at + 12 + length])


def tetrahedra(path):
    """Points and cells."""
    if path.endswith(".vtu"):
        import vtk
        from vtk.util.numpy_support import vtk_to_numpy
        reader = vtk.vtkXMLUnstructuredGridReader()
        reader.SetFileName(path)
        reader.Update()
        grid = reader.GetOutput()
        cells = [[grid.GetCell(i).GetPointId(k) for k in range(4)] for i in range(grid.GetNumberOfCells())]
        return vtk_to_numpy(grid.GetPoints().GetData()).astype(float), np.array(cells)
    points, cells, part = {}, [], ""
    for line in open(path, errors="replace"):
        if line.startswith(("$", "*")):
            part = line.strip().lower().split(",")[0] + (",c3d4" if "C3D4" in line.upper() else "")
            continue
        words = line.replace(",", " ").split()
        if part in ("$nodes", "*node") and len(words) == 4:
            points[int(words[0])] = [float(x) for x in words[1:]]
        elif part == "*element,c3d4":
            cells.append([int(x) for x in words[1:5]])
        elif part == "$elements" and len(words) > 5 and words[1] == "4":
            cells.append([int(x) for x in words[-4:]])
    index = {n: i for i, n in enumerate(points)}
    return np.array(list(points.values())), np.array([[index[n] for n in c] for c in cells])


def volume_of(points, cells):
    p = points[cells]
    return np.abs(np.einsum("ij,ij->i", p[:, 1] - p[:, 0], np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 0]))).sum() / 6


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cli")
    parser.add_argument("volumes")
    parser.add_argument("--keep")
    o = parser.parse_args()
    cli, wrong = os.path.abspath(o.cli), 0
    temporary = tempfile.TemporaryDirectory()
    folder = o.keep or temporary.name
    os.makedirs(folder, exist_ok=True)
    words = ["segment", os.path.join(o.volumes, "ct_abdomen_dicom_j2k")]
    for name, clicks in ORGANS.items():
        words += ["--object-name", name, *clicks]
    for ending in TOGETHER:
        words += ["-o", f"{folder}/all.{ending}"]
    for name in ORGANS:
        for ending in ALONE:
            words += ["-o", f"{name}={folder}/{name.replace(' ', '_')}.{ending}"]
    words += ["--report", folder + "/r.json", "--session", folder + "/s.json", "--label-description", folder + "/labels.txt", "--quiet"]
    run(cli, *words)
    objects = json.load(open(folder + "/r.json"))["objects"]
    meant = np.asarray(nibabel.load(folder + "/all.nii.gz").dataobj)

    def tell(what, same):
        nonlocal wrong
        wrong += not same
        print(f"{what:28s} {'the same' if same else 'DIFFERS'}", flush=True)

    slicer, keys = read_nrrd(folder + "/all.seg.nrrd")
    for name, voxels in (("nii", np.asarray(nibabel.load(folder + "/all.nii").dataobj)), ("nrrd", read_nrrd(folder + "/all.nrrd")[0]),
                         ("mha", read_mha(folder + "/all.mha")), ("seg.nrrd", slicer)):
        tell(f"all.{name}", voxels.shape == meant.shape and (voxels == meant).all())
    named = {int(keys[f"Segment{i}_LabelValue"]): keys[f"Segment{i}_Name"] for i in range(len(objects))}
    numbers = read_seg(folder + "/all.seg.dcm", meant, nibabel.load(folder + "/all.nii.gz").affine)
    values = np.array([0, *(r["label_value"] for r in objects)])
    tell("all.seg.dcm by pydicom", (values[numbers] == meant).all())
    described = re.findall(r'^ *(\d+) .*"(.*)"$', open(folder + "/all.label").read(), re.M)
    tell("names in all.label", {int(n): name for n, name in described} == {0: "Clear Label", **{r["label_value"]: r["name"] for r in objects}})
    scene = json.load(open(folder + "/all.gltf"))
    tell("names in all.gltf", {r["name"] for r in objects} <= {part.get("name") for key in ("nodes", "meshes") for part in scene.get(key, [])})
    tell("names in all.seg.nrrd", named == {r["label_value"]: r["name"] for r in objects})

    def compared(path, label, to=None):
        more = [] if to is None else ["--label-a", str(to)]
        found = json.loads(run(cli, "compare", path, folder + "/all.nii.gz", "--label-b", str(label), *more, "--json").stdout)
        return found["overlap"]["a_mm3"] == found["overlap"]["b_mm3"] == found["overlap"]["both_mm3"]

    def tell_filled(name, stem, volume):
        for ending in (".msh", ".vtu", ".inp"):
            tell(f"{name}{ending}", abs(volume_of(*tetrahedra(stem + ending)) - volume) < 1e-4 * volume)
        for mesher, fill in MESHERS:
            tell(f"{name} filled by {mesher}", fill(*read_obj(stem + ".obj"), folder) > 0)

    for i, r in enumerate(objects):
        name, stem = r["name"], f"{folder}/{r['name'].replace(' ', '_')}"
        tell(f"{name}: voxels", (meant == r["label_value"]).any())
        tell(f"{name} in all.seg.dcm", compared(folder + "/all.seg.dcm", r["label_value"], i + 1))
        stl_of_3mf(stem + ".3mf", stem + "_3mf.stl")
        stl_of_dicom(stem + ".stl.dcm", stem + "_dcm.stl")
        for ending in (".stl", ".vtp", ".ply", ".obj", "_3mf.stl", "_dcm.stl"):
            tell(f"{name}{ending}", compared(stem + ending, r["label_value"]))
        tell_filled(name, stem, r["mesh"]["volume_mm3"])
    # All of them in one file: what any of them holds.
    stl_of_3mf(folder + "/all.3mf", folder + "/all_3mf.stl")
    stl_of_dicom(folder + "/all.stl.dcm", folder + "/all_dcm.stl")
    for ending in (".stl", ".vtp", ".ply", ".obj", "_3mf.stl", "_dcm.stl"):
        found = json.loads(run(cli, "compare", folder + "/all" + ending, folder + "/all.nii.gz", "--json").stdout)
        tell(f"all{ending}", found["dice"] == 1)
    tell_filled("all", folder + "/all", sum(r["mesh"]["volume_mm3"] for r in objects))
    run(cli, "replay", folder + "/s.json", "-o", folder + "/again.seg.nrrd", "--quiet")
    tell("replayed", open(folder + "/again.seg.nrrd", "rb").read() == open(folder + "/all.seg.nrrd", "rb").read())
    print(f"{wrong} differ")
    return wrong > 0


sys.exit(main())
