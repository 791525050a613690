"""The answers to steps of a mesh."""

from __future__ import annotations

from typing import Any, NamedTuple, Optional

import numpy as np
from numpy.typing import NDArray

from ._records import by_value
from .contacts import Contact


class PairCounts(NamedTuple):
    """Numbers of pairs, by their kind.

    Attributes
    ----------
    vertex_face, edge_edge : int
        The pairs of a vertex and a face, and of two edges.
    vertex_edge, vertex_vertex : int
        The pairs of a vertex and a loose edge, and of two loose vertices.
    """

    vertex_face: int
    edge_edge: int
    vertex_edge: int
    vertex_vertex: int


class StepReport(NamedTuple):
    """The contacts of a step, counted.

    Attributes
    ----------
    candidates : PairCounts
        The pairs of primitives that come near each other.
    colliding : PairCounts
        The pairs in contact at some time of the step.
    touching : PairCounts
        The pairs in contact at t = 0.
    earliest : Contact or None
        The earliest contact; None if the step is free of contact.
    """

    candidates: PairCounts
    colliding: PairCounts
    touching: PairCounts
    earliest: Optional[Contact]


@by_value
class FreeStep(NamedTuple):
    """A step that is certified to be free of contact.

    Attributes
    ----------
    size : float
        The part of the full step that is taken, from 0 to 1: 1 if the full step is free, 0 if none of
        the sizes that are tried is certified: the mesh touches itself at the start, or is nearer to itself
        there than rounded positions are to the path.
    positions : float64 or float32 array of shape (V, 3)
        The positions at its end. Unless `size` is 0, the straight motion to these very positions has
        been decided to be free of contact, exactly.
    contact : Contact or None
        The earliest contact of the full step; None if it is free.
    touching : PairCounts
        The pairs that touch at the start: all pairs within their minimum distance, even if an
        `inner_distance` holds for them.
    """

    size: float
    positions: NDArray[Any]
    contact: Optional[Contact]
    touching: PairCounts


@by_value
class FirstContacts(NamedTuple):
    """The contacts of a step, and the first one of each vertex: for methods with a rule of their own.

    Attributes
    ----------
    contacts : structured array of shape (M,)
        The contacts, the earliest first, with the fields of :data:`CONTACT`.
    of_vertices : int64 array of shape (V,)
        The index in `contacts` of the first one of a pair to which the vertex belongs; -1 without contact.
    times : float64 array of shape (V,)
        The time of that contact, rounded down; infinity without contact.
    """

    contacts: NDArray[np.void]
    of_vertices: NDArray[np.int64]
    times: NDArray[np.float64]


@by_value
class FreeSteps(NamedTuple):
    """A step for each vertex, such that together they are certified to be free of contact.

    The straight motion from the start to `positions` has been decided exactly: no two primitives touch, except
    the pairs in `blocked`.

    Attributes
    ----------
    sizes : float64 array of shape (V,)
        The fraction of its displacement by which each vertex moves, from 0 to 1. It is 1 if the vertex is pinned,
        or if no contact held it back in any round.
    positions : float64 or float32 array of shape (V, 3)
        The positions after these moves.
    rounds : int
        The number of searches for contact.
    blocked : structured array of shape (M,)
        The pairs that touch, whatever the sizes of the vertices that are not pinned: pairs that touch at
        the start, and pairs that touch even if their vertices that are not pinned stay at the start. Sorted,
        with the fields of :data:`PAIR`.
    """

    sizes: NDArray[np.float64]
    positions: NDArray[Any]
    rounds: int
    blocked: NDArray[np.void]
