"""Messages for wrong arguments come from this package, and name the argument."""

from __future__ import annotations

import threading
from types import SimpleNamespace

import numpy as np
import pytest

import exact_ccd
from exact_ccd import Detector, Mesh, Queries, ipc
from test_meshes import FACES, two_triangles

X0, X1 = two_triangles(1.0), two_triangles(-1.0)
POINTS = np.zeros((4, 3))
PAIR = Queries("vv", POINTS[None, :2], POINTS[None, 2:])
HUGE = 10**400

CASES = {
    "kind is of type list": lambda: Queries(["vv"], X0, X1),
    "kind is of type ndarray": lambda: Queries(X0, X0, X1),
    "mesh is of type str, expected an exact_ccd.Mesh": lambda: Detector("mesh"),
    "mesh is of type list, which has no attribute num_vertices": lambda: ipc.is_step_collision_free(FACES, X0, X1),
    "row 0 of faces has an edge that is missing in edges": lambda: ipc.CollisionMesh(X0, [[0, 1]], FACES),
    "mesh is of type dict": lambda: ipc.Candidates().build({}, X0, X1),
    "frames has the shape (6, 3), expected (T, V, 3)": lambda: exact_ccd.audit(X0, FACES),
    "faces is a Mesh, expected an array: mesh.faces": lambda: exact_ccd.audit([X0], Mesh(6, FACES)),
    "pinned has the dtype bool, expected integers: np.flatnonzero(mask) has them": lambda: Detector(
        Mesh(6, FACES)
    ).free_steps(X0, X1, pinned=np.zeros(6, bool)),
    "number of vertices is -1, expected an integer from 0": lambda: Mesh(-1, []),
    "number of vertices is 1180591620717411303424": lambda: Mesh(2**70, []),
    "min_distance is -1.0, expected a finite number of at least 0": lambda: ipc.Candidates().is_step_collision_free(
        Mesh(6, FACES), X0, X1, -1.0
    ),
    "min_distance is -2.0, expected a finite number of at least 0": lambda: ipc.point_point_ccd(
        [0, 0], [1, 0], [1, 0], [0, 0], min_distance=-2.0
    ),
    "threads is -1, expected an integer from 1 to 1024": lambda: Detector(Mesh(6, FACES), threads=-1),
    "threads is 0": lambda: PAIR.collides(threads=0),
    "threads is 1180591620717411303424": lambda: PAIR.time_of_impact(threads=2**70),
    "threads is of type float": lambda: PAIR.impact(threads=1.5),
    "threads is of type bool": lambda: exact_ccd.audit([X0], FACES, threads=True),
    "separation has the dtype object": lambda: PAIR.collides(separation=HUGE),
    "separation has the dtype <U1": lambda: PAIR.count(separation="1"),
    "min_distance has a number that is not exactly": lambda: Detector(Mesh(6, FACES), min_distance=2**63 - 1),
    "inner_distance has the dtype object": lambda: Detector(Mesh(6, FACES), inner_distance=HUGE),
    "until has the dtype object": lambda: Detector(Mesh(6, FACES)).collisions(X0, X1, until=HUGE),
    "keep has the dtype object": lambda: Detector(Mesh(6, FACES)).free_step(X0, X1, keep=HUGE),
    "tmax has the dtype object": lambda: ipc.point_point_ccd(*POINTS, tmax=HUGE),
    "until is nan": lambda: PAIR.collides(until=np.nan),
    "tmax is nan": lambda: ipc.point_point_ccd(*POINTS, tmax=np.nan),
    "conservative_rescaling has the dtype": lambda: ipc.point_point_ccd(*POINTS, conservative_rescaling="1"),
    "inflation_radius has the dtype": lambda: ipc.Candidates().build(Mesh(6, FACES), X0, X1, "1"),
    "can_collide of the mesh is not callable: give a matrix of groups to exact_ccd.Mesh": lambda: (
        ipc.is_step_collision_free(
            SimpleNamespace(num_vertices=6, edges=ipc.edges(FACES), faces=FACES, can_collide=np.eye(2) > 0), X0, X1
        )
    ),
    "displacement_map is not supported": lambda: ipc.CollisionMesh(X0, displacement_map=np.eye(18)),
}


@pytest.mark.parametrize("message", CASES)
def test_wrong_arguments(message: str) -> None:
    with pytest.raises((TypeError, ValueError)) as error:
        CASES[message]()
    text = str(error.value)
    assert message in text
    for foreign in ("unhashable", "_native", "OverflowError", "borrow", "convert"):
        assert foreign not in text


def test_a_detector_at_work() -> None:
    """The rule of a detector calls it again; another thread does so meanwhile."""
    errors = []

    def call() -> None:
        try:
            detector.collides(X0, X1)
        except RuntimeError as error:
            errors.append(str(error))

    def rule(i: int, j: int) -> bool:
        call()
        thread = threading.Thread(target=call)
        thread.start()
        thread.join()
        return True

    detector = Detector(Mesh(6, FACES, can_collide=rule))
    assert detector.collides(X0, X1)
    assert len(errors) >= 2 and all("the detector is at work" in text for text in errors)
