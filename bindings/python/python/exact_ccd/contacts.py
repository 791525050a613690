"""Contacts of meshes."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, Optional

import numpy as np
from numpy.typing import NDArray

from ._records import by_value
from .groups import Place, Primitive
from .queries import IMPACT, POINTS, Kind

if TYPE_CHECKING:
    from .meshes import Mesh

PAIR = np.dtype([("kind", "U2"), ("first", np.uint32), ("second", np.uint32), ("vertices", np.int64, (4,))])
"""The fields of a pair of primitives of a mesh: the first fields of :class:`Contact`."""

CONTACT = np.dtype([*PAIR.descr, *IMPACT.descr, ("distance", np.float64, (2,))])
"""The fields of a contact of a mesh: all fields of :class:`Contact` except `places`."""

PairColumns = tuple[NDArray[np.uint8], NDArray[np.uint32], NDArray[np.int64]]
"""The columns of pairs: kinds, indices of both primitives, vertices."""

Places = tuple[Optional[Place], Optional[Place]]
"""The places of both primitives of a pair; None for those without names."""

_PRIMITIVES: dict[str, Primitive] = {"v": "vertex", "e": "edge", "f": "face"}

Columns = tuple[NDArray[np.int64], PairColumns, NDArray[np.float64], NDArray[np.float64]]
"""The index of the first contact of each world, and the columns of the contacts: pairs, impacts, distances."""


@by_value
class Contact(NamedTuple):
    """Two primitives of a mesh that touch in a step, and the first time at which they do.

    Two contacts are equal if all of their numbers are.

    Attributes
    ----------
    kind : {"vf", "ee", "ve", "vv"}
        A vertex and a face, two edges, a vertex and a loose edge, or two loose vertices.
    first, second : int
        The indices of both primitives among the vertices, ``Mesh.faces`` or ``Mesh.edges``.
    vertices : int64 array of shape (4,)
        Their vertices, in the order of the query; -1 after the last one.
    time : float
        The earliest contact time, from 0 to 1, rounded down to float64.
    u, v : float
        The parameters of the contact, see :meth:`Queries.impact`.
    normal : float64 array of shape (3,)
        The unit normal, from the second primitive to the first; NaN if there is none.
    points : float64 array of shape (2, 3)
        The points of contact on the first primitive and on the second.
    distance : float64 array of shape (2,)
        Bounds of the distance of the primitives at that time: 0 for contact, otherwise the minimum
        distance, or less if the pair starts nearer.
    places : tuple of two Place or None
        The bodies of both primitives, and the indices there, if the mesh has names of groups.
    """

    kind: Kind
    first: int
    second: int
    vertices: NDArray[np.int64]
    time: float
    u: float
    v: float
    normal: NDArray[np.float64]
    points: NDArray[np.float64]
    distance: NDArray[np.float64]
    places: Places = (None, None)


def primitives(kind: Kind) -> tuple[Primitive, Primitive]:
    """The kinds of the primitives of a pair."""
    first, second = kind
    return _PRIMITIVES[first], _PRIMITIVES[second]


def pairs(columns: PairColumns, dtype: np.dtype[np.void] = PAIR) -> NDArray[np.void]:
    """The pairs in columns of the compiled part as one structured array; other fields of it are not set."""
    kinds, ids, vertices = columns
    rows = np.empty(len(kinds), dtype)
    rows["kind"] = np.array(list(POINTS))[kinds]
    rows["first"], rows["second"] = ids.T
    rows["vertices"] = vertices
    return rows


def table(columns: Columns) -> NDArray[np.void]:
    """The contacts in columns of the compiled part as one structured array."""
    _, pair_columns, impacts, distances = columns
    contacts = pairs(pair_columns, CONTACT)
    contacts["distance"] = distances
    rows = impacts.view(IMPACT).reshape(-1)
    for name in IMPACT.names or ():
        contacts[name] = rows[name]
    return contacts


def first(columns: Columns, mesh: Mesh) -> Optional[Contact]:
    """The only contact in the columns of one world, if there is one."""
    for row in table(columns):
        contact = Contact(*(row[name] if row[name].ndim else row[name].item() for name in CONTACT.names or ()))
        a, b = primitives(contact.kind)
        return contact._replace(places=(mesh.place(a, contact.first), mesh.place(b, contact.second)))
    return None


def earliest(columns: Columns) -> NDArray[np.void]:
    """The contact of each world, at most one in the columns of each; without numbers where there is none."""
    is_found = np.diff(columns[0]) > 0
    contacts = np.zeros(len(is_found), CONTACT)
    for name in (*(IMPACT.names or ()), "distance"):
        contacts[name] = np.nan
    contacts[is_found] = table(columns)
    return contacts
