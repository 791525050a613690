"""The factor of exact times, which ipctk calls the conservative rescaling."""

from __future__ import annotations

import sys
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
    """Return the given factor, the factor of an :class:`ExactCCD` or of its subclass, or the default."""
    if conservative_rescaling is not None:
        return check_rescaling(conservative_rescaling)
    # There is an object of the class only if its module, which needs ipctk, has been imported.
    module = sys.modules.get("exact_ccd.ipc.narrow_phase")
    if module is not None and isinstance(narrow_phase_ccd, module.ExactCCD):
        return check_rescaling(narrow_phase_ccd.conservative_rescaling)
    return CONSERVATIVE_RESCALING
