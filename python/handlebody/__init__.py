"""Handlebody: from a medical volume and a seed to a certified surface mesh.

    import handlebody

    volume = handlebody.read_volume("cyst.nii.gz")
    contour = handlebody.Contour(volume, seed=(77, 49, 85, 8), object="dark")
    contour.run()
    contour.save("cyst.stl", "cyst_label.nii.gz")

World coordinates are LPS millimetres. Arrays of voxels are indexed [z, y, x]; sizes, spacings, origins and points are in
the order x, y, z. For research use only; not a medical device.
"""
import os as _os
import pathlib as _pathlib
import shutil as _shutil

from ._core import (
    Contour,
    Error,
    Grid,
    HandlebodyWarning,
    InputError,
    Mesh,
    OutputError,
    Phantom,
    SeedError,
    UsageError,
    Volume,
    __version__,
    compare,
    phantom,
    read_mesh,
    read_volume,
    set_decoder,
)

__all__ = [
    "Contour",
    "Error",
    "Grid",
    "HandlebodyWarning",
    "InputError",
    "Mesh",
    "OutputError",
    "Phantom",
    "SeedError",
    "UsageError",
    "Volume",
    "compare",
    "phantom",
    "read_mesh",
    "read_volume",
    "set_decoder",
]

for _name in __all__:
    globals()[_name].__module__ = __name__


def _decoder():
    """The handlebody-cli that belongs to this module: told, beside it where it is installed or built, in the path."""
    here = _pathlib.Path(__file__).resolve()
    beside = [parent / folder / "handlebody-cli" for parent in here.parents for folder in ("bin", "app")]
    found = [str(path) for path in beside if _os.access(path, _os.X_OK) and path.is_file()]
    return _os.environ.get("HANDLEBODY_CLI") or (found[0] if found else _shutil.which("handlebody-cli"))


if _path := _decoder():
    set_decoder(_path)
