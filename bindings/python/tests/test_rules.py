"""Rules of the caller that compute themselves, and that refer to the owner of their mesh."""

from __future__ import annotations

import gc
import subprocess
import sys
import weakref

import numpy as np
import pytest

from exact_ccd import Detector, Mesh, Worlds, ipc

SETTING = """
import numpy as np
from exact_ccd import Detector, Mesh, Queries
faces = [[0, 1, 2], [3, 4, 5]]
x0 = np.array([[0, 0, 0], [4, 0, 0], [0, 4, 0], [1, 1, 1], [2, 1, 2], [1, 2, 2.0]])
x1 = x0 - [0, 0, 2] * (np.arange(6) > 2)[:, None]
queries = Queries("vf", np.array([x0[[3, 0, 1, 2]]] * 9), np.array([x1[[3, 0, 1, 2]]] * 9))

def detector(threads, rule=None):
    return Detector(Mesh(6, faces, can_collide=rule), threads=threads)
"""
CALLS = {
    "a detector of as many threads": "detector(1, lambda i, j, own=detector(1): own.collides(x0, x1))",
    "queries": "detector(1, lambda i, j: queries.collides(threads=1).all())",
    "a detector whose rule has another": """detector(1, lambda i, j: detector(
        2, lambda i, j: detector(1).collides(x0, x1)).collides(x0, x1))""",
}


@pytest.mark.parametrize("name", CALLS)
def test_a_rule_that_computes(name: str) -> None:
    """In a process of its own: where two computations wait for each other, no exception ends them."""
    program = f"{SETTING}print({CALLS[name]}.collides(x0, x1))"
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60.0, check=True)
    assert run.stdout == "True\n"


class Owner:
    """A mesh whose rule is a method of the object that has it, and its detectors."""

    def __init__(self) -> None:
        self.mesh = Mesh(6, [[0, 1, 2], [3, 4, 5]], can_collide=self.rule)
        self.detectors = Detector(self.mesh), Worlds(self.mesh)

    def rule(self, i: int, j: int) -> bool:
        return True


def test_a_rule_that_refers_to_the_owner_of_its_mesh() -> None:
    """The cycle is freed, and not before its last use."""
    owner = Owner()
    detector, worlds = owner.detectors
    reference = weakref.ref(owner)
    x = np.zeros((6, 3))
    assert not ipc.is_step_collision_free(owner.mesh, x, x)
    assert detector.collides(x, x) and worlds.collides(x[None], x[None]).all()
    del owner, worlds
    gc.collect()
    assert reference() is not None and detector.collides(x, x)
    del detector
    gc.collect()
    assert reference() is None
