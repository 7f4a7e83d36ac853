#!/usr/bin/python3
"""The tables of our engine beside the parallel sparse field, from one run of bench_peers, as Markdown.

    tests/bench/peers_tables.py build/release/tests/bench/bench_peers [--phantom torus,genus3] [--noise .15] [--repeat 5]

Runs on one thread and on all; with --tune the peer's smoothing and weight are searched first, with the truth in
hand (takes long). Says how busy the machine was: ratios of a busy machine are not to be trusted.
"""
import argparse
import json
import os
import subprocess


def row(name, outcomes, ours):
    cells = [name]
    for o in outcomes:
        cells.append(f"{o['seconds']:.2f}, {o['dice']:.4f}, {o['distance']:.3f}, {o['vertices']}"
                     + ("" if o["right_topology"] else ", wrong topology"))
        cells.append(f"{o['seconds'] / ours['seconds']:.1f}")
    return "| " + " | ".join(cells) + " |"


def table(phantoms, suffix):
    lines = ["| phantom | Handlebody: seconds, Dice, distance, vertices | x | adaptive | x | level set, threshold | x |",
             "| --- | --- | --- | --- | --- | --- | --- |"]
    for name, systems in phantoms.items():
        ours = systems["handlebody" + suffix]
        lines.append(row(name, [ours, systems["  adaptive" + suffix], systems["level set, threshold" + suffix]], ours))
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bench")
    parser.add_argument("--phantom", default="torus,genus3,cube,cyst,rings,trefoil,tree,gyroid")
    parser.add_argument("--noise", default="0.15")
    parser.add_argument("--repeat", default="5")
    parser.add_argument("--tune", action="store_true")
    options = parser.parse_args()
    threads = os.cpu_count() or 1
    before = os.getloadavg()[0]
    command = [options.bench, "--json", "--peers", "threshold", "--phantom", options.phantom, "--noise",
               options.noise, "--repeat", options.repeat, "--threads", f"1,{threads}" if threads > 1 else "1"]
    run = subprocess.run(command + ["--tune"] * options.tune, stdout=subprocess.PIPE, check=True)
    phantoms = json.loads(run.stdout)["phantoms"]
    print(f"Load of the machine before: {before:.1f}; {threads} processors; least of {options.repeat} runs.\n")
    print("One thread (processor time):\n\n" + table(phantoms, ""))
    if threads > 1:
        print(f"\n{threads} threads (wall-clock time):\n\n" + table(phantoms, f", {threads} threads"))


if __name__ == "__main__":
    main()
