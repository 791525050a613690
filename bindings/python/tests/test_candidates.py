"""Pairs that come near each other, without ipctk."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from exact_ccd import Mesh, ipc

SMALLEST = 5e-324


def points_and_an_edge(height: float):
    """In two dimensions, an edge on the x-axis and a point above it."""
    mesh = SimpleNamespace(num_vertices=3, edges=np.array([[0, 1]]), faces=np.empty((0, 3), int))
    return mesh, np.array([[-1.0, 0.0], [1.0, 0.0], [0.0, height]])


def test_boxes_that_meet_when_enlarged_are_candidates() -> None:
    mesh, x = points_and_an_edge(1.0)
    candidates = ipc.Candidates()
    for radius, count in ((0.0, 0), (0.49, 0), (0.5, 1), (2.0, 1)):
        candidates.build(mesh, x, inflation_radius=radius)
        assert len(candidates) == count, radius
    assert candidates.pairs["ve"].tolist() == [[2, 0, 1]]
    for wrong in (-1.0, np.nan, np.inf):
        with pytest.raises(ValueError, match="inflation_radius"):
            candidates.build(mesh, x, inflation_radius=wrong)


def test_candidates_do_not_depend_on_the_distance_to_the_origin() -> None:
    """Edges of a millimetre, at a place where numbers of single precision are 64 m apart."""
    x = np.zeros((400, 2))
    x[:, 0] = np.arange(400) * 2.0**-10
    mesh = SimpleNamespace(
        num_vertices=400, edges=np.arange(400).reshape(-1, 2), faces=np.empty((0, 3), int)
    )
    near, far = ipc.Candidates(), ipc.Candidates()
    near.build(mesh, x, inflation_radius=2.0**-10)
    far.build(mesh, x + 2.0**29, inflation_radius=2.0**-10)
    assert 0 < len(near) < 2000
    assert len(far) == len(near)


@pytest.mark.parametrize("units", [1, 2, 3, 4, 5, 6, 7, 8, 9])
def test_the_smallest_distances(units: int) -> None:
    """Half of a distance may be no float64."""
    mesh, x = points_and_an_edge(units * SMALLEST)
    assert not ipc.is_step_collision_free(mesh, x, x, units * SMALLEST)
    assert ipc.is_step_collision_free(mesh, x, x, (units - 1) * SMALLEST)
    assert ipc.compute_collision_free_stepsize(mesh, x, x, units * SMALLEST) == 0.0


def test_a_size_where_the_difference_overflows() -> None:
    rest = np.zeros((1, 3))
    x0, x1 = (np.concatenate([[[x, 0.0, 0.0]], rest]) for x in (-1.5e308, 1.5e308))
    mesh = Mesh(2, np.empty((0, 3), int))
    candidates = ipc.Candidates()
    candidates.build(mesh, x0, x1)
    assert candidates.compute_collision_free_stepsize(mesh, x0, x1, conservative_rescaling=0.5) == 0.25
