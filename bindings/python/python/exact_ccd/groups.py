"""Groups of vertices: the pairs of them that can collide, and their names."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Literal, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import Indices, booleans, frozen

Rule = Callable[[int, int], object]
"""A function of two vertices: true if they can collide."""

CanCollide = Union[Rule, ArrayLike]
"""A function of two vertices, or a symmetric boolean matrix (G, G) of groups."""

Primitive = Literal["vertex", "edge", "face"]


class Place(NamedTuple):
    """A primitive of a mesh by the body that it belongs to, see :meth:`Mesh.place`.

    Attributes
    ----------
    body : str
        The name of the group of all of its vertices.
    kind : {"vertex", "edge", "face"}
        The kind of primitive.
    id : int
        Its index among the primitives of this kind that the body has. If no face belongs to several bodies, it is
        the index in a :class:`Mesh` of the body alone.

    Examples
    --------
    >>> str(Place("hand", "face", 12))
    'hand: face 12'
    """

    body: str
    kind: Primitive
    id: int

    def __str__(self) -> str:
        return f"{self.body}: {self.kind} {self.id}"


def rule_of(can_collide: Optional[CanCollide]) -> Optional[Rule]:
    """The function of two vertices, if it is one."""
    return can_collide if callable(can_collide) else None


def matrix_of(can_collide: Optional[CanCollide], groups: Optional[Indices]) -> Optional[NDArray[np.bool_]]:
    """The matrix of groups, if it is one."""
    if can_collide is None or callable(can_collide):
        return None
    if np.ndim(can_collide) == 0:
        raise TypeError(
            "can_collide is not callable, nor a matrix: expected a function of two vertices, or an array (G, G) of booleans"
        )
    if groups is None:
        raise TypeError("can_collide is a matrix of groups, but groups is missing: give the number of the group of each vertex")
    return frozen(booleans("can_collide", can_collide))


def strings(names: Sequence[str]) -> tuple[str, ...]:
    """The names, each of which is checked."""
    given = (names,) if isinstance(names, str) else tuple(names)
    for number, name in enumerate(given):
        if not isinstance(name, str):
            raise TypeError(f"name {number} is of type {type(name).__name__}, expected a str")
    return given


def names_of(names: Optional[Sequence[str]], groups: Optional[Indices]) -> Optional[tuple[str, ...]]:
    """The name of each group."""
    if names is None:
        return None
    if groups is None:
        raise TypeError("names are for groups, but groups is missing: give the number of the group of each vertex")
    given = strings(names)
    if groups.size and groups.max() >= len(given):
        vertex = int(np.argmax(groups >= len(given)))
        raise ValueError(f"vertex {vertex} is in group {groups[vertex]}, but there are only {len(given)} names")
    return given


def place_of(
    names: Optional[tuple[str, ...]], groups: Optional[Indices], kind: Primitive, rows: Indices, index: int
) -> Optional[Place]:
    """The place of a primitive among rows of vertices; None without names, or if its vertices are of several groups."""
    if names is None or groups is None:
        return None
    own = groups[rows[index]]
    if (own != own[0]).any():
        return None
    before = (groups[rows[:index]] == own[0]).all(axis=1)
    return Place(names[int(own[0])], kind, int(np.count_nonzero(before)))


def numbers_in(groups: Indices, rows: Indices) -> NDArray[np.int64]:
    """The index of each row of vertices among the rows of its group; -1 if its vertices are of several groups."""
    of_rows = groups[rows]
    (within,) = np.nonzero((of_rows == of_rows[:, :1]).all(axis=1))
    order = within[np.argsort(of_rows[within, 0], kind="stable")]
    own = of_rows[order, 0]
    starts = np.searchsorted(own, own)
    numbers = np.full(len(rows), -1, np.int64)
    numbers[order] = np.arange(len(order)) - starts
    return numbers
