"""Repair of meshes that intersect themselves."""

from __future__ import annotations

import pickle
import threading
from itertools import combinations

import numpy as np
import pytest
from numpy.testing import assert_array_equal

import exact_ccd
from exact_ccd import Detector, Mesh, Repair, RepairProgress, _native, repair
from hostile import CASES, integers, positions, survive

pytestmark = pytest.mark.skipif(not hasattr(_native, "repair"), reason="the package is built without the feature repair")

FACES = [[0, 1, 2], [3, 4, 5]]
X = np.array([[0, 0, 0], [8, 0, 0], [0, 8, 0], [2, 2, -0.5], [2, 1, 4], [1, 2, 4]])
"""The tip of the second triangle passes through the first one."""

CONE = [[0, i, j] for i, j in combinations(range(1, 6), 2)]
"""The cone over the complete graph of five vertices, which is not planar: no positions are free."""


def rings(m: int = 16, n: int = 8) -> tuple[np.ndarray, np.ndarray]:
    """Two tori that overlap: their faces, and their positions."""
    i, j = (index.ravel() for index in np.mgrid[:m, :n])
    corners = [(i + a) % m * n + (j + b) % n for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
    ring = np.vstack([np.column_stack([corners[0], corners[k], corners[k + 1]]) for k in (1, 2)])
    (u, v) = 2 * np.pi * i / m, 2 * np.pi * j / n
    radius = 1 + 0.3 * np.cos(v)
    x = np.column_stack([radius * np.cos(u), radius * np.sin(u), 0.3 * np.sin(v)])
    return np.vstack([ring, ring + m * n]), np.vstack([x, x + [0.1, 0.2, 0.45]])


def moved(x: np.ndarray, vertex: int, by: float) -> np.ndarray:
    y = x.copy()
    y[vertex] += by
    return y


def is_free(mesh: Mesh, x: np.ndarray, min_distance: float = 0.0) -> bool:
    detector = Detector(mesh, min_distance=min_distance)
    return len(detector.intersections(x)) == 0 and not detector.collides(x, x)


def check_repaired(mesh: Mesh, result: Repair, min_distance: float = 0.0) -> None:
    assert result.repaired and result.reason is None and result.message is None
    assert len(result.crossings) == 0 and result.crossings.dtype == np.uint32
    assert len(result.contacts) == 0 and result.contacts.dtype == exact_ccd.PAIR
    assert is_free(mesh, result.positions, min_distance)


def test_overlapping_rings_are_free_afterwards() -> None:
    faces, x = rings()
    mesh = Mesh(len(x), faces)
    assert len(Detector(mesh).intersections(x)) > 0
    result = repair(faces, x)
    check_repaired(mesh, result)
    assert exact_ccd.audit([result.positions], faces).is_free
    # Generic positions: an edge that meets a face passes through it.
    assert result.before == (len(Detector(mesh).intersections(x)), len(Detector(mesh).collisions(x, x)))
    assert repair(mesh, x, threads=1) == result == pickle.loads(pickle.dumps(result))


def test_the_change_in_numbers() -> None:
    faces, x = rings()
    change, after = repair(faces, x).change, repair(faces, x).positions
    displacements = np.sort(np.linalg.norm(after - x, axis=1)) / np.linalg.norm(np.ptp(x, axis=0))
    assert change.moved == (after != x).any(axis=1).sum() > 0
    close = {"rtol": 1e-12, "atol": 0.0}
    np.testing.assert_allclose(change.mean_displacement, displacements.mean(), **close)
    np.testing.assert_allclose(change.p95_displacement, displacements[int(np.ceil(0.95 * len(x))) - 1], **close)
    np.testing.assert_allclose(change.max_displacement, displacements[-1], **close)
    a, b = Mesh(len(x), faces).edges.T
    stretches = np.linalg.norm(after[a] - after[b], axis=1) / np.linalg.norm(x[a] - x[b], axis=1)
    np.testing.assert_allclose([change.min_stretch, change.max_stretch], [stretches.min(), stretches.max()], **close)

    def areas(y: np.ndarray) -> np.ndarray:
        p, q, r = (y[faces[:, k]] for k in range(3))
        return np.linalg.norm(np.cross(q - p, r - p), axis=1)

    ratios = areas(after) / areas(x)
    np.testing.assert_allclose([change.min_area, change.max_area], [ratios.min(), ratios.max()], rtol=1e-9)
    assert change.min_stretch <= change.p5_stretch <= change.p95_stretch <= change.max_stretch
    assert change.min_area <= change.p5_area <= change.p95_area <= change.max_area
    assert change.worst_aspect >= 2 / 3**0.5 * (1 - 1e-12) and isinstance(change.folds, int)


def test_a_free_mesh_keeps_its_bits() -> None:
    x = X.copy()
    x[3:, 2] += 1.0
    x[0, 0] = -0.0
    result = repair(FACES, x)
    assert result.positions.tobytes() == x.tobytes() and result.before == (0, 0) and result.change.moved == 0


def test_pinned_vertices_keep_their_bits() -> None:
    mesh = Mesh(6, FACES)
    for pinned in ([0, 1, 2], np.array([2, 1, 0, 0], np.uint8), np.arange(3)[::-1]):
        result = repair(mesh, X, pinned=pinned)
        check_repaired(mesh, result)
        assert_array_equal(result.positions[:3], X[:3])
        assert (result.positions[3:] != X[3:]).any()


def test_pinned_vertices_that_intersect_are_named() -> None:
    result = repair(FACES, X, pinned=range(6))
    assert not result.repaired and result.reason == "pinned" and "vertices that do not move" in result.message
    assert_array_equal(result.crossings, Detector(Mesh(6, FACES)).intersections(X))
    assert_array_equal(result.positions, X)
    assert result.before is None and result.change is None
    touching = X.copy()
    touching[3] = [2, 2, 0]
    result = repair(FACES, touching, pinned=range(6))
    assert result.reason == "pinned"
    assert (3, 0) in result.contacts[result.contacts["kind"] == "vf"][["first", "second"]].tolist()


def test_a_minimum_distance_is_reached() -> None:
    mesh = Mesh(6, FACES)
    result = repair(mesh, X, min_distance=0.25)
    check_repaired(mesh, result, 0.25)
    near = X.copy()
    near[3, 2] = 0.125
    result = repair(mesh, near, min_distance=0.25)
    check_repaired(mesh, result, 0.25)
    assert result.before[0] == 0 and result.before[1] > 0
    assert repair(mesh, near).change.moved == 0


def test_pairs_that_cannot_collide_may_intersect() -> None:
    bodies = [0, 0, 0, 1, 1, 1]
    for mesh in (
        Mesh(6, FACES, groups=[0] * 6),
        Mesh(6, FACES, groups=bodies, can_collide=np.eye(2, dtype=bool)),
        Mesh(6, FACES, can_collide=lambda i, j: False),
    ):
        result = repair(mesh, X)
        assert result.repaired and result.before == (0, 0)
        assert_array_equal(result.positions, X)
    for mesh in (Mesh(6, FACES, groups=bodies), Mesh(6, FACES, can_collide=lambda i, j: True)):
        check_repaired(mesh, repair(mesh, X))


def test_float32_positions_are_free_as_they_are_rounded() -> None:
    faces, x = rings()
    mesh = Mesh(len(x), faces)
    result = repair(mesh, x, dtype=np.float32)
    assert result.positions.dtype == np.float32
    check_repaired(mesh, result)
    assert repair(mesh, x).positions.dtype == np.float64
    single = x.astype(np.float32)
    assert repair(mesh, single) == repair(mesh, single.astype(float))
    assert repair(mesh, single[:, ::-1], dtype="f4") == repair(mesh, single[:, ::-1].tolist(), dtype="float32")
    # Pinned vertices keep their bits, so these have to be float32.
    pinned = repair(FACES, X, pinned=[0, 1, 2], dtype=np.float32)
    assert pinned.repaired and pinned.positions[:3].tolist() == X[:3].tolist()
    with pytest.raises(ValueError, match="vertex 2 is pinned, but its position is not exactly float32"):
        repair(FACES, moved(X, 2, 0.1), pinned=[1, 2], dtype="f4")
    with pytest.raises(ValueError, match="vertex 4 has a coordinate beyond the range of single precision"):
        repair(FACES, moved(X, 4, 1e39), dtype=np.float32)


def test_a_surface_with_one_side_is_refused() -> None:
    """The projective plane, half of an icosahedron."""
    faces = [[0, i, i % 5 + 1] for i in range(1, 6)] + [[1, 2, 4], [2, 3, 5], [3, 4, 1], [4, 5, 2], [5, 1, 3]]
    x = np.random.default_rng(0).normal(size=(6, 3))
    result = repair(faces, x)
    assert not result.repaired and result.reason == "one-sided" and "Klein bottle" in result.message
    assert_array_equal(result.positions, x)


def test_the_best_state_and_the_pairs_that_remain() -> None:
    x = np.random.default_rng(1).normal(size=(6, 3))
    mesh = Mesh(6, CONE)
    for dtype in (np.float64, np.float32):
        result = repair(mesh, x, max_rounds=20, dtype=dtype)
        assert not result.repaired and result.reason == "rounds" and "the limit of rounds" in result.message
        assert_array_equal(result.crossings, Detector(mesh).intersections(result.positions))
        assert len(result.crossings) > 0 and result.change is None


def test_a_function_that_stops() -> None:
    faces, x = rings()
    calls: list[RepairProgress] = []
    threads = set()

    def watch(progress: RepairProgress) -> None:
        calls.append(progress)
        threads.add(threading.get_ident())

    result = repair(faces, x, stop=watch)
    assert result == repair(faces, x) and result.repaired
    phases = [["loosen", "separate", "return"].index(call.phase) for call in calls]
    assert phases == sorted(phases)
    assert calls[0] == ("loosen", 0, result.before[0]) and calls[1].round == 1 and calls[-1].phase == "return"
    # Another thread calls it: this one has released the interpreter lock.
    assert threading.get_ident() not in threads

    stopped = repair(faces, x, stop=lambda progress: np.True_)
    assert not stopped.repaired and stopped.reason == "stopped" and len(stopped.crossings) > 0
    assert stopped == repair(faces, x, seconds=0)
    early = repair(faces, x, stop=lambda progress: progress.phase == "return", seconds=np.inf)
    check_repaired(Mesh(len(x), faces), early)
    assert early != result


def test_exceptions_of_functions_are_passed_on() -> None:
    def fail(*_: object) -> bool:
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        repair(FACES, X, stop=fail)
    with pytest.raises(KeyError, match="mine"):
        repair(Mesh(6, FACES, can_collide=fail), X)

    class Undecided:
        def __bool__(self) -> bool:
            raise KeyError("undecided")

    with pytest.raises(KeyError, match="undecided"):
        repair(FACES, X, stop=lambda progress: Undecided())


WRONG = {
    "faces has the dtype <U4, expected integers": lambda: repair("mesh", X),
    "positions has the shape (5, 3), expected (6, 3)": lambda: repair(Mesh(6, FACES), X[:5]),
    "positions has the dtype complex128": lambda: repair(FACES, X.astype(complex)),
    "vertex 3 has x = NaN, expected a finite number": lambda: repair(FACES, moved(X, 3, np.nan), pinned=[3], dtype="f4"),
    "face 1 names vertex 5, but there are only 5 vertices": lambda: repair(FACES, X[:5]),
    "vertex 6 is pinned, but the mesh has 6 vertices": lambda: repair(FACES, X, pinned=[6], dtype=np.float32),
    "row 0 of pinned has an index that is negative": lambda: repair(FACES, X, pinned=[-1]),
    "pinned has the dtype bool, expected integers: np.flatnonzero(mask) has them": lambda: repair(
        FACES, X, pinned=np.zeros(6, bool)
    ),
    "min_distance: ": lambda: repair(FACES, X, min_distance=-1.0),
    "min_distance has the shape (6,)": lambda: repair(FACES, X, min_distance=np.ones(6)),
    "max_rounds is -1, expected an integer from 0": lambda: repair(FACES, X, max_rounds=-1),
    "max_rounds is of type float": lambda: repair(FACES, X, max_rounds=10.0),
    "seconds is -1, expected a number of at least 0": lambda: repair(FACES, X, seconds=-1),
    "seconds is NaN, expected a number of at least 0": lambda: repair(FACES, X, seconds=np.nan),
    "stop is of type int, expected a function": lambda: repair(FACES, X, stop=1),
    "dtype is float16, expected float32 or float64": lambda: repair(FACES, X, dtype=np.float16),
    "threads is 0": lambda: repair(FACES, X, threads=0),
}


@pytest.mark.parametrize("message", WRONG)
def test_wrong_arguments(message: str) -> None:
    with pytest.raises((TypeError, ValueError)) as error:
        WRONG[message]()
    assert message in str(error.value) and "_native" not in str(error.value)


def test_hostile_arguments() -> None:
    random = np.random.default_rng(3)
    answers = 0
    for _ in range(CASES):

        def call() -> None:
            pinned = [None, integers(random, 6, 2)][random.integers(2)]
            dtype = [np.float64, np.float32][random.integers(2)]
            repair(integers(random, 6, 3, 3), positions(random, 6, 3), pinned=pinned, max_rounds=5, dtype=dtype)

        answers += survive(call)
    assert 0 < answers < CASES


def test_a_recording_is_free_in_all_frames_and_between_them() -> None:
    # The second triangle sinks into the first one, which is pinned, and rises again.
    frames = np.array([X + [0, 0, 2], X + [0, 0, 1], X, X + [0, 0, 1]])
    frames[:, :3] = X[:3]
    recording = exact_ccd.repair_recording(FACES, frames, pinned=[0, 1, 2])
    assert recording.blocked is None and recording.frames.shape == frames.shape
    assert len(recording.changes) == 4 and recording.changes[2].moved > 0
    assert_array_equal(recording.frames[:, :3], frames[:, :3])
    detector = Detector(Mesh(6, FACES))
    for before, after in zip(recording.frames, recording.frames[1:]):
        assert len(detector.intersections(after)) == 0
        assert not detector.collides(before, after)


def test_a_recording_without_a_way_ends_before_the_frame() -> None:
    frames = np.array([X + [0, 0, 2], X + [0, 0, 1], X])
    frames[:, :3] = X[:3]
    recording = exact_ccd.repair_recording(FACES, frames, pinned=range(6))
    assert recording.blocked is not None and recording.blocked.frame == 2
    assert len(recording.blocked.contacts) > 0
    assert_array_equal(recording.frames, frames[:2])
