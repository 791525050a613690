"""Steps of a whole mesh."""

from __future__ import annotations

import threading
import weakref
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Optional

import numpy as np
from numpy.typing import ArrayLike

from .. import _native
from ..detectors import Detector
from ..meshes import Mesh
from ..queries import Queries
from .candidates import Candidates, allows
from .collision_mesh import CollisionMesh
from .pairs import check_distance
from .primitives import AnyMesh, ends, primitives, rule_of, surface
from .rescaling import choose_rescaling


def is_step_collision_free(
    mesh: AnyMesh,
    vertices_t0: ArrayLike,
    vertices_t1: ArrayLike,
    min_distance: float = 0.0,
    broad_phase: object = None,
    narrow_phase_ccd: object = None,
) -> bool:
    """Decide if a step of a mesh is free of contact, exactly.

    A mesh that is pierced at the start is not in contact by that, as in ipctk: :func:`has_intersections` decides
    it, and ``docs/pairs.md`` lists all pairs that are never in contact.

    Parameters
    ----------
    mesh : ipctk.CollisionMesh, CollisionMesh or exact_ccd.Mesh
        Or an object with the same attributes.
    vertices_t0, vertices_t1 : arrays of shape (V, 2) or (V, 3)
        The positions of the vertices at the start and at the end.
    min_distance : float
        Primitives that come within this distance of each other count as touching.
    broad_phase, narrow_phase_ccd : object
        Accepted as in ipctk, without effect.

    Returns
    -------
    bool
        True if the step is free.

    Examples
    --------
    >>> from types import SimpleNamespace
    >>> mesh = SimpleNamespace(num_vertices=4, edges=[[0, 1], [1, 2], [2, 0]], faces=[[0, 1, 2]])
    >>> x0 = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.25, 0.25, 1]])
    >>> is_step_collision_free(mesh, x0, x0 - [0, 0, 2] * (np.arange(4) == 3)[:, None])
    False
    """
    x0, x1, dim = ends(surface(mesh), vertices_t0, vertices_t1)
    if dim == 3:
        with _detector(mesh, min_distance) as detector:
            return not detector.collides(x0, x1)
    candidates = _candidates(mesh, vertices_t0, vertices_t1, min_distance)
    return candidates.is_step_collision_free(mesh, vertices_t0, vertices_t1, min_distance)


def compute_collision_free_stepsize(
    mesh: AnyMesh,
    vertices_t0: ArrayLike,
    vertices_t1: ArrayLike,
    min_distance: float = 0.0,
    broad_phase: object = None,
    narrow_phase_ccd: object = None,
    conservative_rescaling: Optional[float] = None,
) -> float:
    """Compute a step size at which a mesh has not touched itself.

    It is 0.9 times the exact time of contact, as with ``AdditiveCCD`` of ipctk: 0.18 for a contact at 0.2, where the default
    of ipctk, ``TightInclusionCCD``, returns 0.1999. ``conservative_rescaling=1.0`` gives the largest size that is free.

    A mesh that is pierced at the start is not in contact by that, as in ipctk: :func:`has_intersections` decides
    it, and ``docs/pairs.md`` lists all pairs that are never in contact.

    Parameters
    ----------
    mesh, vertices_t0, vertices_t1, min_distance, broad_phase, narrow_phase_ccd : see is_step_collision_free
        As for :func:`is_step_collision_free`. If `narrow_phase_ccd` is an :class:`ExactCCD` or an
        :class:`AdditiveCCD` of this module, its ``conservative_rescaling`` is taken.
    conservative_rescaling : float, optional
        The factor of the exact time of contact that is returned, above 0 and at most 1; 0.9 by default.

    Returns
    -------
    float
        1 if the whole step is free; 0 if none of the sizes that are tried is certified: the mesh touches
        itself at the start, or is nearer to itself there than rounded positions are to the path. Otherwise
        the motion to ``vertices_t0 + size * (vertices_t1 - vertices_t0)``, rounded, is free of contact, if
        no difference overflows. With 1, take ``vertices_t1``, not the sum.

    Examples
    --------
    >>> from types import SimpleNamespace
    >>> mesh = SimpleNamespace(num_vertices=4, edges=[[0, 1], [1, 2], [2, 0]], faces=[[0, 1, 2]])
    >>> x0 = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.25, 0.25, 1]])
    >>> compute_collision_free_stepsize(mesh, x0, x0 - [0, 0, 2] * (np.arange(4) == 3)[:, None])
    0.45
    """
    rescaling = choose_rescaling(conservative_rescaling, narrow_phase_ccd)
    x0, x1, dim = ends(surface(mesh), vertices_t0, vertices_t1)
    if dim == 3:
        with _detector(mesh, min_distance) as detector:
            return detector.free_step(x0, x1, keep=rescaling).size
    return _candidates(mesh, vertices_t0, vertices_t1, min_distance).compute_collision_free_stepsize(
        mesh, vertices_t0, vertices_t1, min_distance, conservative_rescaling=rescaling
    )


def has_intersections(mesh: AnyMesh, vertices: ArrayLike, broad_phase: object = None) -> bool:
    """Decide if a mesh at rest passes through itself, exactly: an edge through a face, in 2D through an edge.

    Primitives that share a vertex are not compared. Touching counts.

    Parameters
    ----------
    mesh : ipctk.CollisionMesh, CollisionMesh or exact_ccd.Mesh
        Or an object with the same attributes.
    vertices : array of shape (V, 2) or (V, 3)
        The positions.
    broad_phase : object
        Accepted as in ipctk, without effect.

    Returns
    -------
    bool
        True if it does.
    """
    given = surface(mesh)
    x, _, dim = ends(given, vertices, vertices)
    if dim == 3:
        with _detector(mesh, 0.0) as detector:
            return detector._native.has_intersections(x[None])
    edges = primitives(given).edges
    pairs = _native.overlaps(edges, edges, x, x, 0.0, None)
    pairs = pairs[pairs[:, 0] < pairs[:, 1]]
    fours = np.hstack([edges[pairs[:, 0]], edges[pairs[:, 1]]])
    meet = Queries("ee", x, x, fours).collides()
    rule = rule_of(given)
    return any(allows(rule, "ee", four) for four in fours[meet])


def _candidates(
    mesh: AnyMesh, vertices_t0: ArrayLike, vertices_t1: ArrayLike, min_distance: float
) -> Candidates:
    distance = check_distance("min_distance", min_distance)
    # Half of an odd multiple of the smallest float64 is rounded, perhaps down: the rest is not less then.
    half = 0.5 * distance
    candidates = Candidates()
    candidates.build(mesh, vertices_t0, vertices_t1, max(half, distance - half))
    return candidates


class _Rule:
    """The rule of the mesh of the current call: a mesh may have another one in the next call."""

    now: Optional[Callable[[int, int], object]] = None

    def __call__(self, v: int, w: int) -> object:
        """Return the answer of the rule; True without one."""
        return self.now is None or self.now(v, w)


_Detectors = dict[tuple[float, bool], tuple[Detector, _Rule]]
"""The detectors of a mesh, by the distance, and by True with a rule."""


class _Cache(threading.local):
    """The detectors of the meshes of a thread, whose faces and edges never change."""

    def __init__(self) -> None:
        self.detectors = weakref.WeakKeyDictionary[AnyMesh, _Detectors]()


_cache = _Cache()

_MOST_DETECTORS = 4
"""The number of detectors that are kept for each mesh: the last ones in use."""


@contextmanager
def _detector(mesh: AnyMesh, min_distance: float) -> Iterator[Detector]:
    """The detector of a mesh in three dimensions, with the rule that the mesh has now."""
    rule = rule_of(surface(mesh))
    key = check_distance("min_distance", min_distance), rule is not None
    kept: _Detectors = _cache.detectors.setdefault(mesh, {}) if _is_kept(mesh) else {}
    found = kept.pop(key, None)
    detector, own_rule = kept[key] = found or _new(mesh, *key)
    if len(kept) > _MOST_DETECTORS:
        del kept[next(iter(kept))]
    # A signal handler may be called within a call, and call this one.
    before, own_rule.now = own_rule.now, rule
    try:
        yield detector
    finally:
        # The rule may have the mesh, which its own detector does not keep alive.
        own_rule.now = before


def _is_kept(mesh: AnyMesh) -> bool:
    """Return True if a detector of the mesh can be kept: its primitives never change, and it is not kept alive."""
    if isinstance(mesh, Mesh):
        return not callable(mesh.can_collide)
    kinds = type(mesh).__mro__
    return isinstance(mesh, CollisionMesh) or any(kind.__module__.split(".")[0] == "ipctk" for kind in kinds)


def _new(mesh: AnyMesh, distance: float, has_rule: bool) -> tuple[Detector, _Rule]:
    rule = _Rule()
    if isinstance(mesh, Mesh):
        # Another object with the same compiled part.
        own = object.__new__(Mesh)
        own.__dict__.update(mesh.__dict__)
    else:
        every = primitives(mesh)
        own = Mesh(mesh.num_vertices, every.faces, every.edges, can_collide=rule if has_rule else None)
    detector = Detector(own, min_distance=distance)
    # As in ipctk, without warnings.
    detector._is_warned = True
    return detector, rule
