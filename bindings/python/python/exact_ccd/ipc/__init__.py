"""Functions of the IPC Toolkit (Python package ipctk), with the same arguments and exact decisions.

Change the import of ipctk for these functions:

>>> from exact_ccd.ipc import compute_collision_free_stepsize, is_step_collision_free

They take an ``ipctk.CollisionMesh`` as it is, a :class:`CollisionMesh` of this module, an
:class:`exact_ccd.Mesh`, or any object with the attributes ``edges``, ``faces``, ``num_vertices`` and,
optionally, ``can_collide``; ipctk itself is not needed. Positions have two or three columns.

Where they differ from ipctk:

- Step sizes and times are the exact time of contact, times ``conservative_rescaling``: 0.9 by default, because
  at the exact time itself the primitives touch. For a size below 1, the straight motion to the rounded positions
  ``x0 + size * (x1 - x0)`` has been decided to be free of contact; with 1, that to ``x1``: take ``x1``, not the
  sum. With a factor of 1, the size is as near to the contact as rounding permits. The built-in method of ipctk
  keeps a distance of
  ``min(0.2 * d, 1e-4)`` instead, d being the distance at the start.
- `broad_phase` is accepted and has no effect, as every pair that touches is found. A `narrow_phase_ccd` has no
  effect either, unless it is an :class:`ExactCCD`: its ``conservative_rescaling`` is taken.
- The lists of :class:`Candidates` have all pairs whose boxes meet; ``can_collide`` restricts the answers only.
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
from .pairs import edge_edge_ccd, point_edge_ccd, point_point_ccd, point_triangle_ccd
from .primitives import edges
from .stencils import EdgeEdgeCandidate, EdgeVertexCandidate, FaceVertexCandidate, VertexVertexCandidate
from .steps import compute_collision_free_stepsize, has_intersections, is_step_collision_free

__all__ = [
    "Candidates",
    "CollisionMesh",
    "EdgeEdgeCandidate",
    "EdgeVertexCandidate",
    "FaceVertexCandidate",
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
        from .narrow_phase import ExactCCD

        return ExactCCD
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
