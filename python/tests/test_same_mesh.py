"""The module and the command line make the same mesh, bit for bit."""
import numpy as np
import pytest

import handlebody


def text(numbers):
    return ",".join(map(repr, numbers))


def assert_same(mesh, path):
    """.obj keeps every digit and is read without help."""
    written = handlebody.read_mesh(path)
    assert mesh.vertices.dtype == np.float64 and mesh.faces.dtype == np.int32
    np.testing.assert_array_equal(mesh.vertices.view(np.uint64), written.vertices.view(np.uint64))
    np.testing.assert_array_equal(mesh.faces, written.faces)
    assert len(mesh.faces) > 500


@pytest.mark.parametrize("options", [
    {},
    {"object": "dark"},
    {"range": (-float("inf"), 300.5), "edge_length": 2.9, "curvature": 0.3},
    {"smoothing": 0.7, "direction": "both", "balloon": 1.1, "max_iterations": 40, "broad_phase": "hashing"},
])
def test_options_make_the_mesh_of_the_command_line(torus_file, tmp_path, cli, options):
    path, seed = torus_file
    arguments = [word for name, value in options.items()
                 for word in ("--" + name.replace("_", "-"), value if isinstance(value, (str, int, float)) else text(value))]
    cli("segment", path, "--seed", text(seed), *arguments, "-o", tmp_path / "cli.obj", "-o", tmp_path / "cli.nii.gz",
        "-o", tmp_path / "cli.stl", "--quiet")
    contour = handlebody.Contour(handlebody.read_volume(path), seed=seed, **options)
    contour.run()
    assert_same(contour.mesh(), tmp_path / "cli.obj")
    contour.save(tmp_path / "module.stl")
    assert (tmp_path / "module.stl").read_bytes() == (tmp_path / "cli.stl").read_bytes()
    labels = handlebody.read_volume(tmp_path / "cli.nii.gz").array
    np.testing.assert_array_equal(contour.label_map(), labels)


def test_a_bare_click_makes_the_mesh_of_the_command_line(torus_file, tmp_path, cli):
    path, seed = torus_file
    cli("segment", path, "--seed", text(seed[:3]), "-o", tmp_path / "cli.obj", "--quiet")
    volume = handlebody.read_volume(path)
    contour = handlebody.Contour(volume, seed=seed[:3])
    contour.run()
    assert_same(contour.mesh(), tmp_path / "cli.obj")
    by_voxel = handlebody.Contour(volume, seed_ijk=volume.grid.to_index(seed[:3]))
    assert by_voxel.parameters["seeds"][0]["centre"] == pytest.approx(seed[:3])
    voxels, world = (*volume.grid.to_index(seed[:3]), 2), (*seed[:3], 3)  # the first decides
    first = handlebody.Contour(volume, seed_ijk=voxels, seed=world).parameters["seeds"][0]
    assert first["radius"] == pytest.approx(2 * np.prod(volume.grid.spacing) ** (1 / 3))
    assert handlebody.Contour(volume, seed=world, seed_ijk=voxels).parameters["seeds"][0]["radius"] == pytest.approx(3)


def test_several_clicks_and_constraints_are_those_of_the_command_line(torus_file, tmp_path, cli):
    path, seed = torus_file
    grid = handlebody.read_volume(path).grid
    outside = grid.to_world((1, 1, 1))
    x, y, z = seed[:3]
    cli("segment", path, "--seed", text(seed), "--background", text(outside), "--wall", text((x + 20, y, z, 3)),
        "--wall", text((x, y + 20, z, 2.5)), "--genus", 0, "--max-iterations", 60, "-o", tmp_path / "cli.obj", "--quiet")
    contour = handlebody.Contour(handlebody.read_volume(path), seed=[seed], background=[outside], genus=0,
                                 wall=[(x + 20, y, z, 3), np.array([x, y + 20, z, 2.5], dtype=np.float32)],
                                 max_iterations=60)
    contour.run()
    assert_same(contour.mesh(), tmp_path / "cli.obj")


def with_a_thin_triangle(mesh):
    """One face becomes three that meet next to the middle of an edge."""
    a, b, c = mesh.faces[0]
    middle = mesh.vertices[[a, b, c]].T @ (0.495, 0.495, 0.01)
    new = len(mesh.vertices)
    faces = np.vstack([mesh.faces[1:], [(a, b, new), (b, c, new), (c, a, new)]])
    return handlebody.Mesh(np.vstack([mesh.vertices, middle]), faces)


def test_a_given_mesh_stays_as_it_is_and_is_that_of_the_command_line(torus_file, tmp_path, cli):
    path, seed = torus_file
    volume = handlebody.read_volume(path)
    first = handlebody.Contour(volume, seed=seed)
    first.run()
    given = tmp_path / "given.ply"
    with_a_thin_triangle(first.mesh()).save(given)
    contour = handlebody.Contour(volume, given=given)
    assert contour.stop_reason == "given"
    contour.run()
    read = handlebody.read_mesh(given)
    np.testing.assert_array_equal(contour.mesh().vertices, read.vertices)
    np.testing.assert_array_equal(contour.mesh().faces, read.faces)
    cli("segment", path, "--given", given, "-o", tmp_path / "cli.obj", "--quiet")
    assert_same(contour.mesh(), tmp_path / "cli.obj")
    assert "polish" not in contour.report()
    assert any("as it was given" in warning for warning in contour.warnings())


def test_what_can_have_no_effect_is_refused(torus_file, tmp_path):
    path, seed = torus_file
    volume = handlebody.read_volume(path)
    first = handlebody.Contour(volume, seed=seed)
    first.run()
    given = tmp_path / "given.ply"
    first.save(given)
    for refused, option in [({"range": (0, 100), "candidate": 2, "seed": seed}, "candidate has no effect with range"),
                            ({"given": given, "smoothing": 1}, "smoothing has no effect on an object that given"),
                            ({"given": given, "start_genus": 0}, "start_genus has no effect.* is a mesh"),
                            ({"given": given, "wall": (*first.mesh().vertices[0], 3)}, "lies over the surface"),
                            ({"given": given, "genus": 0}, "genus: .* 1 handles or tunnels")]:
        with pytest.raises(handlebody.UsageError, match=option):
            handlebody.Contour(volume, **refused)


def test_a_start_is_the_same_at_all_iterations(torus_file, tmp_path):
    path, seed = torus_file
    volume = handlebody.read_volume(path)
    first = handlebody.Contour(volume, seed=seed)
    first.run()
    first.save(tmp_path / "labels.nrrd")
    contour = handlebody.Contour(volume, start=tmp_path / "labels.nrrd")
    contour.run(1)
    for options in ({"start_smooth": 1}, {"start_label": 1}, {"given": tmp_path / "labels.nrrd"}):
        with pytest.raises(handlebody.UsageError, match=next(iter(options))):
            contour.change(**options)
    contour.change(curvature=0.4)
    with pytest.raises(handlebody.UsageError, match="start_smooth"):
        handlebody.Contour(volume, seed=seed, start_smooth=1)


def test_a_given_segment_is_called_as_in_its_file(torus_file, tmp_path, cli):
    path, seed = torus_file
    volume = handlebody.read_volume(path)
    cli("segment", path, "--seed", text(seed), "--object-name", "left ring", "--term", "vessel", "--color", "9,8,7",
        "-o", tmp_path / "made.seg.nrrd", "--quiet")
    given = tmp_path / "made.seg.nrrd"
    contour = handlebody.Contour(volume, given=given, start_label=1)
    contour.save(tmp_path / "python.seg.nrrd")
    cli("segment", path, "--given", given, "--start-label", "1", "-o", tmp_path / "cli.seg.nrrd", "--quiet")
    assert (tmp_path / "python.seg.nrrd").read_bytes() == (tmp_path / "cli.seg.nrrd").read_bytes()
    assert b"left ring" in (tmp_path / "python.seg.nrrd").read_bytes()
    contour.save(tmp_path / "other.seg.nrrd", name="other")
    assert b"other" in (tmp_path / "other.seg.nrrd").read_bytes()


def test_an_array_with_voxels_that_are_no_numbers_is_warned_of():
    array = np.zeros((4, 4, 4), np.float32)
    array[1, 1, 1] = np.nan
    with pytest.warns(handlebody.HandlebodyWarning):
        handlebody.Volume(array)


def test_an_array_makes_the_mesh_of_its_file(torus_file):
    path, seed = torus_file
    read = handlebody.read_volume(path)
    made = handlebody.Volume(read.array, read.grid.spacing, read.grid.origin, read.grid.direction)
    meshes = []
    for volume in (read, made):
        contour = handlebody.Contour(volume, seed=seed)
        contour.run(30)
        meshes.append(contour.mesh())
    np.testing.assert_array_equal(meshes[0].vertices, meshes[1].vertices)
    np.testing.assert_array_equal(meshes[0].faces, meshes[1].faces)


def test_steps_one_by_one_make_the_mesh_of_a_run(torus):
    run = handlebody.Contour(torus.volume, seed=torus.seed)
    run.run()
    stepped = handlebody.Contour(torus.volume, seed=torus.seed)
    while stepped.stop_reason == "running":
        stepped.step()
    assert stepped.iteration == run.iteration > 10
    np.testing.assert_array_equal(stepped.vertices, run.vertices)
    np.testing.assert_array_equal(stepped.faces, run.faces)
    assert stepped.events == run.events


def test_a_session_is_replayed_to_the_same_mesh(torus_file, tmp_path, cli):
    path, seed = torus_file
    contour = handlebody.Contour(handlebody.read_volume(path), seed=seed, object="dark")
    contour.run(25)
    contour.save_session(tmp_path / "session.json")
    cli("replay", tmp_path / "session.json", "-o", tmp_path / "cli.obj", "--quiet")
    assert contour.stop_reason == "running"
    assert_same(contour.mesh(), tmp_path / "cli.obj")


def test_a_contour_that_was_changed_is_replayed_to_the_same_mesh(torus_file, tmp_path, cli):
    path, seed = torus_file
    volume = handlebody.read_volume(path)
    contour = handlebody.Contour(volume, seed=seed, object="dark")
    contour.run(20)
    contour.change(curvature=0.4, background=volume.grid.to_world((2, 2, 2)))
    contour.run(10)
    middle = np.array(volume.grid.to_world([(n - 1) / 2 for n in volume.grid.size]))
    across = 2 * middle - seed[:3]  # where the ring would close
    contour.change(edge_length=2.5, wall=(*across, 15))
    contour.run()
    assert contour.certificate()["genus"][0] == 0
    assert contour.parameters["curvature"] == 0.4 and contour.parameters["edge_length"] == 2.5
    contour.save_session(tmp_path / "session.json")
    cli("replay", tmp_path / "session.json", "-o", tmp_path / "cli.obj", "--quiet")
    assert_same(contour.mesh(), tmp_path / "cli.obj")
    other = handlebody.Contour(volume, seed=seed, object="dark")
    other.run()
    assert len(other.vertices) != len(contour.vertices)
