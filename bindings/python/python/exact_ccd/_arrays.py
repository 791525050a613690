"""Conversion of arguments to the arrays of the compiled part: exactly, or not at all."""

from __future__ import annotations

from typing import Any, Optional, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

Floats = NDArray[np.float64]
Positions = NDArray[Union[np.float32, np.float64]]
Indices = NDArray[np.uint32]
Shape = tuple[Optional[int], ...]
"""The sizes that are expected; None, which only the first may be, for any."""

_Number = TypeVar("_Number", bound=np.generic)

MOST_THREADS = 1024
"""The largest number of threads, as in the program."""

_CPU = 1
"""The number of the kind of device in DLPack."""

_IN_PLACE = (np.dtype(np.float64), np.dtype(np.float32))
"""The types of numbers that the compiled part reads as they are."""


def as_array(name: str, values: Union[ArrayLike, tuple[ArrayLike, ...]]) -> NDArray[Any]:
    """The argument as an array: itself, a tensor of DLPack in place, or numbers or arrays in lists."""
    if _is_masked(values):
        raise TypeError(f"{name} is a masked array: the kernel has no missing values")
    if not isinstance(values, np.ndarray) and hasattr(values, "__dlpack__"):
        return _tensor(name, values)
    array = np.asarray(values)
    if array.size == 0 and not isinstance(values, np.ndarray):
        # An empty list has no type of its own.
        array = array.astype(np.float64)
    return array


def _is_masked(values: object, depth: int = 2) -> bool:
    """Return True for a masked array, and for a list of some, or of lists of some. Deeper lists have numbers."""
    if depth > 0 and isinstance(values, (list, tuple)):
        return any(_is_masked(one, depth - 1) for one in values)
    return isinstance(values, np.ma.MaskedArray)


def _tensor(name: str, tensor: Any) -> NDArray[Any]:
    device, _ = tensor.__dlpack_device__()
    if device != _CPU:
        raise TypeError(f"{name} is on a device of kind {int(device)} of DLPack: copy it to the CPU")
    try:
        return np.from_dlpack(tensor)
    except (BufferError, RuntimeError, TypeError, ValueError) as error:
        raise TypeError(f"{name} cannot be read by DLPack: {error}") from error


def _checked(name: str, values: ArrayLike, shape: Shape, kinds: str, expected: str) -> NDArray[Any]:
    """The argument as an array of this shape, of numbers of these kinds."""
    array = as_array(name, values)
    if array.shape[:1] == (0,) and shape[:1] == (None,):
        # Without rows, such as an empty list.
        array = array.reshape(0, *(size or 0 for size in shape[1:]))
    if kinds == "iu" and array.size == 0:
        array = np.empty(array.shape, np.uint32)
    if array.dtype.kind not in kinds:
        hint = ": np.flatnonzero(mask) has them" if kinds == "iu" and array.dtype.kind == "b" else ""
        raise TypeError(f"{name} has the dtype {array.dtype}, expected {expected}{hint}")
    if not _fits(array.shape, shape):
        sizes = ", ".join("N" if size is None else str(size) for size in shape)
        raise ValueError(f"{name} has the shape {array.shape}, expected ({sizes})")
    return array


def _fits(actual: tuple[int, ...], shape: Shape) -> bool:
    return actual == shape or (len(actual) == len(shape) and shape[0] is None and actual[1:] == shape[1:])


def _first_row(differs: NDArray[np.bool_]) -> int:
    """The index of the first row with a value that is set."""
    return int(np.flatnonzero(differs.reshape(len(differs), -1).any(axis=1))[0])


def positions(name: str, values: ArrayLike, shape: Shape, rows: Optional[NDArray[np.intp]] = None) -> Positions:
    """The same numbers as an array of this shape, without a copy of float64 and float32 with any strides.

    Raises the same exceptions as :func:`floats`. Errors name a row by its number in `rows`, by default by its
    index.
    """
    if type(values) is np.ndarray and values.dtype in _IN_PLACE and values.flags.aligned:
        return values if _fits(values.shape, shape) else _checked(name, values, shape, "f", "real numbers")
    return floats(name, values, shape, rows)


def floats(name: str, values: ArrayLike, shape: Shape, rows: Optional[NDArray[np.intp]] = None) -> Floats:
    """The same numbers as a contiguous float64 array of this shape, without a copy where none is needed.

    Raises
    ------
    TypeError
        If the values are not real numbers.
    ValueError
        If the shape differs, or if a number is not exactly a float64.
    """
    array = _checked(name, values, shape, "fiu", "real numbers")
    converted = np.require(array, np.float64, ["C", "A"])
    is_short = array.dtype.itemsize < 8 or array.dtype.kind == "f" and array.dtype.itemsize == 8
    if not is_short:
        _check_exact(name, array, converted, rows)
    return converted


def _check_exact(name: str, array: NDArray[Any], converted: Floats, rows: Optional[NDArray[np.intp]]) -> None:
    """Refuse numbers that the conversion has rounded."""
    if array.dtype.kind == "f":
        differs = (converted != array) & ~np.isnan(array)
    else:
        # Numbers beyond the integers of this type have been rounded up.
        differs = converted >= 2.0 ** (63 if array.dtype.kind == "i" else 64)
        differs |= np.where(differs, 0.0, converted).astype(array.dtype) != array
    if differs.any():
        place = name
        if array.ndim > 0:
            row = _first_row(differs)
            place = f"row {row if rows is None else rows[row]} of {name}"
        raise ValueError(f"{place} has a number that is not exactly a float64")


def indices(name: str, values: ArrayLike, shape: Shape) -> Indices:
    """The same indices as a contiguous uint32 array of this shape; int32 and uint32 are not copied.

    Raises
    ------
    TypeError
        If the values are not integers.
    ValueError
        If the shape differs, or if an index is negative or above 2**32 - 1.
    """
    array = _checked(name, values, shape, "iu", "integers")
    if array.size and (array.dtype.kind == "i" or array.dtype.itemsize > 4):
        low, high = array.min(), array.max()
        if low < 0 or high > 0xFFFF_FFFF:
            row = _first_row((array < 0) | (array > 0xFFFF_FFFF))
            raise ValueError(f"row {row} of {name} has an index that is negative or above 2**32 - 1")
    if array.dtype == np.int32:
        return np.require(array, np.int32, ["C", "A"]).view(np.uint32)
    return np.require(array, np.uint32, ["C", "A"])


def booleans(name: str, values: ArrayLike) -> NDArray[np.bool_]:
    """A contiguous square matrix of booleans, which is not empty.

    Raises
    ------
    TypeError
        If the values are not booleans.
    ValueError
        If the shape differs.
    """
    array = as_array(name, values)
    if array.ndim != 2 or array.shape[0] != array.shape[1] or array.size == 0:
        raise ValueError(f"{name} has the shape {array.shape}, expected (G, G), for G groups")
    if array.dtype != np.bool_:
        raise TypeError(f"{name} has the dtype {array.dtype}, expected booleans: {name} != 0 has them")
    return np.require(array, np.bool_, ["C", "A"])


def number(name: str, value: ArrayLike) -> float:
    """The same number as a float, with the exceptions of :func:`floats`."""
    return value if type(value) is float else float(floats(name, value, ()))


def is_single(dtype: DTypeLike) -> bool:
    """Whether positions are in single precision, else in double precision; a ValueError for other types."""
    if np.dtype(dtype) not in (np.float32, np.float64):
        raise ValueError(f"dtype is {np.dtype(dtype)}, expected float32 or float64")
    return np.dtype(dtype) == np.float32


def distances(values: ArrayLike, count: Optional[int]) -> Floats:
    """A minimum distance of shape (), or one for each of so many vertices, with the exceptions of :func:`floats`."""
    array = as_array("min_distance", values)
    return floats("min_distance", array, (count,) if array.ndim else ())


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
    """A number of threads; None for the number of cores."""
    return None if threads is None else integer("threads", threads, 1, MOST_THREADS)


def frozen(array: NDArray[_Number]) -> NDArray[_Number]:
    """A copy that cannot be written to."""
    own = array.copy()
    own.flags.writeable = False
    # Of a view, the flag cannot be set again.
    return own.view()
