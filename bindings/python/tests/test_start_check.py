"""The check of the start of a step."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

from exact_ccd import CrossingError, Detector, Mesh, ipc
from test_meshes import FACES, two_triangles

PIERCED = two_triangles(-1.0)
"""Two sides of the second face pass through the first face."""

FREE = two_triangles(1.0)
CALLS = ["collides", "collision", "collisions", "free_step", "free_steps", "step"]


@pytest.mark.parametrize("name", CALLS)
@pytest.mark.parametrize("rule", [None, lambda i, j: True], ids=["no rule", "rule"])
def test_a_pierced_start(name: str, rule) -> None:
    mesh = Mesh(6, FACES, can_collide=rule)
    plain, checked = Detector(mesh), Detector(mesh, start_check=True)
    # Nothing touches in the step, and the mesh is pierced all the time.
    assert not plain.collides(PIERCED, PIERCED) and plain.free_step(PIERCED, PIERCED).size == 1.0
    for _ in range(2):
        with pytest.raises(CrossingError, match="edge 3 .*face 0") as error:
            getattr(checked, name)(PIERCED, PIERCED)
        expected = plain.intersections(PIERCED)[0].tolist()
        assert [error.value.edge, error.value.face] == expected
        twin = pickle.loads(pickle.dumps(error.value))
        assert (twin.edge, twin.face, str(twin)) == (*expected, str(error.value))
        # The detector goes on, and gives the answers of one without the check.
        answers = [getattr(detector, name)(FREE, PIERCED) for detector in (plain, checked)]
        assert np.array_equal(*answers) if name == "collisions" else answers[0] == answers[1]


def test_the_pairs_that_cannot_collide() -> None:
    for rules in ({"groups": [0] * 6}, {"can_collide": lambda i, j: False}):
        for name in CALLS:
            getattr(Detector(Mesh(6, FACES, **rules), start_check=True), name)(PIERCED, PIERCED)
    # The rule is asked for the first edge and face, and for others.
    only = Mesh(6, FACES, can_collide=lambda i, j: {i, j} == {5, 0})
    with pytest.raises(CrossingError) as error:
        Detector(only, start_check=True).collides(PIERCED, PIERCED)
    assert 5 in only.edges[error.value.edge]


def test_a_pierced_start_without_the_check_is_a_warning_once(recwarn: pytest.WarningsRecorder) -> None:
    named = {"groups": [0, 0, 0, 1, 1, 1], "names": ["floor", "leaf"]}
    for name in ("collision", "free_step", "step"):
        for mesh, words in [
            (Mesh(6, FACES), "edge 3 passes through face 0"),
            (Mesh(6, FACES, **named), "leaf: edge 0 passes through floor: face 0"),
        ]:
            detector = Detector(mesh)
            with pytest.warns(UserWarning, match=f"{words} at the start of the step.*start_check=True") as caught:
                getattr(detector, name)(PIERCED, PIERCED)
            # The caller's line, not one of the package.
            assert caught[0].filename == __file__
            getattr(detector, name)(PIERCED, PIERCED)
    # No warning: of a free start, of a step with contact, nor if the start is left out by the groups.
    Detector(Mesh(6, FACES)).collision(FREE, FREE)
    Detector(Mesh(6, FACES)).collision(PIERCED, FREE)
    Detector(Mesh(6, FACES, groups=[0] * 6)).free_step(PIERCED, PIERCED)
    assert not recwarn.list


def test_touching_is_no_crossing() -> None:
    detector = Detector(Mesh(6, FACES), start_check=True)
    assert detector.free_step(two_triangles(0.0), FREE).size == 0.0
    assert detector.collision(two_triangles(0.0), FREE).time == 0.0


def test_random_steps() -> None:
    """Successive steps, whose start may be known: the check agrees with `intersections`."""
    random = np.random.default_rng(2)
    mesh = Mesh(9, [[0, 1, 2], [3, 4, 5], [6, 7, 8]])
    plain, checked = Detector(mesh), Detector(mesh, start_check=True)
    refused = 0
    x0 = random.normal(size=(9, 3))
    for _ in range(300):
        x1 = x0 + random.normal(0, 0.3, (9, 3))
        crosses = len(plain.intersections(x0)) > 0
        try:
            assert checked.collides(x0, x1) == plain.collides(x0, x1)
            assert not crosses
        except CrossingError:
            refused += 1
            assert crosses
        choice = random.integers(3)
        x0 = [x0, x1, random.normal(size=(9, 3))][choice].copy()
    assert 50 < refused < 250


def test_an_interrupted_check_is_made_again() -> None:
    """A rule that fails ends the computation; the positions do not count as checked."""
    fails = True

    def rule(i: int, j: int) -> bool:
        if fails:
            raise RuntimeError("the rule fails")
        return True

    detector = Detector(Mesh(6, FACES, can_collide=rule), start_check=True)
    with pytest.raises(RuntimeError, match="the rule fails"):
        detector.collides(PIERCED, PIERCED)
    fails = False
    with pytest.raises(CrossingError):
        detector.collides(PIERCED, PIERCED)


def test_settings() -> None:
    detector = Detector(Mesh(6, FACES), start_check=True)
    assert detector != Detector(Mesh(6, FACES)) and repr(detector).endswith("start_check=True>")
    with pytest.raises(CrossingError):
        pickle.loads(pickle.dumps(detector)).collides(PIERCED, PIERCED)
    # The functions of ipctk do not check the start: has_intersections does.
    assert ipc.is_step_collision_free(Mesh(6, FACES), PIERCED, PIERCED)
    assert ipc.has_intersections(Mesh(6, FACES), PIERCED)
