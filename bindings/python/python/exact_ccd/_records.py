"""Records with arrays: named tuples that compare by value."""

from __future__ import annotations

from typing import Any, TypeVar

import numpy as np

_Record = TypeVar("_Record", bound=type)


def by_value(record: _Record) -> _Record:
    """Decorate a named tuple with arrays: two are equal if all numbers are; NaN equals NaN.

    The comparison of tuples has no answer for arrays of several numbers.
    """
    for name, method in (("__eq__", _eq), ("__ne__", _ne), ("__hash__", _hash)):
        setattr(record, name, method)
    return record


def _eq(self: Any, other: object) -> Any:
    if not isinstance(other, tuple):
        return NotImplemented
    return len(self) == len(other) and all(map(same, self, other))


def _ne(self: Any, other: object) -> Any:
    equal = _eq(self, other)
    return equal if equal is NotImplemented else not equal


def _hash(self: Any) -> int:
    # Without the numbers in arrays: 0.0 and -0.0 are equal, and two records rarely differ in arrays only.
    return hash(tuple(np.shape(value) if isinstance(value, np.ndarray) else value for value in self))


def same(a: Any, b: Any) -> bool:
    """Return True if two numbers, arrays or other values are equal; NaN equals NaN."""
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        x, y = np.asarray(a), np.asarray(b)
        names = x.dtype.names or ()
        if names and x.dtype == y.dtype and x.shape == y.shape:
            # Numpy compares structures without `equal_nan`.
            return all(same(x[name], y[name]) for name in names)
        return np.array_equal(x, y, equal_nan=x.dtype.kind == y.dtype.kind == "f")
    # A parameter may be NaN, too.
    return bool(a == b or a != a and b != b)
