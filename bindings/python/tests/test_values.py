"""Meshes, detectors and answers as values: equality, keys, pickles, texts."""

from __future__ import annotations

import copy
import gc
import pickle
import weakref

import numpy as np
import pytest

import exact_ccd
from exact_ccd import Detector, Mesh, Worlds, ipc
from test_meshes import FACES, two_triangles


def odd_numbers(i: int, j: int) -> bool:
    """A rule that can be pickled."""
    return (i + j) % 2 == 1


EDGES = [[5, 6], [2, 5]]
MESHES = [
    Mesh(7, FACES),
    Mesh(8, FACES),
    Mesh(7, FACES[::-1]),
    Mesh(7, FACES, edges=EDGES),
    Mesh(7, FACES, edges=EDGES, groups=[0, 0, 0, 1, 1, 1, 1]),
    Mesh(7, FACES, edges=EDGES, groups=[0, 0, 0, 1, 1, 1, 2]),
    Mesh(7, FACES, can_collide=odd_numbers),
    Mesh(0, []),
]
DETECTORS = [
    Detector(MESHES[0]),
    Detector(MESHES[4]),
    Detector(MESHES[0], min_distance=0.5),
    Detector(MESHES[0], min_distance=[0.5] * 7),
    Detector(MESHES[0], min_distance=[0.5] * 6 + [0.25]),
    Detector(MESHES[0], min_distance=0.5, inner_distance=0.25),
    Detector(MESHES[0], threads=2),
]


WORLDS = [Worlds(detector.mesh, **detector._settings._asdict()) for detector in DETECTORS]


@pytest.mark.parametrize("values", [MESHES, DETECTORS, WORLDS], ids=["meshes", "detectors", "worlds"])
def test_equality_and_pickles(values: list) -> None:
    twins = [pickle.loads(pickle.dumps(value)) for value in values]
    for i, value in enumerate(values):
        assert [value == twin for twin in twins] == [i == k for k in range(len(values))]
        assert hash(value) == hash(twins[i]) and copy.deepcopy(value) == value
        assert repr(value) == repr(twins[i])
    assert len({*values, *twins}) == len(values)
    assert values[0] != "text"


def test_a_pickled_detector_answers_alike() -> None:
    x0, x1 = two_triangles(1.0), two_triangles(-1.0)
    for settings in ({}, {"min_distance": 0.25}, {"min_distance": [0.25] * 6}):
        detector = Detector(Mesh(6, FACES, can_collide=odd_numbers), **settings)
        expected = detector.collision(x0, x1)
        assert pickle.loads(pickle.dumps(detector)).collision(x0, x1) == expected


def test_texts() -> None:
    assert repr(MESHES[4]) == (
        "<exact_ccd.Mesh: 7 vertices, 2 faces, 8 edges, 2 of them loose, restricted by groups>"
    )
    assert repr(DETECTORS[5]).endswith("0 of them loose>, min_distance=0.5, inner_distance=0.25>")


def test_faces_and_edges_are_read_only_and_not_copied() -> None:
    mesh = Mesh(7, FACES, edges=EDGES, groups=np.zeros(7, np.uint32))
    for name in ("faces", "edges", "groups"):
        array = getattr(mesh, name)
        assert np.shares_memory(array, getattr(mesh, name))
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 3
        with pytest.raises(ValueError):
            array.flags.writeable = True
    with pytest.raises(ValueError, match="read-only"):
        mesh.loose_edges[0] = 3


def test_the_arrays_of_the_caller_stay_writable() -> None:
    groups, thickness = np.zeros(6, np.uint32), np.zeros(6)
    mesh = Mesh(6, FACES, groups=groups)
    detector = Detector(mesh, min_distance=thickness)
    groups[0], thickness[0] = 1, 1.0
    assert mesh == Mesh(6, FACES, groups=[0] * 6)
    assert detector == Detector(mesh, min_distance=[0.0] * 6)


def test_contacts_compare_by_value() -> None:
    x0, x1 = two_triangles(1.0), two_triangles(-1.0)
    detector = Detector(Mesh(6, FACES))
    contact, again = detector.collision(x0, x1), detector.collision(x0, x1)
    assert contact == contact and contact == again and not contact != again
    assert hash(contact) == hash(again) and contact in [None, again]
    other = detector.collision(x0, two_triangles(-3.0))
    assert contact != other and not contact == other and contact == tuple(contact)
    assert detector.free_step(x0, x1) == detector.free_step(x0, x1)
    assert detector.free_step(x0, x1) != detector.free_step(x0, x1, keep=0.5)
    assert detector.step(x0, x1) == detector.step(x0, x1) != detector.step(x0, x0)
    assert exact_ccd.audit([x0, x1], FACES) == exact_ccd.audit([x0, x1], FACES)
    # Two points that rest in one place have no normal: NaN equals NaN.
    rest = np.zeros((2, 3))
    points = [Detector(Mesh(2, [])).collision(rest, rest) for _ in range(2)]
    assert np.isnan(points[0].normal).any() and points[0] == points[1]
    assert pickle.loads(pickle.dumps(contact)) == contact


def test_meshes_in_use_are_not_kept_alive() -> None:
    x0, x1 = two_triangles(1.0), two_triangles(-1.0)
    for make in (lambda: Mesh(6, FACES), lambda: ipc.CollisionMesh(x0, faces=FACES)):
        mesh = make()
        assert not ipc.is_step_collision_free(mesh, x0, x1)
        seen = weakref.ref(mesh)
        del mesh
        gc.collect()
        assert seen() is None


def test_no_faces() -> None:
    assert Mesh(5, []).faces.shape == (0, 3) and Mesh(5, [], edges=[]).edges.shape == (0, 2)
    x0, x1 = np.array([[0.0, 0, 0], [1, 0, 0]]), np.array([[1.0, 0, 0], [0, 0, 0]])
    assert Detector(Mesh(2, [])).collision(x0, x1).time == 0.5
    assert exact_ccd.audit([x0, x1], []).violation.contact.kind == "vv"
    assert exact_ccd.Queries("vf", [], []).collides().shape == (0,)
    with pytest.raises(ValueError, match=r"min_distance has the shape \(0,\), expected \(5\)"):
        Detector(Mesh(5, []), min_distance=[])


def test_records_with_structures_compare_by_value() -> None:
    """Among the numbers of contacts is NaN: of a free world, or of a contact without a normal."""
    x0 = np.repeat(two_triangles(1.0)[None], 2, axis=0)
    x1 = np.stack([two_triangles(0.75), two_triangles(-1.0)])
    worlds = Worlds(Mesh(6, FACES))
    for answer in (worlds.free_step, worlds.step):
        assert answer(x0, x1) == answer(x0, x1) != answer(x0, x0)
    rest = np.zeros((2, 3))
    points = Detector(Mesh(2, []))
    assert points.first_contacts(rest, rest) == points.first_contacts(rest, rest)
