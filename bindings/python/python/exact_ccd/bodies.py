"""Rigid bodies that turn."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple, Optional, Protocol, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._arrays import Floats, booleans, floats, number, thread_count
from ._records import by_value
from .contacts import Places, primitives
from .groups import Place, strings
from .meshes import Mesh, MeshFile
from .poses import Poses
from .poses import poses as _checked
from .queries import POINTS, Kind
from .steps import PairCounts

BODY_CONTACT = np.dtype(
    [
        ("kind", "U2"),
        ("bodies", np.int64, (2,)),
        ("primitives", np.uint32, (2,)),
        ("time", np.float64),
        ("u", np.float64),
        ("v", np.float64),
        ("normal", np.float64, (3,)),
    ]
)
"""The fields of a contact of two bodies: all fields of :class:`BodyContact` except `places`."""


Columns = tuple[NDArray[np.uint8], NDArray[np.int64], NDArray[np.uint32], Floats]
"""The columns of contacts: kinds, bodies, primitives, impacts."""


@by_value
class BodyContact(NamedTuple):
    """Primitives of two bodies that touch in a step, and the first time at which they do.

    Attributes
    ----------
    kind : {"vf", "ee", "ve", "vv"}
        A vertex and a face, two edges, a vertex and a loose edge, or two loose vertices.
    bodies : int64 array of shape (2,)
        The bodies of the first and of the second primitive.
    primitives : uint32 array of shape (2,)
        The index of each among the vertices, ``Mesh.faces`` or ``Mesh.edges`` of its body.
    time : float
        The earliest contact time, from 0 to 1, rounded down to float64.
    u, v : float
        The parameters of the contact, see :meth:`Queries.impact`.
    normal : float64 array of shape (3,)
        The unit normal in the world, from the second primitive to the first; NaN if there is none.
    places : tuple of two Place or None
        The names of both bodies with their primitives, if bodies have names.
    """

    kind: Kind
    bodies: NDArray[np.int64]
    primitives: NDArray[np.uint32]
    time: float
    u: float
    v: float
    normal: NDArray[np.float64]
    places: Places = (None, None)


class BodiesReport(NamedTuple):
    """The contacts of a step of bodies, counted.

    Attributes
    ----------
    colliding : PairCounts
        The pairs of primitives in contact at some time of the step.
    touching : PairCounts
        The pairs in contact at t = 0.
    earliest : BodyContact or None
        The earliest contact; None if the step is free of contact.
    """

    colliding: PairCounts
    touching: PairCounts
    earliest: Optional[BodyContact]


@by_value
class BodyDistances(NamedTuple):
    """The distances of pairs of bodies at rest, a row for each pair, in increasing order of the pairs.

    Attributes
    ----------
    bodies : int64 array of shape (N, 2)
        The pairs, the lesser body first.
    lower, upper : float64 arrays of shape (N,)
        Certified bounds of the distances of the surfaces. A lower one is 0 if the bodies may touch or pass through
        each other. They differ by some 1e-12 of the largest coordinates, and are 0 and infinite if coordinates are
        above 2e120.
    points : float64 array of shape (N, 2, 3)
        A point of each body, in the coordinates of the world, rounded: the closest ones.
    """

    bodies: NDArray[np.int64]
    lower: NDArray[np.float64]
    upper: NDArray[np.float64]
    points: NDArray[np.float64]


@by_value
class FreePoses(NamedTuple):
    """A step of bodies that is certified to be free of contact.

    Attributes
    ----------
    size : float
        The part of the full step that is taken, from 0 to 1: 1 if the full step is free, 0 if none of the sizes
        that are tried is certified.
    poses : float64 array of shape (B, 7)
        The poses at its end. Unless `size` is 0, the motion from the start to these very poses has been decided to
        be free of contact, exactly.
    contact : BodyContact or None
        The earliest contact of the full step; None if it is free.
    """

    size: float
    poses: NDArray[np.float64]
    contact: Optional[BodyContact]


class Shape(Protocol):
    """A mesh with its positions: a :class:`MeshFile`, or a mesh of trimesh."""

    @property
    def vertices(self) -> ArrayLike:
        """The positions (V, 3)."""
        ...

    @property
    def faces(self) -> ArrayLike:
        """The vertices of each face (F, 3)."""
        ...


class Bodies:
    """Finds contact between rigid bodies, exactly on their curved paths.

    A pose is a row of seven numbers: the place x, y, z of the origin of the body, and its quaternion w, x, y, z,
    scalar first. The quaternion is taken exactly and may have any length but 0: every one is a rotation. In
    a step, place and quaternion are linear in time: a body turns about its origin, which moves in a straight line.
    ``q`` and ``-q`` are one rotation, but other ways: one turns by at most 180°, see ``docs/curved-motion.md``.

    Poses are arrays of shape (B, 7), or tuples of the places (B, 3) and of a ``scipy`` ``Rotation``.
    :func:`nearest_poses` has the poses of matrices.

    Parameters
    ----------
    meshes : iterable of tuples, MeshFile or trimesh.Trimesh
        For each body, its mesh, a :class:`Mesh` or its faces, and the positions (V, 3) in its own coordinates; or
        a file of :func:`read_mesh`, or another object with `vertices` and `faces`. Groups and rules of the meshes have no part in it.
    can_collide : bool array of shape (B, B), optional
        A symmetric matrix: the pairs of bodies that can collide. By default all can. A body never collides with itself.
    names : sequence of str, optional
        A name for each body: contacts have them, see :attr:`BodyContact.places`.
    min_distance : float
        Bodies that come within this distance of each other count as touching.
    threads : int, optional
        The number of threads; by default the number of cores. The answers do not depend on it.

    Raises
    ------
    TypeError
        If an argument has another type.
    ValueError
        If the positions of a body do not fit its mesh, or are not finite: the message has the index of the body. If
        the matrix is not symmetric, or the distance negative or not finite. If there is not one name for each body.

    See Also
    --------
    Detector : Straight motion of all vertices.

    Notes
    -----
    Bodies that intersect at the start, or one inside the other, may be free of contact. All methods raise
    ValueError, with the index of the body, if a pose is not finite, a quaternion is 0, or one vanishes in the step.
    Bodies serve one call at a time; another one meanwhile raises RuntimeError. Ctrl-C ends a call before the next
    pair of bodies is compared.

    Examples
    --------
    A bar turns by a right angle about the z axis, and swings into a post.

    >>> from exact_ccd import Bodies, Mesh
    >>> rod = Mesh(2, [], edges=[[0, 1]])
    >>> parts = [(rod, [[1, 0, 0], [4, 0, 0]]), (rod, [[2, 2, -1], [2, 2, 1]])]
    >>> bodies = Bodies(parts, names=["bar", "post"])
    >>> start = [[0, 0, 0, 1, 0, 0, 0]] * 2
    >>> end = [[0, 0, 0, 1, 0, 0, 1], [0, 0, 0, 1, 0, 0, 0]]
    >>> contact = bodies.collision(start, end)
    >>> str(contact.places[0]), str(contact.places[1]), contact.time
    ('bar: edge 0', 'post: edge 0', 0.41421356237309503)
    >>> step = bodies.free_step(start, end)
    >>> bodies.collides(start, step.poses)
    False
    """

    def __init__(
        self,
        meshes: Iterable[Union[tuple[Union[Mesh, ArrayLike], ArrayLike], Shape]],
        *,
        can_collide: Optional[ArrayLike] = None,
        names: Optional[Sequence[str]] = None,
        min_distance: float = 0.0,
        threads: Optional[int] = None,
    ) -> None:
        bodies = [_body(index, given) for index, given in enumerate(meshes)]
        matrix = None if can_collide is None else booleans("can_collide", can_collide)
        if matrix is not None and len(matrix) != len(bodies):
            raise ValueError(f"can_collide has the shape {matrix.shape}, expected (B, B), for {len(bodies)} bodies")
        self._count = len(bodies)
        self._names = None if names is None else strings(names)
        if self._names is not None and len(self._names) != len(bodies):
            raise ValueError(f"there are {len(self._names)} names for {len(bodies)} bodies, expected one for each")
        self._native = _native.Bodies(
            [(mesh._native, positions) for mesh, positions in bodies],
            matrix,
            number("min_distance", min_distance),
            thread_count(threads),
        )

    def __len__(self) -> int:
        """The number of bodies."""
        return self._count

    @property
    def names(self) -> Optional[tuple[str, ...]]:
        """The name of each body, if they have names."""
        return self._names

    def _ends(self, poses0: Poses, poses1: Poses) -> tuple[Floats, Floats]:
        return _checked("poses0", poses0, self._count), _checked("poses1", poses1, self._count)

    def collides(self, poses0: Poses, poses1: Poses, *, until: float = 1.0) -> bool:
        """Decide if any two bodies touch in the step.

        Parameters
        ----------
        poses0, poses1 : array of shape (B, 7), or tuple of array (B, 3) and Rotation
            The poses at t = 0 and at t = 1.
        until : float
            The last time that counts, in [0, 1]: contacts that begin later are left out.

        Returns
        -------
        bool
            False if the step is free of contact.
        """
        return self._native.collides(*self._ends(poses0, poses1), number("until", until))

    def collision(self, poses0: Poses, poses1: Poses, *, until: float = 1.0) -> Optional[BodyContact]:
        """Find the earliest contact of the step.

        Parameters
        ----------
        poses0, poses1, until : array, array and float
            As for :meth:`collides`.

        Returns
        -------
        BodyContact or None
            None if the step is free.
        """
        return self._first(self._native.collision(*self._ends(poses0, poses1), number("until", until)))

    def collisions(self, poses0: Poses, poses1: Poses, *, until: float = 1.0) -> NDArray[np.void]:
        """Find all contacts of the step.

        Parameters
        ----------
        poses0, poses1, until : array, array and float
            As for :meth:`collides`.

        Returns
        -------
        structured array of shape (M,)
            The contacts, the earliest first, with the fields of :data:`BODY_CONTACT`.
        """
        return _table(self._native.collisions(*self._ends(poses0, poses1), number("until", until)))

    def step(self, poses0: Poses, poses1: Poses) -> BodiesReport:
        """Count the contacts of the step.

        Parameters
        ----------
        poses0, poses1 : array and array
            As for :meth:`collides`.

        Returns
        -------
        BodiesReport
            The numbers of pairs, and the earliest contact.
        """
        (colliding, touching), contact = self._native.step(*self._ends(poses0, poses1))
        return BodiesReport(PairCounts(*colliding), PairCounts(*touching), self._first(contact))

    def distances(self, poses: Poses, cut_off: float) -> BodyDistances:
        """Compute the distance of each pair of bodies that can collide.

        Parameters
        ----------
        poses : array of shape (B, 7), or tuple of array (B, 3) and Rotation
            The poses of all bodies at rest.
        cut_off : float
            Pairs that are farther apart are left out; the largest float64 for all pairs.

        Returns
        -------
        BodyDistances
            The bounds are certified for the rotations and places of the poses as they are.

        Examples
        --------
        >>> from exact_ccd import Bodies, Mesh
        >>> rod = Mesh(2, [], edges=[[0, 1]])
        >>> bodies = Bodies([(rod, [[-1, 0, 0], [1, 0, 0]]), (rod, [[-1, 0, 0], [1, 0, 0]])])
        >>> distances = bodies.distances([[0, 0, 0, 1, 0, 0, 0], [0, 0, 0.75, 1, 0, 0, 1]], 10.0)
        >>> bool(distances.lower[0] <= 0.75 <= distances.upper[0])
        True
        """
        array = _checked("poses", poses, self._count)
        bodies, bounds, points = self._native.distances(array, number("cut_off", cut_off))
        return BodyDistances(bodies, bounds[:, 0], bounds[:, 1], points.reshape(-1, 2, 3))

    def free_step(self, poses0: Poses, poses1: Poses, *, keep: float = 0.9) -> FreePoses:
        """Compute a step towards `poses1` that is certified to be free of contact.

        Parameters
        ----------
        poses0, poses1 : array and array
            As for :meth:`collides`.
        keep : float
            The part of the time of impact that is taken if the full step is not free, above 0 and at most 1.

        Returns
        -------
        FreePoses
            The poses there are rounded, and the motion to the rounded poses is decided exactly; if it is not free,
            smaller sizes are tried.
        """
        size, end, contact = self._native.free_step(*self._ends(poses0, poses1), number("keep", keep))
        return FreePoses(size, end, self._first(contact))

    def _first(self, columns: Columns) -> Optional[BodyContact]:
        """The only contact in the columns, if there is one."""
        for row in _table(columns):
            contact = BodyContact(*(row[name] if row[name].ndim else row[name].item() for name in BODY_CONTACT.names or ()))
            return contact if self._names is None else contact._replace(places=_places(self._names, contact))
        return None


def _places(names: tuple[str, ...], contact: BodyContact) -> Places:
    """The primitives of a contact by the names of their bodies."""
    ids = zip(contact.bodies.tolist(), primitives(contact.kind), contact.primitives.tolist())
    first, second = (Place(names[body], kind, index) for body, kind, index in ids)
    return first, second


def _body(index: int, given: Any) -> tuple[Mesh, Floats]:
    """The mesh and the positions of a body."""
    if hasattr(given, "vertices") and hasattr(given, "faces"):
        array = floats(f"vertices of body {index}", given.vertices, (None, 3))
        # The edges of a mesh of trimesh belong to its faces.
        edges = given.edges if isinstance(given, MeshFile) else None
        return Mesh(len(array), given.faces, edges), array
    if not isinstance(given, (tuple, list)) or len(given) != 2:
        raise TypeError(f"body {index} is of type {type(given).__name__}, expected a tuple of a mesh and its positions")
    mesh, positions = given
    array = floats(f"positions of body {index}", positions, (None, 3))
    return mesh if isinstance(mesh, Mesh) else Mesh(len(array), mesh), array


def _table(columns: Columns) -> NDArray[np.void]:
    """The contacts in columns of the compiled part as one structured array."""
    kinds, bodies, primitives, impacts = columns
    contacts = np.empty(len(kinds), BODY_CONTACT)
    contacts["kind"] = np.array(list(POINTS))[kinds]
    contacts["bodies"], contacts["primitives"] = bodies, primitives
    contacts["time"], contacts["u"], contacts["v"] = impacts[:, :3].T
    contacts["normal"] = impacts[:, 3:]
    return contacts
