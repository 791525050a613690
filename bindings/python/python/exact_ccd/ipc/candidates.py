"""Pairs of primitives that come near each other in a step."""

from __future__ import annotations

from math import inf
from typing import Any, NamedTuple, Optional, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import _native
from .._arrays import Floats, Indices, indices
from ..queries import Kind, time_of_impact
from .pairs import three_dimensional
from .rescaling import choose_rescaling


class CollisionMesh(Protocol):
    """The attributes of ``ipctk.CollisionMesh`` that are used; ``can_collide`` and ``codim_vertices`` too, if any."""

    @property
    def num_vertices(self) -> int: ...
    @property
    def edges(self) -> Any: ...
    @property
    def faces(self) -> Any: ...


class Primitives(NamedTuple):
    """The primitives of a mesh, by their vertices."""

    vertices: Indices
    edges: Indices
    faces: Indices
    loose_vertices: Indices
    loose_edges: Indices


def primitives(mesh: CollisionMesh) -> Primitives:
    """The primitives of a mesh, with its loose vertices and edges."""
    edges = indices("edges", _two_dimensional(mesh.edges, 2), (None, 2))
    faces = indices("faces", _two_dimensional(mesh.faces, 3), (None, 3))
    for name, rows in (("edges", edges), ("faces", faces)):
        if rows.size and rows.max() >= mesh.num_vertices:
            row = int(np.argmax((rows >= mesh.num_vertices).any(axis=1)))
            raise ValueError(f"row {row} of {name} names a vertex that does not exist")
    vertices = np.arange(mesh.num_vertices, dtype=np.uint32)[:, None]
    used = np.zeros(mesh.num_vertices, bool)
    used[edges.ravel()] = True
    used[faces.ravel()] = True
    # An edge as one number: the edges of faces in any direction.
    sides = np.sort(faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2).astype(np.uint64), axis=1)
    own = np.sort(edges.astype(np.uint64), axis=1)
    loose = ~np.isin(own[:, 0] << 32 | own[:, 1], sides[:, 0] << 32 | sides[:, 1])
    return Primitives(vertices, edges, faces, vertices[~used], np.ascontiguousarray(edges[loose]))


def _two_dimensional(rows: Any, width: int) -> NDArray[Any]:
    """The rows; an empty array of ipctk may have another width."""
    array = np.asarray(rows)
    return array.reshape(0, width) if array.size == 0 else array


class Candidates:
    """Pairs of primitives that come near each other in a step: decided together, as often as needed.

    The methods are those of ``ipctk.Candidates``. The pairs of a step hold for every step from the same
    start to positions on the way.

    Examples
    --------
    >>> from types import SimpleNamespace
    >>> mesh = SimpleNamespace(num_vertices=4, edges=[[0, 1], [1, 2], [2, 0]], faces=[[0, 1, 2]])
    >>> x0 = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.25, 0.25, 1]])
    >>> x1 = x0 - [0, 0, 2] * (np.arange(4) == 3)[:, None]
    >>> candidates = Candidates()
    >>> candidates.build(mesh, x0, x1)
    >>> len(candidates), candidates.is_step_collision_free(mesh, x0, x1)
    (1, False)
    >>> candidates.compute_collision_free_stepsize(mesh, x0, x1)
    0.45
    """

    def __init__(self) -> None:
        self._pairs: dict[Kind, Indices] = {}

    def build(
        self,
        mesh: CollisionMesh,
        vertices_t0: ArrayLike,
        vertices_t1: Optional[ArrayLike] = None,
        inflation_radius: float = 0.0,
        broad_phase: object = None,
    ) -> None:
        """Find the pairs whose boxes over the step meet, each enlarged by `inflation_radius` on every side.

        Without `vertices_t1`, the vertices do not move. `broad_phase` has no effect.
        """
        if vertices_t1 is not None and np.ndim(vertices_t1) == 0:
            # The form without the end: build(mesh, vertices, inflation_radius).
            inflation_radius, vertices_t1 = float(np.asarray(vertices_t1)), None
        check_distance("inflation_radius", inflation_radius)
        x0, x1 = ends(mesh, vertices_t0, vertices_t0 if vertices_t1 is None else vertices_t1)
        every = primitives(mesh)
        is_flat = np.shape(vertices_t0)[1] == 2

        def near(first: Indices, second: Indices) -> Indices:
            pairs = _native.overlaps(first, second, x0, x1, inflation_radius, None)
            if first is second:
                pairs = pairs[pairs[:, 0] < pairs[:, 1]]
            return np.hstack([first[pairs[:, 0]], second[pairs[:, 1]]])

        if is_flat:
            self._pairs = {"ve": near(every.vertices, every.edges)}
        else:
            self._pairs = {
                "vf": near(every.vertices, every.faces),
                "ee": near(every.edges, every.edges),
                "ve": near(every.loose_vertices, every.loose_edges),
                "vv": near(every.loose_vertices, every.loose_vertices),
            }

    def __len__(self) -> int:
        """The number of pairs."""
        return sum(len(pairs) for pairs in self._pairs.values())

    def empty(self) -> bool:
        """Return True if there are no pairs."""
        return len(self) == 0

    def clear(self) -> None:
        """Remove all pairs."""
        self._pairs = {}

    @property
    def pairs(self) -> dict[Kind, NDArray[np.uint32]]:
        """The vertices of the pairs of each kind, as `indices` of :func:`exact_ccd.collides`."""
        return dict(self._pairs)

    def is_step_collision_free(
        self,
        mesh: CollisionMesh,
        vertices_t0: ArrayLike,
        vertices_t1: ArrayLike,
        min_distance: float = 0.0,
        narrow_phase_ccd: object = None,
    ) -> bool:
        """Return True if none of the pairs comes within `min_distance` in the step, exactly."""
        return self._earliest(mesh, *ends(mesh, vertices_t0, vertices_t1), min_distance) is None

    def compute_collision_free_stepsize(
        self,
        mesh: CollisionMesh,
        vertices_t0: ArrayLike,
        vertices_t1: ArrayLike,
        min_distance: float = 0.0,
        narrow_phase_ccd: object = None,
        conservative_rescaling: Optional[float] = None,
    ) -> float:
        """Return a step size, from 0 to 1, at which none of the pairs has come within `min_distance`.

        See :func:`exact_ccd.ipc.compute_collision_free_stepsize`.
        """
        rescaling = choose_rescaling(conservative_rescaling, narrow_phase_ccd)
        x0, x1 = ends(mesh, vertices_t0, vertices_t1)
        time = self._earliest(mesh, x0, x1, min_distance)
        if time is None:
            return 1.0
        size = whole = rescaling * time
        retreat = whole - np.nextafter(whole, 0.0)
        while size > 0.0:
            if self._earliest(mesh, x0, x0 + size * (x1 - x0), min_distance) is None:
                return size
            size, retreat = float(whole - retreat), 2.0 * retreat
        return 0.0

    def _earliest(self, mesh: CollisionMesh, x0: Floats, x1: Floats, min_distance: float) -> Optional[float]:
        """The first time at which a pair that can collide comes within the distance."""
        first: Optional[float] = None
        for kind, pairs in self._pairs.items():
            times = time_of_impact(
                kind, indices=pairs, vertices_t0=x0, vertices_t1=x1, min_distance=min_distance
            )
            near = np.flatnonzero(~np.isnan(times))
            for row in near[np.argsort(times[near], kind="stable")]:
                if first is not None and times[row] >= first:
                    break
                if allows(mesh, kind, pairs[row]):
                    first = float(times[row])
                    break
        return first


def allows(mesh: CollisionMesh, kind: Kind, vertices: NDArray[np.uint32]) -> bool:
    """Return True if any vertex of the first primitive and any of the second can collide."""
    can_collide = getattr(mesh, "can_collide", None)
    if can_collide is None:
        return True
    size = 2 if kind == "ee" else 1
    a, b = vertices[:size].tolist(), vertices[size:].tolist()
    return any(can_collide(v, w) for v in a for w in b)


def check_distance(name: str, distance: float) -> None:
    """Refuse a number that is not finite or below 0."""
    if not 0.0 <= distance < inf:
        raise ValueError(f"{name} is {distance}, expected a finite number of at least 0")


def ends(mesh: CollisionMesh, vertices_t0: ArrayLike, vertices_t1: ArrayLike) -> tuple[Floats, Floats]:
    """The positions at both ends, with z = 0 in two dimensions."""
    if len(getattr(mesh, "planes", ())):
        raise ValueError("static planes are not supported: add triangles in their place")
    x0 = three_dimensional("vertices_t0", vertices_t0)
    x1 = three_dimensional("vertices_t1", vertices_t1)
    for name, x in (("vertices_t0", x0), ("vertices_t1", x1)):
        if len(x) != mesh.num_vertices:
            raise ValueError(f"{name} has {len(x)} rows, expected one for each of {mesh.num_vertices} vertices")
    return x0, x1
