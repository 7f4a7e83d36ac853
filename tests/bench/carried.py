#!/usr/bin/python3
"""What clicks in one frame are worth in the others: Dice of carried surfaces on sequences made of labelled volumes.

tests/bench/carried.py CLI CASES.json [--only NAMES] [--clicks 4]

CASES.json: a list of {"name", "volume", "label", "value" (0: any label)}, paths relative to the file. Of each structure named in MOTIONS
below four frames are made: the volume, and the same warped by a smooth contraction around the label and a shift, a third more in each
frame, with white noise of its own (half of the image's); the label alike. Frame 0 is grown from the clicks of a simulated user (the
deepest place of the label, then of the largest wrong part), and carried through the others, after the first click and after the last.
Needs numpy, scipy and nibabel. Docs: docs/time.md.
"""

import argparse
import json
import os
import subprocess
import tempfile

import nibabel
import numpy
from scipy import ndimage

FRAMES = 4
# Part of the radius by which the object is smaller in the last frame, and the shift there (mm along the axes of the voxels).
MOTIONS = {
    "us_echo_lv_adult_ed.1": (0.12, (2, 1, 4)),
    "mr_cine_heart_a.1": (0.12, (1, 1, 0)),
    "mr_cine_heart_a.3": (0.15, (1, 1, 0)),
    "mr_lge_left_atrium_b": (0.12, (1, 1, 1)),
    "mr_lungs_0004.1": (0.08, (0, 2, 6)),
    "mr_prostate_a": (0.03, (1, 1, 1)),
    "us_tee_aortic_root.4": (0.1, (1, 1, 1)),
    "aorta_true": (0.06, (1, 1, 1)),
    "mr_fetal_brain_stack": (0.02, (3, 2, 1)),
    "mr_sarcoma_t1_a.1": (0.06, (1, 2, 1)),
}


def voxels(path):
    image = nibabel.load(path)
    values = numpy.asarray(image.dataobj)
    return image, values[..., 0] if values.ndim > 3 else values


def spacing_of(image):
    return numpy.array(image.header.get_zooms()[:3])


def sequence(image, values, label, motion):
    """The frames, (x, y, z, t), and their labels."""
    contraction, shift = motion
    spacing, centre = spacing_of(image), numpy.array(ndimage.center_of_mass(label))
    radius = max(((numpy.argwhere(label) - centre) * spacing).std(0).max() * 2, 5)
    fine = values - ndimage.gaussian_filter(values, 1)
    noise = 0.5 * numpy.median(numpy.abs(fine[label])) / 0.6745
    index = numpy.stack(numpy.meshgrid(*map(numpy.arange, values.shape), indexing="ij"), -1).astype(numpy.float32)
    offset = (index - centre) * spacing
    near = numpy.exp(-((numpy.linalg.norm(offset, axis=-1, keepdims=True) / (2 * radius)) ** 2))
    frames, labels, random = [values], [label], numpy.random.default_rng(3)
    for k in range(1, FRAMES):
        part = k / (FRAMES - 1)
        whence = (offset / (1 - part * contraction * near) - part * numpy.array(shift) * near) / spacing + centre
        whence = numpy.moveaxis(whence, -1, 0)
        frame = ndimage.map_coordinates(values, whence, order=1, mode="nearest")
        frames.append(frame + noise * random.standard_normal(frame.shape).astype(numpy.float32) * (frame > values.min()))
        labels.append(ndimage.map_coordinates(label.astype(numpy.float32), whence, order=1) >= 0.5)
    return numpy.stack(frames, -1).astype(numpy.float32), numpy.stack(labels, -1)


def write(path, image, frames):
    out = nibabel.Nifti1Image(frames, image.affine)
    out.header.set_zooms((*spacing_of(image), 1.0))
    out.header.set_xyzt_units("mm", "sec")
    nibabel.save(out, path)


def dice(a, b):
    return 2 * numpy.count_nonzero(a & b) / max(1, numpy.count_nonzero(a) + numpy.count_nonzero(b))


def deepest(mask, image):
    """LPS millimetres."""
    depth = ndimage.distance_transform_edt(numpy.pad(mask, 1), sampling=spacing_of(image))[1:-1, 1:-1, 1:-1]
    x, y, z = (image.affine @ numpy.append(numpy.unravel_index(depth.argmax(), depth.shape), 1.0))[:3]
    return f"{-x:.4f},{-y:.4f},{z:.4f}"


def largest_wrong(got, label):
    """The largest part that is missing or too much, and whether it is missing."""
    best, size = None, 0
    for wrong, is_missing in ((label & ~got, True), (got & ~label, False)):
        parts, count = ndimage.label(wrong)
        if count == 0:
            continue
        sizes = ndimage.sum(wrong, parts, range(1, count + 1))
        if sizes.max() > size:
            best, size = (parts == 1 + int(numpy.argmax(sizes)), is_missing), sizes.max()
    return best


def grown(cli, folder, clicks, carry):
    out = os.path.join(folder, "out.nii.gz")
    command = [cli, "segment", os.path.join(folder, "frames.nii"), "--frame", "0", "-o", out, "--report", os.path.join(folder, "out.json"), "--quiet"]
    command += [f"--{'seed' if inside else 'background'}={place}" for place, inside in clicks]
    if carry:
        command += ["--frames", "all", "--frame-time", "100", "--drift-check", "none"]
    run = subprocess.run(command, capture_output=True, text=True)
    if not os.path.exists(out):
        raise SystemExit(f"{command}: exit code {run.returncode}\n{run.stderr}")
    labels = numpy.asarray(nibabel.load(out).dataobj) > 0
    os.remove(out)
    with open(os.path.join(folder, "out.json")) as report:
        results = json.load(report).get("over_time", {}).get("results", [])
    return labels if labels.ndim == 4 else labels[..., None], [f["kind"] for r in results for f in r["faults"]]


def follow(cli, name, case, root, clicks_of_user):
    """Dice per frame, after the first click and after the last."""
    image, values = voxels(os.path.join(root, case["volume"]))
    _, labels = voxels(os.path.join(root, case["label"]))
    label = labels == case["value"] if case.get("value") else labels > 0
    frames, truth = sequence(image, values.astype(numpy.float32), label, MOTIONS[name])
    told = []
    with tempfile.TemporaryDirectory() as folder:
        write(os.path.join(folder, "frames.nii"), image, frames)
        clicks = [(deepest(label, image), True)]
        for n in range(clicks_of_user):
            carry = n in (0, clicks_of_user - 1)
            got, faults = grown(cli, folder, clicks, carry)
            if carry:
                told.append([dice(got[..., t], truth[..., t]) for t in range(FRAMES)])
                print(f"{name:24s} {n + 1} clicks  Dice", *(f"{d:.3f}" for d in told[-1]), "", *faults, flush=True)
            wrong = largest_wrong(got[..., 0], label)
            if wrong:
                clicks.append((deepest(wrong[0], image), wrong[1]))
    return told


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cli")
    parser.add_argument("cases")
    parser.add_argument("--only", help="names, with commas between")
    parser.add_argument("--clicks", type=int, default=4)
    options = parser.parse_args()
    with open(options.cases) as file:
        cases = {c["name"]: c for c in json.load(file)}
    names = options.only.split(",") if options.only else [n for n in MOTIONS if n in cases]
    all_told = [follow(options.cli, n, cases[n], os.path.dirname(options.cases), options.clicks) for n in names]
    for which, title in ((0, "first click"), (-1, "last click")):
        means = numpy.mean([told[which] for told in all_told], axis=0)
        print(f"mean of {len(all_told)} after the {title}: Dice", *(f"{m:.3f}" for m in means))


if __name__ == "__main__":
    main()
