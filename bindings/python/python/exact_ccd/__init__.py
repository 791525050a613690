"""Exact continuous collision detection of moving triangle meshes.

- Queries are two primitives in motion: :func:`collides`, :func:`time_of_impact`, :func:`contact_count`,
  :func:`contact_times` and :func:`impacts` answer many at a time, from numpy arrays.
- A :class:`Detector` finds the contacts of a whole :class:`Mesh` in a step, and certifies the step that a
  solver can take. :func:`audit` certifies a sequence of frames.
- :func:`check` answers for the queries in a table of Arrow; :mod:`exact_ccd.ray` distributes large tables and
  long recordings over many machines.
- :mod:`exact_ccd.ipc` has functions of ipctk, with the same arguments.
"""

from ._native import CrossingError, __version__
from .audits import AuditReport, Violation, audit
from .contacts import CONTACT, Contact
from .meshes import Detector, FreeStep, Mesh, MeshFile, PairCounts, Progress, StepReport, read_mesh
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
from .tables import Answer, check

__all__ = [
    "CONTACT",
    "IMPACT",
    "Answer",
    "AuditReport",
    "Contact",
    "ContactTimes",
    "CrossingError",
    "Detector",
    "FreeStep",
    "Kind",
    "Mesh",
    "MeshFile",
    "PairCounts",
    "Progress",
    "StepReport",
    "Violation",
    "__version__",
    "audit",
    "check",
    "collides",
    "contact_count",
    "contact_times",
    "impacts",
    "read_mesh",
    "time_of_impact",
]
