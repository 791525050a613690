"""A step for each vertex."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_array_equal

import exact_ccd
from exact_ccd import Detector, FreeSteps, Mesh
from test_meshes import soup

FACE = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
RULES = {"no rule": None, "odd sums": lambda i, j: (i + j) % 2 == 1, "none": lambda i, j: False}


def check(detector: Detector, x0: np.ndarray, x1: np.ndarray, steps: FreeSteps) -> None:
    """The promises for a step without pinned vertices: by decisions of the step to the positions."""
    assert steps.sizes.shape == (len(x0),) and ((0.0 <= steps.sizes) & (steps.sizes <= 1.0)).all()
    assert (steps.sizes >= detector.free_step(x0, x1).size).all()
    assert_array_equal(steps.positions[steps.sizes == 1.0], x1[steps.sizes == 1.0])
    assert_array_equal(steps.positions[steps.sizes == 0.0], x0[steps.sizes == 0.0])
    contacts = detector.collisions(x0, steps.positions)
    names = list(exact_ccd.PAIR.names)
    assert_array_equal(np.sort(contacts[names]), np.sort(steps.blocked))
    assert not contacts["time"].any()


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize("settings", [{}, {"min_distance": 2**-6}, {"threads": 1}], ids=str)
def test_steps_are_free(settings: dict, rule: str) -> None:
    sizes = []
    for seed in range(20):
        mesh, x0, x1 = soup(seed, triangles=8)
        mesh = Mesh(mesh.vertex_count, mesh.faces, mesh.loose_edges, can_collide=RULES[rule])
        detector = Detector(mesh, **settings)
        steps = detector.free_steps(x0, x1)
        check(detector, x0, x1, steps)
        assert detector.free_steps(x0, x1) == steps
        sizes.append(steps.sizes)
    is_partial = (0.0 < np.array(sizes)) & (np.array(sizes) < 1.0)
    assert is_partial.any() == (rule != "none")


def test_the_step_of_the_documentation_in_rust() -> None:
    """The numbers are the same as in the example of `Detector::free_steps`."""
    x0 = np.array([*FACE, [0.25, 0.25, 1], [5, 0, 1]])
    x1 = x0.copy()
    x1[3:, 2] = -1.0
    steps = Detector(Mesh(5, [[0, 1, 2]])).free_steps(x0, x1, keep=0.5)
    assert steps.sizes.tolist() == [1.0, 1.0, 1.0, 0.25, 1.0]
    assert steps.positions[3].tolist() == [0.25, 0.25, 0.5]
    assert steps.rounds == 2 and len(steps.blocked) == 0 and steps.blocked.dtype == exact_ccd.PAIR


def test_what_pinned_vertices_forbid_is_blocked() -> None:
    """A face moves onto a vertex at rest: the numbers are the same as in a test of `Detector::free_steps`."""
    x0 = np.array([*FACE, [0.25, 0.25, 1]])
    x1 = x0.copy()
    x1[:3, 2] = 2.0
    detector = Detector(Mesh(4, [[0, 1, 2]]))
    free = detector.free_steps(x0, x1)
    assert len(free.blocked) == 0 and free.sizes[3] == 1.0 and free.sizes[0] < 0.5
    check(detector, x0, x1, free)
    for pinned in ([0, 1, 2], np.array([2, 1, 0, 0], np.uint8), (0, 1, 2)):
        steps = detector.free_steps(x0, x1, pinned=pinned)
        assert steps.blocked[["kind", "first", "second"]].tolist() == [("vf", 3, 0)]
        assert_array_equal(steps.blocked["vertices"], [[3, 0, 1, 2]])
        assert_array_equal(steps.sizes[:3], 1.0)
        assert_array_equal(steps.positions[:3], x1[:3])
    # The vertex gets out of the way.
    x1[3, 2] = 3.0
    steps = detector.free_steps(x0, x1, pinned=[0, 1, 2])
    assert len(steps.blocked) == 0 and (steps.sizes == 1.0).all() and steps.rounds == 1
    assert detector.free_steps(x0, x1, pinned=[]) == detector.free_steps(x0, x1)


def test_float32_positions_are_read_as_they_are() -> None:
    mesh, x0, x1 = soup(3, triangles=8)
    x0, x1 = x0.astype(np.float32), x1.astype(np.float32)
    detector = Detector(mesh)
    steps = detector.free_steps(x0, x1)
    assert steps == detector.free_steps(x0.astype(float), x1.astype(float))
    assert steps.positions.dtype == np.float64 and (steps.sizes < 1.0).any()


def test_wrong_arguments() -> None:
    detector = Detector(Mesh(4, [[0, 1, 2]]))
    x = np.array([*FACE, [0.25, 0.25, 1]])
    with pytest.raises(ValueError, match="vertex 4 is pinned, but the mesh has 4 vertices"):
        detector.free_steps(x, x, pinned=[0, 4])
    with pytest.raises(ValueError, match="row 1 of pinned has an index that is negative"):
        detector.free_steps(x, x, pinned=[0, -1])
    with pytest.raises(ValueError, match=r"pinned has the shape \(1, 1\), expected \(N\)"):
        detector.free_steps(x, x, pinned=[[0]])
    for pinned in ([0.0], np.zeros(4, bool), ["0"]):
        with pytest.raises(TypeError, match="pinned has the dtype .*, expected integers"):
            detector.free_steps(x, x, pinned=pinned)
    for keep in (0.0, 1.5, np.nan):
        with pytest.raises(ValueError, match="the fraction of the time of impact to keep is"):
            detector.free_steps(x, x, keep=keep)
    with pytest.raises(ValueError, match="x1 has the shape"):
        detector.free_steps(x, x[:3])


def test_the_bits_are_those_of_rust() -> None:
    """The number is the same as in the test in Rust, `sizes_and_positions_have_the_bits_of_other_languages`."""
    state = 1

    def following(count: int) -> np.ndarray:
        nonlocal state
        numbers = []
        for _ in range(count):
            state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
            numbers.append((state >> 11) / 2**53)
        return np.array(numbers)

    x0, x1 = np.empty((2, 180, 3))
    for vertex in range(180):
        if vertex % 3 == 0:
            centre = 1.5 * following(3)
        x0[vertex] = centre + 0.5 * following(3)
        x1[vertex] = x0[vertex] + (following(3) - 0.5)
    steps = Detector(Mesh(180, np.arange(180).reshape(-1, 3))).free_steps(x0, x1)
    fnv_1a = 0xCBF29CE484222325
    for word in np.concatenate([steps.sizes, steps.positions.ravel()]).view(np.uint64).tolist():
        fnv_1a = (fnv_1a ^ word) * 0x100000001B3 % 2**64
    assert (fnv_1a, steps.rounds) == (16825418621938942653, 4)


def test_steps_in_single_precision_are_free_as_they_are() -> None:
    held = 0
    for seed in range(20):
        mesh, x0, x1 = soup(seed, triangles=8)
        x0 = x0.astype(np.float32)
        detector = Detector(mesh)
        step = detector.free_step(x0, x1, dtype=np.float32)
        steps = detector.free_steps(x0, x1, dtype=np.float32)
        assert step.positions.dtype == steps.positions.dtype == np.float32
        if step.size > 0.0:
            assert not detector.collides(x0, step.positions)
            assert len(steps.blocked) == 0 and not detector.collides(x0, steps.positions)
            held += step.size < 1.0
        worlds = exact_ccd.Worlds(mesh).free_step(x0[None], x1[None], dtype=np.float32)
        assert_array_equal(worlds.positions[0], step.positions)
    assert held > 5


def test_the_precision_of_a_step_is_checked() -> None:
    detector = Detector(Mesh(3, [[0, 1, 2]]))
    with pytest.raises(ValueError, match="vertex 1 at the start is not in single precision"):
        detector.free_step(np.array([[0.5, 0, 0], [0.1, 0, 0], [0, 1, 0]]), FACE, dtype=np.float32)
    with pytest.raises(ValueError, match="dtype is float16, expected float32 or float64"):
        detector.free_steps(FACE, FACE, dtype=np.float16)
