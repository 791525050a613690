"""The meshes of `exact_ccd.ipc`, and the lists of its candidates, beside ipctk where it is installed."""

from __future__ import annotations

import copy
import pickle
from types import SimpleNamespace

import numpy as np
import pytest

from exact_ccd import Mesh, ipc
from exact_ccd.ipc import EdgeEdgeCandidate, EdgeVertexCandidate, FaceVertexCandidate, VertexVertexCandidate

FACES = np.array([[0, 1, 2], [1, 3, 2]], np.int32)
EDGES = np.array([[0, 1], [1, 2], [2, 0], [1, 3], [3, 2], [4, 5]], np.int32)


def motion(seed: int, count: int = 8, dim: int = 3) -> tuple[np.ndarray, np.ndarray]:
    random = np.random.default_rng(seed)
    x0 = random.uniform(-1, 1, (count, dim))
    return x0, x0 + random.normal(0, 0.7, (count, dim))


def test_all_kinds_of_meshes_are_one() -> None:
    verdicts = set()
    for seed in range(40):
        x0, x1 = motion(seed)
        groups = np.random.default_rng(seed).integers(0, 3, 8)

        def rule(i: int, j: int) -> bool:
            return bool(groups[i] != groups[j])

        own = ipc.CollisionMesh(x0, EDGES, FACES)
        own.can_collide = rule
        plain = SimpleNamespace(num_vertices=8, edges=EDGES, faces=FACES, can_collide=rule)
        meshes = [own, plain, Mesh(8, FACES, EDGES, groups=groups), Mesh(8, FACES, EDGES, can_collide=rule)]
        answers = []
        for mesh in meshes:
            candidates = ipc.Candidates()
            candidates.build(mesh, x0, x1)
            answers.append(
                [
                    ipc.is_step_collision_free(mesh, x0, x1),
                    ipc.compute_collision_free_stepsize(mesh, x0, x1),
                    ipc.is_step_collision_free(mesh, x0, x1, 0.01),
                    ipc.has_intersections(mesh, x1),
                    candidates.is_step_collision_free(mesh, x0, x1),
                    # The edges of a Mesh have another order.
                    sorted(map(len, (candidates.vv_candidates, candidates.ev_candidates))),
                    len(candidates),
                ]
            )
        assert answers[1:] == answers[:-1]
        verdicts.add(answers[0][0])
    assert verdicts == {False, True}


def test_the_lists() -> None:
    x0, x1 = motion(3)
    mesh = ipc.CollisionMesh(x0, EDGES, FACES)
    candidates = ipc.Candidates()
    candidates.build(mesh, x0, x1, 0.5)
    lists = [
        candidates.vv_candidates,
        candidates.ev_candidates,
        candidates.ee_candidates,
        candidates.fv_candidates,
    ]
    types = [VertexVertexCandidate, EdgeVertexCandidate, EdgeEdgeCandidate, FaceVertexCandidate]
    for of, items in zip(types, lists):
        assert items and all(isinstance(item, of) for item in items)
    every = [item for items in lists for item in items]
    assert [*candidates] == every == [candidates[i] for i in range(len(candidates))]
    assert candidates[-1] == every[-1] and not candidates.empty()
    for wrong in (len(every), -len(every) - 1):
        with pytest.raises(IndexError, match=f"candidate {wrong}, but there are only {len(every)}"):
            candidates[wrong]
    # The items have the vertices of the pairs.
    rows = [item.vertex_ids(mesh.edges, mesh.faces) for item in every]
    assert rows == [row for kind in ("vv", "ve", "ee", "vf") for row in candidates.pairs[kind].tolist()]
    assert len({*every}) == len(every) and EdgeEdgeCandidate(0, 3) != FaceVertexCandidate(0, 3)
    candidates.clear()
    assert candidates.empty() and [*candidates] == [] and candidates.fv_candidates == []


@pytest.mark.parametrize("dim", [2, 3])
def test_the_lists_are_those_of_ipctk(dim: int) -> None:
    ipctk = pytest.importorskip("ipctk", reason="ipctk is not installed: pip install ipctk")
    counts = np.zeros(4, int)
    for seed in range(30):
        x0, x1 = motion(seed, dim=dim)
        faces = FACES if dim == 3 else np.empty((0, 3), np.int32)
        edges = EDGES if dim == 3 else EDGES[3:]
        theirs, ours = ipctk.Candidates(), ipc.Candidates()
        mesh = ipctk.CollisionMesh(x0, edges, faces)
        # Its boxes are rounded to float32: a radius, so that no pair is on the edge.
        theirs.build(mesh, x0, x1, 0.01, ipctk.BruteForce())
        ours.build(mesh, x0, x1, 0.01)

        def ids(candidates) -> list[set[tuple[int, ...]]]:
            lists = {
                "vv_candidates": ("vertex0_id", "vertex1_id"),
                "ev_candidates": ("edge_id", "vertex_id"),
                "ee_candidates": ("edge0_id", "edge1_id"),
                "fv_candidates": ("face_id", "vertex_id"),
            }
            rows = [
                [tuple(getattr(item, name) for name in names) for item in getattr(candidates, listed)]
                for listed, names in lists.items()
            ]
            symmetric = [sorted(row) if i % 2 == 0 else row for i, of in enumerate(rows) for row in of]
            assert len(symmetric) == len(candidates)
            return [{tuple(sorted(row)) if i % 2 == 0 else row for row in of} for i, of in enumerate(rows)]

        assert ids(ours) == ids(theirs)
        counts += [len(of) for of in ids(ours)]
    assert (counts > 0).tolist() == [True, True, dim == 3, dim == 3]


def test_the_attributes_of_a_mesh() -> None:
    x, _ = motion(0)
    mesh = ipc.CollisionMesh(x, EDGES, FACES)
    part = ipc.CollisionMesh.build_from_full_mesh(x, EDGES, FACES)
    assert repr(mesh) == "<exact_ccd.ipc.CollisionMesh: dimension 3, 8 vertices, 6 edges, 2 faces>"
    assert part.vertices(x).tolist() == x[:6].tolist()
    assert part.displace_vertices(x).tolist() == (2 * x[:6]).tolist()
    assert [part.to_full_vertex_id(i) for i in range(6)] == [*range(6)]
    ipctk = pytest.importorskip("ipctk", reason="ipctk is not installed: pip install ipctk")
    peers = [ipctk.CollisionMesh(x, EDGES, FACES), ipctk.CollisionMesh.build_from_full_mesh(x, EDGES, FACES)]
    for ours, theirs in zip((mesh, part), peers):
        for name in (
            "num_vertices num_edges num_faces num_codim_vertices num_codim_edges dim ndof full_num_vertices "
            "full_ndof rest_positions edges faces codim_vertices codim_edges"
        ).split():
            assert np.array_equal(getattr(ours, name), getattr(theirs, name)), name
    assert ipc.edges(FACES).tolist() == ipctk.edges(FACES).tolist()


def test_a_mesh_is_kept_but_its_rule_is_not() -> None:
    x0 = np.array([[0.0, 0, 0], [1, 0, 0]])
    mesh = ipc.CollisionMesh(x0)
    assert not ipc.is_step_collision_free(mesh, x0, x0[::-1])
    mesh.can_collide = lambda i, j: False
    assert ipc.is_step_collision_free(mesh, x0, x0[::-1])
    mesh.can_collide = None
    twin = pickle.loads(pickle.dumps(mesh))
    assert not ipc.is_step_collision_free(twin, x0, x0[::-1])
    assert copy.deepcopy(mesh).edges.shape == (0, 2)
    with pytest.raises(ValueError, match="read-only"):
        mesh.rest_positions[0] = 3.0
