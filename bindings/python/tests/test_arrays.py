"""Arrays in and out: tensors of DLPack, and arrays that are not copied."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest

import exact_ccd
from exact_ccd import Detector, Mesh, Queries, ipc
from generated import of_points, queries
from test_meshes import FACES, two_triangles


class Tensor:
    """An array that has nothing but the methods of DLPack."""

    def __init__(self, array: np.ndarray, device: int = 1) -> None:
        self._array, self._device = array, device

    def __dlpack__(self, **arguments: object) -> object:
        if self._array.dtype.kind not in "fiu":
            raise BufferError("no such type")
        return self._array.__dlpack__()

    def __dlpack_device__(self) -> tuple[int, int]:
        return self._device, 0


@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.int64])
def test_tensors_are_arguments(dtype) -> None:
    points = queries("vf", 300).astype(dtype)
    x0, x1 = points[:, :4], points[:, 4:]
    expected = Queries("vf", x0, x1).time_of_impact()
    assert np.array_equal(Queries("vf", Tensor(x0), Tensor(x1)).time_of_impact(), expected, equal_nan=True)
    mesh = Mesh(6, Tensor(np.array(FACES, np.int64)))
    start, end = (two_triangles(z).astype(dtype) for z in (1.0, -1.0))
    assert Detector(mesh).collision(Tensor(start), Tensor(end)).time == 0.5


def test_tensors_that_are_refused() -> None:
    x = queries("vf", 3)[:, :4].copy()
    with pytest.raises(TypeError, match="x1 is on a device of kind 2 of DLPack: copy it to the CPU"):
        Queries("vf", x, Tensor(x, device=2))
    with pytest.raises(TypeError, match="x0 cannot be read by DLPack: no such type"):
        Queries("vf", Tensor(x.astype(complex)), x)


ENDS = two_triangles(1.0), two_triangles(-1.0)
EDGES = np.array([[0, 1], [1, 2], [0, 2], [3, 4], [4, 5], [3, 5]])
STEP = {
    "positions": lambda of: ipc.compute_collision_free_stepsize(Mesh(6, FACES), *map(of, ENDS)),
    "positions at rest": lambda of: ipc.has_intersections(Mesh(6, FACES), of(ENDS[1])),
    "candidates": lambda of: ipc.Candidates().build(Mesh(6, FACES), of(ENDS[0]), of(ENDS[1])),
    "rest positions": lambda of: ipc.CollisionMesh(of(ENDS[0]), EDGES, FACES).dim,
    "distances": lambda of: exact_ccd.audit(ENDS, FACES, min_distance=of(np.ones(6))).is_free,
    "distances of half spaces": lambda of: exact_ccd.audit(
        [ENDS[0]], FACES, half_spaces=[[[0, 0, -1], [0, 0, 1]]], min_distance=of(np.ones(6))
    ).violation.half_space,
    "frames in one": lambda of: exact_ccd.audit(of(np.stack(ENDS)), FACES).violation.contact.time,
    "frames": lambda of: exact_ccd.audit([of(end) for end in ENDS], FACES).violation.contact.time,
}


@pytest.mark.parametrize("name", STEP)
def test_every_argument_is_read_in_one_way(name: str) -> None:
    assert STEP[name](Tensor) == STEP[name](np.array)
    with pytest.raises(TypeError, match="is a masked array"):
        STEP[name](np.ma.array)


def test_masked_points_of_a_pair() -> None:
    with pytest.raises(TypeError, match="points is a masked array"):
        ipc.point_point_ccd(np.ma.array([0.0, 0, 0], mask=[1, 0, 0]), [1, 0, 0], [1, 0, 0], [0, 0, 0])
    masked = np.ma.array([0.0, 0, 0], mask=[1, 0, 0])
    with pytest.raises(TypeError, match="x0 is a masked array"):
        Queries("vv", [[masked, [0, 0, 0]]], [[[1, 0, 0], [0, 0, 0]]])


def test_a_view_that_cannot_be_written_to_is_copied() -> None:
    """Its numbers may change by the array that it is a view of."""
    groups, thickness = np.zeros(6, np.uint32), np.zeros(6)
    views = [groups.view(), thickness.view()]
    for view in views:
        view.flags.writeable = False
    detector = Detector(Mesh(6, FACES, groups=views[0]), min_distance=views[1])
    groups[:], thickness[:] = 7, 1.0
    assert detector.mesh.groups.tolist() == [0] * 6
    assert detector == Detector(Mesh(6, FACES, groups=[0] * 6), min_distance=[0.0] * 6)


def test_results_are_tensors() -> None:
    """An array of numpy is one itself; the fields of records, too."""
    points = of_points("vf", queries("vf", 30))
    impact = points.impact()
    for result in (points.time_of_impact(), points.count(), points.intervals().times, impact["time"], impact["normal"]):
        assert np.shares_memory(np.from_dlpack(Tensor(result)), result)
    contacts = Detector(Mesh(6, FACES)).collisions(two_triangles(1.0), two_triangles(-1.0))
    assert np.from_dlpack(Tensor(contacts["points"])).shape == (1, 2, 3)


@pytest.mark.parametrize("dtype", ["f4", "f8"])
def test_queries_are_not_copied(dtype: str) -> None:
    """All queries are one in memory: a copy of both ends as float64 would take 400 MB."""
    code = f"""
import resource, numpy as np, exact_ccd
x = np.array([[0.25, 0.25, 1], [0, 0, 0], [1, 0, 0], [0, 1, 0]], "{dtype}")
x0, x1 = (np.broadcast_to(a, (2**21, 4, 3)) for a in (x, x * np.array([1, 1, -1], "{dtype}")))
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
assert exact_ccd.Queries("vf", x0, x1).collides().all()
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)
"""
    pytest.importorskip("resource", reason="the system does not report the memory of a process")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert int(done.stdout) < 50_000, "KiB"


def test_more_queries_than_memory() -> None:
    x = np.broadcast_to(np.zeros((2, 3)), (2**48, 2, 3))
    with pytest.raises(MemoryError, match="no memory for 281474976710656 results"):
        Queries("vv", x, x).time_of_impact()
    worlds = exact_ccd.Worlds(Mesh(2, []))
    with pytest.raises(MemoryError):
        worlds.collides(x, x)
