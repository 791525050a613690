"""Contact of two primitives in two or three dimensions."""

from __future__ import annotations

from math import inf, isnan
from typing import Union

import numpy as np
from numpy.typing import ArrayLike

from .._arrays import Floats, as_array, floats, number
from ..queries import Kind, Queries
from .rescaling import CONSERVATIVE_RESCALING, check_rescaling


def _ccd(
    kind: Kind, points: tuple[ArrayLike, ...], min_distance: float, tmax: float, conservative_rescaling: float
) -> tuple[bool, float]:
    """The decision for one query, and its time; infinity if there is no contact until `tmax`."""
    rescaling = check_rescaling(conservative_rescaling)
    distance, last = check_distance("min_distance", min_distance), number("tmax", tmax)
    if isnan(last):
        raise ValueError("tmax is nan, expected a number")
    x = in_space(coordinates("points", points))
    half = len(x) // 2
    query = Queries(kind, x[None, :half], x[None, half:])
    (time,) = query.time_of_impact(separation=distance, until=last).tolist()
    return (False, inf) if isnan(time) else (True, rescaling * time)


def in_space(x: Floats) -> Floats:
    """The points with z = 0 if they have two coordinates."""
    return np.hstack([x, np.zeros((len(x), 1))]) if x.shape[1] == 2 else x


def coordinates(name: str, points: Union[ArrayLike, tuple[ArrayLike, ...]]) -> Floats:
    """The points, each with its two or three coordinates."""
    array = as_array(name, points)
    return floats(name, array, (None, 2 if array.ndim == 2 and array.shape[1] == 2 else 3))


def check_distance(name: str, value: ArrayLike) -> float:
    """Return a distance; refuse a number that is not finite or below 0."""
    distance = number(name, value)
    if not 0.0 <= distance < inf:
        raise ValueError(f"{name} is {distance}, expected a finite number of at least 0")
    return distance


def point_point_ccd(
    p0_t0: ArrayLike,
    p1_t0: ArrayLike,
    p0_t1: ArrayLike,
    p1_t1: ArrayLike,
    min_distance: float = 0.0,
    tmax: float = 1.0,
    conservative_rescaling: float = CONSERVATIVE_RESCALING,
) -> tuple[bool, float]:
    """Decide if two points come within `min_distance` of each other until `tmax`, and when.

    Parameters
    ----------
    p0_t0, p1_t0, p0_t1, p1_t1 : arrays of shape (2,) or (3,)
        The points at t = 0 and at t = 1.
    min_distance : float
        The distance at which they count as touching.
    tmax : float
        The end of the time that is examined, and part of it. A contact at 1/3, which is no float64, is after
        the largest float64 below it.
    conservative_rescaling : float
        The factor of the exact time that is returned, above 0 and at most 1.

    Returns
    -------
    bool, float
        True and the time, or False and infinity. The time is 0 if they touch at t = 0.

    Examples
    --------
    >>> point_point_ccd([0, 0], [1, 0], [1, 0], [0, 0], conservative_rescaling=1.0)
    (True, 0.5)
    """
    points = (p0_t0, p1_t0, p0_t1, p1_t1)
    return _ccd("vv", points, min_distance, tmax, conservative_rescaling)


def point_edge_ccd(
    p_t0: ArrayLike,
    e0_t0: ArrayLike,
    e1_t0: ArrayLike,
    p_t1: ArrayLike,
    e0_t1: ArrayLike,
    e1_t1: ArrayLike,
    min_distance: float = 0.0,
    tmax: float = 1.0,
    conservative_rescaling: float = CONSERVATIVE_RESCALING,
) -> tuple[bool, float]:
    """Decide if a point and an edge come within `min_distance` until `tmax`, and when.

    Parameters
    ----------
    p_t0, e0_t0, e1_t0, p_t1, e0_t1, e1_t1 : array of shape (2,) or (3,)
        The points at t = 0 and at t = 1.
    min_distance, tmax, conservative_rescaling : float
        As for :func:`point_point_ccd`.

    Returns
    -------
    tuple of bool and float
        As of :func:`point_point_ccd`.

    Examples
    --------
    >>> e0, e1 = [-1, 0], [1, 0]
    >>> point_edge_ccd([0, 1], e0, e1, [0, -1], e0, e1)
    (True, 0.45)
    """
    points = (p_t0, e0_t0, e1_t0, p_t1, e0_t1, e1_t1)
    return _ccd("ve", points, min_distance, tmax, conservative_rescaling)


def point_triangle_ccd(
    p_t0: ArrayLike,
    t0_t0: ArrayLike,
    t1_t0: ArrayLike,
    t2_t0: ArrayLike,
    p_t1: ArrayLike,
    t0_t1: ArrayLike,
    t1_t1: ArrayLike,
    t2_t1: ArrayLike,
    min_distance: float = 0.0,
    tmax: float = 1.0,
    conservative_rescaling: float = CONSERVATIVE_RESCALING,
) -> tuple[bool, float]:
    """Decide if a point and a triangle come within `min_distance` until `tmax`, and when.

    Parameters
    ----------
    p_t0, t0_t0, t1_t0, t2_t0, p_t1, t0_t1, t1_t1, t2_t1 : array of shape (2,) or (3,)
        The points at t = 0 and at t = 1.
    min_distance, tmax, conservative_rescaling : float
        As for :func:`point_point_ccd`.

    Returns
    -------
    tuple of bool and float
        As of :func:`point_point_ccd`.

    Examples
    --------
    >>> face = [0, 0, 0], [1, 0, 0], [0, 1, 0]
    >>> point_triangle_ccd([0.25, 0.25, 1], *face, [0.25, 0.25, 0.5], *face)
    (False, inf)
    """
    points = (p_t0, t0_t0, t1_t0, t2_t0, p_t1, t0_t1, t1_t1, t2_t1)
    return _ccd("vf", points, min_distance, tmax, conservative_rescaling)


def edge_edge_ccd(
    ea0_t0: ArrayLike,
    ea1_t0: ArrayLike,
    eb0_t0: ArrayLike,
    eb1_t0: ArrayLike,
    ea0_t1: ArrayLike,
    ea1_t1: ArrayLike,
    eb0_t1: ArrayLike,
    eb1_t1: ArrayLike,
    min_distance: float = 0.0,
    tmax: float = 1.0,
    conservative_rescaling: float = CONSERVATIVE_RESCALING,
) -> tuple[bool, float]:
    """Decide if two edges come within `min_distance` until `tmax`, and when.

    Parameters
    ----------
    ea0_t0, ea1_t0, eb0_t0, eb1_t0, ea0_t1, ea1_t1, eb0_t1, eb1_t1 : array of shape (2,) or (3,)
        The points at t = 0 and at t = 1.
    min_distance, tmax, conservative_rescaling : float
        As for :func:`point_point_ccd`.

    Returns
    -------
    tuple of bool and float
        As of :func:`point_point_ccd`.
    """
    points = (ea0_t0, ea1_t0, eb0_t0, eb1_t0, ea0_t1, ea1_t1, eb0_t1, eb1_t1)
    return _ccd("ee", points, min_distance, tmax, conservative_rescaling)
