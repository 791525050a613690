"""Meshes in motion."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_array_equal

import exact_ccd
from exact_ccd import Detector, Mesh, Queries

FLOOR = [[0, 0, 0], [8, 0, 0], [0, 8, 0]]


def two_triangles(z: float, x: float = 1.0) -> np.ndarray:
    return np.array([*FLOOR, [x, 1, z], [x, 2, z + 4], [x + 1, 1, z + 4]], float)


FACES = [[0, 1, 2], [3, 4, 5]]


def soup(seed: int, triangles: int = 40) -> tuple[Mesh, np.ndarray, np.ndarray]:
    """Triangles that share no vertices, rods and points, in motion."""
    random = np.random.default_rng(seed)
    count = 3 * triangles
    faces = np.arange(count).reshape(-1, 3)
    edges = count + np.arange(20).reshape(-1, 2)
    total = count + 30
    centres = np.repeat(random.uniform(-3, 3, (total // 2, 3)), 2, axis=0)
    x0 = centres + random.normal(0, 0.5, (total, 3))
    return Mesh(total, faces, edges), x0, x0 + random.normal(0, 0.5, (total, 3))


def all_pairs(mesh: Mesh, x0: np.ndarray, x1: np.ndarray) -> dict[tuple[str, int, int], float]:
    """The earliest contact of every pair, by the queries alone."""
    times = {}
    v, f = np.meshgrid(np.arange(mesh.vertex_count), np.arange(len(mesh.faces)), indexing="ij")
    a, b = np.triu_indices(len(mesh.edges), 1)
    lists = {
        "vf": (v.ravel(), f.ravel(), np.column_stack([v.ravel(), mesh.faces[f.ravel()]])),
        "ee": (a, b, np.hstack([mesh.edges[a], mesh.edges[b]])),
    }
    for kind, (first, second, indices) in lists.items():
        split = 1 if kind == "vf" else 2
        apart = np.array([not set(row[:split]) & set(row[split:]) for row in indices.tolist()])
        toi = Queries(kind, x0, x1, indices[apart]).time_of_impact()
        for i, j, time in zip(first[apart], second[apart], toi):
            if not np.isnan(time):
                times[kind, int(i), int(j)] = float(time)
    return times


@pytest.mark.parametrize("seed", range(3))
def test_the_contacts_are_those_of_all_pairs(seed: int) -> None:
    mesh, x0, x1 = soup(seed)
    expected = all_pairs(mesh, x0, x1)
    assert expected
    detector = Detector(mesh, threads=2)
    contacts = detector.collisions(x0, x1)
    assert contacts.dtype == exact_ccd.CONTACT
    found = {(str(c["kind"]), int(c["first"]), int(c["second"])): float(c["time"]) for c in contacts}
    assert found == expected
    assert (np.diff(contacts["time"]) >= 0).all()
    report = detector.step(x0, x1)
    assert sum(report.colliding) == len(expected)
    earliest = detector.collision(x0, x1)
    assert earliest.time == min(expected.values()) == report.earliest.time
    assert detector.collides(x0, x1)
    # The time of a contact may lie just above the float64 that it is rounded down to.
    middle = float(np.nextafter(np.median(contacts["time"]), 1.0))
    assert len(detector.collisions(x0, x1, until=middle)) == (contacts["time"] <= middle).sum()
    for wrong in (np.nan, -1.0, np.inf):
        with pytest.raises(ValueError, match="from 0 to 1"):
            detector.collisions(x0, x1, until=wrong)


def test_contact_fields() -> None:
    detector = Detector(Mesh(6, FACES))
    contact = detector.collision(two_triangles(1.0), two_triangles(-1.0))
    assert (contact.kind, contact.first, contact.second) == ("vf", 3, 0)
    assert contact.vertices.tolist() == [3, 0, 1, 2]
    assert (contact.time, contact.u, contact.v) == (0.5, 0.125, 0.125)
    assert contact.normal.tolist() == [0.0, 0.0, 1.0]
    assert contact.points.tolist() == [[1.0, 1.0, 0.0], [1.0, 1.0, 0.0]]
    assert detector.collision(two_triangles(1.0), two_triangles(0.5)) is None


def test_free_steps_are_free() -> None:
    detector = Detector(Mesh(6, FACES))
    x0 = two_triangles(1.0)
    free = detector.free_step(x0, two_triangles(-1.0))
    assert free.size == 0.45 and free.contact.time == 0.5
    assert not detector.collides(x0, free.positions)
    full = detector.free_step(x0, two_triangles(0.5))
    assert full.size == 1.0 and full.contact is None
    assert_array_equal(full.positions, two_triangles(0.5))
    touching = detector.free_step(two_triangles(0.0), two_triangles(1.0))
    assert touching.size == 0.0
    with pytest.raises(ValueError, match="keep"):
        detector.free_step(x0, x0, keep=0.0)


def test_a_step_may_have_no_positive_size() -> None:
    x0 = np.array([*FLOOR, [1.0, 1.0, 1.5e-323]])
    x1 = np.array([*FLOOR, [1.0, 1.0, -1e300]])
    step = Detector(Mesh(4, FACES[:1])).free_step(x0, x1)
    # Free at the start, and in contact after a part of the step below the smallest number.
    assert step.size == 0.0 and sum(step.touching) == 0
    assert step.contact.time == 0.0
    assert_array_equal(step.positions, x0)


def test_groups_and_rules() -> None:
    x0, x1 = two_triangles(1.0), two_triangles(-1.0)
    same = Detector(Mesh(6, FACES, groups=[0] * 6))
    assert not same.collides(x0, x1)
    assert Detector(Mesh(6, FACES, groups=[0, 0, 0, 1, 1, 1])).collides(x0, x1)

    calls = []
    never = Detector(Mesh(6, FACES, can_collide=lambda i, j: calls.append((i, j))))
    assert not never.collides(x0, x1) and never.collision(x0, x1) is None
    assert len(never.collisions(x0, x1)) == 0 and never.free_step(x0, x1).size == 1.0
    assert (3, 0) in calls
    assert never.step(x0, x1).candidates == (0, 0, 0, 0)
    resting = never.free_step(two_triangles(0.0), two_triangles(0.0))
    assert (resting.size, sum(resting.touching)) == (1.0, 0)
    one = Detector(Mesh(6, FACES, can_collide=lambda i, j: {i, j} == {3, 2}))
    assert one.collision(x0, x1).first == 3
    assert len(one.intersections(two_triangles(-1.0))) == 2


def test_the_calls_of_a_rule() -> None:
    x0, x1 = two_triangles(1.0), two_triangles(-1.0)
    calls: set[tuple[int, int]] = set()

    def called(method: str, *positions: np.ndarray, answer: bool) -> set[tuple[int, int]]:
        calls.clear()
        rule = Mesh(6, FACES, can_collide=lambda i, j: calls.add((i, j)) or answer)
        getattr(Detector(rule), method)(*positions)
        return set(calls)

    in_contact = set()
    for contact in Detector(Mesh(6, FACES)).collisions(x0, x1):
        split = 2 if contact["kind"] == "ee" else 1
        first, second = contact["vertices"][:split].tolist(), contact["vertices"][split:].tolist()
        in_contact |= {(v, w) for v in first for w in second}
    for answer in (False, True):
        for method in ("collides", "collisions"):
            assert called(method, x0, x1, answer=answer) <= in_contact
    assert called("intersections", x0, answer=False) == set()
    # The sides of the falling face that meet the floor.
    assert called("intersections", x1, answer=False) == {(v, w) for v in (3, 4, 5) for w in (0, 1, 2)}
    assert called("step", x0, x1, answer=False) > in_contact
    for method in ("collision", "free_step"):
        assert called(method, x0, x1, answer=True) == {(3, 0)}
        assert called(method, x0, x1, answer=False) > in_contact
    resting = two_triangles(0.0)
    assert called("collision", resting, resting, answer=True) == {(3, 0)}
    assert called("free_step", resting, resting, answer=True) > {(3, 0)}


def test_a_rule_gives_the_same_answers_as_groups() -> None:
    mesh, x0, x1 = soup(7)
    groups = np.arange(mesh.vertex_count) // 30
    grouped = Detector(Mesh(mesh.vertex_count, mesh.faces, mesh.loose_edges, groups=groups))
    rule = Mesh(mesh.vertex_count, mesh.faces, mesh.loose_edges, can_collide=lambda i, j: groups[i] != groups[j])
    ruled = Detector(rule)
    assert_array_equal(grouped.collisions(x0, x1), ruled.collisions(x0, x1))
    assert grouped.collision(x0, x1)[:4][3].tolist() == ruled.collision(x0, x1).vertices.tolist()
    assert grouped.free_step(x0, x1).size == ruled.free_step(x0, x1).size
    assert grouped.step(x0, x1)[:3] == ruled.step(x0, x1)[:3]


def test_an_exception_of_a_rule_is_passed_on() -> None:
    def fails(i: int, j: int) -> bool:
        raise RuntimeError("the rule fails")

    detector = Detector(Mesh(6, FACES, can_collide=fails))
    x0, x1 = two_triangles(1.0), two_triangles(-1.0)
    for call in (detector.collides, detector.collision, detector.collisions, detector.free_step, detector.step):
        with pytest.raises(RuntimeError, match="the rule fails"):
            call(x0, x1)
    # The detector is as good as new.
    assert not detector.collides(x0, x0)


def test_progress() -> None:
    mesh, x0, x1 = soup(1)
    done = []
    report = Detector(mesh).step(x0, x1, progress=done.append)
    assert sum(done) == sum(report.candidates)

    def fails(count: int) -> None:
        raise RuntimeError("no progress")

    with pytest.raises(RuntimeError, match="no progress"):
        Detector(mesh).step(x0, x1, progress=fails)


def test_errors() -> None:
    with pytest.raises(ValueError, match="face 0 names vertex 9, but there are only 4"):
        Mesh(4, [[0, 1, 9]])
    with pytest.raises(ValueError, match="edge 1 names vertex 4"):
        Mesh(4, [[0, 1, 2]], edges=[[0, 3], [3, 4]])
    with pytest.raises(ValueError, match="groups has the shape"):
        Mesh(4, [[0, 1, 2]], groups=[0, 1])
    with pytest.raises(TypeError, match="can_collide is not callable"):
        Mesh(4, [[0, 1, 2]], can_collide=3)
    with pytest.raises((OverflowError, ValueError)):
        Mesh(-1, [])
    detector = Detector(Mesh(6, FACES))
    x = two_triangles(1.0)
    with pytest.raises(ValueError, match="x1 has the shape"):
        detector.collides(x, x[:5])
    x[4, 1] = np.nan
    with pytest.raises(ValueError, match="vertex 4 has y = NaN"):
        detector.collisions(x, two_triangles(0.0))
    with pytest.raises(ValueError, match="threads"):
        Detector(Mesh(6, FACES), threads=0).collides(two_triangles(1.0), two_triangles(1.0))


def test_mesh_files(tmp_path) -> None:
    file = tmp_path / "rod.obj"
    file.write_text("v 0 0 0\nv 0.1 0 0\nv 0 1 0\nv 0 2 0\nf 1 2 3\nl 3 4\n")
    vertices, faces, edges = exact_ccd.read_mesh(file)
    assert vertices.tolist() == [[0, 0, 0], [0.1, 0, 0], [0, 1, 0], [0, 2, 0]]
    assert (faces.tolist(), edges.tolist()) == ([[0, 1, 2]], [[2, 3]])
    with pytest.raises(OSError):
        exact_ccd.read_mesh(tmp_path / "none.ply")
    file.write_text("v 0 0 zero")
    with pytest.raises(ValueError, match="line 1: expected a number"):
        exact_ccd.read_mesh(file)


def test_facts_of_a_file_that_could_change_an_answer_are_warnings(tmp_path) -> None:
    file = tmp_path / "plane.obj"
    file.write_text("v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n")
    with pytest.warns(UserWarning, match="plane.obj: line 1: the vertices have two coordinates"):
        exact_ccd.read_mesh(file)
    with pytest.warns(UserWarning, match="plane.obj: line 1: the vertices have two coordinates"):
        assert exact_ccd.audit([file]).is_free


def test_minimum_distance() -> None:
    mesh = Mesh(6, FACES)
    x0, x1 = two_triangles(2.25), two_triangles(0.25)
    assert not Detector(mesh).collides(x0, x1)
    for distance in (1.0, np.array([0.25] * 3 + [0.75, 0.0, 0.0])):
        detector = Detector(mesh, min_distance=distance)
        contact = detector.collision(x0, x1)
        assert contact.time == 0.625 and contact.distance.tolist() == [1.0, 1.0]
        assert detector.collisions(x0, x1)["time"].tolist() == [0.625]
        assert detector.step(x0, x1).colliding == (1, 0, 0, 0)
        step = detector.free_step(x0, x1)
        assert step.size == pytest.approx(0.5625) and step.touching == (0, 0, 0, 0)
    assert exact_ccd.audit([x0, x1], FACES, min_distance=1.0).violation.contact.time == 0.625
    near = two_triangles(0.75)
    assert Detector(mesh, min_distance=1.0).collides(near, x1)
    moves_on = Detector(mesh, min_distance=1.0, inner_distance=0.125)
    assert not moves_on.collides(near, x1)
    assert moves_on.free_step(near, x1).touching == (1, 0, 0, 0)


def test_loose_vertices_and_edges() -> None:
    """A rod on the x-axis, a vertex that falls on it, and one that meets the other vertex."""
    mesh = Mesh(4, np.empty((0, 3), int), edges=[[0, 1]])
    x0 = np.array([[-1.0, 0, 0], [1, 0, 0], [0, 0, 1], [0, 4, 1]])
    x1 = np.array([[-1.0, 0, 0], [1, 0, 0], [0, 0, -3], [0, -4, -3]])
    contacts = Detector(mesh).collisions(x0, x1)
    assert contacts["kind"].tolist() == ["ve", "vv"]
    assert contacts["time"].tolist() == [0.25, 0.5]
    assert contacts["vertices"].tolist() == [[2, 0, 1, -1], [2, 3, -1, -1]]


def test_wrong_distances() -> None:
    mesh = Mesh(6, FACES)
    for wrong in (-1.0, np.nan, np.inf, [1.0] * 5, [-1.0] * 6):
        with pytest.raises(ValueError):
            Detector(mesh, min_distance=wrong)
    with pytest.raises(ValueError):
        Detector(mesh, inner_distance=-1.0)
