"""Answers for each vertex: first contacts and clearances."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from exact_ccd import Detector, Mesh
from test_meshes import soup

FACE = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]


@pytest.mark.parametrize("settings", [{}, {"min_distance": 2**-6}], ids=str)
def test_first_contacts_are_the_first_of_all(settings: dict) -> None:
    without = 0
    for seed in range(20):
        mesh, x0, x1 = soup(seed, triangles=8)
        detector = Detector(mesh, **settings)
        first = detector.first_contacts(x0, x1)
        contacts = detector.collisions(x0, x1)
        assert_array_equal(first.contacts, contacts)
        for vertex, (index, time) in enumerate(zip(first.of_vertices, first.times)):
            rows = [i for i, contact in enumerate(contacts) if vertex in contact["vertices"]]
            assert index == (rows[0] if rows else -1)
            assert time == (contacts["time"][rows[0]] if rows else np.inf)
            without += not rows
        assert detector.first_contacts(x0, x1) == first
        early = detector.first_contacts(x0, x1, until=0.25)
        assert_array_equal(early.times, np.where(first.times <= 0.25, first.times, np.inf))
    assert without > 20


def test_clearances_are_where_pairs_begin_to_touch() -> None:
    """The least distance of a vertex is the least at which it has a contact at rest: by decisions."""
    limited, partial = 0, 0
    for seed in range(10):
        mesh, x, _ = soup(seed, triangles=6)
        clearances = Detector(mesh).clearances(x, 0.25)
        assert clearances.shape == (mesh.vertex_count,) and (clearances <= 0.25).all()
        for vertex, clearance in enumerate(clearances):
            is_touched = [
                vertex in Detector(mesh, min_distance=d).collisions(x, x)["vertices"]
                for d in (np.nextafter(clearance, 0.0), np.nextafter(clearance, 1.0))
            ]
            assert not is_touched[0] or clearance == 0.0
            assert is_touched[1] or clearance == 0.25
        limited += (clearances == 0.25).sum()
        partial += ((clearances > 0.0) & (clearances < 0.25)).sum()
        assert_array_equal(Detector(mesh, threads=1).clearances(x.astype(np.float32).astype(float), 0.25),
                           Detector(mesh).clearances(x.astype(np.float32), 0.25))
    assert partial > 20, (limited, partial)


def test_clearances_obey_rules() -> None:
    x = np.array([*FACE, [0.25, 0.25, 0.5]])
    assert Detector(Mesh(4, [[0, 1, 2]])).clearances(x, 1.0).tolist() == [0.5] * 4
    mesh = Mesh(4, [[0, 1, 2]], can_collide=lambda i, j: False)
    assert Detector(mesh).clearances(x, 1.0).tolist() == [1.0] * 4
    mesh = Mesh(4, [[0, 1, 2]], groups=[0, 0, 0, 0])
    assert Detector(mesh).clearances(x, 1.0).tolist() == [1.0] * 4


def test_wrong_arguments() -> None:
    detector = Detector(Mesh(4, [[0, 1, 2]]))
    x = np.array([*FACE, [0.25, 0.25, 0.5]])
    for cut_off in (-1.0, np.inf, np.nan):
        with pytest.raises(ValueError, match="cut_off: distance .* is not a finite number"):
            detector.clearances(x, cut_off)
    with pytest.raises(ValueError, match="x has the shape"):
        detector.clearances(x[:3], 1.0)
    with pytest.raises(ValueError, match="time 2 is not in the step"):
        detector.first_contacts(x, x, until=2.0)
