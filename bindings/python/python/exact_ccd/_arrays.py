"""Conversion of arguments to the arrays of the compiled part: exactly, or not at all."""

from __future__ import annotations

from typing import Any, Optional, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
Indices = NDArray[np.uint32]
_Number = TypeVar("_Number", bound=np.generic)

MOST_THREADS = 1024
"""The largest number of threads, as in the program."""


def _array(name: str, values: ArrayLike) -> NDArray[Any]:
    """The argument as an array of integers or floating-point numbers."""
    if isinstance(values, np.ma.MaskedArray):
        raise TypeError(f"{name} is a masked array: the kernel has no missing values")
    array = np.asarray(values)
    if array.size == 0 and not isinstance(values, np.ndarray):
        # An empty list has no type of its own.
        array = array.astype(np.float64)
    return array


def _without_rows(array: NDArray[Any], shape: tuple[Optional[int], ...]) -> NDArray[Any]:
    """An array without rows, such as an empty list, in the shape that is expected; others as they are."""
    if array.shape[:1] == (0,) and shape[:1] == (None,):
        return array.reshape(0, *(size or 0 for size in shape[1:]))
    return array


def _first_row(differs: NDArray[np.bool_]) -> int:
    """The index of the first row with a value that is set."""
    return int(np.flatnonzero(differs.reshape(len(differs), -1).any(axis=1))[0])


def floats(name: str, values: ArrayLike, shape: tuple[Optional[int], ...]) -> Floats:
    """The same numbers as a contiguous float64 array of this shape, without a copy where none is needed.

    Raises
    ------
    TypeError
        If the values are not real numbers.
    ValueError
        If the shape differs, or if a number is not exactly a float64.
    """
    array = _without_rows(_array(name, values), shape)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name} has the dtype {array.dtype}, expected real numbers")
    _check_shape(name, array, shape)
    converted = np.require(array, np.float64, ["C", "A"])
    is_short = array.dtype.itemsize < 8 or array.dtype.kind == "f" and array.dtype.itemsize == 8
    if not is_short:
        _check_exact(name, array, converted)
    return converted


def _check_exact(name: str, array: NDArray[Any], converted: Floats) -> None:
    """Refuse numbers that the conversion has rounded."""
    if array.dtype.kind == "f":
        differs = (converted != array) & ~np.isnan(array)
    else:
        # Numbers beyond the integers of this type have been rounded up.
        differs = converted >= 2.0 ** (63 if array.dtype.kind == "i" else 64)
        differs |= np.where(differs, 0.0, converted).astype(array.dtype) != array
    if differs.any():
        place = f"row {_first_row(differs)} of {name}" if array.ndim > 0 else name
        raise ValueError(f"{place} has a number that is not exactly a float64")


def indices(name: str, values: ArrayLike, shape: tuple[Optional[int], ...]) -> Indices:
    """The same indices as a contiguous uint32 array of this shape; int32 and uint32 are not copied.

    Raises
    ------
    TypeError
        If the values are not integers.
    ValueError
        If the shape differs, or if an index is negative or above 2**32 - 1.
    """
    array = _without_rows(_array(name, values), shape)
    if array.size == 0:
        array = np.empty(array.shape, np.uint32)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name} has the dtype {array.dtype}, expected integers")
    _check_shape(name, array, shape)
    if array.size and (array.dtype.kind == "i" or array.dtype.itemsize > 4):
        low, high = array.min(), array.max()
        if low < 0 or high > 0xFFFF_FFFF:
            row = _first_row((array < 0) | (array > 0xFFFF_FFFF))
            raise ValueError(f"row {row} of {name} has an index that is negative or above 2**32 - 1")
    if array.dtype == np.int32:
        return np.require(array, np.int32, ["C", "A"]).view(np.uint32)
    return np.require(array, np.uint32, ["C", "A"])


def number(name: str, value: ArrayLike) -> float:
    """The same number as a float, with the exceptions of :func:`floats`."""
    return value if type(value) is float else float(floats(name, value, ()))


def integer(name: str, value: object, low: int, high: int) -> int:
    """An integer from `low` to `high`.

    Raises
    ------
    TypeError
        If the value is no integer.
    ValueError
        If it is below or above.
    """
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)):
        raise TypeError(f"{name} is of type {type(value).__name__}, expected an integer")
    if not low <= value <= high:
        raise ValueError(f"{name} is {value}, expected an integer from {low} to {high}")
    return int(value)


def thread_count(threads: Optional[int]) -> Optional[int]:
    """A number of threads; None for that of the cores."""
    return None if threads is None else integer("threads", threads, 1, MOST_THREADS)


def frozen(array: NDArray[_Number]) -> NDArray[_Number]:
    """The same array, which cannot be written to: a copy, if the caller could."""
    own = array.copy() if array.flags.writeable else array
    own.flags.writeable = False
    # Of a view, the flag cannot be set again.
    return own.view()


def _check_shape(name: str, array: NDArray[Any], shape: tuple[Optional[int], ...]) -> None:
    fits = len(array.shape) == len(shape) and all(
        expected is None or actual == expected for actual, expected in zip(array.shape, shape)
    )
    if not fits:
        expected = ", ".join("N" if size is None else str(size) for size in shape)
        raise ValueError(f"{name} has the shape {array.shape}, expected ({expected})")
