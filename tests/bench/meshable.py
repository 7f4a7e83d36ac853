#!/usr/bin/env python3
"""What share of the surfaces that are written TetGen and gmsh fill with tetrahedra, and what polishing makes of them.

    meshable.py HANDLEBODY_CLI [--volumes FOLDER] [--random N] [--first N] [--only phantoms,real,labels,fields] [--polish on|off]

All phantoms; the cases of FOLDER/cases.json that have a seed; N random label maps by `mesh` and N random fields by
`segment` (half of the N each, numbered from --first on). Every surface goes to TetGen (.off, -pYQ) and to gmsh (its bodies, cavities taken
out), each for at most five minutes. A line each, a table at the end; exit code 1 if one is not filled or not made.
Needs numpy; programs that are not installed are left out.
"""
import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time

import numpy as np

LIMIT = 300  # seconds


def run(words, folder):
    try:
        return subprocess.run(words, capture_output=True, text=True, timeout=LIMIT, cwd=folder)
    except subprocess.TimeoutExpired:
        return None


def read_obj(path):
    points, faces = [], []
    for line in open(path):
        if line.startswith("v "):
            points.append([float(x) for x in line.split()[1:4]])
        elif line.startswith("f "):
            faces.append([int(x.split("/")[0]) - 1 for x in line.split()[1:4]])
    return np.array(points), np.array(faces)


def components(points, faces):
    parent = np.arange(len(points))

    def root(v):
        while parent[v] != v:
            parent[v] = parent[parent[v]]
            v = parent[v]
        return v

    for a, b, c in faces:
        parent[root(a)] = root(b)
        parent[root(b)] = root(c)
    roots = np.array([root(f[0]) for f in faces])
    return np.unique(roots, return_inverse=True)[1]


def bodies_of(points, faces, part):
    """Components of each body, the outer one first."""
    count = part.max() + 1
    volume, low, high = np.zeros(count), [], []
    for c in range(count):
        p = points[faces[part == c]]
        o = p[0, 0]
        volume[c] = np.einsum("ij,ij->i", p[:, 0] - o, np.cross(p[:, 1] - o, p[:, 2] - o)).sum() / 6
        low.append(p.min((0, 1)))
        high.append(p.max((0, 1)))
    bodies = {c: [c] for c in range(count) if volume[c] > 0}
    for c in range(count):
        if volume[c] > 0:
            continue
        around = [b for b in bodies if volume[b] > -volume[c] and (low[b] <= low[c]).all() and (high[b] >= high[c]).all()]
        if around:
            bodies[min(around, key=lambda b: volume[b])].append(c)
    return list(bodies.values())


def fill_by_tetgen(points, faces, folder):
    with open(folder + "/s.off", "w") as f:
        f.write(f"OFF\n{len(points)} {len(faces)} 0\n")
        np.savetxt(f, points, "%.17g")
        np.savetxt(f, np.c_[np.full(len(faces), 3), faces], "%d")
    done = run(["tetgen", "-pYQ", "s.off"], folder)
    if not done or done.returncode != 0 or not os.path.exists(folder + "/s.1.ele"):
        return 0
    return int(open(folder + "/s.1.ele").readline().split()[0])


def fill_by_gmsh(points, faces, folder):
    part = components(points, faces)
    with open(folder + "/s.msh", "w") as f:
        f.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{len(points)}\n")
        for i, p in enumerate(points):
            f.write(f"{i + 1} {p[0]:.17g} {p[1]:.17g} {p[2]:.17g}\n")
        f.write(f"$EndNodes\n$Elements\n{len(faces)}\n")
        for i, (t, c) in enumerate(zip(faces, part)):
            f.write(f"{i + 1} 2 2 {c + 1} {c + 1} {t[0] + 1} {t[1] + 1} {t[2] + 1}\n")
        f.write("$EndElements\n")
    with open(folder + "/s.geo", "w") as f:
        f.write('Merge "s.msh";\n')
        for b, parts in enumerate(bodies_of(points, faces, part)):
            for c in parts:
                f.write(f"Surface Loop({c + 1}) = {{{c + 1}}};\n")
            f.write(f"Volume({b + 1}) = {{{', '.join(str(c + 1) for c in parts)}}};\n")
            f.write(f"Physical Volume({b + 1}) = {{{b + 1}}};\n")
    done = run(["gmsh", "s.geo", "-3", "-format", "msh22", "-nt", "1", "-v", "2", "-o", "filled.msh"], folder)
    if not done or done.returncode != 0 or not os.path.exists(folder + "/filled.msh"):
        return 0
    cells, inside = 0, False
    for line in open(folder + "/filled.msh"):
        words = line.split()
        inside = line.startswith("$Elements") or (inside and not line.startswith("$End"))
        cells += inside and len(words) > 2 and words[1] == "4"
    return cells


MESHERS = [(name, fill) for name, fill in (("tetgen", fill_by_tetgen), ("gmsh", fill_by_gmsh)) if shutil.which(name)]


class Tally:
    def __init__(self):
        self.groups, self.faults = {}, 0

    def add(self, group, name, polish, filled, seconds):
        self.groups.setdefault(group, []).append((polish, filled))
        self.faults += not all(filled.values())
        was, now = polish["before"], polish["after"]
        print(f"{group:9s} {name:22s} angle {was['least_angle_degrees']:5.2f} -> {now['least_angle_degrees']:5.2f}  dihedral "
              f"{was['least_dihedral_angle_degrees']:6.2f} -> {now['least_dihedral_angle_degrees']:6.2f}  bad {was['thin_faces'] + was['sharp_edges']:5d} -> "
              f"{now['thin_faces'] + now['sharp_edges']:4d}  moved {polish['farthest_mm']:.3f} of {polish['limit_mm']:.3f} mm  "
              + "  ".join(f"{m} {'yes' if n > 0 else 'NO'}" for m, n in filled.items()) + f"  {seconds:.1f} s", flush=True)

    def table(self):
        head = "".join(f" {m} |" for m, _ in MESHERS)
        print(f"| surfaces | number |{head} least angle before, after | with an angle under 15° | with a dihedral angle under 20° |")
        for group, rows in self.groups.items():
            n = len(rows)
            worst = lambda when, key: min(p[when][key] for p, _ in rows)
            under = lambda when, key: sum(p[when][key] > 0 for p, _ in rows)
            shares = "".join(f" {sum(f[m] > 0 for _, f in rows)} |" for m, _ in MESHERS)
            print(f"| {group} | {n} |{shares} {worst('before', 'least_angle_degrees'):.2g}°, {worst('after', 'least_angle_degrees'):.2g}° | "
                  f"{under('before', 'thin_faces')}, {under('after', 'thin_faces')} | "
                  f"{under('before', 'sharp_edges')}, {under('after', 'sharp_edges')} |")


def write_nrrd(path, values, spacing=(1, 1, 1)):
    kind = {"uint8": "uchar", "float32": "float"}[str(values.dtype)]
    directions = " ".join("(" + ",".join(str(spacing[i] if i == j else 0) for j in range(3)) + ")" for i in range(3))
    head = (f"NRRD0004\ntype: {kind}\ndimension: 3\nspace: left-posterior-superior\nsizes: {' '.join(map(str, values.shape))}\n"
            f"space directions: {directions}\nspace origin: (0,0,0)\nendian: little\nencoding: raw\n\n")
    with open(path, "wb") as f:
        f.write(head.encode() + values.ravel(order="F").tobytes())


def one(cli, group, name, words, tally, polish_switch):
    with tempfile.TemporaryDirectory() as folder:
        start = time.time()
        report = folder + "/report.json"
        command = [cli, *[w.replace("@", folder) for w in words], "-o", folder + "/s.obj", "--polish", polish_switch]
        command += ["--json"] if words[0] == "mesh" else ["--report", report, "--quiet"]
        done = run(command, folder)
        if not done or done.returncode not in (0, 5) or not os.path.exists(folder + "/s.obj"):
            why = "takes too long" if not done else done.stderr.strip().splitlines()[-1:] or done.returncode
            print(f"{group:9s} {name:22s} no surface: {why}", flush=True)
            tally.faults += 1
            return
        told = json.loads(done.stdout) if words[0] == "mesh" else json.load(open(report))
        if "polish" not in told:
            quality = json.loads(run([cli, "check", folder + "/s.obj", "--json"], folder).stdout)["quality"]
            same = {"least_angle_degrees": quality["angles_degrees"]["least"], "least_dihedral_angle_degrees": quality["dihedral_angles_degrees"]["least"],
                    "thin_faces": int(quality["angles_degrees"]["least"] < 15), "sharp_edges": int(quality["dihedral_angles_degrees"]["least"] < 20)}
            told["polish"] = {"before": same, "after": same, "farthest_mm": 0, "limit_mm": 0}
        points, faces = read_obj(folder + "/s.obj")
        filled = {m: fill(points, faces, folder) for m, fill in MESHERS}
        tally.add(group, name, told["polish"], filled, time.time() - start)


def phantoms(cli, tally, switch):
    text = " ".join(subprocess.run([cli, "phantom", "--help"], capture_output=True, text=True).stdout.split())
    for name in text.split("NAME TEXT REQUIRED")[1].split("Options:")[0].replace("|", " ").split():
        with tempfile.TemporaryDirectory() as folder:
            made = subprocess.run([cli, "phantom", name, "-o", folder + "/v.nrrd"], capture_output=True, text=True)
            seed = json.loads(made.stdout)["seed"]
            place = ",".join(str(x) for x in [*seed["centre"], seed["radius"]] if x is not None)
            one(cli, "phantoms", name, ["segment", folder + "/v.nrrd", "--seed", place], tally, switch)


def real(cli, tally, switch, volumes):
    for case in json.load(open(volumes + "/cases.json"))["cases"]:
        if "seed_ijk" not in case:
            continue
        seed = ",".join(str(x) for x in [*case["seed_ijk"], case["radius_voxels"]])
        words = ["segment", volumes + "/" + case["volume"], "--seed-ijk", seed, "--object", case.get("object", "auto")]
        one(cli, "real", case["name"], words, tally, switch)
        if "label" in case:
            one(cli, "real", case["name"] + " label", ["mesh", volumes + "/" + case["label"]], tally, switch)


def smoothed(noise, passes):
    for _ in range(passes):
        for axis in range(3):
            noise = (np.roll(noise, 1, axis) + 2 * noise + np.roll(noise, -1, axis)) / 4
    return noise


def labels(cli, tally, switch, numbers):
    for i in numbers:
        random = np.random.default_rng(1000 + i)
        noise = smoothed(random.normal(size=(18, 18, 18)), int(random.integers(1, 6)))
        mask = np.zeros((22, 22, 22), np.uint8)
        mask[2:-2, 2:-2, 2:-2] = noise > np.quantile(noise, random.uniform(0.6, 0.95))
        spacing = (1, 1, 1) if i % 2 == 0 else (0.7, 0.9, 2.5)
        with tempfile.TemporaryDirectory() as folder:
            write_nrrd(folder + "/v.nrrd", mask, spacing)
            one(cli, "labels", f"label map {i}", ["mesh", folder + "/v.nrrd"], tally, switch)


def fields(cli, tally, switch, numbers):
    for i in numbers:
        random = np.random.default_rng(5000 + i)
        noise = smoothed(random.normal(size=(28, 28, 28)), int(random.integers(3, 10)))
        noise = (100 * (noise - noise.mean()) / noise.std()).astype(np.float32)
        seed = np.unravel_index(np.argmax(noise[6:-6, 6:-6, 6:-6]), (16, 16, 16))
        where = ",".join(str(x + 6) for x in seed)
        spacing = (1, 1, 1) if i % 2 == 0 else (0.8, 0.8, 2)
        with tempfile.TemporaryDirectory() as folder:
            write_nrrd(folder + "/v.nrrd", noise, spacing)
            low = round(float(random.uniform(-20, 80)), 1)
            words = ["segment", folder + "/v.nrrd", "--seed-ijk", where + ",2", "--range", f"{low},inf", "--max-iterations", "60",
                     "--edge-length", str(round(float(random.uniform(1.2, 2.5)), 2))]
            one(cli, "fields", f"field {i}", words, tally, switch)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cli")
    parser.add_argument("--volumes")
    parser.add_argument("--random", type=int, default=200)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--only", default="phantoms,real,labels,fields")
    parser.add_argument("--polish", default="on", choices=["on", "off"])
    o = parser.parse_args()
    cli, tally, wanted = os.path.abspath(o.cli), Tally(), o.only.split(",")
    if not MESHERS:
        sys.exit("neither TetGen nor gmsh is installed")
    if "phantoms" in wanted:
        phantoms(cli, tally, o.polish)
    if "real" in wanted and o.volumes:
        real(cli, tally, o.polish, os.path.abspath(o.volumes))
    if "labels" in wanted:
        labels(cli, tally, o.polish, range(o.first, o.first + o.random // 2))
    if "fields" in wanted:
        fields(cli, tally, o.polish, range(o.first, o.first + o.random - o.random // 2))
    tally.table()
    return tally.faults > 0


if __name__ == "__main__":
    sys.exit(main())
