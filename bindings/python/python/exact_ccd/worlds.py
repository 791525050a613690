"""Contact in steps of many worlds."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from ._arrays import Positions, is_single, number, positions
from ._records import by_value
from .contacts import earliest, table
from .detectors import Searcher


@by_value
class Contacts(NamedTuple):
    """The contacts of many worlds; world ``w`` has ``contacts[offsets[w]:offsets[w + 1]]``.

    Attributes
    ----------
    offsets : int64 array of shape (W + 1,)
        The index of the first contact of each world; the last is M.
    contacts : structured array of shape (M,)
        The contacts of each world, the earliest first, with the fields of :data:`CONTACT`.
    """

    offsets: NDArray[np.int64]
    contacts: NDArray[np.void]


@by_value
class WorldFreeSteps(NamedTuple):
    """Steps of many worlds that are certified to be free of contact; see :class:`FreeStep`.

    Attributes
    ----------
    size : float64 array of shape (W,)
        The part of the full step that is taken, from 0 to 1.
    positions : float64 or float32 array of shape (W, V, 3)
        The positions at its end, in the unit of the coordinates.
    contact : structured array of shape (W,)
        The earliest contact of the full step, as of :meth:`Worlds.collision`.
    touching : int64 array of shape (W, 4)
        The numbers of pairs that touch at the start, in the order of :class:`PairCounts`.
    """

    size: NDArray[np.float64]
    positions: NDArray[Any]
    contact: NDArray[np.void]
    touching: NDArray[np.int64]


@by_value
class StepReports(NamedTuple):
    """The contacts of steps of many worlds, counted; see :class:`StepReport`.

    Attributes
    ----------
    candidates, colliding, touching : int64 array of shape (W, 4)
        The numbers of pairs that come near each other, that are in contact at some time of the step, and
        that are in contact at t = 0, in the order of :class:`PairCounts`.
    earliest : structured array of shape (W,)
        The earliest contact, as of :meth:`Worlds.collision`.
    """

    candidates: NDArray[np.int64]
    colliding: NDArray[np.int64]
    touching: NDArray[np.int64]
    earliest: NDArray[np.void]


class Worlds(Searcher):
    """Finds contact in steps of many worlds, which share one mesh and have their own positions.

    The primitives of a world touch only each other. Each answer equals the answer of a
    :class:`Detector` for the positions of the world, whatever the number of worlds. The worlds are decided in
    parallel.

    Parameters
    ----------
    mesh : Mesh, or array of shape (V, 3)
        The mesh of every world; or the vertices, with `faces`.
    faces : int array of shape (F, 3), optional
        The faces of a mesh that is given by its vertices.
    min_distance, inner_distance, threads, start_check : see Detector
        As for :class:`Detector`.

    Raises
    ------
    TypeError
        If an argument has another type.
    ValueError
        If a distance is negative or not finite, or there is not one thickness for each vertex.

    See Also
    --------
    Detector : The same for one world, with views and progress.

    Notes
    -----
    Positions are arrays of shape (W, V, 3), at t = 0 and at t = 1. float64 and float32 with any strides are
    read where they are, and must not be changed by another thread meanwhile. The exceptions are the same as
    for a :class:`Detector`; the message names the first world with an error.

    Examples
    --------
    A vertex falls onto a triangle at three different speeds.

    >>> import numpy as np
    >>> from exact_ccd import Mesh, Worlds
    >>> x0 = np.zeros((3, 4, 3), np.float32)
    >>> x0[:] = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.25, 0.25, 1]]
    >>> x1 = x0.copy()
    >>> x1[:, 3, 2] = [0.5, -1, -3]
    >>> worlds = Worlds(Mesh(4, [[0, 1, 2]]))
    >>> worlds.collides(x0, x1)
    array([False,  True,  True])
    >>> worlds.collision(x0, x1)["time"]
    array([ nan, 0.5 , 0.25])
    >>> worlds.free_step(x0, x1, keep=0.5).size
    array([1.   , 0.25 , 0.125])
    """

    def _ends(self, x0: ArrayLike, x1: ArrayLike) -> tuple[Positions, Positions]:
        shape = (None, self._mesh.vertex_count, 3)
        return positions("x0", x0, shape), positions("x1", x1, shape)

    def collides(self, x0: ArrayLike, x1: ArrayLike, *, until: float = 1.0) -> NDArray[np.bool_]:
        """Decide in which worlds any two primitives touch in the step.

        Parameters
        ----------
        x0, x1 : array of shape (W, V, 3)
            The positions of the vertices of each world at t = 0 and at t = 1.
        until : float
            The last time that counts, in [0, 1]: contacts that begin later are left out.

        Returns
        -------
        bool array of shape (W,)
            False for the worlds that are free of contact.
        """
        return self._native.collides(*self._ends(x0, x1), number("until", until))

    def collision(self, x0: ArrayLike, x1: ArrayLike, *, until: float = 1.0) -> NDArray[np.void]:
        """Find the earliest contact of each world.

        Parameters
        ----------
        x0, x1, until : array, array and float
            As for :meth:`collides`.

        Returns
        -------
        structured array of shape (W,)
            The fields of :data:`CONTACT`. For a world that is free, ``kind`` is empty, ``first``,
            ``second`` and ``vertices`` are 0, and the other numbers NaN.
        """
        return earliest(self._native.collision(*self._ends(x0, x1), number("until", until)))

    def collisions(self, x0: ArrayLike, x1: ArrayLike, *, until: float = 1.0) -> Contacts:
        """Find all contacts of each world.

        Parameters
        ----------
        x0, x1, until : array, array and float
            As for :meth:`collides`.

        Returns
        -------
        Contacts
            The contacts, world by world.
        """
        columns = self._native.collisions(*self._ends(x0, x1), number("until", until))
        return Contacts(columns[0], table(columns))

    def free_step(
        self, x0: ArrayLike, x1: ArrayLike, *, keep: float = 0.9, dtype: DTypeLike = np.float64
    ) -> WorldFreeSteps:
        """Compute a step of each world that is certified to be free of contact.

        Parameters
        ----------
        x0, x1 : array of shape (W, V, 3)
            As for :meth:`collides`.
        keep : float
            The part of the time of impact of a world that is taken if its full step is not free, above 0 and
            at most 1.
        dtype : float64 or float32
            As for :meth:`Detector.free_step`.

        Returns
        -------
        WorldFreeSteps
            Each world has a size of its own; see :meth:`Detector.free_step`.
        """
        ends = self._ends(x0, x1)
        size, end, contact, touching = self._native.free_step(*ends, number("keep", keep), is_single(dtype))
        return WorldFreeSteps(size, end.astype(dtype, copy=False), earliest(contact), touching)

    def step(self, x0: ArrayLike, x1: ArrayLike) -> StepReports:
        """Examine all candidates of each world, and count the contacts.

        Parameters
        ----------
        x0, x1 : array of shape (W, V, 3)
            As for :meth:`collides`.

        Returns
        -------
        StepReports
            The numbers of pairs, and the earliest contact of each world.
        """
        (candidates, colliding, touching), contact = self._native.step(*self._ends(x0, x1), None)
        return StepReports(candidates, colliding, touching, earliest(contact))
