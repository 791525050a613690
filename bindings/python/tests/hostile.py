"""Arguments that are almost valid."""

from __future__ import annotations

import numpy as np

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


def table(random: np.random.Generator):
    """A table of queries, of an arrow type that may not be the right one."""
    import pyarrow as pa

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

    rows = int(random.integers(0, 5))
    kinds = [["vv"] * rows, ["vv", "ve", "vf", "ee"][:rows] + ["vv"] * (rows - 4), [None] * rows, [3] * rows]
    queries = pa.table({"kind": kinds[random.choice(4, p=[0.7, 0.1, 0.1, 0.1])], "points": column(rows)})
    return pa.concat_tables([queries, queries.slice(1)]) if random.random() < 0.3 else queries
