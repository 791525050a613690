"""A narrow phase for ipctk, which must be installed."""

from __future__ import annotations

import ipctk
from numpy.typing import ArrayLike

from .pairs import edge_edge_ccd, point_edge_ccd, point_point_ccd, point_triangle_ccd
from .rescaling import CONSERVATIVE_RESCALING, check_rescaling


class ExactCCD(ipctk.NarrowPhaseCCD):  # type: ignore[misc]
    """The exact decisions as a narrow phase of ipctk.

    ipctk waits forever if a narrow phase in Python is called from more than one of its threads, because
    it does not release the interpreter lock. So the number of its threads is set to 1 here, for the whole
    process; do not increase it while an object of this class is in use. Where speed matters, call
    :func:`is_step_collision_free` or :func:`compute_collision_free_stepsize` of this module instead: they
    decide all pairs of a step in one batch, on all cores.

    Static planes do not use the narrow phase in ipctk, and read a factor that a subclass cannot set.

    Parameters
    ----------
    conservative_rescaling : float
        The factor of the exact time that is returned, above 0 and at most 1.
    """

    def __init__(self, conservative_rescaling: float = CONSERVATIVE_RESCALING) -> None:
        super().__init__()
        self.conservative_rescaling = check_rescaling(conservative_rescaling)
        if ipctk.get_num_threads() != 1:
            ipctk.set_num_threads(1)

    def point_point_ccd(
        self,
        p0_t0: ArrayLike,
        p1_t0: ArrayLike,
        p0_t1: ArrayLike,
        p1_t1: ArrayLike,
        min_distance: float = 0.0,
        tmax: float = 1.0,
    ) -> tuple[bool, float]:
        """See :func:`exact_ccd.ipc.point_point_ccd`."""
        points = (p0_t0, p1_t0, p0_t1, p1_t1)
        return point_point_ccd(*points, min_distance, tmax, self.conservative_rescaling)

    def point_edge_ccd(
        self,
        p_t0: ArrayLike,
        e0_t0: ArrayLike,
        e1_t0: ArrayLike,
        p_t1: ArrayLike,
        e0_t1: ArrayLike,
        e1_t1: ArrayLike,
        min_distance: float = 0.0,
        tmax: float = 1.0,
    ) -> tuple[bool, float]:
        """See :func:`exact_ccd.ipc.point_edge_ccd`."""
        points = (p_t0, e0_t0, e1_t0, p_t1, e0_t1, e1_t1)
        return point_edge_ccd(*points, min_distance, tmax, self.conservative_rescaling)

    def point_triangle_ccd(
        self,
        p_t0: ArrayLike,
        t0_t0: ArrayLike,
        t1_t0: ArrayLike,
        t2_t0: ArrayLike,
        p_t1: ArrayLike,
        t0_t1: ArrayLike,
        t1_t1: ArrayLike,
        t2_t1: ArrayLike,
        min_distance: float = 0.0,
        tmax: float = 1.0,
    ) -> tuple[bool, float]:
        """See :func:`exact_ccd.ipc.point_triangle_ccd`."""
        points = (p_t0, t0_t0, t1_t0, t2_t0, p_t1, t0_t1, t1_t1, t2_t1)
        return point_triangle_ccd(*points, min_distance, tmax, self.conservative_rescaling)

    def edge_edge_ccd(
        self,
        ea0_t0: ArrayLike,
        ea1_t0: ArrayLike,
        eb0_t0: ArrayLike,
        eb1_t0: ArrayLike,
        ea0_t1: ArrayLike,
        ea1_t1: ArrayLike,
        eb0_t1: ArrayLike,
        eb1_t1: ArrayLike,
        min_distance: float = 0.0,
        tmax: float = 1.0,
    ) -> tuple[bool, float]:
        """See :func:`exact_ccd.ipc.edge_edge_ccd`."""
        points = (ea0_t0, ea1_t0, eb0_t0, eb1_t0, ea0_t1, ea1_t1, eb0_t1, eb1_t1)
        return edge_edge_ccd(*points, min_distance, tmax, self.conservative_rescaling)
