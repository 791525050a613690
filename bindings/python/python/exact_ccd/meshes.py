"""Meshes: faces, rods and points, and the pairs that can collide."""

from __future__ import annotations

from collections.abc import Callable
from os import PathLike
from typing import NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._arrays import Indices, floats, frozen, indices, integer
from ._records import by_value, same


@by_value
class MeshFile(NamedTuple):
    """The mesh in a file, see :func:`read_mesh`.

    Attributes
    ----------
    vertices : float64 array of shape (V, 3)
        The positions of the vertices, in the unit of the file.
    faces : uint32 array of shape (F, 3)
        The vertices of each face, from 0.
    edges : uint32 array of shape (E, 2)
        The vertices of each loose edge.
    """

    vertices: NDArray[np.float64]
    faces: NDArray[np.uint32]
    edges: NDArray[np.uint32]


class Mesh:
    """The connectivity of a triangle mesh, with rods and points, and the pairs that can collide.

    Primitives that share a vertex always touch, and are never examined; `docs/pairs.md` of the repository
    lists all pairs that are never a contact.

    A mesh does not change. Two meshes are equal if their vertices, faces, loose edges, groups and rules are;
    it can be a key, and be pickled, if its rule can.

    Parameters
    ----------
    vertices_or_count : int or array of shape (V, 3)
        The number of vertices, or the vertices.
    faces : int array of shape (F, 3)
        The vertices of each triangle, from 0.
    edges : int array of shape (E, 2), optional
        Loose edges, as of rods. Edges of faces have no effect. A vertex of no face and no edge is a point.
    groups : int array of shape (V,), optional
        A number for each vertex: primitives all of whose vertices have the same number do not collide.
    can_collide : callable, optional
        ``can_collide(i, j) -> bool`` for two vertices: a pair of primitives can collide if it holds for
        any vertex of the first and any of the second, as in the IPC Toolkit. It is called for pairs in
        contact. Of the methods of :class:`Detector`, ``step`` and ``clearances`` call it for all candidates,
        which is slow; so do ``collision`` and ``free_step`` if it forbids the earliest contact, ``free_step``
        if a pair touches at the start, and ``free_steps`` if any pair touches. `groups` have no such cost.

    Raises
    ------
    ValueError
        If a face or an edge names a vertex that does not exist.

    Examples
    --------
    A triangle, and a rod that leads away from it.

    >>> mesh = Mesh(5, [[0, 1, 2]], edges=[[2, 3], [4, 3]])
    >>> mesh.edges.tolist()
    [[0, 1], [0, 2], [1, 2], [2, 3], [3, 4]]
    >>> mesh.loose_edges.tolist()
    [[2, 3], [3, 4]]
    """

    def __init__(
        self,
        vertices_or_count: Union[int, ArrayLike],
        faces: ArrayLike,
        edges: Optional[ArrayLike] = None,
        groups: Optional[ArrayLike] = None,
        can_collide: Optional[Callable[[int, int], object]] = None,
    ) -> None:
        if isinstance(vertices_or_count, (int, np.integer)):
            count = integer("the number of vertices", vertices_or_count, 0, 2**32 - 1)
        else:
            count = len(floats("vertices", vertices_or_count, (None, 3)))
        if can_collide is not None and not callable(can_collide):
            raise TypeError("can_collide is not callable, expected a function of two vertices")
        self._groups = None if groups is None else frozen(indices("groups", groups, (count,)))
        self._can_collide = can_collide
        self._native = _native.Mesh(
            count,
            indices("faces", faces, (None, 3)),
            indices("edges", [] if edges is None else edges, (None, 2)),
            self._groups,
            can_collide,
        )
        self._faces: Optional[Indices] = None
        self._edges: Optional[Indices] = None
        self._hash: Optional[int] = None

    @property
    def vertex_count(self) -> int:
        """The number of vertices."""
        return self._native.vertex_count

    @property
    def faces(self) -> NDArray[np.uint32]:
        """The faces in the given order, an array of shape (F, 3), which cannot be written to."""
        if self._faces is None:
            self._faces = frozen(self._native.faces)
        return self._faces

    @property
    def edges(self) -> NDArray[np.uint32]:
        """The edges of the faces, then the loose edges, an array of shape (E, 2), which cannot be written to.

        Both parts hold pairs i < j, each once, sorted by j, then by i.
        """
        if self._edges is None:
            self._edges = frozen(self._native.edges)
        return self._edges

    @property
    def loose_edges(self) -> NDArray[np.uint32]:
        """The edges of no face, the last ones of `edges`."""
        return self.edges[len(self.edges) - self._native.loose_edge_count :]

    @property
    def groups(self) -> Optional[NDArray[np.uint32]]:
        """The group of each vertex, if there are groups."""
        return self._groups

    @property
    def can_collide(self) -> Optional[Callable[[int, int], object]]:
        """The rule that was given."""
        return self._can_collide

    def vertices_can_collide(self, i: int, j: int) -> bool:
        """Decide if two vertices can collide by the groups and by the rule.

        Parameters
        ----------
        i, j : int
            The indices of the vertices.

        Returns
        -------
        bool
            True if they can.
        """
        if self._groups is not None and self._groups[i] == self._groups[j]:
            return False
        return self._can_collide is None or bool(self._can_collide(i, j))

    def __repr__(self) -> str:
        loose = self._native.loose_edge_count
        rules = ["groups"] * (self._groups is not None) + ["a rule"] * (self._can_collide is not None)
        restricted = f", restricted by {' and '.join(rules)}" if rules else ""
        return (
            f"<exact_ccd.Mesh: {self.vertex_count} vertices, {len(self.faces)} faces, "
            f"{len(self.edges)} edges, {loose} of them loose{restricted}>"
        )

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Mesh):
            return NotImplemented
        return self is other or all(map(same, self._value(), other._value()))

    def __hash__(self) -> int:
        if self._hash is None:
            self._hash = hash((self.vertex_count, self.faces.tobytes(), self.loose_edges.tobytes()))
        return self._hash

    def __reduce__(self) -> tuple[type[Mesh], tuple[object, ...]]:
        return Mesh, self._value()

    def _value(self) -> tuple[object, ...]:
        """The arguments of the constructor, all that a mesh is."""
        return self.vertex_count, self.faces, self.loose_edges, self._groups, self._can_collide


def read_mesh(path: Union[str, PathLike[str]]) -> MeshFile:
    """Read a mesh from a PLY, OBJ, STL, OFF, Gmsh (.msh) or VTK (.vtu) file, exactly.

    Parameters
    ----------
    path : path
        The file; its format is that of the extension.

    Returns
    -------
    MeshFile
        Vertices (V, 3), faces (F, 3) and loose edges (E, 2). Of a mesh of tetrahedra, the surface. An STL
        file has no shared vertices: it reads as three vertices for each face.

    Raises
    ------
    OSError
        If the file cannot be read.
    ValueError
        If its contents are wrong; the message names the place.
    """
    return MeshFile(*_native.read_mesh(path))
