"""Exact continuous collision detection of moving triangle meshes.

Queries are two primitives in motion: :func:`collides`, :func:`time_of_impact`, :func:`contact_count`,
:func:`contact_times` and :func:`impacts` answer many at a time, from numpy arrays.
"""

from ._native import __version__
from .queries import (
    IMPACT,
    ContactTimes,
    Kind,
    collides,
    contact_count,
    contact_times,
    impacts,
    time_of_impact,
)

__all__ = [
    "IMPACT",
    "ContactTimes",
    "Kind",
    "__version__",
    "collides",
    "contact_count",
    "contact_times",
    "impacts",
    "time_of_impact",
]
