"""Functions of the IPC Toolkit (Python package ipctk), with the same arguments and exact decisions.

Change the import of ipctk for these functions:

>>> from exact_ccd.ipc import compute_collision_free_stepsize, is_step_collision_free

They take an ``ipctk.CollisionMesh`` as it is, a :class:`CollisionMesh` of this module, an
:class:`exact_ccd.Mesh`, or any object with the attributes ``edges``, ``faces``, ``num_vertices`` and,
optionally, ``can_collide``; ipctk itself is not needed. Positions have two or three columns.

Where they differ from ipctk:

- Step sizes and times are the exact time of contact, times ``conservative_rescaling``: 0.9 by default, because
  at the exact time itself the primitives touch. If contact is at 0.2, the size is 0.18, as of ``AdditiveCCD`` of ipctk. The
  default of ipctk, ``TightInclusionCCD``, returns 0.19998 there: it stops ``min(0.2 * d, 1e-4)`` before contact, d being
  the distance at the start. ``conservative_rescaling=1.0`` gives the largest size that is free of contact.
- For a size below 1, the straight motion to the rounded positions
  ``x0 + size * (x1 - x0)`` has been decided to be free of contact; with 1, the motion to ``x1``: take ``x1``, not the
  sum.
- `broad_phase` is accepted and has no effect, as every pair that touches is found. A `narrow_phase_ccd` has no
  effect either, unless it is an :class:`ExactCCD` or an :class:`AdditiveCCD` of this module: its ``conservative_rescaling`` is
  taken. Alone, :class:`AdditiveCCD` and :class:`TightInclusionCCD` have the methods of ipctk for single pairs, with the same
  rescaling.
- The lists of :class:`Candidates` have all pairs whose boxes meet; ``can_collide`` restricts the answers only.
  :meth:`Candidates.to_ipctk` makes an ``ipctk.Candidates`` of them, for the collisions and potentials of ipctk.
- Static planes (``CollisionMesh.planes``) are refused.
- In ipctk 1.6, `can_collide` gets the wrong numbers of vertices for pairs of codimensional vertices; here it gets
  their numbers in the mesh.

``ExactCCD`` is a subclass of ``ipctk.NarrowPhaseCCD``, where ipctk is installed, for the other functions of
ipctk that take a narrow phase. See its documentation before use: one call at a time through Python is several
times as slow as a batch, and ipctk must run on one thread then.
"""

from __future__ import annotations

from typing import Any

from .candidates import Candidates
from .collision_mesh import CollisionMesh
from .narrow_phases import AdditiveCCD, TightInclusionCCD
from .pairs import edge_edge_ccd, point_edge_ccd, point_point_ccd, point_triangle_ccd
from .primitives import edges
from .stencils import EdgeEdgeCandidate, EdgeVertexCandidate, FaceVertexCandidate, VertexVertexCandidate
from .steps import compute_collision_free_stepsize, has_intersections, is_step_collision_free

__all__ = [
    "AdditiveCCD",
    "Candidates",
    "CollisionMesh",
    "EdgeEdgeCandidate",
    "EdgeVertexCandidate",
    "FaceVertexCandidate",
    "TightInclusionCCD",
    "VertexVertexCandidate",
    "compute_collision_free_stepsize",
    "edge_edge_ccd",
    "edges",
    "has_intersections",
    "is_step_collision_free",
    "point_edge_ccd",
    "point_point_ccd",
    "point_triangle_ccd",
]


def __getattr__(name: str) -> Any:
    """``ExactCCD``, which needs ipctk, on first use."""
    if name == "ExactCCD":
        from .exact_narrow_phase import ExactCCD

        return ExactCCD
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
