"""Meshes in motion."""

from __future__ import annotations

from collections.abc import Callable
from os import PathLike
from typing import Any, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._arrays import Floats, Indices, floats, frozen, indices, integer, number, thread_count
from ._records import by_value, same
from .contacts import Contact, first, table
from .pages import Page, line

Progress = Callable[[int], object]
"""A function that is called with the number of steps done since its last call, as ``tqdm.update``."""


@by_value
class MeshFile(NamedTuple):
    """The mesh in a file, see :func:`read_mesh`."""

    vertices: NDArray[np.float64]
    faces: NDArray[np.uint32]
    edges: NDArray[np.uint32]


class PairCounts(NamedTuple):
    """Numbers of pairs, by their kind."""

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
        Those that are in contact at some time of the step.
    touching : PairCounts
        Those that are in contact at t = 0.
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
        The part of the full step that is taken, from 0 to 1: 1 if the full step is free, 0 if no positive
        size is certified, because the mesh touches itself at the start, or within the smallest float64 of it.
    positions : float64 array of shape (V, 3)
        The positions at its end. Unless `size` is 0, the straight motion to these very positions has
        been decided to be free of contact, exactly.
    contact : Contact or None
        The earliest contact of the full step; None if it is free.
    touching : PairCounts
        The pairs that touch at the start: those within their minimum distance, even if an
        `inner_distance` holds for them.
    """

    size: float
    positions: NDArray[np.float64]
    contact: Optional[Contact]
    touching: PairCounts


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
        contact. Three methods of :class:`Detector` may call it for all candidates, which is slow: ``step``
        does; ``earliest_contact`` and ``free_step`` do if it forbids the earliest contact, and ``free_step``
        also if a pair touches at the start. `groups` have no such cost.

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
            count = integer("the number of vertices", vertices_or_count, 0, 2**32)
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
        """Return True if two vertices can collide by the groups and by the rule."""
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


@by_value
class _Settings(NamedTuple):
    """The settings of a detector."""

    min_distance: Union[float, Floats] = 0.0
    inner_distance: Optional[float] = None
    threads: Optional[int] = None
    start_check: bool = False


def _detector(mesh: Mesh, settings: dict[str, Any]) -> Detector:
    """The detector with these settings."""
    return Detector(mesh, **settings)


class Detector:
    """Finds contact in successive steps of one mesh, in which each vertex moves in a straight line.

    The detector keeps memory and order between steps; no answer depends on earlier steps. A call while it
    works for another thread, or from the rule that it calls, raises RuntimeError: each needs its own.

    Two detectors are equal if their meshes and settings are. One that is pickled has these, and no memory.

    Parameters
    ----------
    mesh : Mesh
    min_distance : float or array of shape (V,)
        Primitives that come within this distance of each other count as touching, in all that follows; in
        the unit of the coordinates, taken exactly. Or a thickness for each vertex: a primitive has the
        largest of its vertices, and the distance of a pair is the sum of both, rounded up.
        A vertex and an edge of rods that another edge connects touch at distance 0 only (docs/pairs.md).
    inner_distance : float, optional
        In place of `min_distance` for pairs that start within that: for a line search that has to move on
        from there.
    threads : int, optional
        The number of threads; by default that of the cores. The answers do not depend on it.
    start_check : bool
        Refuse a step that begins with an edge that passes through a face, by a :class:`CrossingError`. This
        takes a pass over the mesh at rest, which is not repeated for a start that is the one before, or the
        end of a step that was found free. With `groups` or a rule `can_collide`, only for
        the one before.

    Notes
    -----
    Positions are arrays of shape (V, 3), at t = 0 and at t = 1. A contiguous array of float64 is not
    copied. All methods raise ValueError if there is not one position for each vertex, or if one is not
    finite, and KeyboardInterrupt after Ctrl-C.

    A contact is that of a vertex and a face, of two edges, or of points and rods. An edge that pierces a face
    at rest, away from its boundary, is none of these: a step from such a start may be free of contact, and
    `free_step` may return the size 1. With `start_check`, it is an error. `intersections` finds such edges,
    and :func:`audit` begins with them.
    ``docs/pairs.md`` lists all pairs that are never in contact.

    Examples
    --------
    A vertex falls onto a triangle.

    >>> detector = Detector(Mesh(4, [[0, 1, 2]]))
    >>> x0 = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.25, 0.25, 1]])
    >>> x1 = x0.copy()
    >>> x1[3, 2] = -1.0
    >>> detector.is_free(x0, x1)
    False
    >>> contact = detector.earliest_contact(x0, x1)
    >>> contact.kind, contact.first, contact.second, contact.time
    ('vf', 3, 0, 0.5)
    >>> step = detector.free_step(x0, x1)
    >>> step.size, step.positions[3].tolist()
    (0.45, [0.25, 0.25, 0.09999999999999998])
    >>> detector.is_free(x0, step.positions)
    True
    """

    def __init__(
        self,
        mesh: Mesh,
        *,
        min_distance: Union[float, ArrayLike] = 0.0,
        inner_distance: Optional[float] = None,
        threads: Optional[int] = None,
        start_check: bool = False,
    ) -> None:
        if not isinstance(mesh, Mesh):
            raise TypeError(f"mesh is of type {type(mesh).__name__}, expected an exact_ccd.Mesh")
        self._mesh = mesh
        distance: Union[float, Floats]
        if np.ndim(min_distance) == 0:
            distance = number("min_distance", min_distance)
        else:
            distance = frozen(floats("min_distance", min_distance, (mesh.vertex_count,)))
        inner = None if inner_distance is None else number("inner_distance", inner_distance)
        self._settings = _Settings(distance, inner, thread_count(threads), bool(start_check))
        self._native = _native.Detector(mesh._native, *self._settings)

    @property
    def mesh(self) -> Mesh:
        """The mesh."""
        return self._mesh

    def __repr__(self) -> str:
        default = _Settings()._asdict()
        shown = [
            f"{name}=<array>" if isinstance(value, np.ndarray) else f"{name}={value}"
            for name, value in self._settings._asdict().items()
            if not same(value, default[name])
        ]
        return f"<exact_ccd.Detector: {', '.join([repr(self._mesh), *shown])}>"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Detector):
            return NotImplemented
        return self._settings == other._settings and self._mesh == other._mesh

    def __hash__(self) -> int:
        return hash((self._settings, self._mesh))

    def __reduce__(self) -> tuple[Callable[..., Detector], tuple[object, ...]]:
        return _detector, (self._mesh, self._settings._asdict())

    def _positions(self, name: str, positions: ArrayLike) -> Floats:
        return floats(name, positions, (self._mesh.vertex_count, 3))

    def _ends(self, x0: ArrayLike, x1: ArrayLike) -> tuple[Floats, Floats]:
        return self._positions("x0", x0), self._positions("x1", x1)

    def is_free(self, x0: ArrayLike, x1: ArrayLike) -> bool:
        """Return True if no two primitives touch in the step. Ends soon after the first contact found.

        An edge that pierces a face at the start is no contact, see the notes above.
        """
        return self._native.is_free(*self._ends(x0, x1))

    def earliest_contact(self, x0: ArrayLike, x1: ArrayLike) -> Optional[Contact]:
        """Return the earliest contact of the step, or None if it is free.

        An edge that pierces a face at the start is no contact, see the notes above.
        """
        return first(self._native.earliest_contact(*self._ends(x0, x1)))

    def contacts(self, x0: ArrayLike, x1: ArrayLike, until: float = 1.0) -> NDArray[np.void]:
        """Return all contacts of the step whose first time is not after `until`, the earliest first.

        A time `until` that is not in [0, 1] raises ValueError. An edge that pierces a face at the start is no
        contact, see the notes above.

        Returns
        -------
        structured array of shape (M,), with the fields of :data:`CONTACT`
        """
        return table(self._native.contacts(*self._ends(x0, x1), number("until", until)))

    def free_step(self, x0: ArrayLike, x1: ArrayLike, keep: float = 0.9) -> FreeStep:
        """Return a step towards `x1` that is certified to be free of contact.

        Its size is 1 if the full step is free, otherwise the time of impact times `keep`, a number above 0
        and at most 1. The positions there are rounded, and the step to the rounded positions is decided
        exactly; if it is not free, the size is reduced by units in its last place until it is, or is 0.

        An edge that pierces a face at the start is no contact, see the notes above: the size may be 1 then.
        """
        size, positions, contact, touching = self._native.free_step(*self._ends(x0, x1), number("keep", keep))
        return FreeStep(size, positions, first(contact), PairCounts(*touching))

    def step(
        self,
        x0: ArrayLike,
        x1: ArrayLike,
        progress: Optional[Progress] = None,
        *,
        view: Optional[Union[str, PathLike[str]]] = None,
    ) -> StepReport:
        """Examine all candidates of the step, and count the contacts.

        An edge that pierces a face at the start is no contact, see the notes above.

        Parameters
        ----------
        x0, x1 : arrays of shape (V, 3)
        progress : callable, optional
            Called with the number of candidates examined since its last call, as ``tqdm.update``.
        view : path, optional
            An HTML file to write, which shows the motion in a browser, with the edges and faces that meet at
            t = 0, and all contacts. It needs no network.
        """
        start, end = self._ends(x0, x1)
        counts, contact = self._native.step(start, end, progress)
        candidates, colliding, touching = (PairCounts(*count) for count in counts)
        report = StepReport(candidates, colliding, touching, first(contact))
        if view is not None:
            page = Page("Step", self._mesh)
            page.add_frame("t = 0", start)
            page.add_intersections(self)
            page.add_frame("t = 1", end)
            page.add_contacts(self, every=True)
            answer = "free of contact" if report.earliest is None else line(report.earliest)
            page.write(view, [answer, f"pairs in contact: {sum(colliding)}, at t = 0: {sum(touching)}"])
        return report

    def intersections(self, x: ArrayLike) -> NDArray[np.uint32]:
        """Return the edges and faces that have a common point at rest and share no vertex.

        Returns
        -------
        uint32 array of shape (M, 2)
            The index of the edge in ``Mesh.edges`` and that of the face, sorted.
        """
        return self._native.intersections(self._positions("x", x))


def read_mesh(path: Union[str, PathLike[str]]) -> MeshFile:
    """Read a mesh from a PLY, OBJ, STL, OFF, Gmsh (.msh) or VTK (.vtu) file, exactly.

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
