"""A narrow phase for ipctk, which must be installed."""

from __future__ import annotations

import ipctk

from .narrow_phases import NarrowPhase
from .rescaling import CONSERVATIVE_RESCALING, check_rescaling


class ExactCCD(NarrowPhase, ipctk.NarrowPhaseCCD):  # type: ignore[misc]
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
        ipctk.NarrowPhaseCCD.__init__(self)
        self.conservative_rescaling = check_rescaling(conservative_rescaling)
        if ipctk.get_num_threads() != 1:
            ipctk.set_num_threads(1)
