"""Pairs of primitives that come near each other in a step."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import _native
from .._arrays import Floats, Indices, as_array, number
from ..queries import Kind, Queries
from .pairs import check_distance
from .primitives import AnyMesh, SurfaceMesh, ends, primitives, rule_of, surface
from .rescaling import choose_rescaling
from .stencils import (
    Candidate,
    EdgeEdgeCandidate,
    EdgeVertexCandidate,
    FaceVertexCandidate,
    VertexVertexCandidate,
)

_STENCILS: dict[Kind, tuple[Callable[[int, int], Candidate], int]] = {
    "vv": (VertexVertexCandidate, 1),
    "ve": (EdgeVertexCandidate, -1),
    "ee": (EdgeEdgeCandidate, 1),
    "vf": (FaceVertexCandidate, -1),
}
"""The kinds in the order of ipctk, and the direction in which it names the two primitives."""

_LISTS: dict[Kind, str] = {"vv": "vv_candidates", "ve": "ev_candidates", "ee": "ee_candidates", "vf": "fv_candidates"}
"""The names of the lists in ipctk."""


class Candidates:
    """Pairs of primitives that come near each other in a step: decided together, as often as needed.

    The methods, the lists and the order of the items are the same as in ``ipctk.Candidates``. The pairs
    of a step are also sufficient for every step from the same start to positions on the way.

    In three dimensions, a rod may also fold through the rod before it: a vertex that has edges meets the edge
    of a rod. Such pairs are compared for contact, whatever the distance, and are not in the lists of ipctk.

    The rule ``can_collide`` of a mesh restricts the answers, not the lists: it is called for pairs in contact.

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
    >>> candidates.fv_candidates
    [FaceVertexCandidate(face_id=0, vertex_id=3)]
    """

    def __init__(self) -> None:
        # Of each kind, the indices of both primitives, and the vertices, in the order of the queries.
        self._ids: dict[Kind, Indices] = {}
        self._pairs: dict[Kind, Indices] = {}
        # The vertices of pairs that are compared for contact only, whatever the distance.
        self._folds = np.empty((0, 3), np.uint32)

    def build(
        self,
        mesh: AnyMesh,
        vertices_t0: ArrayLike,
        vertices_t1: Optional[ArrayLike] = None,
        inflation_radius: float = 0.0,
        broad_phase: object = None,
    ) -> None:
        """Find the pairs whose boxes over the step meet.

        Parameters
        ----------
        mesh, vertices_t0 : CollisionMesh, and array of shape (V, 2) or (V, 3)
            As for :func:`exact_ccd.ipc.is_step_collision_free`.
        vertices_t1 : array of shape (V, 2) or (V, 3), optional
            The positions at the end; without them, the vertices do not move.
        inflation_radius : float
            The distance by which each box is enlarged on every side.
        broad_phase : object
            Accepted as in ipctk, without effect.
        """
        if vertices_t1 is not None and as_array("vertices_t1", vertices_t1).ndim == 0:
            # The form without the end: build(mesh, vertices, inflation_radius).
            inflation_radius, vertices_t1 = number("inflation_radius", vertices_t1), None
        radius = check_distance("inflation_radius", inflation_radius)
        given = surface(mesh)
        x0, x1, dim = ends(given, vertices_t0, vertices_t0 if vertices_t1 is None else vertices_t1)
        every = primitives(given)
        self.clear()

        def near(first: Indices, second: Indices, of_first: Indices, of_second: Indices) -> Indices:
            """The pairs of primitives with these indices."""
            pairs = _native.overlaps(of_first[first], of_second[second], x0, x1, radius, None)
            if of_first is of_second:
                pairs = pairs[pairs[:, 0] < pairs[:, 1]]
            return np.column_stack([first[pairs[:, 0]], second[pairs[:, 1]]])

        def add(kind: Kind, first: Indices, second: Indices, of_first: Indices, of_second: Indices) -> None:
            self._ids[kind] = ids = near(first, second, of_first, of_second)
            self._pairs[kind] = np.hstack([of_first[ids[:, 0]], of_second[ids[:, 1]]])

        vertices, edges, faces = (_all(rows) for rows in every[:3])
        loose, rods = every.loose_vertices, every.loose_edges
        add("vv", loose, loose, every.vertices, every.vertices)
        if dim == 2:
            add("ve", vertices, edges, every.vertices, every.edges)
        else:
            add("ve", loose, rods, every.vertices, every.edges)
            add("ee", edges, edges, every.edges, every.edges)
            add("vf", vertices, faces, every.vertices, every.faces)
            folds = near(np.setdiff1d(vertices, loose), rods, every.vertices, every.edges)
            self._folds = np.column_stack([folds[:, 0], every.edges[folds[:, 1]]])

    def __len__(self) -> int:
        """The number of pairs."""
        return sum(len(pairs) for pairs in self._pairs.values())

    def __getitem__(self, index: int) -> Candidate:
        """The candidate with an index, in the order of ipctk: vertex-vertex, edge-vertex, edge-edge, face-vertex."""
        place = index + len(self) if index < 0 else index
        if place >= 0:
            for kind, ids in self._ids.items():
                if place < len(ids):
                    return _stencil(kind, ids[place])
                place -= len(ids)
        raise IndexError(f"candidate {index}, but there are only {len(self)} candidates")

    def __iter__(self) -> Iterator[Candidate]:
        """The candidates in the order of their indices."""
        return (_stencil(kind, row) for kind, ids in self._ids.items() for row in ids)

    @property
    def vv_candidates(self) -> list[VertexVertexCandidate]:
        """The pairs of two vertices."""
        return self._list("vv")

    @property
    def ev_candidates(self) -> list[EdgeVertexCandidate]:
        """The pairs of an edge and a vertex."""
        return self._list("ve")

    @property
    def ee_candidates(self) -> list[EdgeEdgeCandidate]:
        """The pairs of two edges."""
        return self._list("ee")

    @property
    def fv_candidates(self) -> list[FaceVertexCandidate]:
        """The pairs of a face and a vertex."""
        return self._list("vf")

    def _list(self, kind: Kind) -> list[Any]:
        return [_stencil(kind, row) for row in self._ids.get(kind, ())]

    def empty(self) -> bool:
        """Return True if there are no pairs.

        Returns
        -------
        bool
            True without pairs.
        """
        return len(self) == 0

    def clear(self) -> None:
        """Remove all pairs."""
        self._ids, self._pairs, self._folds = {}, {}, self._folds[:0]

    def to_ipctk(self, mesh: AnyMesh) -> Any:
        """Return the pairs that can collide as an ``ipctk.Candidates``, which must be installed.

        It is for functions of ipctk, such as ``NormalCollisions.build(candidates, mesh, vertices, dhat)``. Build the
        candidates with the `inflation_radius` that these need: half of `dhat`.

        Parameters
        ----------
        mesh : CollisionMesh
            The mesh of :meth:`build`: its ``can_collide`` is called for each pair.

        Returns
        -------
        ipctk.Candidates
            The same pairs in the same order, without the pairs that cannot collide.
        """
        import ipctk

        rule = rule_of(surface(mesh))
        result = ipctk.Candidates()
        for kind, (stencil, direction) in _STENCILS.items():
            name = stencil.__name__
            rows = zip(self._ids.get(kind, ()), self._pairs.get(kind, ()))
            allowed = [ids[::direction].tolist() for ids, vertices in rows if allows(rule, kind, vertices)]
            setattr(result, _LISTS[kind], [getattr(ipctk, name)(*ids) for ids in allowed])
        return result

    @property
    def pairs(self) -> dict[Kind, NDArray[np.uint32]]:
        """The vertices of the pairs of each kind, as `vertices` of :class:`exact_ccd.Queries`."""
        return dict(self._pairs)

    def is_step_collision_free(
        self,
        mesh: AnyMesh,
        vertices_t0: ArrayLike,
        vertices_t1: ArrayLike,
        min_distance: float = 0.0,
        narrow_phase_ccd: object = None,
    ) -> bool:
        """Decide if none of the pairs comes within `min_distance` in the step, exactly.

        Parameters
        ----------
        mesh, vertices_t0, vertices_t1, min_distance, narrow_phase_ccd : see is_step_collision_free
            As for :func:`exact_ccd.ipc.is_step_collision_free`.

        Returns
        -------
        bool
            True if the step is free.
        """
        given = surface(mesh)
        x0, x1, _ = ends(given, vertices_t0, vertices_t1)
        return self._earliest(given, x0, x1, min_distance) is None

    def compute_collision_free_stepsize(
        self,
        mesh: AnyMesh,
        vertices_t0: ArrayLike,
        vertices_t1: ArrayLike,
        min_distance: float = 0.0,
        narrow_phase_ccd: object = None,
        conservative_rescaling: Optional[float] = None,
    ) -> float:
        """Compute a step size at which none of the pairs has come within `min_distance`.

        Parameters
        ----------
        mesh, vertices_t0, vertices_t1, min_distance, narrow_phase_ccd, conservative_rescaling : see compute_collision_free_stepsize
            As for :func:`exact_ccd.ipc.compute_collision_free_stepsize`.

        Returns
        -------
        float
            The size, from 0 to 1.
        """
        rescaling = choose_rescaling(conservative_rescaling, narrow_phase_ccd)
        given = surface(mesh)
        x0, x1, _ = ends(given, vertices_t0, vertices_t1)
        time = self._earliest(given, x0, x1, min_distance)
        if time is None:
            return 1.0
        size = whole = rescaling * time
        retreat = whole - np.nextafter(whole, 0.0)
        while size > 0.0:
            # The sum is rounded: at 1, the positions are x1.
            x = _between(x0, x1, size) if size < 1.0 else x1
            if self._earliest(given, x0, x, min_distance) is None:
                return size
            size, retreat = float(whole - retreat), 2.0 * retreat
        return 0.0

    def _earliest(self, mesh: SurfaceMesh, x0: Floats, x1: Floats, min_distance: float) -> Optional[float]:
        """The first time at which a pair that can collide comes within the distance."""
        distance, rule = check_distance("min_distance", min_distance), rule_of(mesh)
        first: Optional[float] = None
        fold: tuple[Kind, Indices, float] = ("ve", self._folds, 0.0)
        for kind, pairs, d in [*((kind, pairs, distance) for kind, pairs in self._pairs.items()), fold]:
            times = Queries(kind, x0, x1, pairs).time_of_impact(separation=d)
            near = np.flatnonzero(~np.isnan(times))
            for row in near[np.argsort(times[near], kind="stable")]:
                if first is not None and times[row] >= first:
                    break
                if allows(rule, kind, pairs[row]):
                    first = float(times[row])
                    break
        return first


def _between(x0: Floats, x1: Floats, size: float) -> Floats:
    """``x0 + size * (x1 - x0)``; a weighted sum where the difference overflows, as in a step of a detector."""
    with np.errstate(over="ignore", invalid="ignore"):
        x = x0 + size * (x1 - x0)
    return np.where(np.isfinite(x), x, (1.0 - size) * x0 + size * x1)


def _all(rows: Indices) -> Indices:
    """The indices of all rows."""
    return np.arange(len(rows), dtype=np.uint32)


def _stencil(kind: Kind, ids: NDArray[np.uint32]) -> Candidate:
    stencil, direction = _STENCILS[kind]
    return stencil(*ids[::direction].tolist())


def allows(
    can_collide: Optional[Callable[[int, int], object]], kind: Kind, vertices: NDArray[np.uint32]
) -> bool:
    """Return True if any vertex of the first primitive and any of the second can collide."""
    if can_collide is None:
        return True
    size = 2 if kind == "ee" else 1
    a, b = vertices[:size].tolist(), vertices[size:].tolist()
    return any(can_collide(v, w) for v in a for w in b)
