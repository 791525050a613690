"""Exact continuous collision detection of moving triangle meshes.

- :class:`Queries` are pairs of primitives in motion, in numpy arrays, and answer many at a time.
- A :class:`Detector` finds the contacts of a whole :class:`Mesh` in a step, and certifies the step that a
  solver can take; :class:`Worlds` do so for many positions of one mesh at a time. :func:`audit` certifies a
  sequence of frames, and :func:`repair` moves vertices of a mesh that intersects itself.
- :class:`Bodies` are rigid, and turn: contact is exact on their curved paths.
- :func:`answer_table` answers the queries in a table of Arrow; :mod:`exact_ccd.ray` distributes large tables
  and long recordings over many machines.
- :mod:`exact_ccd.ipc` has functions of ipctk, with the same arguments.
"""

from ._native import CrossingError, UncertifiedError, __version__
from .audits import audit
from .bodies import BODY_CONTACT, Bodies, BodiesReport, BodyContact, BodyDistances, FreePoses
from .contacts import CONTACT, PAIR, Contact
from .detectors import Detector, Progress
from .groups import CanCollide, Place
from .meshes import Mesh, MeshFile, read_mesh
from .notebooks import NotebookPage
from .poses import NearestPoses, nearest_poses
from .queries import IMPACT, Intervals, Kind, Queries
from .recordings import Frames, open_recording
from .repairs import Blocked, Change, Repair, RepairedRecording, RepairProgress, repair, repair_recording
from .scenes import PlacedMesh, from_trimesh
from .steps import FirstContacts, FreeStep, FreeSteps, PairCounts, StepReport
from .tables import Answer, answer_table
from .violations import AuditReport, Violation
from .worlds import Contacts, StepReports, WorldFreeSteps, Worlds

__all__ = [
    "BODY_CONTACT",
    "CONTACT",
    "IMPACT",
    "PAIR",
    "Answer",
    "AuditReport",
    "Blocked",
    "Bodies",
    "BodiesReport",
    "BodyContact",
    "BodyDistances",
    "CanCollide",
    "Change",
    "Contact",
    "Contacts",
    "CrossingError",
    "Detector",
    "FirstContacts",
    "Frames",
    "FreePoses",
    "FreeStep",
    "FreeSteps",
    "Intervals",
    "Kind",
    "Mesh",
    "MeshFile",
    "NearestPoses",
    "NotebookPage",
    "PairCounts",
    "Place",
    "PlacedMesh",
    "Progress",
    "Queries",
    "Repair",
    "RepairProgress",
    "RepairedRecording",
    "StepReport",
    "StepReports",
    "UncertifiedError",
    "Violation",
    "WorldFreeSteps",
    "Worlds",
    "__version__",
    "answer_table",
    "audit",
    "from_trimesh",
    "nearest_poses",
    "open_recording",
    "read_mesh",
    "repair",
    "repair_recording",
]
