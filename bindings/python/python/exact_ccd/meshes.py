"""Meshes: faces, rods and points, and the pairs that can collide."""

from __future__ import annotations

from collections.abc import Sequence
from os import PathLike
from typing import NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._arrays import Indices, floats, frozen, indices, integer
from ._records import by_value, same
from .groups import CanCollide, Place, Primitive, matrix_of, names_of, place_of, rule_of
from .welding import Weld, style_of, welded


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

    def __repr__(self) -> str:
        return (
            f"<exact_ccd.MeshFile: {len(self.vertices)} vertices, {len(self.faces)} faces, "
            f"{len(self.edges)} loose edges>"
        )


class Mesh:
    """The connectivity of a triangle mesh, with rods and points, and the pairs that can collide.

    Primitives that share a vertex always touch, and are never examined; `docs/pairs.md` of the repository
    lists all pairs that are never a contact.

    A mesh does not change. Two meshes are equal if their vertices, faces, loose edges, groups, rules and names are;
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
        A number for each vertex; with a matrix or names, from 0 to G - 1. Without a matrix, primitives all of whose
        vertices have the same number do not collide.
    can_collide : bool array of shape (G, G) or callable, optional
        A symmetric matrix of groups: a pair of primitives can collide if ``can_collide[g, h]`` is true for the groups
        of any vertex of the first and any of the second. Its diagonal is the pairs within a group. No call of Python
        is made. Or a function ``can_collide(i, j) -> bool`` of two vertices, beside the groups: a pair can collide if
        it holds for any vertex of the first and any of the second, as in the IPC Toolkit. It is called for pairs in
        contact. Of the methods of :class:`Detector`, ``step`` and ``clearances`` call it for all candidates,
        which is slow; so do ``collision`` and ``free_step`` if it forbids the earliest contact, ``free_step``
        if a pair touches at the start, and ``free_steps`` if any pair touches.
    names : sequence of str, optional
        A name for each group: contacts have the names of both bodies then, see :attr:`Contact.places`.

    Raises
    ------
    ValueError
        If a face or an edge names a vertex that does not exist, if a matrix is not symmetric, or if the matrix or
        the names lack the group of a vertex.
    TypeError
        If a matrix has no booleans, or if a matrix or names are given without groups.

    Examples
    --------
    A triangle, and a rod that leads away from it.

    >>> mesh = Mesh(5, [[0, 1, 2]], edges=[[2, 3], [4, 3]])
    >>> mesh.edges.tolist()
    [[0, 1], [0, 2], [1, 2], [2, 3], [3, 4]]
    >>> mesh.loose_edges.tolist()
    [[2, 3], [3, 4]]

    Three bodies; the first two do not collide with each other.

    >>> import numpy as np
    >>> rule = ~np.eye(3, dtype=bool)
    >>> rule[0, 1] = rule[1, 0] = False
    >>> bodies = Mesh(9, [[0, 1, 2], [3, 4, 5], [6, 7, 8]], groups=[0] * 3 + [1] * 3 + [2] * 3, can_collide=rule)
    >>> bodies.vertices_can_collide(0, 3), bodies.vertices_can_collide(3, 6)
    (False, True)
    """

    def __init__(
        self,
        vertices_or_count: Union[int, ArrayLike],
        faces: ArrayLike,
        edges: Optional[ArrayLike] = None,
        groups: Optional[ArrayLike] = None,
        can_collide: Optional[CanCollide] = None,
        names: Optional[Sequence[str]] = None,
    ) -> None:
        if isinstance(vertices_or_count, (int, np.integer)):
            count = integer("the number of vertices", vertices_or_count, 0, 2**32 - 1)
        else:
            count = len(floats("vertices", vertices_or_count, (None, 3)))
        self._groups = None if groups is None else frozen(indices("groups", groups, (count,)))
        self._rule = rule_of(can_collide)
        self._matrix = matrix_of(can_collide, self._groups)
        self._names = names_of(names, self._groups)
        self._native = _native.Mesh(
            count,
            indices("faces", faces, (None, 3)),
            indices("edges", [] if edges is None else edges, (None, 2)),
            self._groups,
            self._matrix,
            self._rule,
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
    def can_collide(self) -> Optional[CanCollide]:
        """The rule that was given: a function, or a matrix of groups, which cannot be written to."""
        return self._rule if self._matrix is None else self._matrix

    @property
    def names(self) -> Optional[tuple[str, ...]]:
        """The name of each group, if they have names."""
        return self._names

    def place(self, kind: Primitive, index: int) -> Optional[Place]:
        """Find the body of a primitive, and its index there.

        Parameters
        ----------
        kind : {"vertex", "edge", "face"}
            The kind of primitive.
        index : int
            Its index among the vertices, `edges` or `faces`.

        Returns
        -------
        Place or None
            The name of the group of its vertices, and the index in it. None if groups have no names, or if the
            vertices of the primitive are in several groups.

        Examples
        --------
        >>> mesh = Mesh(6, [[0, 1, 2], [3, 4, 5]], groups=[0, 0, 0, 1, 1, 1], names=["floor", "leaf"])
        >>> mesh.place("vertex", 4), str(mesh.place("face", 1))
        (Place(body='leaf', kind='vertex', id=1), 'leaf: face 0')
        """
        rows = {"edge": self.edges, "face": self.faces}.get(kind)
        if rows is None:
            rows = np.arange(self.vertex_count, dtype=np.uint32)[:, None]
        return place_of(self._names, self._groups, kind, rows, index)

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
        if self._groups is not None:
            a, b = self._groups[i], self._groups[j]
            if a == b if self._matrix is None else not self._matrix[a, b]:
                return False
        return self._rule is None or bool(self._rule(i, j))

    def __repr__(self) -> str:
        loose = self._native.loose_edge_count
        groups = "groups" if self._matrix is None else "a matrix of groups"
        rules = [groups] * (self._groups is not None) + ["a rule"] * (self._rule is not None)
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
        return self.vertex_count, self.faces, self.loose_edges, self._groups, self.can_collide, self._names


def read_mesh(path: Union[str, PathLike[str]], *, weld: Weld = None) -> MeshFile:
    """Read a mesh from a PLY, OBJ, STL, OFF, Gmsh (.msh) or VTK (.vtu) file, exactly.

    Parameters
    ----------
    path : path
        The file; its extension determines the format.
    weld : bool, optional
        Make one vertex of several in the same place, as the option ``--weld`` of the program does, if they are ends
        of edges that coincide: exporters split vertices at seams of textures and normals. By default, vertices are
        welded in STL files only, which have no shared vertices; there, all vertices in the same place become one.
        With False, an STL file reads as three vertices for each face.

    Returns
    -------
    MeshFile
        Vertices (V, 3), faces (F, 3) and loose edges (E, 2). Of a mesh of tetrahedra, the surface. Welded vertices are
        in the order of the first of each.

    Raises
    ------
    OSError
        If the file cannot be read.
    TypeError
        If `weld` is no boolean.
    ValueError
        If its contents are wrong; the message names the place.

    Warns
    -----
    UserWarning
        For each fact about the file that could change an answer, such as a part that is not read.
    """
    file = MeshFile(*_native.read_mesh(path))
    style = style_of(weld, _native.mesh_format(path) == "Stl")
    if style is None:
        return file
    faces, edges, kept = welded(Mesh(*file)._native, [file.vertices], style)
    return MeshFile(file.vertices[kept], faces, edges)
