"""Hostile arguments: an exception or a right answer, never a crash."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

import exact_ccd
from exact_ccd import ipc
from generated import POINTS

CASES = 100
HUGE = np.lib.stride_tricks.as_strided(np.zeros(3), (2**40, 8, 3), (0, 0, 8))
NUMBERS = [0.0, -0.0, 1.0, 5e-324, -5e-324, 1.7e308, -1.7e308, 1e-160, np.nan, np.inf, -np.inf, 0.1]
TYPES = ["f8", "f4", "f2", "g", "i1", "i8", "u8", ">f8", ">i4", "?", "c16", "O", "U3", "M8[s]"]
ALLOWED = (ValueError, TypeError, OverflowError, MemoryError)


def positions(random: np.random.Generator, *shape: int):
    """An array that is almost a valid one."""
    choice = random.integers(12)
    if choice == 0:
        shape = tuple(random.integers(0, 5, random.integers(0, 5)))
    array = random.integers(-2, 3, shape).astype(float)
    if choice in (1, 2, 3) and array.size:
        array.ravel()[random.integers(array.size)] = NUMBERS[random.integers(len(NUMBERS))]
    if choice == 4:
        array = random.choice(NUMBERS[:8], shape)
    if choice == 5:
        with np.errstate(all="ignore"):
            return array.astype(TYPES[random.integers(len(TYPES))])
    if choice == 6:
        return np.lib.stride_tricks.as_strided(array, array.shape, (0,) * array.ndim)
    if choice == 7:
        array.flags.writeable = False
    if choice == 8:
        return np.asfortranarray(array)[::-1]
    if choice == 9:
        return [None, "text", 3, [], [[]], {}, object(), array.tolist(), np.ma.masked_array(array)][
            random.integers(9)
        ]
    if choice == 10:
        return HUGE if random.random() < 0.2 else array[:0]
    return array


def integers(random: np.random.Generator, count: int, *shape: int):
    """Indices that are almost valid."""
    choice = random.integers(8)
    array = random.integers(0, max(count, 1), shape)
    if choice == 0:
        array = random.integers(-3, 2 * count + 1, shape)
    if choice == 1:
        return array.astype(TYPES[random.integers(len(TYPES))])
    if choice == 2:
        return positions(random, *shape)
    if choice == 3 and array.size:
        array.ravel()[0] = random.choice([2**31, 2**32, -1, 2**62])
    if choice == 4:
        return np.asfortranarray(array.astype("i4"))[::-1]
    return array


def survive(call) -> bool:
    """Return True if there was an answer."""
    try:
        call()
    except ALLOWED as error:
        assert str(error) or isinstance(error, MemoryError)
        return False
    return True


@pytest.mark.parametrize("kind", POINTS)
@pytest.mark.parametrize("name", ["collides", "time_of_impact", "contact_count", "contact_times", "impacts"])
def test_queries(name: str, kind: str) -> None:
    random = np.random.default_rng(len(name))
    function = getattr(exact_ccd, name)
    answers = 0
    for _ in range(CASES):
        d = float(random.choice([0.0, 0.0, 1.0, 5e-324, 1.7e308, -1.0, np.nan, np.inf]))
        threads = [None, None, 1, 2, 0, -1][random.integers(6)]
        points = positions(random, 4, 2 * POINTS[kind], 3)
        answers += survive(lambda: function(kind, points, min_distance=d, threads=threads))
        form = {
            "indices": integers(random, 6, 5, POINTS[kind]),
            "vertices_t0": positions(random, 6, 3),
            "vertices_t1": positions(random, 6, 3),
        }
        answers += survive(lambda: function(kind, **form, min_distance=d, threads=threads))
    assert 10 < answers < 2 * CASES


@pytest.mark.parametrize(
    "name", ["is_free", "earliest_contact", "contacts", "free_step", "step", "intersections", "audit"]
)
def test_meshes(name: str) -> None:
    random = np.random.default_rng(len(name))
    answers = 0
    for _ in range(CASES):

        def call() -> None:
            groups = [None, None, integers(random, 3, 6)][random.integers(3)]
            edges = [None, integers(random, 6, 2, 2)][random.integers(2)]
            faces = integers(random, 6, 3, 3)
            x0, x1 = positions(random, 6, 3), positions(random, 6, 3)
            if name == "audit":
                exact_ccd.audit([x0, x1], faces, edges=edges)
                return
            detector = exact_ccd.Detector(exact_ccd.Mesh(6, faces, edges, groups))
            getattr(detector, name)(*([x0] if name == "intersections" else [x0, x1]))

        answers += survive(call)
    assert 0 < answers < CASES


@pytest.mark.parametrize(
    "name", ["is_step_collision_free", "compute_collision_free_stepsize", "has_intersections"]
)
def test_steps_of_ipc(name: str) -> None:
    random = np.random.default_rng(len(name))
    answers = 0
    for _ in range(CASES):
        dim = int(random.integers(2, 4))
        mesh = SimpleNamespace(
            num_vertices=6,
            edges=integers(random, 6, 4, 2),
            faces=integers(random, 6, 2 if dim == 3 else 0, 3),
        )
        x0, x1 = positions(random, 6, dim), positions(random, 6, dim)
        arguments = (mesh, x0) if name == "has_intersections" else (mesh, x0, x1)
        answers += survive(lambda: getattr(ipc, name)(*arguments))
    assert 0 < answers < CASES


def test_tables() -> None:
    pa = pytest.importorskip("pyarrow", reason="pyarrow is not installed: pip install pyarrow")
    random = np.random.default_rng(0)
    lists = [pa.list_, pa.large_list, lambda type: pa.list_(type, 12)]
    numbers = [pa.float64(), pa.float64(), pa.float32(), pa.int64(), pa.uint8(), pa.string(), pa.bool_()]

    def column(rows: int):
        width = int(random.choice([12, 12, 12, 18, 24, 11, 0]))
        values: list = random.integers(0, 3, (rows, width)).tolist()
        if random.random() < 0.3 and rows and width:
            values[random.integers(rows)][0] = [None, np.nan, np.inf, 1e308, 5e-324][random.integers(5)]
        if random.random() < 0.2 and rows:
            values[random.integers(rows)] = [None, [], [1.0]][random.integers(3)]
        chosen = lists[random.integers(3)](numbers[random.integers(len(numbers))])
        try:
            return pa.array(values, chosen)
        except (pa.ArrowException, TypeError):
            return pa.array(values)

    answers = 0
    for _ in range(4 * CASES):
        rows = int(random.integers(0, 5))
        kinds = [["vv"] * rows, ["vv", "ve", "vf", "ee"][:rows] + ["vv"] * (rows - 4), [None] * rows, [3] * rows]
        table = pa.table({"kind": kinds[random.choice(4, p=[0.7, 0.1, 0.1, 0.1])], "points": column(rows)})
        if random.random() < 0.3:
            table = pa.concat_tables([table, table.slice(1)])
        d = float(random.choice([0.0, 1.0, np.nan, -1.0], p=[0.6, 0.2, 0.1, 0.1]))
        answers += survive(lambda: exact_ccd.check(table, min_distance=d))
    assert CASES / 4 < answers < 4 * CASES


@pytest.mark.parametrize(
    ("name", "count"), [("point_point", 4), ("point_edge", 6), ("point_triangle", 8), ("edge_edge", 8)]
)
def test_pairs_of_ipc(name: str, count: int) -> None:
    random = np.random.default_rng(count)
    answers = 0
    for _ in range(CASES):
        points = [positions(random, 3) for _ in range(count)] if random.random() < 0.5 else positions(random, count, 3)
        answers += survive(lambda: getattr(ipc, f"{name}_ccd")(*points))
    assert 0 < answers < CASES
