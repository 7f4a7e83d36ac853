"""Runs the tests of this folder, or those of the files named, with arguments for pytest; 77 says that they were skipped."""
import pathlib
import sys

try:
    import numpy  # noqa: F401
    import pytest
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)
folder = pathlib.Path(__file__).parent
files = [str(folder / name) for name in sys.argv[1:] if name.endswith(".py")] or [str(folder)]
options = [argument for argument in sys.argv[1:] if not argument.endswith(".py")]
sys.exit(pytest.main(["-q", "-p", "no:cacheprovider", *files, *options]))
