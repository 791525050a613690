"""A narrow phase for ipctk, which must be installed."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import ipctk

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

    def point_point_ccd(self, *arguments: Any, **options: Any) -> tuple[bool, float]:
        """See :func:`exact_ccd.ipc.point_point_ccd`."""
        return self._rescaled(point_point_ccd, *arguments, **options)

    def point_edge_ccd(self, *arguments: Any, **options: Any) -> tuple[bool, float]:
        """See :func:`exact_ccd.ipc.point_edge_ccd`."""
        return self._rescaled(point_edge_ccd, *arguments, **options)

    def point_triangle_ccd(self, *arguments: Any, **options: Any) -> tuple[bool, float]:
        """See :func:`exact_ccd.ipc.point_triangle_ccd`."""
        return self._rescaled(point_triangle_ccd, *arguments, **options)

    def edge_edge_ccd(self, *arguments: Any, **options: Any) -> tuple[bool, float]:
        """See :func:`exact_ccd.ipc.edge_edge_ccd`."""
        return self._rescaled(edge_edge_ccd, *arguments, **options)

    def _rescaled(
        self, decide: Callable[..., tuple[bool, float]], *arguments: Any, **options: Any
    ) -> tuple[bool, float]:
        return decide(*arguments, **options, conservative_rescaling=self.conservative_rescaling)
