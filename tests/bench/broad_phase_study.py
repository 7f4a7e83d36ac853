#!/usr/bin/env python3
"""Draws the study of the hash table's size (paper, section 2) as SVG.

detection_bench --benchmark_filter=tableSize --benchmark_repetitions=9 --benchmark_format=json > study.json
broad_phase_study.py study.json docs/pictures/table_size.svg
Needs nothing but Python. The time is the median over the repetitions; pairs looked at are counted once."""
import json
import math
import re
import statistics
import sys

LEFT, RIGHT, TOP, BOTTOM, WIDE, HIGH = 70, 70, 40, 55, 640, 360


def read(path):
    """Size in vertices -> (ms, pairs looked at, vertices)."""
    times, seen, vertices = {}, {}, 0
    for run in json.load(open(path))["benchmarks"]:
        if run.get("run_type") == "aggregate":
            continue
        size = int(re.search(r"hundredths:(\d+)", run["name"]).group(1)) / 100
        times.setdefault(size, []).append(run["cpu_time"])
        seen[size] = run["candidates"]
        vertices = int(run["vertices"])
    return {s: (statistics.median(t), seen[s]) for s, t in sorted(times.items())}, vertices


def line(points, colour):
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    dots = "".join(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{colour}"/>' for x, y in points)
    return f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="2"/>{dots}'


def drawn(study, vertices):
    sizes = list(study)
    x = lambda s: LEFT + (math.log(s) - math.log(sizes[0])) / (math.log(sizes[-1]) - math.log(sizes[0])) * (WIDE - LEFT - RIGHT)
    most = max(t for t, _ in study.values()) * 1.1, max(c for _, c in study.values()) * 1.1
    y = lambda value, axis: HIGH - BOTTOM - value / most[axis] * (HIGH - TOP - BOTTOM)
    text = lambda a, b, words, anchor="middle", colour="#555": f'<text x="{a:.0f}" y="{b:.0f}" text-anchor="{anchor}" fill="{colour}">{words}</text>'
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDE} {HIGH}" font-family="sans-serif" font-size="12">',
           f'<rect width="{WIDE}" height="{HIGH}" fill="#fff"/>',
           text(WIDE / 2, 20, f"Pairs of near vertices by eight hash functions, {vertices:,} vertices", colour="#222")]
    out.append(f'<line x1="{x(2):.1f}" x2="{x(2):.1f}" y1="{TOP}" y2="{HIGH - BOTTOM}" stroke="#bbb" stroke-dasharray="4 3"/>')
    out.append(text(x(2), TOP - 4, "twice the vertices"))
    out.append(f'<path d="M{LEFT},{TOP} V{HIGH - BOTTOM} H{WIDE - RIGHT} V{TOP}" fill="none" stroke="#888"/>')
    for s in sizes:
        out.append(text(x(s), HIGH - BOTTOM + 18, f"{s:g}"))
    out.append(text(WIDE / 2, HIGH - 12, "size of the table / number of vertices"))
    for axis, (colour, place, anchor, unit) in enumerate([("#0b66c3", LEFT - 6, "end", 1), ("#b35900", WIDE - RIGHT + 6, "start", 1e6)]):
        for part in (0, 0.25, 0.5, 0.75, 1):
            value = part * most[axis]
            out.append(text(place, y(value, axis) + 4, f"{value / unit:.3g}", anchor, colour))
        out.append(line([(x(s), y(study[s][axis], axis)) for s in sizes], colour))
    out += [text(LEFT - 6, TOP - 18, "ms", "end", "#0b66c3"), text(WIDE - RIGHT + 6, TOP - 18, "million pairs", "middle", "#b35900"), "</svg>"]
    return "\n".join(out) + "\n"


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    study, vertices = read(sys.argv[1])
    if not study:
        sys.exit(f"{sys.argv[1]}: no runs of tableSize")
    open(sys.argv[2], "w").write(drawn(study, vertices))
    for size, (ms, pairs) in study.items():
        print(f"{size:6g}  {ms:8.2f} ms  {pairs:12,.0f} pairs looked at")


main()
