"""The examples of docs/examples/python run."""
import importlib.util
import os
import pathlib
import subprocess
import sys

import pytest

EXAMPLES = pathlib.Path(os.environ["HANDLEBODY_SOURCE"]) / "docs" / "examples" / "python"


def run(name, folder):
    done = subprocess.run([sys.executable, EXAMPLES / name], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def test_no_example_is_forgotten():
    assert {path.name for path in EXAMPLES.iterdir()} == {"sweep.py", "leak_study.py", "plot.py"}


def test_the_sweep_prints_a_row_for_each_setting(tmp_path):
    header, *rows = run("sweep.py", tmp_path)
    assert header.split(",")[:2] == ["edge_length", "curvature"] and len(rows) == 6
    dice = [float(row.split(",")[-1]) for row in rows]
    assert all(0.9 < d <= 1 for d in dice) and len(set(dice)) == len(dice)


def test_the_leak_study_finds_where_the_wall_gives_way(tmp_path):
    header, *rows = run("leak_study.py", tmp_path)
    leaks = [int(row.split(",")[1]) for row in rows]
    volumes = [float(row.split(",")[2]) for row in rows]
    assert leaks[0] == 0 and leaks[-1] == 1
    assert volumes[-1] > 1.5 * volumes[0]


def test_the_plot_is_a_picture(tmp_path):
    if importlib.util.find_spec("matplotlib") is None:
        pytest.skip("matplotlib is not installed")
    run("plot.py", tmp_path)
    assert (tmp_path / "torus.png").read_bytes()[:8] == b"\x89PNG\r\n\x1a\n"
