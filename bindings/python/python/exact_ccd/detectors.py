"""Contact in steps of a mesh."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from os import PathLike
from typing import Any, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _native
from ._arrays import Floats, Positions, distances, frozen, indices, is_single, number, positions, thread_count
from ._records import by_value, same
from .contacts import Contact, first, pairs, table
from .meshes import Mesh
from .pages import Page, line
from .steps import FirstContacts, FreeStep, FreeSteps, PairCounts, StepReport
from .turns import Turns

Progress = Callable[[int], object]
"""A function that is called with the number of steps done since its last call, as ``tqdm.update``."""


@by_value
class Settings(NamedTuple):
    """The settings of a detector, and of the detector of many worlds."""

    min_distance: Union[float, Floats] = 0.0
    inner_distance: Optional[float] = None
    threads: Optional[int] = None
    start_check: bool = False


class Searcher:
    """A mesh, and settings with which its steps are searched; compares by both."""

    def __init__(
        self,
        mesh: Union[Mesh, ArrayLike],
        faces: Optional[ArrayLike] = None,
        *,
        min_distance: Union[float, ArrayLike] = 0.0,
        inner_distance: Optional[float] = None,
        threads: Optional[int] = None,
        start_check: bool = False,
    ) -> None:
        mesh = _mesh_of(type(self).__name__, mesh, faces)
        self._mesh = mesh
        given = distances(min_distance, mesh.vertex_count)
        distance: Union[float, Floats] = frozen(given) if given.ndim else float(given)
        inner = None if inner_distance is None else number("inner_distance", inner_distance)
        self._settings = Settings(distance, inner, thread_count(threads), bool(start_check))
        self._native = _native.Detector(mesh._native, *self._settings)
        self._is_warned = False

    @property
    def mesh(self) -> Mesh:
        """The mesh."""
        return self._mesh

    def __repr__(self) -> str:
        default = Settings()._asdict()
        shown = [
            f"{name}=<array>" if isinstance(value, np.ndarray) else f"{name}={value}"
            for name, value in self._settings._asdict().items()
            if not same(value, default[name])
        ]
        return f"<exact_ccd.{type(self).__name__}: {', '.join([repr(self._mesh), *shown])}>"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, type(self)):
            return NotImplemented
        return self._settings == other._settings and self._mesh == other._mesh

    def __hash__(self) -> int:
        return hash((self._settings, self._mesh))

    def __reduce__(self) -> tuple[Callable[..., Searcher], tuple[object, ...]]:
        return _searcher, (type(self), self._mesh, self._settings._asdict())


def _mesh_of(kind: str, mesh: Union[Mesh, ArrayLike], faces: Optional[ArrayLike]) -> Mesh:
    """The mesh, which may be given by its vertices and faces."""
    if isinstance(mesh, Mesh):
        if faces is not None:
            raise TypeError(f"the mesh has its own faces; all arguments of {kind} after it are given by name")
        return mesh
    if faces is None:
        raise TypeError(
            f"mesh is of type {type(mesh).__name__}, expected an exact_ccd.Mesh, or the vertices and the faces: "
            f"{kind}(vertices, faces); from_trimesh has the mesh of a trimesh object"
        )
    return Mesh(mesh, faces)


def _searcher(kind: type[Searcher], mesh: Mesh, settings: dict[str, Any]) -> Searcher:
    return kind(mesh, **settings)


class Detector(Searcher):
    """Finds contact in successive steps of one mesh, in which each vertex moves in a straight line.

    The detector keeps memory and order between steps; no answer depends on earlier steps. A call while it
    works for another thread, or from the rule that it calls, raises RuntimeError: each needs its own detector.

    Two detectors are equal if their meshes and settings are. A pickled detector keeps both, but not the memory
    of earlier steps.

    Parameters
    ----------
    mesh : Mesh, or array of shape (V, 3)
        The mesh, with the pairs that can collide; or the vertices, with `faces`.
    faces : int array of shape (F, 3), optional
        The faces of a mesh that is given by its vertices.
    min_distance : float or array of shape (V,)
        Primitives that come within this distance of each other count as touching, in all that follows; in
        the unit of the coordinates, taken exactly. Or a thickness for each vertex: a primitive has the
        largest thickness of its vertices, and the minimum distance of a pair is the sum of both thicknesses,
        rounded up.
        A vertex and an edge of rods that another edge connects touch at distance 0 only (docs/pairs.md).
    inner_distance : float, optional
        A smaller distance that replaces `min_distance` for pairs that start within `min_distance`: a line search
        can then move on from there. A distance that is not smaller changes nothing.
    threads : int, optional
        The number of threads; by default the number of cores, and 1 for a call from inside a rule
        `can_collide`. The answers do not depend on it.
    start_check : bool
        Refuse a step at whose start an edge passes through a face, by a :class:`CrossingError`. This takes a
        pass over the mesh at rest. The pass is not repeated if the start is the same as in the step before, or
        the end of a step that was found free. With `groups` or a rule `can_collide`, only an
        equal start saves the pass.

    Raises
    ------
    TypeError
        If an argument has another type.
    ValueError
        If a distance is negative or not finite, or there is not one thickness for each vertex.

    See Also
    --------
    Worlds : The same for many worlds at a time.

    Notes
    -----
    Positions are arrays of shape (V, 3), at t = 0 and at t = 1. float64 and float32 with any strides are read
    where they are, and must not be changed by another thread meanwhile. All methods raise ValueError if there
    is not one position for each vertex, or if one is not finite, CrossingError with `start_check`, and
    KeyboardInterrupt after Ctrl-C.

    A contact is between a vertex and a face, between two edges, or between points and rods. An edge that
    pierces a face at rest, away from the boundary of the face, is none of these: a step from such a start may
    be free of contact, and `free_step` may return the size 1. With `start_check`, such a start is an error; without, the
    first step of a detector that `collision`, `free_step` or `step` finds free is a warning if it has such a start. So it is
    if a part of the mesh turns in it by more than 10°, as it shrinks on the way: see :class:`Bodies`.
    `intersections` finds such edges, and :func:`audit` begins with them.
    ``docs/pairs.md`` lists all pairs that are never in contact.

    Examples
    --------
    A vertex falls onto a triangle.

    >>> import numpy as np
    >>> from exact_ccd import Detector, Mesh
    >>> detector = Detector(Mesh(4, [[0, 1, 2]]))
    >>> x0 = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.25, 0.25, 1]])
    >>> x1 = x0.copy()
    >>> x1[3, 2] = -1.0
    >>> detector.collides(x0, x1), detector.collides(x0, x1, until=0.25)
    (True, False)
    >>> contact = detector.collision(x0, x1)
    >>> contact.kind, contact.first, contact.second, contact.time
    ('vf', 3, 0, 0.5)
    >>> step = detector.free_step(x0, x1)
    >>> step.size, step.positions[3].tolist()
    (0.45, [0.25, 0.25, 0.09999999999999998])
    >>> detector.collides(x0, step.positions)
    False
    """

    def _world(self, name: str, x: ArrayLike) -> Positions:
        return positions(name, x, (self._mesh.vertex_count, 3))[None]

    def _ends(self, x0: ArrayLike, x1: ArrayLike) -> tuple[Positions, Positions]:
        return self._world("x0", x0), self._world("x1", x1)

    def _warn_once(self, x0: ArrayLike, x1: ArrayLike) -> None:
        """Warn of facts that the first step without contact does not say: a pierced start, and parts that turn."""
        if self._is_warned:
            return
        self._is_warned = True
        turns = Turns(self._mesh)
        turns.add(x0, x1, "in the step")
        turns.warn(stacklevel=3)
        if self._settings.start_check:
            return
        found = self._crossings(x0)
        if len(found):
            edge, face = found[0].tolist()
            first = self._mesh.place("edge", edge) or f"edge {edge}"
            second = self._mesh.place("face", face) or f"face {face}"
            warnings.warn(
                f"{first} passes through {second} at the start of the step, which is no contact of the step; "
                "Detector(..., start_check=True) refuses such a start. This is said once for each detector",
                stacklevel=3,
            )

    def collides(self, x0: ArrayLike, x1: ArrayLike, *, until: float = 1.0) -> bool:
        """Decide if any two primitives touch in the step; ends soon after the first contact found.

        Parameters
        ----------
        x0, x1 : array of shape (V, 3)
            The positions of the vertices at t = 0 and at t = 1.
        until : float
            The last time that counts, in [0, 1]: contacts that begin later are left out.

        Returns
        -------
        bool
            False if the step is free of contact.
        """
        return bool(self._native.collides(*self._ends(x0, x1), number("until", until))[0])

    def collision(self, x0: ArrayLike, x1: ArrayLike, *, until: float = 1.0) -> Optional[Contact]:
        """Find the earliest contact of the step.

        Parameters
        ----------
        x0, x1, until : array, array and float
            As for :meth:`collides`.

        Returns
        -------
        Contact or None
            None if the step is free.
        """
        contact = self._earliest(x0, x1, until)
        if contact is None:
            self._warn_once(x0, x1)
        return contact

    def _earliest(self, x0: ArrayLike, x1: ArrayLike, until: float = 1.0) -> Optional[Contact]:
        """The earliest contact, without a warning."""
        return first(self._native.collision(*self._ends(x0, x1), number("until", until)), self._mesh)

    def collisions(self, x0: ArrayLike, x1: ArrayLike, *, until: float = 1.0) -> NDArray[np.void]:
        """Find all contacts of the step.

        Parameters
        ----------
        x0, x1, until : array, array and float
            As for :meth:`collides`.

        Returns
        -------
        structured array of shape (M,)
            The contacts, the earliest first, with the fields of :data:`CONTACT`.
        """
        return table(self._native.collisions(*self._ends(x0, x1), number("until", until)))

    def first_contacts(self, x0: ArrayLike, x1: ArrayLike, *, until: float = 1.0) -> FirstContacts:
        """Find all contacts of the step, and the first one of each vertex.

        Parameters
        ----------
        x0, x1, until : array, array and float
            As for :meth:`collides`.

        Returns
        -------
        FirstContacts
            The contacts, and an index and a time for each vertex.

        Examples
        --------
        A vertex falls through a triangle, and another one passes by.

        >>> import numpy as np
        >>> from exact_ccd import Detector, Mesh
        >>> x0 = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.25, 0.25, 1], [5, 0, 1]])
        >>> x1 = x0.copy()
        >>> x1[3:, 2] = -1.0
        >>> first = Detector(Mesh(5, [[0, 1, 2]])).first_contacts(x0, x1)
        >>> first.times.tolist()
        [0.5, 0.5, 0.5, 0.5, inf]
        >>> first.contacts["second"][first.of_vertices[3]]  # the face
        np.uint32(0)
        """
        contacts = self.collisions(x0, x1, until=until)
        count = len(contacts)
        vertices = contacts["vertices"]
        rows, _ = np.nonzero(vertices >= 0)
        of_vertices = np.full(self._mesh.vertex_count, count, np.int64)
        np.minimum.at(of_vertices, vertices[vertices >= 0], rows)
        times = np.append(contacts["time"], np.inf)[of_vertices]
        of_vertices[of_vertices == count] = -1
        return FirstContacts(contacts, of_vertices, times)

    def clearances(self, x: ArrayLike, cut_off: float) -> NDArray[np.float64]:
        """Compute the distance of each vertex to the rest of the mesh, with the primitives that it belongs to.

        Displacements of all vertices by less than half of their clearances are free of contact, on whatever
        path (docs/steps.md). The minimum distance of the detector has no part in them.

        Parameters
        ----------
        x : array of shape (V, 3)
            The positions of the vertices.
        cut_off : float
            The largest distance that is of interest, finite and at least 0: pairs farther apart are not examined.

        Returns
        -------
        float64 array of shape (V,)
            For each vertex, the least distance of the pairs in which a primitive has this vertex, rounded down, and
            at most `cut_off`.

        Raises
        ------
        ValueError
            If `cut_off` is negative or not finite.

        Examples
        --------
        >>> from exact_ccd import Detector, Mesh
        >>> x = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.25, 0.25, 0.5], [5, 0, 1]]
        >>> Detector(Mesh(5, [[0, 1, 2]])).clearances(x, 2.0).tolist()
        [0.5, 0.5, 0.5, 0.5, 2.0]
        """
        return self._native.clearances(self._world("x", x), number("cut_off", cut_off))

    def free_step(
        self, x0: ArrayLike, x1: ArrayLike, *, keep: float = 0.9, dtype: DTypeLike = np.float64
    ) -> FreeStep:
        """Compute a step towards `x1` that is certified to be free of contact.

        Parameters
        ----------
        x0, x1 : array of shape (V, 3)
            As for :meth:`collides`.
        keep : float
            The part of the time of impact that is taken if the full step is not free, above 0 and at most 1.
        dtype : float64 or float32
            The type of the positions that are returned, and certified as they are. With float32, the numbers of
            `x0` have to be float32 numbers, in an array of any type.

        Returns
        -------
        FreeStep
            Its size is 1 if the full step is free, otherwise the time of impact times `keep`. The positions
            there are rounded, and the step to the rounded positions is decided exactly; if it is not free,
            the size is reduced by units in its last place until it is, or is 0.

        Examples
        --------
        >>> import numpy as np
        >>> from exact_ccd import Detector, Mesh
        >>> x0 = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.25, 0.25, 1]], np.float32)
        >>> x1 = x0 - [[0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 2]]
        >>> step = Detector(Mesh(4, [[0, 1, 2]])).free_step(x0, x1, dtype=np.float32)
        >>> step.positions[3], step.positions.dtype
        (array([0.25, 0.25, 0.1 ], dtype=float32), dtype('float32'))
        """
        single = is_single(dtype)
        size, end, contact, touching = self._native.free_step(*self._ends(x0, x1), number("keep", keep), single)
        if not len(contact[1][0]):
            self._warn_once(x0, x1)
        positions = end[0].astype(dtype, copy=False)
        return FreeStep(size.item(), positions, first(contact, self._mesh), PairCounts(*touching[0].tolist()))

    def free_steps(
        self,
        x0: ArrayLike,
        x1: ArrayLike,
        *,
        keep: float = 0.9,
        pinned: Optional[ArrayLike] = None,
        dtype: DTypeLike = np.float64,
    ) -> FreeSteps:
        """Compute a step for each vertex, such that the motion of all vertices is certified to be free of contact.

        Only vertices near a contact are held back, in place of the whole mesh (docs/steps.md).

        Parameters
        ----------
        x0, x1 : array of shape (V, 3)
            As for :meth:`collides`.
        keep : float
            Above 0 and at most 1. In the k-th round that holds vertices back, a contact at the time t multiplies the
            sizes of its vertices by t times the k-th power of `keep`.
        pinned : array of shape (N,), optional
            The indices of vertices that move the whole step, such as the vertices of obstacles and scripts.
        dtype : float64 or float32
            As for :meth:`free_step`.

        Returns
        -------
        FreeSteps
            If no vertex is pinned, no size is below the size from :meth:`free_step`.

        Raises
        ------
        TypeError
            If `pinned` has no integers.
        ValueError
            If a pinned vertex is not one of the mesh.

        See Also
        --------
        free_step : One size for all vertices.

        Examples
        --------
        A vertex stops above a triangle, and another one passes by.

        >>> import numpy as np
        >>> from exact_ccd import Detector, Mesh
        >>> x0 = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.25, 0.25, 1], [5, 0, 1]])
        >>> x1 = x0.copy()
        >>> x1[3:, 2] = -1.0
        >>> steps = Detector(Mesh(5, [[0, 1, 2]])).free_steps(x0, x1, keep=0.5)
        >>> steps.sizes.tolist()
        [1.0, 1.0, 1.0, 0.25, 1.0]
        >>> steps.positions[3].tolist()
        [0.25, 0.25, 0.5]
        """
        held = np.empty(0, np.uint32) if pinned is None else indices("pinned", pinned, (None,))
        single = is_single(dtype)
        sizes, end, rounds, blocked = self._native.free_steps(
            *self._ends(x0, x1), number("keep", keep), single, held
        )
        return FreeSteps(sizes, end.astype(dtype, copy=False), rounds, pairs(blocked))

    def step(
        self,
        x0: ArrayLike,
        x1: ArrayLike,
        *,
        progress: Optional[Progress] = None,
        view: Optional[Union[str, PathLike[str]]] = None,
    ) -> StepReport:
        """Examine all candidates of the step, and count the contacts.

        Parameters
        ----------
        x0, x1 : array of shape (V, 3)
            As for :meth:`collides`.
        progress : callable, optional
            Called with the number of candidates examined since its last call, as ``tqdm.update``.
        view : path, optional
            An HTML file to write, which shows the motion in a browser, with the edges and faces that meet at
            t = 0, and all contacts. It needs no network.

        Returns
        -------
        StepReport
            The numbers of pairs, and the earliest contact.
        """
        start, end = self._ends(x0, x1)
        counts, contact = self._native.step(start, end, progress)
        candidates, colliding, touching = (PairCounts(*count[0].tolist()) for count in counts)
        report = StepReport(candidates, colliding, touching, first(contact, self._mesh))
        if report.earliest is None:
            self._warn_once(x0, x1)
        if view is not None:
            page = Page("Step", self._mesh)
            page.add_frame("t = 0", start[0])
            page.add_intersections(self._native)
            page.add_frame("t = 1", end[0])
            page.add_contacts(self._native, every=True)
            answer = "free of contact" if report.earliest is None else line(report.earliest)
            page.write(view, [answer, f"pairs in contact: {sum(colliding)}, at t = 0: {sum(touching)}"])
        return report

    def certificate(self, x0: ArrayLike, x1: ArrayLike, *, at_rest: bool = True) -> bytes:
        r"""Prove the answer to a step, for the program exact-ccd-check (docs/certificates.md).

        The certificate proves that the step is free until its earliest contact, and that it has that one. It is
        about all pairs and one distance: without `groups`, `can_collide`, thicknesses and `inner_distance`.

        Parameters
        ----------
        x0, x1 : array of shape (V, 3)
            As for :meth:`collides`.
        at_rest : bool
            Prove also that no edge passes through a face at `x0`.

        Returns
        -------
        bytes
            The contents of the file that ``exact-ccd step --certificate`` writes for the same positions.

        Raises
        ------
        UncertifiedError
            If some pairs have no proof: `missing` is their number, `pairs` the number of all pairs, and `first` the
            name of one without a proof.
        CrossingError
            If an edge passes through a face at `x0`.
        ValueError
            If some pairs cannot collide, or have another distance.

        Examples
        --------
        A vertex falls through a triangle.

        >>> from exact_ccd import Detector, Mesh
        >>> x0 = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.25, 0.25, 1]]
        >>> x1 = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.25, 0.25, -1]]
        >>> Detector(Mesh(4, [[0, 1, 2]])).certificate(x0, x1)[:24]
        b'exact-ccd certificate 1\n'
        """
        return self._certificate(x0, x1, at_rest, False)

    def _certificate(self, x0: ArrayLike, x1: ArrayLike, at_rest: bool, is_continued: bool) -> bytes:
        """A certificate of one step, or a part that continues one."""
        return self._native.certificate(*self._ends(x0, x1), bool(at_rest), is_continued)

    def intersections(self, x: ArrayLike) -> NDArray[np.uint32]:
        """Find the edges and faces that have a common point at rest and share no vertex.

        Parameters
        ----------
        x : array of shape (V, 3)
            The positions of the vertices.

        Returns
        -------
        uint32 array of shape (M, 2)
            The index of the edge in :attr:`Mesh.edges` and the index of the face, sorted.
        """
        return self._native.intersections(self._world("x", x), False)

    def _crossings(self, x: ArrayLike) -> NDArray[np.uint32]:
        """The :meth:`intersections` whose edges pass through their faces."""
        return self._native.intersections(self._world("x", x), True)
