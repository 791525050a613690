"""Calls that compute release the interpreter lock."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable

import numpy as np
import pytest

from exact_ccd import _native

COUNT = 300_000
"""The number of vertices: enough for some milliseconds."""
POINTS = np.random.default_rng(0).normal(size=(COUNT, 3))
FACES = np.arange(COUNT, dtype=np.uint32).reshape(-1, 3)
NO_EDGES = np.empty((0, 2), np.uint32)
BAD_ROW = FACES.copy()
BAD_ROW[-1, -1] = COUNT


def welding() -> _native.Welding:
    found = _native.Welding()
    found.restrict(POINTS)
    return found


def overlaps_of_a_missing_vertex() -> None:
    with pytest.raises(ValueError, match=f"row {COUNT // 3 - 1}: vertex {COUNT}"):
        _native.overlaps(FACES, BAD_ROW, POINTS, POINTS, 0.0, 1)


def mesh() -> _native.Mesh:
    return _native.Mesh(COUNT, FACES, NO_EDGES, None, None, None)


# The arguments are arrays of the compiled part: the conversions of numpy release the lock too.
CALLS: dict[str, Callable[[], Callable[[], object]]] = {
    "Mesh": lambda: mesh,
    "restrict": lambda: welding,
    "primitives": lambda: lambda welding=welding(), mesh=mesh(): welding.primitives(mesh),
    "along_edges": lambda: lambda welding=welding(), mesh=mesh(): welding.along_edges(mesh),
    "overlaps": lambda: overlaps_of_a_missing_vertex,
}


@pytest.mark.parametrize("name", CALLS)
def test_another_thread_runs(name: str) -> None:
    call = CALLS[name]()
    turns = 0
    is_over = threading.Event()

    def count_turns() -> None:
        nonlocal turns
        while not is_over.is_set():
            turns += 1
            time.sleep(0.0001)

    interval = sys.getswitchinterval()
    other = threading.Thread(target=count_turns)
    other.start()
    try:
        # This thread passes on the lock only where it releases it by itself.
        sys.setswitchinterval(600.0)
        # The other thread may wait for the lock by the interval of before.
        former = turns
        while turns < former + 2:
            time.sleep(0.001)
        deadline, before = time.monotonic() + 60.0, turns
        while turns == before and time.monotonic() < deadline:
            call()
        assert turns > before
    finally:
        sys.setswitchinterval(interval)
        is_over.set()
        other.join()
