"""Steps of `exact_ccd.ipc` beside all pairs of primitives, without ipctk."""

from __future__ import annotations

import gc
import weakref
from itertools import combinations
from types import SimpleNamespace
from typing import Optional

import numpy as np
import pytest

import exact_ccd
from exact_ccd import Queries, ipc
from exact_ccd.ipc import steps
from plane import first_meeting


def test_two_points_that_swap_places() -> None:
    x0 = np.array([[0.0, 0.0], [1.0, 0.0]])
    x1 = x0[::-1]
    mesh = SimpleNamespace(num_vertices=2, edges=np.empty((0, 2), int), faces=np.empty((0, 3), int))
    assert not ipc.is_step_collision_free(mesh, x0, x1)
    assert ipc.compute_collision_free_stepsize(mesh, x0, x1) == 0.45
    candidates = ipc.Candidates()
    candidates.build(mesh, x0, x1)
    assert len(candidates) == 1 and not candidates.is_step_collision_free(mesh, x0, x1)
    # The same beside a distance: they begin at the distance 1.
    assert ipc.compute_collision_free_stepsize(mesh, x0, x1, 0.5, conservative_rescaling=1.0) == pytest.approx(0.25)


def edges_of(random: np.random.Generator, count: int) -> list[tuple[int, int]]:
    """Some edges of the vertices, so that others have none."""
    every = list(combinations(range(count - 2), 2))
    return [every[i] for i in random.choice(len(every), random.integers(0, 4), replace=False)]


def earliest_in_the_plane(edges, x0: np.ndarray, x1: np.ndarray) -> Optional[float]:
    """The first meeting of any vertex with an edge, or of two vertices of no edge."""
    paths = list(zip(x0.tolist(), x1.tolist()))
    loose = sorted(set(range(len(paths))) - {v for edge in edges for v in edge})
    pairs = [(v, *edge) for v in range(len(paths)) for edge in edges if v not in edge]
    pairs += [(v, w, w) for v, w in combinations(loose, 2)]
    times = [first_meeting(*(paths[v] for v in pair)) for pair in pairs]
    return min((time for time in times if time is not None), default=None)


def check(mesh, x0: np.ndarray, x1: np.ndarray, expected: Optional[float]) -> None:
    """Both ways agree with the times of all pairs."""
    candidates = ipc.Candidates()
    candidates.build(mesh, x0, x1)
    for way in (ipc, candidates):
        assert way.is_step_collision_free(mesh, x0, x1) == (expected is None)
        size = way.compute_collision_free_stepsize(mesh, x0, x1, conservative_rescaling=1.0)
        assert size == (1.0 if expected is None else pytest.approx(expected, rel=1e-6))


def test_random_steps_in_the_plane() -> None:
    random = np.random.default_rng(0)
    free = 0
    for _ in range(300):
        count = int(random.integers(5, 8))
        edges = edges_of(random, count)
        x0 = random.integers(-4, 5, (count, 2)).astype(float)
        x1 = x0 + random.integers(-3, 4, (count, 2))
        mesh = SimpleNamespace(
            num_vertices=count, edges=np.array(edges, int).reshape(-1, 2), faces=np.empty((0, 3), int)
        )
        expected = earliest_in_the_plane(edges, x0, x1)
        free += expected is None
        check(mesh, x0, x1, expected)
    assert 50 < free < 250


def earliest_in_space(edges, faces, x0: np.ndarray, x1: np.ndarray) -> Optional[float]:
    """The first contact of any pair of primitives, by single queries."""
    sides = {tuple(sorted(side)) for a, b, c in faces for side in ((a, b), (b, c), (c, a))}
    loose_edges = [edge for edge in edges if tuple(sorted(edge)) not in sides]
    every = [*sides, *loose_edges]
    vertices = range(len(x0))
    loose = [v for v in vertices if not any(v in primitive for primitive in [*every, *faces])]
    pairs = {
        "vf": [((v,), face) for v in vertices for face in faces],
        "ee": list(combinations(every, 2)),
        "ve": [((v,), edge) for v in vertices for edge in loose_edges],
        "vv": [((v,), (w,)) for v, w in combinations(loose, 2)],
    }
    times = []
    for kind, of_kind in pairs.items():
        fours = [[*a, *b] for a, b in of_kind if not {*a} & {*b}]
        if fours:
            queries = Queries(kind, x0, x1, fours)
            times += queries.time_of_impact().tolist()
    return min((time for time in times if not np.isnan(time)), default=None)


def test_random_steps_in_space() -> None:
    random = np.random.default_rng(1)
    free = 0
    for case in range(300):
        count = int(random.integers(5, 9))
        edges = edges_of(random, count)
        faces = [tuple(random.choice(count - 2, 3, replace=False).tolist()) for _ in range(random.integers(0, 3))]
        sides = [side for a, b, c in faces for side in ((a, b), (b, c), (c, a))]
        edges = list({tuple(sorted(edge)) for edge in [*edges, *sides]})
        x0 = random.integers(-4, 5, (count, 3)).astype(float)
        # Many points move in one plane or in one line: those that have no faces meet only there.
        x1 = x0 + random.integers(-2, 3, (count, 3)) * np.array([1, 1, case % 2])
        x0[:, 2 - case % 3 :] = x1[:, 2 - case % 3 :] = 0.0
        mesh = SimpleNamespace(
            num_vertices=count,
            edges=np.array(edges, int).reshape(-1, 2),
            faces=np.array(faces, int).reshape(-1, 3),
        )
        expected = earliest_in_space(edges, faces, x0, x1)
        free += expected is None
        check(mesh, x0, x1, expected)
    assert 20 < free < 280


def test_the_size_1_is_that_of_the_end_itself() -> None:
    """Vertex 3 touches the face at t = 1; the sum x0 + (x1 - x0) is rounded to the side where it begins."""
    height = 1e-17
    x0 = np.array([[0, 0, height], [1, 0, height], [0, 1, height], [0.25, 0.25, -1]])
    x1 = x0.copy()
    x1[3, 2] = height
    mesh = SimpleNamespace(num_vertices=4, edges=np.array([[0, 1], [1, 2], [2, 0]]), faces=np.array([[0, 1, 2]]))
    candidates = ipc.Candidates()
    candidates.build(mesh, x0, x1)
    for way in (ipc, candidates):
        assert not way.is_step_collision_free(mesh, x0, x1)
        size = way.compute_collision_free_stepsize(mesh, x0, x1, conservative_rescaling=1.0)
        assert size == np.nextafter(1.0, 0.0)


def test_positions_of_another_dimension() -> None:
    x, flat = np.zeros((2, 3)), np.zeros((2, 2))
    meshes = [ipc.CollisionMesh(x), SimpleNamespace(num_vertices=2, edges=[], faces=[])]
    for mesh, ends, message in (
        (meshes[0], (flat, flat), "vertices_t0 has 2 columns, expected 3"),
        (meshes[1], (flat, x), "vertices_t1 has 3 columns, expected 2"),
        (meshes[1], (x, flat), "vertices_t1 has 2 columns, expected 3"),
        (ipc.CollisionMesh(flat), (x, x), "vertices_t0 has 3 columns, expected 2"),
    ):
        for call in (ipc.is_step_collision_free, ipc.compute_collision_free_stepsize, ipc.Candidates().build):
            with pytest.raises(ValueError, match=message):
                call(mesh, *ends)
    with pytest.raises(ValueError, match="vertices_t0 has 2 columns, expected 3"):
        ipc.has_intersections(meshes[0], flat)


def test_detectors_are_kept() -> None:
    """By the distance, without a rule if the mesh has none; at most some of each mesh."""
    mesh = ipc.CollisionMesh(np.zeros((2, 3)))
    x0 = np.array([[0.0, 0, 0], [4, 0, 0]])

    def detector(distance: float, x: np.ndarray = x0) -> exact_ccd.Detector:
        ipc.is_step_collision_free(mesh, x, x, distance)
        with steps._detector(mesh, distance) as kept:
            return kept

    contact, near = detector(0.0), detector(0.25)
    assert detector(0.0) is contact and detector(0.25) is near is not contact
    assert contact.mesh.can_collide is None
    mesh.can_collide = lambda i, j: False
    assert detector(0.0) is not contact and not steps.has_intersections(mesh, x0)
    assert ipc.is_step_collision_free(mesh, x0, x0[::-1])
    mesh.can_collide = None
    assert not ipc.is_step_collision_free(mesh, x0, x0[::-1]) and detector(0.0) is contact
    for distance in range(1, 9):
        detector(distance)
    assert detector(8.0) is detector(8.0) and detector(0.0) is not contact

    # A rule that has its mesh does not keep it alive.
    mesh.can_collide = lambda i, j, mesh=mesh: mesh is not None
    assert not ipc.is_step_collision_free(mesh, x0, x0[::-1])
    alive = weakref.ref(mesh)
    del mesh, detector, contact, near
    gc.collect()
    assert alive() is None


def test_a_rod_that_folds_through_its_neighbour() -> None:
    """The edges (0, 1) and (0, 2) have a common vertex; vertex 2 passes through the edge (0, 1) at t = 1/2."""
    x0 = np.array([[0.0, 0, 0], [2, 0, 0], [1, 0, 1]])
    x1 = x0 - [0, 0, 2] * (np.arange(3) == 2)[:, None]
    mesh = SimpleNamespace(num_vertices=3, edges=np.array([[0, 1], [0, 2]]), faces=np.empty((0, 3), int))
    check(mesh, x0, x1, 0.5)
    # A distance says nothing about a fold: the angle of a rod is near, always.
    candidates = ipc.Candidates()
    candidates.build(mesh, x0, x1, 1.0)
    for way in (ipc, candidates):
        assert way.is_step_collision_free(mesh, x0, x0, 1.5)
        assert not way.is_step_collision_free(mesh, x0, x1, 1.5)
