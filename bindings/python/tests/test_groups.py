"""A matrix of groups as the rule, and the names of groups."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from exact_ccd import Detector, Mesh, Place, Worlds, audit, ipc
from exact_ccd._records import same
from exact_ccd.groups import numbers_in
from test_audits import frames
from test_meshes import FACES, soup, two_triangles

COUNT = 5


def matrix(seed: int) -> np.ndarray:
    """A symmetric matrix whose diagonal has both values."""
    upper = np.triu(np.random.default_rng(seed).random((COUNT, COUNT)) < 0.5)
    return upper | upper.T


@pytest.mark.parametrize("seed", range(4))
def test_a_matrix_gives_the_same_answers_as_a_rule(seed: int) -> None:
    mesh, x0, x1 = soup(seed)
    groups = np.random.default_rng(seed).integers(0, COUNT, mesh.vertex_count)
    allowed = matrix(seed)
    primitives = mesh.vertex_count, mesh.faces, mesh.loose_edges
    by_matrix = Mesh(*primitives, groups=groups, can_collide=allowed)
    by_rule = Mesh(*primitives, can_collide=lambda i, j: allowed[groups[i], groups[j]])
    ours, expected = Detector(by_matrix), Detector(by_rule)
    left_out = len(Detector(mesh).collisions(x0, x1)) - len(ours.collisions(x0, x1))
    assert left_out > 0 and len(ours.collisions(x0, x1)) > 0
    for method in ("collisions", "collision", "collides", "free_step", "step", "first_contacts"):
        assert same(getattr(ours, method)(x0, x1), getattr(expected, method)(x0, x1))
    assert ours.free_steps(x0, x1) == expected.free_steps(x0, x1)
    assert_array_equal(ours.clearances(x0, 0.5), expected.clearances(x0, 0.5))
    assert_array_equal(ours.intersections(x0), expected.intersections(x0))
    for method in ("collides", "collision"):
        worlds = [getattr(Worlds(one), method)(x0[None], x1[None]) for one in (by_matrix, by_rule)]
        assert_array_equal(*worlds)
    sizes = [ipc.compute_collision_free_stepsize(one, x0, x1) for one in (by_matrix, by_rule)]
    assert sizes[0] == sizes[1]
    vertices = range(0, mesh.vertex_count, 7)
    assert all(by_matrix.vertices_can_collide(i, j) == by_rule.can_collide(i, j) for i in vertices for j in vertices)


def test_the_diagonal_is_the_pairs_within_a_group() -> None:
    passing = frames(3, 1, -1)
    together = {"groups": [0] * 6}
    assert audit(passing, FACES, **together).is_free
    assert audit(passing, FACES, **together, can_collide=[[False]]).is_free
    assert audit(passing, FACES, **together, can_collide=[[True]]) == audit(passing, FACES)
    apart = {"groups": [0, 0, 0, 1, 1, 1]}
    assert audit(passing, FACES, **apart, can_collide=np.eye(2, dtype=bool)).is_free
    assert audit(passing, FACES, **apart, can_collide=~np.eye(2, dtype=bool)) == audit(passing, FACES)


def test_wrong_matrices() -> None:
    groups = [0, 0, 0, 1, 1, 2]
    asymmetric = np.zeros((3, 3), bool)
    asymmetric[2, 1] = True
    every = np.ones((3, 3), bool)
    cases = {
        "the entries (2, 1) and (1, 2) differ: set both": (ValueError, groups, asymmetric),
        "vertex 5 is in group 2, but the matrix has 2 groups": (ValueError, groups, np.ones((2, 2), bool)),
        "can_collide has the shape (3, 2), expected (G, G)": (ValueError, groups, every[:, :2]),
        "can_collide has the shape (3,)": (ValueError, groups, every[0]),
        "can_collide has the dtype int64, expected booleans": (TypeError, groups, every.astype(np.int64)),
        "groups is missing": (TypeError, None, every),
        "can_collide is not callable, nor a matrix": (TypeError, groups, 3),
    }
    for message, (kind, given, rule) in cases.items():
        with pytest.raises(kind) as error:
            Mesh(6, FACES, groups=given, can_collide=rule)
        assert message in str(error.value)


def test_wrong_names() -> None:
    groups = [0, 0, 0, 1, 1, 2]
    with pytest.raises(ValueError, match="vertex 5 is in group 2, but there are only 2 names"):
        Mesh(6, FACES, groups=groups, names=["a", "b"])
    with pytest.raises(TypeError, match="name 1 is of type int, expected a str"):
        Mesh(6, FACES, groups=groups, names=["a", 1, "c"])
    with pytest.raises(TypeError, match="groups is missing"):
        Mesh(6, FACES, names=["a"])


def test_places_are_those_in_a_mesh_of_the_body_alone() -> None:
    mesh, _, _ = soup(3)
    groups = np.random.default_rng(3).integers(0, COUNT, mesh.vertex_count)
    # Every face is of one body; some rods are of two.
    groups[mesh.faces] = groups[mesh.faces[:, :1]]
    names = [f"body {number}" for number in range(COUNT)]
    named = Mesh(mesh.vertex_count, mesh.faces, mesh.loose_edges, groups=groups, names=names)
    found, joints = 0, 0
    for number, name in enumerate(names):
        (own,) = np.nonzero(groups == number)
        local = np.zeros(mesh.vertex_count, int)
        local[own] = np.arange(len(own))
        within = [rows[(groups[rows] == number).all(axis=1)] for rows in (mesh.faces, mesh.loose_edges)]
        body = Mesh(len(own), *(local[rows] for rows in within))
        for kind, rows, theirs in (("face", mesh.faces, body.faces), ("edge", mesh.edges, body.edges)):
            for index, row in enumerate(rows):
                place = named.place(kind, index)
                if (groups[row] == number).all():
                    assert place[:2] == (name, kind)
                    assert_array_equal(theirs[place.id], local[row])
                    found += 1
                else:
                    assert place is None or place.body != name
                    joints += place is None
        for kind, rows in (("face", mesh.faces), ("edge", mesh.edges)):
            places = [named.place(kind, index) for index in range(len(rows))]
            ids = [-1 if place is None else place.id for place in places]
            assert_array_equal(numbers_in(groups, rows), ids)
        assert all(named.place("vertex", vertex) == (name, "vertex", local[vertex]) for vertex in own)
    assert found > 100 and joints > 0


def test_contacts_have_the_names_of_bodies(tmp_path) -> None:
    rules = {"groups": [1, 1, 1, 0, 0, 0], "names": ["leaf", "floor"]}
    places = (Place("leaf", "vertex", 0), Place("floor", "face", 0))
    detector = Detector(Mesh(6, FACES, **rules))
    x0, x1 = two_triangles(1.0), two_triangles(-1.0)
    assert detector.collision(x0, x1).places == places
    assert detector.free_step(x0, x1).contact.places == places
    assert detector.step(x0, x1).earliest.places == places
    assert Detector(Mesh(6, FACES)).collision(x0, x1).places == (None, None)
    page = tmp_path / "page.html"
    report = audit(frames(3, 1, -3), FACES, **rules, view=page)
    assert report.violation.places == report.violation.contact.places == places
    assert "contact at t = 0.25: leaf: vertex 0 and floor: face 0" in page.read_text("utf-8")
    crossing = audit(frames(-1), FACES, **rules, view=page).violation
    assert [str(place) for place in crossing.places] == ["leaf: edge 0", "floor: face 0"]
    assert "leaf: edge 0 meets floor: face 0" in page.read_text("utf-8")
    wall = [[[0, 0, 4], [0, 0, -1]]]
    beyond = audit(frames(3, 5), FACES, **rules, half_spaces=wall, view=page).violation
    assert beyond.places == (Place("leaf", "vertex", 1),)
    assert "leaf: vertex 1 is not apart from half space 0" in page.read_text("utf-8")


def test_values_of_meshes_with_matrices_and_names() -> None:
    groups = {"groups": [0, 0, 0, 1, 1, 1]}
    meshes = [
        Mesh(6, FACES, **groups),
        Mesh(6, FACES, **groups, can_collide=np.ones((2, 2), bool)),
        Mesh(6, FACES, **groups, can_collide=~np.eye(2, dtype=bool)),
        Mesh(6, FACES, **groups, can_collide=bool),
        Mesh(6, FACES, **groups, names=["a", "b"]),
    ]
    twins = [pickle.loads(pickle.dumps(mesh)) for mesh in meshes]
    for i, mesh in enumerate(meshes):
        assert [mesh == twin for twin in twins] == [i == k for k in range(len(meshes))]
    assert "restricted by a matrix of groups" in repr(meshes[1])
    assert meshes[4].names == ("a", "b")
    given = np.ones((2, 2), bool)
    mesh = Mesh(6, FACES, **groups, can_collide=given)
    given[:] = False
    assert mesh.can_collide.all()
    with pytest.raises(ValueError, match="read-only"):
        mesh.can_collide[0, 0] = False
