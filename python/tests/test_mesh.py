"""Meshes: from arrays and files, certificate, label maps, writing, comparing."""
import json
import warnings

import numpy as np
import pytest

import handlebody

VERTICES = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
FACES = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]


def test_a_mesh_of_arrays_has_a_certificate():
    mesh = handlebody.Mesh(np.array(VERTICES, np.float32)[:, ::-1][:, ::-1], np.array(FACES, np.uint8))
    certificate = mesh.certificate()
    assert certificate["closed"] and certificate["volume_mm3"] == pytest.approx(1 / 6)
    assert mesh.faces.dtype == np.int32 and mesh.faces.tolist() == FACES
    assert mesh.measure()["box_mm"] == [1, 1, 1]


@pytest.mark.parametrize("vertices, faces, sentence", [
    ([[0, 0]], FACES, "vertices"),
    ([["a", "b", "c"]], FACES, "vertices"),
    ([[0, 0, float("nan")]], [[0, 0, 0]], "vertices: number 0"),
    (VERTICES, [[0, 1, 4]], "corner 4"),
    (VERTICES, [[0, 1, -1]], "corner -1"),
    (VERTICES, [[0.5, 1, 2]], "whole numbers"),
    (VERTICES, [[0, 1, 2**40]], "corner"),
    (None, FACES, "vertices"),
])
def test_arrays_that_are_no_mesh_are_one_sentence(vertices, faces, sentence):
    with pytest.raises(handlebody.UsageError, match=sentence):
        handlebody.Mesh(vertices, faces)


def test_a_mesh_without_an_inside_is_not_measured_filled_or_written(tmp_path):
    mesh = handlebody.Mesh(VERTICES, FACES[:3])
    assert not mesh.certificate()["closed"]
    with pytest.raises(handlebody.InputError, match="no inside to measure"):
        mesh.measure()
    with pytest.raises(handlebody.InputError, match="no inside to fill"):
        mesh.label_map(handlebody.Grid((4, 4, 4)))
    with pytest.raises(RuntimeError, match="certificate"):
        mesh.save(tmp_path / "x.stl")
    assert list(tmp_path.iterdir()) == []


def test_a_label_map_lies_on_any_grid(ball, grown):
    mesh = grown.mesh()
    np.testing.assert_array_equal(mesh.label_map(ball.volume), grown.label_map())
    x, y, z = ball.seed[:3]
    fine = handlebody.Grid((30, 20, 10), (1, 1, 1), (x, y, z))
    labels = mesh.label_map(fine)
    assert labels.shape == (10, 20, 30) and labels[0, 0, 0] == 1 and labels[0, 0, -1] == labels[0, 0, 28]
    with pytest.raises(TypeError, match="Grid or a Volume"):
        mesh.label_map((3, 3, 3))


@pytest.mark.parametrize("ending", [".stl", ".vtp", ".ply", ".obj", ".3mf"])
def test_a_written_mesh_is_read_back_the_same(grown, tmp_path, ending):
    mesh = grown.mesh()
    mesh.save(tmp_path / ("mesh" + ending))
    read = handlebody.read_mesh(tmp_path / ("mesh" + ending))
    assert read.certificate() == pytest.approx(mesh.certificate())
    if ending != ".stl":  # which numbers the vertices anew
        np.testing.assert_array_equal(read.vertices, mesh.vertices)
        np.testing.assert_array_equal(read.faces, mesh.faces)


def test_ras_is_turned_in_the_file_and_back(grown, tmp_path):
    grown.save(tmp_path / "ras.vtp", space="RAS")
    np.testing.assert_array_equal(handlebody.read_mesh(tmp_path / "ras.vtp").vertices, grown.mesh().vertices)
    with pytest.raises(handlebody.UsageError, match="space: 'XYZ'"):
        grown.save(tmp_path / "x.vtp", space="XYZ")
    with pytest.raises(handlebody.UsageError, match="RAS has no effect"):
        grown.save(tmp_path / "x.gltf", space="RAS")


def test_what_cannot_be_written_leaves_nothing_behind(ball, grown, tmp_path):
    for path, error in [("a.xyz", handlebody.UsageError), ("absent/a.stl", handlebody.OutputError),
                        ("a.stl.dcm", handlebody.UsageError)]:
        with pytest.raises(error) as raised:
            grown.save(tmp_path / path)
        assert path in str(raised.value)
    with pytest.raises(handlebody.UsageError, match="needs the volume"):
        grown.mesh().save(tmp_path / "a.nii.gz")
    with pytest.raises(handlebody.UsageError, match="label"):
        grown.save(tmp_path / "a.nii.gz", label=0)
    with pytest.raises(TypeError):
        grown.save()
    with pytest.raises(handlebody.UsageError, match="made from an array"):
        grown.save_session(tmp_path / "session.json")
    assert list(tmp_path.iterdir()) == []
    grown.mesh().save(tmp_path / "a.nii.gz", volume=ball.volume, label=7)
    assert set(np.unique(handlebody.read_volume(tmp_path / "a.nii.gz").array)) == {0, 7}


def test_what_a_label_map_leaves_out_is_a_warning(ball, tmp_path):
    corners = np.array(VERTICES, float)
    between = handlebody.Mesh(corners * 0.5 + 5.2, FACES)
    with pytest.warns(handlebody.HandlebodyWarning, match="No voxel with a value has its centre inside"):
        between.save(tmp_path / "a.nii.gz", volume=ball.volume)
    outside = handlebody.Mesh(corners * 4 - 2, FACES)
    with pytest.warns(handlebody.HandlebodyWarning, match="lies outside of the volume"):
        outside.save(tmp_path / "b.nii.gz", volume=ball.volume)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        between.save(tmp_path / "c.ply")


def test_nothing_is_written_over_the_volume(torus_file, tmp_path, cli):
    path, seed = torus_file
    before = path.read_bytes()
    contour = handlebody.Contour(handlebody.read_volume(path), seed=seed)
    contour.run(3)
    with pytest.raises(handlebody.UsageError, match="not overwritten"):
        contour.save(tmp_path / "a.stl", path)
    assert path.read_bytes() == before and list(tmp_path.iterdir()) == []


def test_nothing_is_written_over_walls_a_start_or_the_volume_of_a_session(torus_file, tmp_path):
    path, seed = torus_file
    volume = handlebody.read_volume(path)
    labels = np.zeros(volume.grid.shape, np.uint8)
    labels[0, 0, 0] = 1
    walls, start = tmp_path / "walls.nrrd", tmp_path / "start.stl"
    handlebody.Volume(labels, volume.grid.spacing, volume.grid.origin, volume.grid.direction).save(walls)
    first = handlebody.Contour(volume, seed=seed)
    first.run(3)
    first.save(start)
    contour = handlebody.Contour(volume, start=start, walls=walls)
    before = {name: name.read_bytes() for name in (path, walls, start)}
    for name in before:
        with pytest.raises(handlebody.UsageError, match="not overwritten"):
            contour.save_session(name)
        with pytest.raises(handlebody.UsageError, match="not overwritten"):
            contour.save(name)
    assert all(name.read_bytes() == bytes for name, bytes in before.items())


def test_compare_has_the_figures_of_the_command_line(ball, grown, tmp_path, cli):
    grown.save(tmp_path / "mesh.obj")
    ball.truth.save(tmp_path / "truth.nii.gz")
    said = json.loads(cli("compare", tmp_path / "mesh.obj", tmp_path / "truth.nii.gz", "--json"))
    by_path = handlebody.compare(tmp_path / "mesh.obj", str(tmp_path / "truth.nii.gz"))
    assert by_path == said and said["dice"] > 0.97
    in_memory = handlebody.compare(grown.mesh(), ball.truth, label=1)
    for key in ("dice", "iou", "distances", "volume_difference_mm3"):
        assert in_memory[key] == said[key]
    assert in_memory["b"]["label"] == 1


def test_what_cannot_be_compared_is_one_sentence(ball, grown, tmp_path):
    half = handlebody.Volume(np.full((4, 4, 4), 0.5))
    for b, error, sentence in [(half, handlebody.InputError, "b: it is no label map"),
                               (tmp_path / "absent.stl", handlebody.InputError, "absent.stl"),
                               (grown, TypeError, "mesh()"), (3, TypeError, "")]:
        with pytest.raises(error, match=sentence):
            handlebody.compare(grown.mesh(), b)
    with pytest.raises(handlebody.UsageError, match="sampling"):
        handlebody.compare(grown.mesh(), ball.truth, sampling=0)
    with pytest.raises(handlebody.InputError, match="no area"):
        handlebody.compare(handlebody.Mesh(np.zeros((0, 3)), np.zeros((0, 3), int)), ball.truth)
