"""The factor of exact times, which ipctk calls the conservative rescaling."""

from __future__ import annotations

from typing import Optional

from .._arrays import number

CONSERVATIVE_RESCALING = 0.9
"""The factor by default."""


def check_rescaling(conservative_rescaling: float) -> float:
    """Return the factor; refuse one that is not above 0 and at most 1."""
    factor = number("conservative_rescaling", conservative_rescaling)
    if not 0.0 < factor <= 1.0:
        raise ValueError(f"conservative_rescaling is {factor}, expected a number above 0 and at most 1")
    return factor


def choose_rescaling(conservative_rescaling: Optional[float], narrow_phase_ccd: object) -> float:
    """Return the given factor, the factor of a narrow phase of this package that has one, or the default."""
    if conservative_rescaling is not None:
        return check_rescaling(conservative_rescaling)
    # Here, because the classes need this module.
    from .narrow_phases import NarrowPhase, TightInclusionCCD

    if isinstance(narrow_phase_ccd, NarrowPhase) and not isinstance(narrow_phase_ccd, TightInclusionCCD):
        return check_rescaling(narrow_phase_ccd.conservative_rescaling)
    return CONSERVATIVE_RESCALING
