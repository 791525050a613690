"""Answers to queries in arrays."""

from __future__ import annotations

from typing import Literal, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._arrays import Floats, Indices, floats, indices as integers, number, thread_count
from ._records import by_value

Kind = Literal["vf", "ee", "ve", "vv"]
"""The kind of a query: ``"vf"``, ``"ee"``, ``"ve"`` or ``"vv"``."""

POINTS: dict[str, int] = dict(_native.KINDS)
"""The kinds in their order, and the number of points of a query of each."""

IMPACT = np.dtype(
    [
        ("time", np.float64),
        ("u", np.float64),
        ("v", np.float64),
        ("normal", np.float64, (3,)),
        ("points", np.float64, (2, 3)),
    ]
)
"""The fields of an impact, see :func:`impacts`."""


@by_value
class ContactTimes(NamedTuple):
    """The times of contact of many queries.

    Those of query ``i`` are ``intervals[offsets[i]:offsets[i + 1]]``.

    Attributes
    ----------
    offsets : int64 array of shape (N + 1,)
        The index of the first interval of each query; the last is M.
    intervals : float64 array of shape (M, 2)
        The first and the last time of each maximal interval of contact, both rounded down, in
        increasing order. They are equal for a moment.
    """

    offsets: NDArray[np.int64]
    intervals: NDArray[np.float64]


_Arrays = Union[Floats, tuple[Indices, Floats, Floats]]


def check_kind(kind: str, place: str = "") -> None:
    """Refuse a name that is not that of a kind; `place` is a prefix of the message."""
    names = ", ".join(f'"{name}"' for name in POINTS)
    if not isinstance(kind, str):
        raise TypeError(f"{place}kind is of type {type(kind).__name__}, expected one of {names}")
    if kind not in POINTS:
        raise ValueError(f"{place}kind {kind!r}, expected one of {names}")


def _arrays(
    kind: str,
    points: Optional[ArrayLike],
    indices: Optional[ArrayLike],
    vertices_t0: Optional[ArrayLike],
    vertices_t1: Optional[ArrayLike],
) -> _Arrays:
    """The queries as arrays of the compiled part."""
    check_kind(kind)
    count = POINTS[kind]
    if indices is None and vertices_t0 is None and vertices_t1 is None and points is not None:
        return floats("points", points, (None, 2 * count, 3))
    if points is not None or indices is None or vertices_t0 is None or vertices_t1 is None:
        raise TypeError("expected either points, or indices with vertices_t0 and vertices_t1")
    return (
        integers("indices", indices, (None, count)),
        floats("vertices_t0", vertices_t0, (None, 3)),
        floats("vertices_t1", vertices_t1, (None, 3)),
    )


def _settings(min_distance: float, threads: Optional[int]) -> tuple[float, Optional[int]]:
    """The distance and the number of threads, as the compiled part takes them."""
    return number("min_distance", min_distance), thread_count(threads)


def collides(
    kind: Kind,
    points: Optional[ArrayLike] = None,
    *,
    indices: Optional[ArrayLike] = None,
    vertices_t0: Optional[ArrayLike] = None,
    vertices_t1: Optional[ArrayLike] = None,
    min_distance: float = 0.0,
    threads: Optional[int] = None,
) -> NDArray[np.bool_]:
    """Decide contact, exactly.

    A query is two primitives, whose vertices move in straight lines from t = 0 to t = 1. They are in
    contact if they have a common point at some time of the step; touching counts, at t = 0 and at
    t = 1 too. There are no false positives and no false negatives, for any finite coordinates.

    Parameters
    ----------
    kind : {"vf", "ee", "ve", "vv"}
        A vertex against a face (points p, v1, v2, v3), an edge against an edge (a0, a1, b0, b1), a
        vertex against an edge (p, a, b), or a vertex against a vertex (p, q).
    points : array of shape (N, 8, 3), for "ve" (N, 6, 3), for "vv" (N, 4, 3)
        The points of each query at t = 0, then the same at t = 1.
    indices : array of shape (N, 4), for "ve" (N, 3), for "vv" (N, 2)
        In place of `points`: the vertices of each query. int32 and uint32 are not copied.
    vertices_t0, vertices_t1 : arrays of shape (V, 3)
        The positions of the vertices at t = 0 and at t = 1.
    min_distance : float
        Primitives that come within this distance of each other count as touching, in the unit of the
        coordinates. 0 for contact.
    threads : int, optional
        The number of threads; by default that of the cores. The answers do not depend on it.

    Returns
    -------
    bool array of shape (N,)

    Raises
    ------
    ValueError
        If a shape is wrong, a coordinate is not finite or not exactly a float64, or an index is out of
        range; the message names the row.
    TypeError
        If the values are not real numbers.

    Notes
    -----
    A contiguous array of float64 is not copied. The interpreter lock is released, so another thread
    must not write to the arrays meanwhile.

    Examples
    --------
    A vertex falls through a resting triangle, or stops above it.

    >>> import numpy as np
    >>> import exact_ccd
    >>> face = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    >>> def fall(z):
    ...     return [[0.25, 0.25, 1], *face, [0.25, 0.25, z], *face]
    >>> exact_ccd.collides("vf", [fall(-2.0), fall(0.5), fall(0.0)])
    array([ True, False,  True])

    The same by the indices of vertices:

    >>> x0 = np.array([*face, [0.25, 0.25, 1.0]])
    >>> x1 = x0 - [0, 0, 3] * (np.arange(4) == 3)[:, None]
    >>> exact_ccd.collides("vf", indices=[[3, 0, 1, 2]], vertices_t0=x0, vertices_t1=x1)
    array([ True])
    """
    arrays = _arrays(kind, points, indices, vertices_t0, vertices_t1)
    return _native.collides(kind, arrays, *_settings(min_distance, threads))


def time_of_impact(
    kind: Kind,
    points: Optional[ArrayLike] = None,
    *,
    indices: Optional[ArrayLike] = None,
    vertices_t0: Optional[ArrayLike] = None,
    vertices_t1: Optional[ArrayLike] = None,
    min_distance: float = 0.0,
    threads: Optional[int] = None,
) -> NDArray[np.float64]:
    """Compute the earliest contact time, correctly rounded down.

    It is the largest float64 not above the earliest contact time: the step is free of contact before
    it, and no larger float64 has this property.

    Parameters and exceptions are those of :func:`collides`.

    Returns
    -------
    float64 array of shape (N,)
        From 0 to 1; NaN where there is no contact.

    Examples
    --------
    >>> face = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    >>> time_of_impact("vf", [[[0.25, 0.25, 1], *face, [0.25, 0.25, -2], *face]]).tolist()
    [0.3333333333333333]
    """
    arrays = _arrays(kind, points, indices, vertices_t0, vertices_t1)
    return _native.time_of_impact(kind, arrays, *_settings(min_distance, threads))


def contact_count(
    kind: Kind,
    points: Optional[ArrayLike] = None,
    *,
    indices: Optional[ArrayLike] = None,
    vertices_t0: Optional[ArrayLike] = None,
    vertices_t1: Optional[ArrayLike] = None,
    min_distance: float = 0.0,
    threads: Optional[int] = None,
) -> NDArray[np.int64]:
    """Count the distinct contact times.

    Parameters and exceptions are those of :func:`collides`.

    Returns
    -------
    int64 array of shape (N,)
        The number of contact times, -1 for infinitely many. With a `min_distance` above 0, the number
        of maximal intervals of time within it.

    Examples
    --------
    An edge passes through another one.

    >>> rest = [[0, -1, 0], [0, 1, 0]]
    >>> contact_count("ee", [[[-1, 0, 1], [1, 0, 1], *rest, [-1, 0, -1], [1, 0, -1], *rest]])
    array([1])
    """
    arrays = _arrays(kind, points, indices, vertices_t0, vertices_t1)
    return _native.contact_count(kind, arrays, *_settings(min_distance, threads))


def contact_times(
    kind: Kind,
    points: Optional[ArrayLike] = None,
    *,
    indices: Optional[ArrayLike] = None,
    vertices_t0: Optional[ArrayLike] = None,
    vertices_t1: Optional[ArrayLike] = None,
    min_distance: float = 0.0,
    threads: Optional[int] = None,
) -> ContactTimes:
    """Compute all times of contact, as maximal closed intervals.

    Parameters and exceptions are those of :func:`collides`.

    Returns
    -------
    ContactTimes
        The intervals of each query; a moment of contact is an interval of length 0.

    Examples
    --------
    A vertex passes another one at the distance 3.

    >>> pass_by = [[[-8, 3, 0], [0, 0, 0], [8, 3, 0], [0, 0, 0]]]
    >>> contact_times("vv", pass_by, min_distance=5.0).intervals.tolist()
    [[0.25, 0.75]]
    >>> contact_times("vv", pass_by, min_distance=3.0).intervals.tolist()
    [[0.5, 0.5]]
    >>> contact_times("vv", pass_by).offsets.tolist()
    [0, 0]
    """
    arrays = _arrays(kind, points, indices, vertices_t0, vertices_t1)
    return ContactTimes(*_native.contact_times(kind, arrays, *_settings(min_distance, threads)))


def impacts(
    kind: Kind,
    points: Optional[ArrayLike] = None,
    *,
    indices: Optional[ArrayLike] = None,
    vertices_t0: Optional[ArrayLike] = None,
    vertices_t1: Optional[ArrayLike] = None,
    min_distance: float = 0.0,
    threads: Optional[int] = None,
) -> NDArray[np.void]:
    """Compute the earliest contact: time, parameters, normal and points.

    Parameters and exceptions are those of :func:`collides`.

    Returns
    -------
    structured array of shape (N,), with the fields of :data:`IMPACT`
        ``time`` is that of :func:`time_of_impact`. The others are approximate: ``u`` and ``v``, in
        [0, 1], are within 2**-32. The primitives meet at (1 - u - v) v1 + u v2 + v v3, or at
        (1 - u) a0 + u a1 and (1 - v) b0 + v b1, where a vertex counts as an edge of length zero.
        ``normal`` is a unit vector from the second primitive to the first, NaN if there is none.
        ``points`` are the points of contact on the first primitive and on the second. All are NaN where
        there is no contact.

    Examples
    --------
    >>> face = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    >>> impact = impacts("vf", [[[0.25, 0.25, 1], *face, [0.25, 0.25, -1], *face]])
    >>> impact["time"].tolist(), impact["normal"].tolist()
    ([0.5], [[0.0, 0.0, 1.0]])
    """
    arrays = _arrays(kind, points, indices, vertices_t0, vertices_t1)
    return _native.impacts(kind, arrays, *_settings(min_distance, threads)).view(IMPACT).reshape(-1)
