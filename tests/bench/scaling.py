#!/usr/bin/python3
"""How the whole job of `handlebody-cli segment` grows: with voxels, vertices, threads and the number of fronts.

    tests/bench/scaling.py build/release/app/handlebody-cli [--repeat 3] [--limit 1800] [--json F] [--plot F.svg]

Makes phantoms (cubes of 100 mm), segments them, each run a process of its own, and prints tables in Markdown, with exponents
fitted by least squares to the logarithms:

    voxels    every --phantom at every one of --sizes (voxels along an edge); edges of the mesh as long as by default
    vertices  the last phantom at --size, target edge length from 4 voxels down to 1
    threads   the same with edges of 2 voxels, on 1 to as many threads as there are processors
    fronts    the same, grown from 1, 2, 4, 8 and 16 balls apart from each other

Where it is not said there is one thread, and, where it is not beyond doubt what the click means, another one. Seconds are of the
process from start to end, the least (and most) of the runs, which take turns, without the listing of tunnels for the report.
Memory is the most of the runs. A run longer than --limit seconds is ended and told as such. Exit code 1 if a run fails or is
ended, a mesh has no certificate or the wrong topology, runs that must give the same mesh do not, or fewer fronts start than were
asked for; fits leave these out. --quick is to show that all works; its figures mean nothing. --plot needs python3-matplotlib.
"""
import argparse
import hashlib
import importlib.util
import json
import math
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time

EXTENT = 100  # mm, of the phantoms
SWEEPS = ["voxels", "vertices", "threads", "fronts"]
MEASURES = {"seconds": "whole job, s", "evolve": "of it evolution, s", "megabytes": "peak memory, MB"}


def run(words, limit, log):
    """One process: exit code, seconds, seconds of processor, peak memory in MB, and in words how it ended."""
    start = time.perf_counter()
    with open(log, "w") as out:
        process = subprocess.Popen(words, stdout=out, stderr=subprocess.STDOUT)
    timer = threading.Timer(limit, os.kill, (process.pid, signal.SIGKILL))
    timer.start()
    _, status, usage = os.wait4(process.pid, 0)
    timer.cancel()
    seconds, process.returncode = time.perf_counter() - start, os.waitstatus_to_exitcode(status)
    is_ended = seconds >= limit and process.returncode == -signal.SIGKILL
    words = f"exit code {process.returncode}: " + (open(log).read().strip().splitlines() or ["without a word"])[-1]
    return {"code": process.returncode, "seconds": seconds, "words": f"ENDED at the limit of {limit:g} s" if is_ended else words,
            "processor": usage.ru_utime + usage.ru_stime, "megabytes": usage.ru_maxrss / 1024}


def phantom(o, folder, name, size):
    """Its seed and topology and the paths of its files; each is made once."""
    base = f"{folder}/{name}{size}"
    if not os.path.exists(base + ".json"):
        done = run([o.cli, "phantom", name, "--size", f"{size},{size},{size}", "--spacing", ",".join([repr(EXTENT / size)] * 3),
                    "-o", base + ".nii", "--truth", base + "_truth.nii"], o.limit, base + ".json")
        done["code"] == 0 or sys.exit(f"No phantom {name} of {size}³ voxels: {done['words']}")
    return {**json.load(open(base + ".json")), "path": base + ".nii", "truth": base + "_truth.nii"}


def roomy_places(path, size, radius):
    """Voxels of an uncompressed NIfTI label map around which a ball (radius in voxels) fits into the object."""
    label = open(path, "rb").read()[-size ** 3:]
    around = [(x, y, z) for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)]
    ball = {tuple(round(radius * c / max(1, math.hypot(*d))) for c in d) for d in around}
    grid = range(math.ceil(radius), size - math.ceil(radius), max(1, size // 40))
    return [(x, y, z) for z in grid for y in grid for x in grid
            if all(label[x + a + size * (y + b + size * (z + c))] for a, b, c in ball)]


def balls(volume, size, count):
    """Places for seeds (voxels, with radius): the one nearest to the middle, then always the one farthest from those before."""
    radius = 0.6 * volume["seed"]["radius"] * size / EXTENT
    places = roomy_places(volume["truth"], size, radius) or sys.exit(
        f"No place for a ball of {radius:.1f} voxels radius in {volume['name']} of {size}³ voxels.")
    chosen = [min(places, key=lambda p: math.dist(p, [size / 2] * 3))]
    while len(chosen) < count:
        chosen.append(max(places, key=lambda p: min(math.dist(p, c) for c in chosen)))
    return [(*p, radius) for p in chosen]


def point(volume, size, threads=1, edge=None, seeds=None):
    """What is run: its words for the command line, and what to expect of it; edge in voxels."""
    centre = volume["seed"]["centre"] + [volume["seed"]["radius"]]
    start = [["--seed-ijk", ",".join(map(str, s))] for s in seeds or []] or [["--seed", ",".join(map(str, centre))]]
    words = [volume["path"], *sum(start, []), "--threads", str(threads)]
    edge_mm = edge and edge * EXTENT / size
    return {"phantom": volume["name"], "size": size, "voxels": size ** 3, "threads": threads, "edge_mm": edge_mm, "fronts": len(start),
            "genus": sorted(volume["genus"]), "runs": [], "problem": "", "words": words + ["--edge-length", repr(edge_mm)] * bool(edge)}


def points_of(sweep, o, folder):
    if sweep == "voxels":
        return [point(phantom(o, folder, name, s), s) for name in o.phantom for s in o.sizes]
    volume = phantom(o, folder, o.phantom[-1], o.size)
    if sweep == "vertices":
        return [point(volume, o.size, edge=e) for e in o.edges]
    if sweep == "threads":
        most = os.cpu_count() or 1
        return [point(volume, o.size, threads=t, edge=2) for t in range(1, most + 1) if t <= 8 or t == most or t & (t - 1) == 0]
    seeds = balls(volume, o.size, max(o.fronts))
    return [point(volume, o.size, edge=2, seeds=seeds[:n]) for n in o.fronts]


def fault(p, report):
    """What is wrong with a run that ended well, or nothing."""
    mesh, topology = report["mesh"], sorted(report["mesh"]["genus"])
    faults = {"no certificate": not (mesh["closed"] and mesh["manifold"] and mesh["oriented"])
              or mesh["self_intersections"] + mesh["misplaced_components"] > 0,
              f"WRONG TOPOLOGY: genus {topology}, not {p['genus']}": topology != p["genus"],
              "stopped: " + report["stopped"]: report["stopped"] != "converged",
              f"started from {len(report['seeds'])} fronts": len(report["seeds"]) != p["fronts"],
              "runs give different meshes": len({r["mesh"] for r in p["runs"]}) > 1}
    return next((what for what, is_so in faults.items() if is_so), "")


def measure(p, folder, o):
    """One run more of a point; its first mesh is checked by a process of its own, too."""
    mesh, log, told = folder + "/mesh.ply", folder + "/log.txt", folder + "/report.json"
    done = run([o.cli, "segment", *p["words"], "-o", mesh, "--report", told, "--quiet"], o.limit, log)
    p["runs"].append(done)
    if done["code"] != 0:
        return p.update(problem=done["words"])
    report = json.load(open(told))
    done.update(evolve=report["seconds"]["evolve"], mesh=hashlib.sha256(open(mesh, "rb").read()).hexdigest())
    done["seconds"] -= report["seconds"]["tunnels"]
    p.update(vertices=report["mesh"]["vertices"], iterations=report["iterations"], edge_mm=report["parameters"]["edge_length"])
    p["problem"] = fault(p, report)
    if len(p["runs"]) == 1 and not p["problem"]:
        checked = run([o.cli, "check", mesh], o.limit, log)
        p["problem"] = "" if checked["code"] == 0 else "check: " + checked["words"]


def measure_all(sweep, points, folder, o):
    """Runs take turns, so that a busy minute does not fall upon one point; what has a problem is not run again."""
    for i in range(o.repeat):
        for p in [p for p in points if not p["problem"]]:
            measure(p, folder, o)
            print(f"{sweep}, run {i + 1} of {o.repeat}: {p['phantom']} {p['size']}³, threads {p['threads']}, fronts {p['fronts']}: "
                  f"{p['runs'][-1]['seconds']:.2f} s {p['problem']}", file=sys.stderr, flush=True)
    if sweep == "threads" and len({p["runs"][0]["mesh"] for p in points if not p["problem"]}) > 1:
        points[-1]["problem"] = "the mesh depends on the number of threads"
    for p in points:
        best = min(p["runs"], key=lambda r: r["seconds"])
        p.update(seconds=best["seconds"], most_seconds=max(r["seconds"] for r in p["runs"]), processor=best["processor"],
                 megabytes=max(r["megabytes"] for r in p["runs"]), evolve=best.get("evolve"))


def markdown(head, rows):
    return "\n".join("| " + " | ".join(map(str, cells)) + " |" for cells in [head, ["---"] * len(head), *rows])


def table(points):
    known = lambda p, key, form: format(p[key], form) if p.get(key) is not None else "?"
    rows = [[p["phantom"], f"{p['size']}³", known(p, "edge_mm", ".3g"), p["threads"], p["fronts"], known(p, "vertices", ","),
             known(p, "iterations", ","), f"{p['seconds']:.2f} ({p['most_seconds']:.2f})", known(p, "evolve", ".2f"),
             f"{p['processor']:.2f}", f"{p['megabytes']:.0f}", len(p["runs"]), p["problem"] or "right"] for p in points]
    return markdown(["phantom", "voxels", "edge length, mm", "threads", "fronts", "vertices", "iterations", "seconds, least (most)",
                     "of them evolution", "processor s", "peak MB", "runs", "mesh"], rows)


def fit(points, x, y):
    """y = a x^b by least squares of the logarithms; no exponent if there are no two different x."""
    pairs = [(math.log(p[x]), math.log(p[y])) for p in points if not p["problem"]]
    if len({u for u, _ in pairs}) < 2:
        return {"exponent": None, "text": "too few points"}
    mx, my = (sum(c) / len(pairs) for c in zip(*pairs))
    sxx, syy, sxy = (sum(c) for c in zip(*(((u - mx) ** 2, (v - my) ** 2, (u - mx) * (v - my)) for u, v in pairs)))
    b = sxy / sxx
    sure = f"R² {b * sxy / syy:.3f}, " if len(pairs) > 2 and syy > 0 else ""
    return {"exponent": b, "factor": math.exp(my - b * mx), "text": f"{b:.2f} ({sure}{len(pairs)} points)"}


def draw_panel(panel, sweep, points, fits, y, colours):
    for name, fitted in fits.items():
        mine = [p for p in points if p["phantom"] == name and p.get(sweep)]
        good, bad = ([p for p in mine if bool(p["problem"]) == b] for b in (False, True))
        panel.plot([p[sweep] for p in good], [p[y] for p in good], "o", color=colours[name], label=name)
        panel.plot([p[sweep] for p in bad], [p[y] for p in bad], "x", color="red", label="ended or failed" if bad else None)
        if fitted[y]["exponent"] is not None:
            ends = [f(p[sweep] for p in good) for f in (min, max)]
            panel.plot(ends, [fitted[y]["factor"] * e ** fitted[y]["exponent"] for e in ends], color=colours[name], linewidth=1,
                       label=f"power {fitted[y]['exponent']:.2f}")
    panel.set(xscale="log", yscale="log", xlabel=sweep, ylabel=MEASURES[y])
    low, high = (f(p[y] for p in points) for f in (min, max))
    wide = max(2, math.sqrt(20 * low / high))  # less than a decade would make a mountain of noise
    panel.set_ylim(low / wide, high * wide)
    names = {p[sweep]: f"{p['size']}³" if sweep == "voxels" else f"{p[sweep]:,}" for p in points if p.get(sweep)}
    panel.set_xticks(list(names), list(names.values()), rotation=30)


def draw(sweeps, phantoms, path):
    from matplotlib import figure, ticker
    plot = figure.Figure(figsize=(4 * len(sweeps), 7), layout="constrained")
    panels = plot.subplots(2, len(sweeps), squeeze=False)
    for column, (sweep, done) in zip(panels.T, sweeps.items()):
        for panel, y in zip(column, ("seconds", "megabytes")):
            draw_panel(panel, sweep, done["points"], done["fits"], y, {name: f"C{i}" for i, name in enumerate(phantoms)})
            panel.yaxis.set_major_locator(ticker.LogLocator(subs=(1, 2, 5)))
            panel.yaxis.set_major_formatter(ticker.StrMethodFormatter("{x:g}"))
            panel.minorticks_off()
            panel.legend(fontsize="small")
    plot.savefig(path)


def options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cli", type=os.path.abspath)
    parser.add_argument("--sweeps", nargs="+", choices=SWEEPS, default=SWEEPS)
    parser.add_argument("--phantom", nargs="+", default=["torus", "gyroid"])
    parser.add_argument("--sizes", nargs="+", type=int)
    for name, kind in (("--size", int), ("--repeat", int), ("--limit", float), ("--json", str), ("--plot", str)):
        parser.add_argument(name, type=kind)
    parser.add_argument("--quick", action="store_true")
    o = parser.parse_args()
    usual = ([50, 64], 50, 1, 60, [2, 1.4], [1, 4]) if o.quick else (
        [100, 200, 400], 200, 3, 1800, [4, 2.8, 2, 1.4, 1], [1, 2, 4, 8, 16])
    for name, value in zip(("sizes", "size", "repeat", "limit", "edges", "fronts"), usual):
        setattr(o, name, getattr(o, name, None) or value)
    if o.plot and not importlib.util.find_spec("matplotlib"):
        parser.error("--plot: python3-matplotlib is not installed for " + sys.executable)
    return o


def main():
    o = options()
    told = {"cores": os.cpu_count(), "load_before": os.getloadavg(), "options": vars(o), "sweeps": {}}
    print(f"{told['cores']} processors, load before {told['load_before'][0]:.1f}; least of {o.repeat} runs, at most {o.limit:g} s each."
          + " Quick: the figures mean nothing." * o.quick)
    with tempfile.TemporaryDirectory() as folder:
        for sweep in o.sweeps:
            points = points_of(sweep, o, folder)
            measure_all(sweep, points, folder, o)
            made = {name: {y: fit([p for p in points if p["phantom"] == name], sweep, y) for y in MEASURES}
                    for name in dict.fromkeys(p["phantom"] for p in points)}
            told["sweeps"][sweep] = {"points": points, "fits": made}
            print(f"\n{sweep.capitalize()}:\n\n{table(points)}\n\nExponents against {sweep}:\n", flush=True)
            print(markdown(["phantom", *MEASURES.values()], [[name] + [f["text"] for f in fits.values()] for name, fits in made.items()]))
    if o.json:
        json.dump(told, open(o.json, "w"), indent=1)
    if o.plot:
        draw(told["sweeps"], o.phantom, o.plot)
    sys.exit(any(p["problem"] for done in told["sweeps"].values() for p in done["points"]))


main()
