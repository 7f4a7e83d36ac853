"""What the tests share: the program, small volumes, and a command line beside the module."""
import json
import os
import pathlib
import subprocess

import pytest

import handlebody

CLI = os.environ["HANDLEBODY_CLI"]
SOURCE = pathlib.Path(os.environ["HANDLEBODY_SOURCE"])


def run_cli(*arguments):
    """Standard output of the program; what it says goes into the failure if it fails."""
    done = subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode in (0, 5), done.stderr
    return done.stdout


@pytest.fixture(scope="session")
def cli():
    return run_cli


@pytest.fixture(scope="session")
def source():
    return SOURCE


@pytest.fixture(scope="session")
def ball():
    """The smallest phantom: a dark ball of 30 mm radius."""
    return handlebody.phantom("sphere", spacing=(2, 2, 2))


@pytest.fixture(scope="session")
def torus():
    return handlebody.phantom("torus", spacing=(2, 2, 2))


@pytest.fixture(scope="session")
def torus_file(tmp_path_factory, cli):
    """A file, and its seed as the command line takes it."""
    path = tmp_path_factory.mktemp("torus") / "torus.nii.gz"
    said = json.loads(cli("phantom", "torus", "--spacing", "1.5,2,1.75", "--rotate", "20,-30,50", "--type", "int16",
                          "--noise", "0.05", "-o", path))
    return path, (*said["seed"]["centre"], said["seed"]["radius"])


@pytest.fixture
def grown(ball):
    contour = handlebody.Contour(ball.volume, seed=ball.seed)
    contour.run()
    return contour
