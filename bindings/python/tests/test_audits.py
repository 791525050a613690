"""Sequences of frames."""

from __future__ import annotations

import numpy as np
import pytest

from exact_ccd import audit
from test_meshes import FACES, two_triangles


def frames(*heights: float) -> np.ndarray:
    return np.array([two_triangles(height) for height in heights])


def test_a_free_motion() -> None:
    done = []
    report = audit(frames(3, 2, 1), FACES, progress=done.append)
    assert report.is_free and report.frames == 3 and sum(done) == 3


def test_the_first_violation() -> None:
    done = []
    report = audit(frames(3, 1, -3, 1), FACES, progress=done.append)
    assert (report.frames, report.violation.frame, report.violation.contact.time) == (3, 1, 0.25)
    assert sum(done) == 3
    report = audit(frames(0, 1), FACES)
    # The tip touches the face: no edge passes through it.
    assert (report.frames, report.violation.frame, report.violation.intersection) == (1, 0, None)
    assert report.violation.contact.kind == "vf"
    # Two points at rest in one place.
    rods = audit(np.zeros((1, 4, 3)), np.empty((0, 3), int), edges=[[0, 1], [2, 3]])
    assert (rods.violation.frame, rods.violation.contact.kind) == (0, "ee")


def test_groups_and_rules() -> None:
    passing = frames(3, 1, -3)
    assert audit(passing, FACES, groups=[0] * 6).is_free
    assert audit(passing, FACES, groups=[0, 0, 0, 1, 1, 1]) == audit(passing, FACES)
    assert audit(passing, FACES, can_collide=lambda i, j: False).is_free
    # The rule holds for edges that meet faces at rest, too.
    assert audit(frames(-1), FACES, can_collide=lambda i, j: False).is_free
    with pytest.raises(ValueError, match="groups has the shape"):
        audit(passing, FACES, groups=[0])


def test_a_vertex_that_cannot_collide() -> None:
    # The tip passes through the face, and its edges follow.
    report = audit(frames(3, 1, -1), FACES, groups=[0, 0, 0, 0, 1, 1])
    violation = report.violation
    assert (report.frames, violation.frame, violation.contact) == (3, 2, None)
    assert violation.intersection[1] == 0
    assert audit(frames(3, 1, -1), FACES, can_collide=lambda i, j: {i, j} & {4, 5}) == report


def test_groups_of_files(tmp_path) -> None:
    np.savez(tmp_path / "recording.npz", positions=frames(3, 1, -3), faces=FACES)
    assert audit(tmp_path / "recording.npz", groups=[0] * 6).is_free
    assert not audit(tmp_path / "recording.npz", groups=[0, 0, 0, 1, 1, 1]).is_free
    # A name that is not in its shortest form.
    assert not audit(f"{tmp_path}/.//recording.npz", groups=[0, 0, 0, 1, 1, 1]).is_free


def test_an_iterator_that_reuses_its_array() -> None:
    def positions():
        array = np.empty((6, 3))
        for height in (3.0, 1.0, -3.0):
            array[...] = two_triangles(height)
            yield array

    assert audit(positions(), FACES).violation.contact.time == 0.25


def test_files(tmp_path) -> None:
    for number, height in zip((2, 9, 10), (3.0, 1.0, -3.0)):
        vertices = "".join("v {} {} {}\n".format(*v) for v in two_triangles(height).tolist())
        (tmp_path / f"frame{number}.obj").write_text(vertices + "f 1 2 3\nf 4 5 6\n")
    expected = audit(frames(3, 1, -3), FACES)
    for form in (tmp_path, str(tmp_path), sorted(tmp_path.iterdir(), key=lambda f: int(f.stem[5:]))):
        report = audit(form)
        assert (report.frames, report.violation.frame) == (expected.frames, 1)
        assert report.violation.contact.time == expected.violation.contact.time
    (tmp_path / "frame11.obj").write_text("v 0 0 0\n")
    (tmp_path / "frame10.obj").unlink()
    with pytest.raises(ValueError, match="frame11.obj has other faces"):
        audit(tmp_path)


def test_stl_files_are_welded(tmp_path) -> None:
    # Two faces with a common edge, whose copies would touch, and one that falls through them.
    faces = [[0, 1, 2], [2, 1, 3], [4, 5, 6]]
    below = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [4, 4, 0]]
    positions = np.array([[*below, [1, 1, z], [1, 2, z + 4], [2, 1, z + 4]] for z in (3, 1, -3)], float)
    for number, frame in enumerate(positions):
        text = "".join(
            "facet normal 0 0 0\nouter loop\n"
            + "".join("vertex {} {} {}\n".format(*vertex) for vertex in frame[face].tolist())
            + "endloop\nendfacet\n"
            for face in faces
        )
        (tmp_path / f"frame{number}.stl").write_text(f"solid\n{text}endsolid\n")
    expected = audit(positions, faces)
    report = audit(tmp_path)
    assert (report.frames, report.violation.frame) == (expected.frames, 1) == (3, 1)
    assert report.violation.contact.time == expected.violation.contact.time == 0.25


def test_files_with_several_frames(tmp_path) -> None:
    expected = audit(frames(3, 1, -3), FACES)
    np.savez(tmp_path / "recording.npz", positions=frames(3, 1, -3), faces=FACES)
    listed = ""
    for number, height in enumerate((3.0, 1.0, -3.0)):
        vertices = "".join("{} {} {}\n".format(*v) for v in two_triangles(height).tolist())
        text = f"OFF\n6 2 0\n{vertices}3 0 1 2\n3 3 4 5\n"
        (tmp_path / f"frame{number}.off").write_text(text)
        listed += f'<DataSet timestep="{number}" file="frame{number}.off"/>'
    (tmp_path / "all.pvd").write_text(
        f'<?xml version="1.0"?><VTKFile type="Collection"><Collection>{listed}</Collection></VTKFile>'
    )
    for file in ("recording.npz", "all.pvd"):
        report = audit(tmp_path / file)
        assert (report.frames, report.violation.frame) == (expected.frames, 1), file
        assert report.violation.contact.time == expected.violation.contact.time
    assert audit([tmp_path / "frame0.off", tmp_path / "frame1.off"]).is_free


def test_errors(tmp_path) -> None:
    with pytest.raises(ValueError, match="there are no frames"):
        audit([], FACES)
    with pytest.raises(TypeError, match="expected the faces"):
        audit(frames(3, 1))
    bad = frames(3, 2, 1)
    bad[1, 4, 2] = np.inf
    with pytest.raises(ValueError, match="frame 1: .*vertex 4 has z = inf"):
        audit(bad, FACES)
    with pytest.raises(ValueError, match="frame 1: "):
        audit([two_triangles(3.0), two_triangles(2.0)[:5]], FACES)
    with pytest.raises(OSError, match="missing.ply"):
        audit(tmp_path / "missing.ply")
    with pytest.raises(ValueError, match="mesh files of one format"):
        audit(tmp_path)
    with pytest.raises(TypeError, match="come from the files"):
        audit(["frame.ply"], FACES)
