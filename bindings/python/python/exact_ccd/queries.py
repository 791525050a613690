"""Queries in arrays, and their answers."""

from __future__ import annotations

from typing import Literal, NamedTuple, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._arrays import Indices, Positions, indices, number, positions, thread_count
from ._records import by_value

Kind = Literal["vf", "ee", "ve", "vv"]
"""The kind of a query: ``"vf"``, ``"ee"``, ``"ve"`` or ``"vv"``."""

POINTS: dict[str, int] = dict(_native.KINDS)
"""The kinds in their order, and the number of points of a query of each."""

_NUMBERS = {kind: number for number, kind in enumerate(POINTS)}
_NAMES = ", ".join(f'"{kind}"' for kind in POINTS)

IMPACT = np.dtype(
    [
        ("time", np.float64),
        ("u", np.float64),
        ("v", np.float64),
        ("normal", np.float64, (3,)),
        ("points", np.float64, (2, 3)),
    ]
)
"""The fields of an impact, see :meth:`Queries.impact`."""

Arrays = tuple[int, Positions, Positions, Optional[Indices]]
"""Queries as the compiled part takes them."""


@by_value
class Intervals(NamedTuple):
    """The times at which the primitives of many queries touch, as maximal closed intervals.

    The intervals of query ``i`` are ``times[offsets[i]:offsets[i + 1]]``.

    Attributes
    ----------
    offsets : int64 array of shape (N + 1,)
        The index of the first interval of each query; the last is M.
    times : float64 array of shape (M, 2)
        The first and the last time of each interval, from 0 to 1, both rounded down, in increasing order.
        They are equal for a moment.
    """

    offsets: NDArray[np.int64]
    times: NDArray[np.float64]


def check_kind(kind: object, place: str = "") -> None:
    """Refuse anything but the name of a kind; `place` is a prefix of the message."""
    if not isinstance(kind, str):
        raise TypeError(f"{place}kind is of type {type(kind).__name__}, expected one of {_NAMES}")
    if kind not in POINTS:
        raise ValueError(f"{place}kind {kind!r}, expected one of {_NAMES}")


class Queries:
    """Queries of one kind: pairs of primitives, whose points move in straight lines from t = 0 to t = 1.

    Primitives *touch* at a time if their distance then is at most `separation`. For the separation 0, that is
    contact: they have a common point. Touching counts at t = 0 and at t = 1, too. The answers are exact for
    any finite coordinates: there are no false positives and no false negatives.

    The arrays are read by each method, and must not be changed by another thread meanwhile.

    Parameters
    ----------
    kind : {"vf", "ee", "ve", "vv"}
        A vertex against a face (points p, v1, v2, v3), an edge against an edge (a0, a1, b0, b1), a vertex
        against an edge (p, a, b), or a vertex against a vertex (p, q).
    x0, x1 : array of shape (N, P, 3)
        The positions of the P points of each query at t = 0 and at t = 1, in any unit of length. With
        `vertices`, arrays of shape (V, 3): the positions of vertices that queries have in common. float64
        and float32 with any strides are read where they are.
    vertices : int array of shape (N, P), optional
        The vertices of each query, from 0. int32 and uint32 are not copied.

    Raises
    ------
    ValueError
        If a shape is wrong, or a number is not exactly a float64. A method raises it if a coordinate is not
        finite, or a vertex does not exist; the message names the row.
    TypeError
        If the values are not real numbers.

    Examples
    --------
    A vertex falls through a resting triangle, or stops above it.

    >>> import numpy as np
    >>> from exact_ccd import Queries
    >>> face = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    >>> start = [[[0.25, 0.25, 1], *face]] * 3
    >>> end = [[[0.25, 0.25, z], *face] for z in (-2.0, 0.5, 0.0)]
    >>> Queries("vf", start, end).collides()
    array([ True, False,  True])

    The same by the indices of vertices:

    >>> x0 = np.array([*face, [0.25, 0.25, 1.0]])
    >>> x1 = x0 - [0, 0, 3] * (np.arange(4) == 3)[:, None]
    >>> Queries("vf", x0, x1, [[3, 0, 1, 2]]).collides()
    array([ True])
    """

    __slots__ = ("_arrays", "_kind")

    def __init__(
        self, kind: Kind, x0: ArrayLike, x1: ArrayLike, vertices: Optional[ArrayLike] = None
    ) -> None:
        check_kind(kind)
        self._kind: Kind = kind
        points = POINTS[kind]
        self._arrays: Arrays
        if vertices is None:
            shape = (None, points, 3)
            start, end = positions("x0", x0, shape), positions("x1", x1, shape)
            self._arrays = _NUMBERS[kind], start, end, None
        else:
            start, end = positions("x0", x0, (None, 3)), positions("x1", x1, (None, 3))
            self._arrays = _NUMBERS[kind], start[None], end[None], indices("vertices", vertices, (None, points))
        if len(start) != len(end):
            raise ValueError(f"x1 has the shape {end.shape}, expected that of x0: {start.shape}")

    @property
    def kind(self) -> Kind:
        """The kind of all queries."""
        return self._kind

    def __len__(self) -> int:
        """The number of queries."""
        _, x0, _, vertices = self._arrays
        return len(x0 if vertices is None else vertices)

    def __repr__(self) -> str:
        return f'<exact_ccd.Queries: {len(self)} of kind "{self._kind}">'

    def collides(
        self, *, separation: float = 0.0, until: float = 1.0, threads: Optional[int] = None
    ) -> NDArray[np.bool_]:
        """Decide if the primitives touch.

        Parameters
        ----------
        separation : float
            The distance at which primitives touch, in the unit of the coordinates: a finite number of at least
            0, taken exactly. 0 for contact.
        until : float
            The last time that counts: primitives that first touch later do not collide. The exact time is
            compared, not the rounded one.
        threads : int, optional
            The number of threads, from 1 to 1024; by default the number of cores. No answer depends on it.

        Returns
        -------
        bool array of shape (N,)
            True for the queries that collide.

        Examples
        --------
        A vertex passes another one at the distance 3, in the middle of the step.

        >>> pass_by = Queries("vv", [[[-8, 3, 0], [0, 0, 0]]], [[[8, 3, 0], [0, 0, 0]]])
        >>> pass_by.collides(), pass_by.collides(separation=3.0), pass_by.collides(separation=3.0, until=0.25)
        (array([False]), array([ True]), array([False]))
        """
        return _native.collides(self._arrays, settings(separation, until, threads))

    def time_of_impact(
        self, *, separation: float = 0.0, until: float = 1.0, threads: Optional[int] = None
    ) -> NDArray[np.float64]:
        """Compute the first time at which the primitives touch, correctly rounded down.

        It is the largest float64 not above that time: primitives do not touch before it, and no larger float64
        has this property.

        Parameters
        ----------
        separation, until, threads : float, float, int or None
            As for :meth:`collides`.

        Returns
        -------
        float64 array of shape (N,)
            From 0 to 1; NaN for queries that do not collide.

        Examples
        --------
        >>> face = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
        >>> Queries("vf", [[[0.25, 0.25, 1], *face]], [[[0.25, 0.25, -2], *face]]).time_of_impact().tolist()
        [0.3333333333333333]
        """
        return _native.time_of_impact(self._arrays, settings(separation, until, threads))

    def count(
        self, *, separation: float = 0.0, until: float = 1.0, threads: Optional[int] = None
    ) -> NDArray[np.int64]:
        """Count the contact times, or the intervals of time within a separation.

        Parameters
        ----------
        separation, until, threads : float, float, int or None
            As for :meth:`collides`.

        Returns
        -------
        int64 array of shape (N,)
            The number of distinct contact times, -1 for infinitely many. With a separation above 0, the number
            of the :meth:`intervals`. 0 for queries that do not collide.

        Examples
        --------
        An edge passes through another one.

        >>> rest = [[0, -1, 0], [0, 1, 0]]
        >>> Queries("ee", [[[-1, 0, 1], [1, 0, 1], *rest]], [[[-1, 0, -1], [1, 0, -1], *rest]]).count()
        array([1])
        """
        return _native.time_and_count(self._arrays, settings(separation, until, threads))[1]

    def intervals(
        self, *, separation: float = 0.0, until: float = 1.0, threads: Optional[int] = None
    ) -> Intervals:
        """Compute all times of the step at which the primitives touch.

        Parameters
        ----------
        separation, until, threads : float, float, int or None
            As for :meth:`collides`. All times of a query that collides are computed, also those after `until`.

        Returns
        -------
        Intervals
            The maximal closed intervals of each query; a moment of contact is an interval of length 0.

        Examples
        --------
        >>> pass_by = Queries("vv", [[[-8, 3, 0], [0, 0, 0]]], [[[8, 3, 0], [0, 0, 0]]])
        >>> pass_by.intervals(separation=5.0).times.tolist()
        [[0.25, 0.75]]
        >>> pass_by.intervals(separation=3.0).times.tolist()
        [[0.5, 0.5]]
        >>> pass_by.intervals().offsets.tolist()
        [0, 0]
        """
        return Intervals(*_native.intervals(self._arrays, settings(separation, until, threads)))

    def impact(
        self, *, separation: float = 0.0, until: float = 1.0, threads: Optional[int] = None
    ) -> NDArray[np.void]:
        """Compute the first time at which the primitives touch, and the place.

        Parameters
        ----------
        separation, until, threads : float, float, int or None
            As for :meth:`collides`.

        Returns
        -------
        structured array of shape (N,)
            The fields of :data:`IMPACT`. ``time`` equals :meth:`time_of_impact`. The other fields are
            approximate: ``u`` and ``v``, in [0, 1], are within 2**-32. The primitives meet at
            (1 - u - v) v1 + u v2 + v v3, or at (1 - u) a0 + u a1 and (1 - v) b0 + v b1, where a vertex counts
            as an edge of length zero. ``normal`` is a unit vector from the second primitive to the first, NaN
            if there is none. ``points`` are the closest points of the first primitive and of the second, in
            the unit of the coordinates. All are NaN for queries that do not collide.

        Examples
        --------
        >>> face = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
        >>> impact = Queries("vf", [[[0.25, 0.25, 1], *face]], [[[0.25, 0.25, -1], *face]]).impact()
        >>> impact["time"].tolist(), impact["normal"].tolist()
        ([0.5], [[0.0, 0.0, 1.0]])
        """
        return _native.impact(self._arrays, settings(separation, until, threads)).view(IMPACT).reshape(-1)


def settings(separation: float, until: float, threads: Optional[int]) -> tuple[float, float, Optional[int]]:
    """The options of the answers, as the compiled part takes them."""
    distance, last = number("separation", separation), number("until", until)
    if last != last:
        raise ValueError("until is nan, expected a number")
    return distance, last, thread_count(threads)
