"""Narrow phases by the names of ipctk, with exact decisions; ipctk is not needed."""

from __future__ import annotations

from collections.abc import Callable
from inspect import signature
from math import inf
from typing import Any

from .._arrays import number
from ..detectors import Detector
from ..meshes import Mesh
from .pairs import check_distance, coordinates, edge_edge_ccd, in_space, point_edge_ccd, point_point_ccd, point_triangle_ccd
from .rescaling import CONSERVATIVE_RESCALING, check_rescaling

MOST_ITERATIONS = 10_000_000
"""The default of ipctk."""

MOST_GAP = 1e-4
"""The greatest distance from contact at which Tight Inclusion stops in ipctk."""

_MESHES: dict[Callable[..., Any], Mesh] = {
    point_point_ccd: Mesh(2, []),
    point_edge_ccd: Mesh(3, [], edges=[[1, 2]]),
    point_triangle_ccd: Mesh(4, [[1, 2, 3]]),
    edge_edge_ccd: Mesh(4, [], edges=[[0, 1], [2, 3]]),
}
"""The mesh of the points of each pair."""


class NarrowPhase:
    """The methods of ``ipctk.NarrowPhaseCCD``, decided exactly; times are multiplied by `conservative_rescaling`."""

    conservative_rescaling: float

    def point_point_ccd(self, *arguments: Any, **options: Any) -> tuple[bool, float]:
        """See :func:`exact_ccd.ipc.point_point_ccd`."""
        return self._decide(point_point_ccd, *arguments, **options)

    def point_edge_ccd(self, *arguments: Any, **options: Any) -> tuple[bool, float]:
        """See :func:`exact_ccd.ipc.point_edge_ccd`."""
        return self._decide(point_edge_ccd, *arguments, **options)

    def point_triangle_ccd(self, *arguments: Any, **options: Any) -> tuple[bool, float]:
        """See :func:`exact_ccd.ipc.point_triangle_ccd`."""
        return self._decide(point_triangle_ccd, *arguments, **options)

    def edge_edge_ccd(self, *arguments: Any, **options: Any) -> tuple[bool, float]:
        """See :func:`exact_ccd.ipc.edge_edge_ccd`."""
        return self._decide(edge_edge_ccd, *arguments, **options)

    def _decide(self, decide: Callable[..., tuple[bool, float]], *arguments: Any, **options: Any) -> tuple[bool, float]:
        return decide(*arguments, **options, conservative_rescaling=self.conservative_rescaling)


class AdditiveCCD(NarrowPhase):
    """The methods and settings of ``ipctk.AdditiveCCD``, by exact decisions.

    A time is the exact time of contact times `conservative_rescaling`: for an approach at constant speed, the time at
    which the method of ipctk stops, too.

    Parameters
    ----------
    max_iterations : float
        Accepted as in ipctk, without effect.
    conservative_rescaling : float
        The factor of the exact time, above 0 and at most 1.

    Examples
    --------
    >>> face = [0, 0, 0], [1, 0, 0], [0, 1, 0]
    >>> AdditiveCCD().point_triangle_ccd([0.25, 0.25, 1], *face, [0.25, 0.25, -4], *face)
    (True, 0.18)
    """

    def __init__(
        self, max_iterations: float = MOST_ITERATIONS, conservative_rescaling: float = CONSERVATIVE_RESCALING
    ) -> None:
        self.conservative_rescaling = check_rescaling(conservative_rescaling)


class TightInclusionCCD(NarrowPhase):
    """The methods and settings of ``ipctk.TightInclusionCCD``, by exact decisions.

    The time of a pair is the exact time at which it comes within ``min_distance`` plus a gap: 1e-4, or, if that is less,
    ``1 - conservative_rescaling`` times the distance that is left at the start. The method of ipctk stops there, or before.
    In a step of a mesh, this class has no effect: the size is a factor of the exact time.

    Parameters
    ----------
    tolerance, max_iterations : float
        Accepted as in ipctk, without effect.
    conservative_rescaling : float
        Above 0 and at most 1. With 1, the time is the one of contact.

    Examples
    --------
    >>> face = [0, 0, 0], [1, 0, 0], [0, 1, 0]
    >>> TightInclusionCCD().point_triangle_ccd([0.25, 0.25, 1], *face, [0.25, 0.25, -4], *face)
    (True, 0.19998)
    """

    def __init__(
        self,
        tolerance: float = 1e-6,
        max_iterations: float = MOST_ITERATIONS,
        conservative_rescaling: float = 0.8,
    ) -> None:
        self.conservative_rescaling = check_rescaling(conservative_rescaling)

    def _decide(self, decide: Callable[..., tuple[bool, float]], *arguments: Any, **options: Any) -> tuple[bool, float]:
        bound = signature(decide).bind(*arguments, **options)
        bound.apply_defaults()
        *points, min_distance, tmax, _ = bound.arguments.values()
        distance = check_distance("min_distance", min_distance)
        gap = self._gap(_MESHES[decide], points, distance)
        return decide(*points, distance + gap, number("tmax", tmax), 1.0)

    def _gap(self, mesh: Mesh, points: list[Any], distance: float) -> float:
        """The distance beside `distance` at which the time counts; 0 if the pair starts within `distance`."""
        share = 1.0 - check_rescaling(self.conservative_rescaling)
        if share == 0.0:
            return 0.0
        start = in_space(coordinates("points", tuple(points)))[: mesh.vertex_count]
        enough = distance + MOST_GAP / share
        left = Detector(mesh).clearances(start, enough).min() - distance if enough < inf else 0.0
        return float(min(max(share * left, 0.0), MOST_GAP))
