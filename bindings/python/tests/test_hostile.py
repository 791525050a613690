"""Hostile arguments: an exception or a right answer, never a crash."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

import exact_ccd
from exact_ccd import ipc
from exact_ccd.queries import POINTS
from hostile import CASES, integers, positions, survive, table


@pytest.mark.parametrize("kind", POINTS)
@pytest.mark.parametrize("name", ["collides", "time_of_impact", "count", "intervals", "impact"])
def test_queries(name: str, kind: str) -> None:
    random = np.random.default_rng(len(name))
    answers = 0
    for _ in range(CASES):
        d = float(random.choice([0.0, 0.0, 1.0, 5e-324, 1.7e308, -1.0, np.nan, np.inf]))
        options = {"separation": d, "threads": [None, None, 1, 2, 0, -1][random.integers(6)]}
        if random.random() < 0.3:
            options["until"] = float(random.choice([0.0, 0.5, -1.0, np.inf, np.nan]))

        def call(shape: tuple[int, ...], vertices: object) -> None:
            queries = exact_ccd.Queries(kind, positions(random, *shape), positions(random, *shape), vertices)
            getattr(queries, name)(**options)

        answers += survive(lambda: call((4, POINTS[kind], 3), None))
        answers += survive(lambda: call((6, 3), integers(random, 6, 5, POINTS[kind])))
    assert 10 < answers < 2 * CASES


@pytest.mark.parametrize(
    "name", ["collides", "collision", "collisions", "free_step", "free_steps", "step", "intersections", "audit"]
)
def test_meshes(name: str) -> None:
    random = np.random.default_rng(len(name))
    answers = 0
    for _ in range(CASES):

        def call() -> None:
            groups = [None, None, integers(random, 3, 6)][random.integers(3)]
            edges = [None, integers(random, 6, 2, 2)][random.integers(2)]
            faces = integers(random, 6, 3, 3)
            x0, x1 = positions(random, 6, 3), positions(random, 6, 3)
            if name == "audit":
                exact_ccd.audit([x0, x1], faces, edges=edges)
                return
            detector = exact_ccd.Detector(exact_ccd.Mesh(6, faces, edges, groups))
            pinned = {"pinned": integers(random, 6, 2)} if name == "free_steps" else {}
            getattr(detector, name)(*([x0] if name == "intersections" else [x0, x1]), **pinned)

        answers += survive(call)
    assert 0 < answers < CASES


@pytest.mark.parametrize(
    "name", ["is_step_collision_free", "compute_collision_free_stepsize", "has_intersections"]
)
def test_steps_of_ipc(name: str) -> None:
    random = np.random.default_rng(len(name))
    answers = 0
    for _ in range(CASES):
        dim = int(random.integers(2, 4))
        edges, faces = integers(random, 6, 4, 2), integers(random, 6, 2 if dim == 3 else 0, 3)
        try:
            # The edges of faces, too.
            edges = np.concatenate([ipc.edges(faces), edges])
        except (TypeError, ValueError):
            pass
        mesh = SimpleNamespace(num_vertices=6, edges=edges, faces=faces)
        x0, x1 = positions(random, 6, dim), positions(random, 6, dim)
        arguments = (mesh, x0) if name == "has_intersections" else (mesh, x0, x1)
        answers += survive(lambda: getattr(ipc, name)(*arguments))
    assert 0 < answers < CASES


def test_tables() -> None:
    pytest.importorskip("pyarrow", reason="pyarrow is not installed: pip install pyarrow")
    random = np.random.default_rng(0)
    answers = 0
    for _ in range(4 * CASES):
        queries = table(random)
        d = float(random.choice([0.0, 1.0, np.nan, -1.0], p=[0.6, 0.2, 0.1, 0.1]))
        answers += survive(lambda: exact_ccd.answer_table(queries, separation=d))
    assert CASES / 4 < answers < 4 * CASES


@pytest.mark.parametrize(
    ("name", "count"), [("point_point", 4), ("point_edge", 6), ("point_triangle", 8), ("edge_edge", 8)]
)
def test_pairs_of_ipc(name: str, count: int) -> None:
    random = np.random.default_rng(count)
    answers = 0
    for _ in range(CASES):
        points = [positions(random, 3) for _ in range(count)] if random.random() < 0.5 else positions(random, count, 3)
        answers += survive(lambda: getattr(ipc, f"{name}_ccd")(*points))
    assert 0 < answers < CASES
