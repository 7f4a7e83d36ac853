"""Volumes from arrays and files: order of the axes, types, checks."""
import gc
import os

import numpy as np
import pytest

import handlebody


def ramp(dtype=np.int16):
    return np.arange(2 * 3 * 4).reshape(2, 3, 4).astype(dtype)


def test_the_axes_of_an_array_are_z_y_x():
    volume = handlebody.Volume(ramp(), spacing=(1, 2, 3), origin=(10, 20, 30))
    assert volume.grid.size == (4, 3, 2)
    assert volume.grid.shape == volume.array.shape == (2, 3, 4)
    assert volume.grid.spacing == (1, 2, 3)
    assert volume.grid.to_world((3, 2, 1)) == (13, 24, 33)
    assert volume.grid.to_index((13, 24, 33)) == (3, 2, 1)
    assert volume.array[1, 2, 3] == 23


def test_the_columns_of_direction_are_the_axes(tmp_path):
    turned = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    volume = handlebody.Volume(ramp(), spacing=(1, 2, 3), direction=turned)
    assert volume.grid.to_world((1, 0, 0)) == (0, 1, 0)
    volume.save(tmp_path / "v.nrrd")
    read = handlebody.read_volume(tmp_path / "v.nrrd")
    np.testing.assert_array_equal(read.grid.direction, turned)
    np.testing.assert_array_equal(read.array, ramp())


@pytest.mark.parametrize("given, held", [
    ("bool", "uint8"), ("uint8", "uint8"), ("int8", "int8"), ("uint16", "uint16"), ("int16", "int16"),
    ("uint32", "uint32"), ("int32", "int32"), ("int64", "float64"), ("uint64", "float64"), ("float16", "float32"),
    ("float32", "float32"), ("float64", "float64"), (">i2", "int16"), (">f8", "float64")])
def test_types_are_those_of_files(given, held):
    array = ramp(given)
    volume = handlebody.Volume(array)
    assert volume.array.dtype == np.dtype(held)
    np.testing.assert_array_equal(volume.array, array.astype(held))


@pytest.mark.parametrize("view", [
    lambda a: a[::2, ::-1, 1:], lambda a: a.transpose(2, 0, 1), np.asfortranarray, lambda a: a.tolist()])
def test_arrays_of_any_layout_are_taken(view):
    array = view(np.arange(4 * 5 * 6, dtype=np.float32).reshape(4, 5, 6))
    np.testing.assert_array_equal(handlebody.Volume(array).array, np.asarray(array))


def test_the_voxels_are_a_copy_that_nobody_can_change():
    array = ramp()
    volume = handlebody.Volume(array)
    array[:] = 0
    assert volume.array[1, 2, 3] == 23
    assert not volume.array.flags.writeable
    with pytest.raises(ValueError):
        volume.array[0, 0, 0] = 1
    with pytest.raises(ValueError):
        volume.array.setflags(write=True)


def test_a_view_outlives_its_volume():
    view = handlebody.Volume(ramp(np.float64)).array
    other = handlebody.Volume(ramp(np.float64) + 100).array
    gc.collect()
    np.testing.assert_array_equal(view, ramp())
    np.testing.assert_array_equal(other, ramp() + 100)
    volume = handlebody.Volume(ramp())
    assert np.shares_memory(volume.array, volume.array)


@pytest.mark.parametrize("array, sentence", [
    (np.zeros((4, 4)), "2 dimensions"),
    (np.zeros(()), "0 dimensions"),
    (np.zeros((4, 4, 4), complex), "complex128"),
    (np.zeros((4, 4, 4), np.longdouble), "not supported"),
    (np.full((4, 4, 4), None), "object"),
    (np.zeros((4, 4, 4), "S4"), "not supported"),
    (np.ma.masked_array(np.zeros((4, 4, 4))), "masked"),
    (np.zeros((0, 4, 4)), "no voxels"),
    (np.zeros((1, 4, 4)), "2D"),
])
def test_what_is_no_volume_is_one_sentence(array, sentence):
    with pytest.raises(handlebody.InputError, match=sentence) as error:
        handlebody.Volume(array)
    assert str(error.value).startswith("array: ") and str(error.value).endswith(".")


def test_infinite_voxels_are_told():
    array = np.zeros((4, 5, 6))
    array[1, 2, 3] = np.nan
    array[3, 4, 5] = -np.inf
    with pytest.raises(handlebody.InputError, match=r"1 of its voxels is infinite.*\(5, 4, 3\)"):
        handlebody.Volume(array)


@pytest.mark.parametrize("geometry, error", [
    ({"spacing": (1, 1, 0)}, handlebody.InputError),
    ({"spacing": (1, -1, 1)}, handlebody.InputError),
    ({"spacing": (1, 1)}, handlebody.UsageError),
    ({"spacing": "abc"}, handlebody.UsageError),
    ({"spacing": (1, 1, float("nan"))}, handlebody.UsageError),
    ({"origin": (0, 0, float("inf"))}, handlebody.UsageError),
    ({"direction": [[1, 0.1, 0], [0, 1, 0], [0, 0, 1]]}, handlebody.InputError),
    ({"direction": np.zeros((3, 3))}, handlebody.InputError),
    ({"direction": np.eye(4)}, handlebody.UsageError),
])
def test_a_geometry_without_meaning_is_refused(geometry, error):
    with pytest.raises(error) as raised:
        handlebody.Volume(np.zeros((4, 4, 4)), **geometry)
    assert next(iter(geometry)) in str(raised.value) or "axes" in str(raised.value)


def test_a_grid_that_no_memory_holds_is_refused():
    with pytest.raises(handlebody.InputError, match="memory"):
        handlebody.Grid((2_000_000, 2_000_000, 2_000_000))


def test_a_file_that_cannot_be_read_is_one_sentence(tmp_path):
    (tmp_path / "x.nii").write_bytes(b"nothing")
    for path in (tmp_path / "x.nii", str(tmp_path / "absent.nii"), os.fsencode(tmp_path / "absent.nii")):
        with pytest.raises(handlebody.InputError) as error:
            handlebody.read_volume(path)
        assert os.fsdecode(path) in str(error.value)
    assert issubclass(handlebody.InputError, handlebody.Error) and issubclass(handlebody.InputError, ValueError)


def test_a_frame_that_is_not_there_is_refused(torus_file):
    with pytest.raises(handlebody.UsageError, match="frame 3"):
        handlebody.read_volume(torus_file[0], frame=3)
    with pytest.raises(handlebody.UsageError, match="uneven: 'x'"):
        handlebody.read_volume(torus_file[0], uneven="x")


def test_a_warning_names_arguments_and_leaves_file_names_as_they_are(tmp_path):
    path = tmp_path / "a --frame b.nrrd"
    header = ("NRRD0004\ntype: uint8\ndimension: 4\nspace: left-posterior-superior\nsizes: 3 3 3 2\n"
              "space directions: (1,0,0) (0,1,0) (0,0,1) none\nspace origin: (0,0,0)\nencoding: raw\n\n")
    path.write_bytes(header.encode() + bytes(range(54)))
    with pytest.warns(handlebody.HandlebodyWarning, match=r"frame 0 is used \(frame chooses another\)"):
        volume = handlebody.read_volume(path)
    assert any("(frame chooses another)" in warning for warning in volume.warnings)
    path.write_bytes(b"nothing")
    with pytest.raises(handlebody.InputError) as error:
        handlebody.read_volume(path)
    assert str(path) in str(error.value)


def test_what_is_doubtful_about_a_file_is_a_warning(torus_file):
    with pytest.warns(handlebody.HandlebodyWarning, match="spacing was given"):
        volume = handlebody.read_volume(torus_file[0], spacing=(1, 1, 1))
    assert volume.warnings and volume.grid.spacing == (1, 1, 1)


def test_a_volume_is_not_written_over_its_file(torus_file, tmp_path):
    path, _ = torus_file
    before = path.read_bytes()
    volume = handlebody.read_volume(path)
    with pytest.raises(handlebody.UsageError, match="not overwritten"):
        volume.save(path)
    assert path.read_bytes() == before
    volume.save(tmp_path / "copy.mha")
    np.testing.assert_array_equal(handlebody.read_volume(tmp_path / "copy.mha").array, volume.array)
    with pytest.raises(handlebody.UsageError):
        volume.save(tmp_path / "copy.xyz")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["copy.mha"]
