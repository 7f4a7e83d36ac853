"""Contours: steps, events, views, errors, threads and signals."""
import gc
import os
import signal
import subprocess
import sys
import textwrap
import threading
import time

import numpy as np
import pytest

import handlebody


def test_a_step_says_what_it_did(torus):
    contour = handlebody.Contour(torus.volume, seed=torus.seed)
    assert (contour.iteration, contour.stop_reason, contour.events) == (0, "running", [])
    step = contour.step()
    assert step["iteration"] == contour.iteration == 1
    assert step["moved_vertices"] > 0 and step["largest_move_mm"] > 0 and step["volume_mm3"] > 0
    assert step["events"] == [] and step["leaks"] == []


def test_events_tell_topology_before_and_after_and_the_place(torus):
    contour = handlebody.Contour(torus.volume, seed=torus.seed)
    told = []
    while contour.stop_reason == "running":
        told += contour.step()["events"]
    assert told == contour.events
    joined = [e for e in told if e["kind"] == "handle inserted"]
    assert joined and all(e["fronts"] >= 2 and len(e["loop_sizes"]) == e["fronts"] for e in joined)
    for event in joined:
        assert event["after"]["euler"] < event["before"]["euler"]
        index = contour_index(torus, event)
        assert all(0 <= i < n for i, n in zip(index, torus.volume.grid.size))
    certificate = contour.certificate()
    assert told[-1]["after"]["euler"] == certificate["euler"]
    assert sorted(certificate["genus"]) == sorted(torus.genus)


def contour_index(phantom, event):
    return phantom.volume.grid.to_index(event["location"])


def test_a_run_can_be_cut_anywhere_and_go_on(ball, grown):
    contour = handlebody.Contour(ball.volume, seed=ball.seed)
    assert contour.run(0) == "running" and contour.iteration == 0
    assert contour.run(3) == "running" and contour.iteration == 3
    assert contour.run() == grown.stop_reason == "converged"
    np.testing.assert_array_equal(contour.vertices, grown.vertices)
    with pytest.raises(handlebody.UsageError, match="converged"):
        contour.step()
    assert contour.run() == "converged"
    with pytest.raises(handlebody.UsageError, match="max_steps"):
        contour.run(-1)


def test_the_limit_of_iterations_is_told(ball):
    contour = handlebody.Contour(ball.volume, seed=ball.seed, max_iterations=2)
    assert contour.run() == "max-iterations" and contour.iteration == 2


def test_views_are_not_copies_and_keep_what_they_show(ball):
    contour = handlebody.Contour(ball.volume, seed=ball.seed)
    vertices, faces = contour.vertices, contour.faces
    assert np.shares_memory(vertices, contour.vertices) and np.shares_memory(faces, contour.faces)
    assert vertices.shape[1] == faces.shape[1] == 3 and faces.max() == len(vertices) - 1
    for view in (vertices, faces):
        assert not view.flags.owndata and not view.flags.writeable
        with pytest.raises(ValueError):
            view[0, 0] = 1
        with pytest.raises(ValueError):
            view.setflags(write=True)
    kept = vertices.copy(), faces.copy()
    contour.run(5)
    assert not np.shares_memory(vertices, contour.vertices)
    moved = contour.vertices
    assert len(moved) != len(kept[0]) or (moved != kept[0]).any()
    mesh = contour.mesh()
    shown = mesh.vertices
    held = shown.copy()
    del contour, mesh
    gc.collect()
    np.testing.assert_array_equal(vertices, kept[0])
    np.testing.assert_array_equal(faces, kept[1])
    np.testing.assert_array_equal(shown, held)


def test_a_copy_goes_its_own_way_to_the_same_mesh(ball, grown):
    contour = handlebody.Contour(ball.volume, seed=ball.seed)
    contour.run(3)
    other = contour.copy()
    contour.run()
    assert other.iteration == 3
    other.run()
    np.testing.assert_array_equal(other.vertices, grown.vertices)


def test_a_change_that_is_refused_changes_nothing(ball, grown):
    contour = handlebody.Contour(ball.volume, seed=ball.seed)
    contour.run(3)
    for options, error in [({"edge_length": -1}, handlebody.UsageError), ({"walls": "/absent"}, handlebody.InputError),
                           ({"seed": (1e5, 0, 0)}, handlebody.SeedError), ({"wall": ball.seed}, handlebody.UsageError)]:
        with pytest.raises(error):
            contour.change(**options)
    contour.change(threads=2)
    with pytest.raises(handlebody.UsageError, match="changed at iteration 3 already"):
        contour.change(threads=1)
    contour.run()
    np.testing.assert_array_equal(contour.vertices, grown.vertices)


def test_a_candidate_that_there_is_not_is_told_of_the_last_that_was_asked_for():
    k, j, i = np.indices((41, 41, 41))
    inside = np.clip(10.5 - np.sqrt((i - 20) ** 2 + (j - 20) ** 2 + (k - 20) ** 2), 0, 1)
    volume = handlebody.Volume((200 - 180 * inside + 0.5 * np.sin(i + 37.1 * j + 1234.5 * k)).astype(np.float32))

    def told(first, then):
        contour = handlebody.Contour(volume, seed=(20, 20, 20), candidate=first)
        contour.run(1)
        contour.change(candidate=then)
        contour.run()
        return any("fewer objects" in warning for warning in contour.warnings())

    assert told(1, 5)
    assert not told(5, 1)


def test_the_mesh_is_certified_and_measured(ball, grown):
    certificate = grown.certificate()
    assert certificate["closed"] and certificate["manifold"] and certificate["oriented"]
    assert certificate["self_intersections"] == 0 and certificate["genus"] == [0]
    assert grown.mesh().certificate() == certificate
    measures = grown.measure()
    assert measures["volume_mm3"] == pytest.approx(4 / 3 * np.pi * 30**3, rel=0.03)
    assert measures["intensity"]["mean"] == pytest.approx(60, abs=10)
    assert grown.mesh().measure()["intensity"] is None
    assert grown.mesh().measure(ball.volume) == measures
    labels = grown.label_map()
    np.testing.assert_array_equal(grown.label_map(ball.truth.grid), labels)
    labels[:] *= 2  # the caller's own
    inside = grown.label_map().sum() * np.prod(ball.volume.grid.spacing)
    assert inside == pytest.approx(certificate["volume_mm3"], rel=0.02)


def test_a_report_has_what_the_command_line_writes(grown):
    report = grown.report()
    assert report["stopped"] == "converged" and report["iterations"] == grown.iteration
    assert report["mesh"] == grown.certificate() and report["measures"] == grown.measure()
    assert report["warnings"] == grown.warnings()
    assert report["input"]["size"] == list(grown.label_map().shape[::-1])
    assert grown.parameters["edge_length"] > 0 and grown.parameters["object"] == "dark"


@pytest.mark.parametrize("options, error, sentence", [
    ({"seed": (1e5, 0, 0)}, handlebody.SeedError, "outside"),
    ({}, handlebody.UsageError, "needs a seed or seed_ijk"),
    ({"seed": (1, 2)}, handlebody.UsageError, "seed: '1,2' is not X,Y,Z"),
    ({"seed": "a,b,c"}, handlebody.UsageError, "seed: 'a'"),
    ({"seed": object()}, TypeError, "seed: "),
    ({"seed": [(1, 2, None)]}, TypeError, "seed: "),
    ({"edge_length": -1}, handlebody.UsageError, "edge_length: '-1' is not above 0"),
    ({"edge_length": float("nan")}, handlebody.UsageError, "edge_length"),
    ({"edge_length": True}, TypeError, "edge_length: True"),
    ({"max_iterations": 2.5}, handlebody.UsageError, "max_iterations: '2.5' is not a whole number"),
    ({"candidate": 9}, handlebody.UsageError, "candidate"),
    ({"range": (3, 1)}, handlebody.UsageError, "range"),
    ({"object": "darkish"}, handlebody.UsageError, "object: 'darkish' is not auto, dark or bright"),
    ({"wall": (0, 0, 0, 0)}, handlebody.UsageError, "wall"),
    ({"edgelength": 1}, TypeError, "no option 'edgelength'"),
    ({"edge-length": 1}, TypeError, "no option 'edge-length'"),
    ({"walls": "/absent/map.nii"}, handlebody.InputError, "/absent/map.nii"),
    ({"veto": "x"}, handlebody.UsageError, "veto: 'x' is not ITERATION:X,Y,Z"),
    ({"wall_disc": "--range"}, handlebody.UsageError, "wall_disc: '--range' is not "),
    ({"start": "a.stl", "given": "--range.stl"}, handlebody.UsageError,
     r"^given: an object begins with one surface \(start\) or is one \(given\), not both\.$"),
])
def test_options_without_meaning_are_one_sentence(ball, options, error, sentence):
    if "seed" not in options and options:
        options = {"seed": ball.seed, **options}
    with pytest.raises(error, match=sentence):
        handlebody.Contour(ball.volume, **options)


def test_none_and_empty_lists_are_as_if_not_given(ball, grown):
    contour = handlebody.Contour(ball.volume, seed=ball.seed, edge_length=None, wall=[], background=None)
    contour.run()
    np.testing.assert_array_equal(contour.vertices, grown.vertices)


def test_a_veto_that_never_comes_is_told(ball):
    contour = handlebody.Contour(ball.volume, seed=ball.seed, veto="2000:1,2,3")
    with pytest.raises(handlebody.UsageError, match="veto of iteration 2000"):
        contour.run()


def test_a_label_map_of_walls_holds_the_surface(ball, grown, tmp_path):
    walls = np.zeros(ball.volume.grid.shape, np.uint8)
    x = int(ball.volume.grid.to_index(ball.seed[:3])[0]) + 6
    walls[:, :, x:] = 1
    handlebody.Volume(walls, ball.volume.grid.spacing, ball.volume.grid.origin).save(tmp_path / "walls.nrrd")
    contour = handlebody.Contour(ball.volume, seed=(*ball.seed[:3], 4), walls=tmp_path / "walls.nrrd")
    contour.run()
    assert (contour.label_map()[walls == 1]).sum() == 0
    assert contour.certificate()["volume_mm3"] < 0.9 * grown.certificate()["volume_mm3"]


def test_other_threads_work_while_the_contour_steps(torus):
    contour = handlebody.Contour(torus.volume, seed=torus.seed)
    refused, seen = [], set()
    worker = threading.Thread(target=contour.run)
    worker.start()
    while worker.is_alive():
        seen.add(contour.iteration)
        try:
            contour.vertices
        except RuntimeError as error:
            refused.append(str(error))
        time.sleep(0.002)
    worker.join()
    assert contour.stop_reason != "running"
    assert len(seen) > 3, "the interpreter was locked"
    assert refused and set(refused) == {"The contour is at work in another thread."}
    again = handlebody.Contour(torus.volume, seed=torus.seed)
    again.run()
    np.testing.assert_array_equal(again.vertices, contour.vertices)


INTERRUPTED = """
    import os, signal, sys, threading, time
    import numpy as np
    import handlebody
    signal.signal(signal.SIGINT, signal.default_int_handler)
    p = handlebody.phantom("cube", spacing=(1, 1, 1))
    contour = handlebody.Contour(p.volume, seed=p.seed)
    threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
    begin = time.monotonic()
    try:
        contour.run()
        sys.exit("it ended by itself")
    except KeyboardInterrupt:
        late = time.monotonic() - begin - 0.3
    assert late < 1.5, late
    at = contour.iteration
    assert contour.stop_reason == "running", at
    assert contour.certificate()["self_intersections"] == 0
    contour.run(2)
    other = handlebody.Contour(p.volume, seed=p.seed)
    other.run(at + 2)
    assert (contour.vertices == other.vertices).all()
    print("interrupted")
"""


def test_ctrl_c_ends_a_run_between_two_iterations():
    done = subprocess.run([sys.executable, "-c", textwrap.dedent(INTERRUPTED)], capture_output=True, text=True)
    assert done.stdout == "interrupted\n", done.stderr


def test_an_alarm_that_does_not_raise_disturbs_nothing(ball, grown):
    called = []
    before = signal.signal(signal.SIGALRM, lambda *_: called.append(1))
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.01, 0.01)
        contour = handlebody.Contour(ball.volume, seed=ball.seed)
        contour.run()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert called
    np.testing.assert_array_equal(contour.vertices, grown.vertices)


def test_a_leak_is_told_and_its_disc_closes_it():
    wall = handlebody.phantom("wall", gap=6)
    x, y, z, radius = wall.seed
    contour = handlebody.Contour(wall.volume, seed=wall.seed, range=(0, 120))
    contour.run(until_leak=True)
    assert contour.stop_reason == "running" and len(contour.leaks) == 1
    leak = contour.leaks[0]
    assert leak["iteration"] == contour.iteration and leak["option"] == "--wall-disc " + leak["wall_disc"]
    closed = handlebody.Contour(wall.volume, seed=wall.seed, range=(0, 120), wall_disc=leak["wall_disc"])
    closed.run()
    assert closed.leaks == []
    assert handlebody.compare(closed.mesh(), wall.truth)["dice"] > 0.98
    contour.run()
    assert any("wall_disc" in warning for warning in contour.warnings())
