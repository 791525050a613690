"""Messages for wrong arguments are those of this package, and name the argument."""

from __future__ import annotations

import threading

import numpy as np
import pytest

import exact_ccd
from exact_ccd import Detector, Mesh, ipc
from test_meshes import FACES, two_triangles

X0, X1 = two_triangles(1.0), two_triangles(-1.0)
PAIR = np.zeros((1, 4, 3))
HUGE = 10**400

CASES = {
    "kind is of type list": lambda: exact_ccd.collides(["vv"], PAIR),
    "kind is of type ndarray": lambda: exact_ccd.collides(PAIR, PAIR),
    "mesh is of type str, expected an exact_ccd.Mesh": lambda: Detector("mesh"),
    "mesh is of type list, which has no attribute num_vertices": lambda: ipc.is_step_collision_free(FACES, X0, X1),
    "mesh is of type dict": lambda: ipc.Candidates().build({}, X0, X1),
    "number of vertices is -1, expected an integer from 0": lambda: Mesh(-1, []),
    "number of vertices is 1180591620717411303424": lambda: Mesh(2**70, []),
    "threads is -1, expected an integer from 1 to 1024": lambda: Detector(Mesh(6, FACES), threads=-1),
    "threads is 0": lambda: exact_ccd.collides("vv", PAIR, threads=0),
    "threads is 1180591620717411303424": lambda: exact_ccd.time_of_impact("vv", PAIR, threads=2**70),
    "threads is of type float": lambda: exact_ccd.impacts("vv", PAIR, threads=1.5),
    "threads is of type bool": lambda: exact_ccd.audit([X0], FACES, threads=True),
    "min_distance has the dtype object": lambda: exact_ccd.collides("vv", PAIR, min_distance=HUGE),
    "min_distance has the dtype <U1": lambda: exact_ccd.contact_count("vv", PAIR, min_distance="1"),
    "min_distance has a number that is not exactly": lambda: Detector(Mesh(6, FACES), min_distance=2**63 - 1),
    "inner_distance has the dtype object": lambda: Detector(Mesh(6, FACES), inner_distance=HUGE),
    "until has the dtype object": lambda: Detector(Mesh(6, FACES)).contacts(X0, X1, HUGE),
    "keep has the dtype object": lambda: Detector(Mesh(6, FACES)).free_step(X0, X1, HUGE),
    "tmax has the dtype object": lambda: ipc.point_point_ccd(*PAIR[0], tmax=HUGE),
    "tmax is nan": lambda: ipc.point_point_ccd(*PAIR[0], tmax=np.nan),
    "conservative_rescaling has the dtype": lambda: ipc.point_point_ccd(*PAIR[0], conservative_rescaling="1"),
    "inflation_radius has the dtype": lambda: ipc.Candidates().build(Mesh(6, FACES), X0, X1, "1"),
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
            detector.is_free(X0, X1)
        except RuntimeError as error:
            errors.append(str(error))

    def rule(i: int, j: int) -> bool:
        call()
        thread = threading.Thread(target=call)
        thread.start()
        thread.join()
        return True

    detector = Detector(Mesh(6, FACES, can_collide=rule))
    assert not detector.is_free(X0, X1)
    assert len(errors) >= 2 and all("the detector is at work" in text for text in errors)
