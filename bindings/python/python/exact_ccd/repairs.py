"""Repair of a mesh that intersects itself."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _arrays, _native
from ._arrays import Indices, Positions, floats, indices, integer, number, thread_count
from ._records import by_value
from .contacts import pairs
from .meshes import Mesh

Phase = Literal["loosen", "separate", "return", "follow"]
"""The phase of a repair, see ``docs/repair.md``."""

RepairReason = Literal["pinned", "one-sided", "linked", "stalled", "rounds", "rounding", "stopped", "other"]
"""The reason why a repair has not succeeded, see :class:`Repair`."""

_MOST_ROUNDS = 2**32 - 1


class RepairProgress(NamedTuple):
    """The state of a repair between two rounds.

    Attributes
    ----------
    phase : {"loosen", "separate", "return", "follow"}
        Vertices move until nothing intersects, then until no pair is within the minimum distance, then back
        towards the given positions.
    round : int
        The number of rounds of this phase so far.
    pairs : int
        The pairs of an edge and a face that intersect, or the pairs that are near each other.
    """

    phase: Phase
    round: int
    pairs: int


class Change(NamedTuple):
    """The change of a mesh by a repair, in numbers.

    Displacements are relative to the diagonal of the box around the mesh before, stretches to the lengths of
    edges before, areas to the areas before. Edges of length 0 before do not count, nor do faces of area 0 before.

    Attributes
    ----------
    moved : int
        The number of vertices whose position differs.
    mean_displacement, p95_displacement, max_displacement : float
        The mean displacement of all vertices, the one that 95 % of them do not exceed, and the largest.
    min_stretch, p5_stretch, p95_stretch, max_stretch : float
        The least stretch of an edge, the ones that 5 % and 95 % do not exceed, and the largest.
    min_area, p5_area, p95_area, max_area : float
        The same of the areas of faces.
    folds : int
        The number of pairs of faces beside an edge with more than 90° between their normals that had less before.
    worst_aspect_before, worst_aspect : float
        The worst aspect of a face before and after: its longest side divided by the height on it.
    """

    moved: int
    mean_displacement: float
    p95_displacement: float
    max_displacement: float
    min_stretch: float
    p5_stretch: float
    p95_stretch: float
    max_stretch: float
    min_area: float
    p5_area: float
    p95_area: float
    max_area: float
    folds: int
    worst_aspect_before: float
    worst_aspect: float


@by_value
class Repair(NamedTuple):
    """The result of :func:`repair`.

    Attributes
    ----------
    positions : float64 or float32 array of shape (V, 3)
        The positions in which the mesh is free; if it is not repaired, the ones with the fewest edges that
        pass through faces.
    repaired : bool
        True if no edge passes through a face and no pair is within the minimum distance: decided exactly for
        `positions` as they are.
    reason : str or None
        The reason why it is not repaired: "pinned", if pinned vertices alone intersect or are too near;
        "one-sided", if a closed surface has one side only, as a Klein bottle, and so has no free positions;
        "linked", if a loop of pinned edges passes an odd number of times through a surface with a pinned border;
        "stalled", if the number of crossings has not become less in 400 rounds; "rounds", after the limit of
        rounds; "rounding", if rounding to float32 makes pairs touch again; "stopped", after `seconds` or by `stop`.
    message : str or None
        The reason in a sentence.
    crossings : uint32 array of shape (M, 2)
        The edges that still pass through faces: the index of the edge in :attr:`Mesh.edges` and of the face. Only
        edges and faces of pinned vertices, if these are the reason.
    contacts : structured array of shape (N,)
        The pairs that are still within the minimum distance, with the fields of :data:`PAIR`; as for crossings.
    before : tuple of two int, or None
        The numbers of crossings and of contacts in the given positions, with `float32` in the rounded ones;
        None if the mesh is not repaired.
    change : Change or None
        The change of the mesh; None if it is not repaired.
    """

    positions: NDArray[Union[np.float32, np.float64]]
    repaired: bool
    reason: Optional[RepairReason]
    message: Optional[str]
    crossings: NDArray[np.uint32]
    contacts: NDArray[np.void]
    before: Optional[tuple[int, int]]
    change: Optional[Change]


def repair(
    mesh: Union[Mesh, ArrayLike],
    positions: ArrayLike,
    *,
    pinned: Optional[ArrayLike] = None,
    min_distance: float = 0.0,
    max_rounds: int = 2000,
    seconds: Optional[float] = None,
    stop: Optional[Callable[[RepairProgress], object]] = None,
    dtype: DTypeLike = np.float64,
    threads: Optional[int] = None,
) -> Repair:
    """Move vertices of a mesh that intersects itself until it does not, decided exactly.

    No edge passes through a face then, and no pair of primitives touches. Vertices, edges and faces stay.
    ``docs/repair.md`` has the method and its limits: it may fail, and says so.

    Parameters
    ----------
    mesh : Mesh or int array of shape (F, 3)
        The mesh, with the pairs that can collide: others may intersect. Or only its faces. A function
        `can_collide` is called for all candidates of all rounds, which is slow.
    positions : array of shape (V, 3)
        The positions of the vertices. They keep their bits if the mesh is free.
    pinned : int array of shape (N,), optional
        The indices of vertices that keep their positions, such as the vertices of obstacles.
    min_distance : float
        Pairs within this distance of each other count as touching, too.
    max_rounds : int
        The number of rounds after which a phase ends.
    seconds : float, optional
        The time after which the repair is stopped as it stands, before its next round.
    stop : callable, optional
        Called with a :class:`RepairProgress` before each round. If the answer is true, the repair ends as it stands:
        the mesh is repaired if vertices were on their way back.
    dtype : dtype
        The type of the resulting numbers, float64 or float32. With float32, the decision is about the rounded
        positions.
    threads : int, optional
        The number of threads; by default the number of cores. The result does not depend on it.

    Returns
    -------
    Repair
        The positions, and the pairs that remain.

    Raises
    ------
    TypeError
        If an argument has another type.
    ValueError
        If there is not one position for each vertex, or one is not finite; if a pinned vertex is not one of the
        mesh; if a distance or the seconds are negative or no number. With float32, if a coordinate is beyond its
        range, or if a pinned position is not exactly a float32.
    ImportError
        If the package is built without repair: the message has the command line that adds it.

    Notes
    -----
    Ctrl-C ends the repair before its next round. An exception of `stop` ends it, and is passed on.

    Examples
    --------
    The tip of the second triangle passes through the first one, which is pinned.

    >>> import numpy as np
    >>> import exact_ccd
    >>> faces = [[0, 1, 2], [3, 4, 5]]
    >>> x = np.array([[0, 0, 0], [8, 0, 0], [0, 8, 0], [2, 2, -0.5], [2, 1, 4], [1, 2, 4]])
    >>> result = exact_ccd.repair(faces, x, pinned=[0, 1, 2])
    >>> result.repaired, result.before, len(result.crossings)
    (True, (2, 0), 0)
    >>> bool((result.positions[:3] == x[:3]).all()), bool(result.positions[3, 2] > 0)
    (True, True)
    """
    _check_build()
    given = mesh if isinstance(mesh, Mesh) else Mesh(len(floats("positions", positions, (None, 3))), mesh)
    x = _arrays.positions("positions", positions, (given.vertex_count, 3))
    held = _pinned(pinned)
    is_single = _is_single(dtype)
    if is_single:
        _check_pinned(x, held)
    settings = _settings(min_distance, max_rounds, seconds, threads)
    columns = _native.repair(given._native, x[None], held, is_single, settings, _asked(stop))
    after, before, failed, crossings, contacts, change = columns
    reason, message = (None, None) if failed is None else failed
    return Repair(
        after.astype(np.float32) if is_single else after,
        failed is None,
        reason,
        message,
        crossings,
        pairs(contacts),
        before,
        None if change is None else Change(**change),
    )


def _check_build() -> None:
    """Refuse a build of the package that has no repair."""
    if not hasattr(_native, "repair"):
        raise ImportError(
            "this build of exact_ccd has no repair; in a checkout, "
            "pip install ./bindings/python --config-settings build-args='--features repair' builds it with repair"
        )


@by_value
class Blocked(NamedTuple):
    """The frame of a recording for which the method found no free positions, or no free motion that leads there.

    Attributes
    ----------
    frame : int
        The frame, from 0.
    crossings : uint32 array of shape (M, 2)
        For the first frame, the edges that still pass through faces, as of :class:`Repair`.
    contacts : structured array of shape (N,)
        The pairs that touch, or come within the minimum distance: for the first frame at rest, for another one in
        the last motion that was tried.
    """

    frame: int
    crossings: NDArray[np.uint32]
    contacts: NDArray[np.void]


@by_value
class RepairedRecording(NamedTuple):
    """The result of :func:`repair_recording`.

    Attributes
    ----------
    frames : float64 array of shape (F, V, 3)
        The repaired frames: all, or those before `blocked`, or before the repair was stopped. No frame
        intersects, and the straight motion between them is free: decided exactly for these positions.
    changes : list of Change
        The change of each of these frames.
    blocked : Blocked or None
        The frame that ended the repair, if there is one.
    """

    frames: NDArray[np.float64]
    changes: list[Change]
    blocked: Optional[Blocked]


def repair_recording(
    mesh: Union[Mesh, Indices],
    frames: ArrayLike,
    *,
    pinned: Optional[ArrayLike] = None,
    min_distance: float = 0.0,
    max_rounds: int = 2000,
    seconds: Optional[float] = None,
    stop: Optional[Callable[[RepairProgress], object]] = None,
    threads: Optional[int] = None,
) -> RepairedRecording:
    """Repair the frames of a recording, such that the straight motion from frame to frame is free of contact.

    Parameters
    ----------
    mesh : Mesh, or int array of shape (N, 3)
        The mesh, or its triangles.
    frames : real array of shape (F, V, 3)
        The positions of the vertices in each frame.
    pinned : int array of shape (N,), optional
        The indices of vertices that have their given positions in all frames.
    min_distance : float
        Pairs within this distance of each other count as touching, too.
    max_rounds : int
        The number of rounds after which a phase ends, in each frame.
    seconds : float, optional
        The time after which the repair is stopped as it stands, before its next round.
    stop : callable, optional
        As of :func:`repair`.
    threads : int, optional
        The number of threads; by default the number of cores. The result does not depend on it.

    Returns
    -------
    RepairedRecording
        The frames, and the one that is blocked.

    Raises
    ------
    TypeError, ValueError, ImportError
        As of :func:`repair`.
    """
    _check_build()
    count = np.shape(frames)[1] if np.ndim(frames) == 3 else 0
    given = mesh if isinstance(mesh, Mesh) else Mesh(count, mesh)
    x = _arrays.positions("frames", frames, (None, given.vertex_count, 3))
    settings = _settings(min_distance, max_rounds, seconds, threads)
    columns = _native.repair_recording(given._native, x, _pinned(pinned), settings, _asked(stop))
    after, changes, ended = columns
    blocked = None if ended is None else Blocked(ended[0], ended[1], pairs(ended[2]))
    return RepairedRecording(
        after.reshape(len(changes), given.vertex_count, 3), [Change(**change) for change in changes], blocked
    )


def _pinned(pinned: Optional[ArrayLike]) -> NDArray[np.uint32]:
    return np.empty(0, np.uint32) if pinned is None else indices("pinned", pinned, (None,))


def _settings(
    min_distance: float, max_rounds: int, seconds: Optional[float], threads: Optional[int]
) -> tuple[float, int, Optional[float], Optional[int]]:
    return (
        number("min_distance", min_distance),
        integer("max_rounds", max_rounds, 0, _MOST_ROUNDS),
        None if seconds is None else number("seconds", seconds),
        thread_count(threads),
    )


def _asked(
    stop: Optional[Callable[[RepairProgress], object]],
) -> Optional[Callable[[Phase, int, int], object]]:
    if stop is None:
        return None
    if not callable(stop):
        raise TypeError(f"stop is of type {type(stop).__name__}, expected a function")
    return lambda *state: stop(RepairProgress(*state))


def _is_single(dtype: DTypeLike) -> bool:
    """True for float32, False for float64."""
    wanted = np.dtype(dtype)
    if wanted not in (np.float32, np.float64):
        raise TypeError(f"dtype is {wanted}, expected float32 or float64")
    return wanted == np.float32


def _check_pinned(x: Positions, pinned: Indices) -> None:
    """Refuse pinned positions that are not exactly float32."""
    # Indices beyond the mesh are refused by the compiled part.
    own = pinned[pinned < len(x)]
    with np.errstate(over="ignore"):
        rounded = x[own].astype(np.float32)
    # NaN is refused there, too.
    differs = ((rounded != x[own]) & ~np.isnan(x[own])).any(axis=1)
    if differs.any():
        raise ValueError(
            f"vertex {own[np.argmax(differs)]} is pinned, but its position is not exactly float32: "
            "round the pinned positions first, or unpin the vertex"
        )
