"""The meshes that the functions of this module take, and their primitives."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple, Optional, Protocol, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._arrays import Floats, Indices, indices
from ..meshes import Mesh
from .pairs import coordinates, in_space


class SurfaceMesh(Protocol):
    """The attributes of ``ipctk.CollisionMesh`` that are used; ``can_collide`` and ``planes`` too, if any."""

    @property
    def num_vertices(self) -> int: ...
    @property
    def edges(self) -> Any: ...
    @property
    def faces(self) -> Any: ...


AnyMesh = Union[SurfaceMesh, Mesh]
"""A mesh of ipctk or of :mod:`exact_ccd.ipc`, an object with its attributes, or an :class:`exact_ccd.Mesh`."""


class _Named(NamedTuple):
    """An :class:`exact_ccd.Mesh`, by the names of ipctk."""

    num_vertices: int
    edges: Indices
    faces: Indices
    can_collide: Callable[[int, int], object]


def surface(mesh: AnyMesh) -> SurfaceMesh:
    """The mesh by the names of ipctk."""
    if isinstance(mesh, Mesh):
        return _Named(mesh.vertex_count, mesh.edges, mesh.faces, mesh.vertices_can_collide)
    for name in ("num_vertices", "edges", "faces"):
        if not hasattr(mesh, name):
            raise TypeError(
                f"mesh is of type {type(mesh).__name__}, which has no attribute {name}: "
                "expected a CollisionMesh or an exact_ccd.Mesh"
            )
    return mesh


class Primitives(NamedTuple):
    """The primitives of a mesh, by their vertices; those that are loose by their indices."""

    vertices: Indices
    edges: Indices
    faces: Indices
    loose_vertices: Indices
    loose_edges: Indices


def primitives(mesh: SurfaceMesh) -> Primitives:
    """The primitives of a mesh: a loose vertex is in no edge, and a loose edge in no face."""
    edges = indices("edges", mesh.edges, (None, 2))
    faces = indices("faces", mesh.faces, (None, 3))
    for name, rows in (("edges", edges), ("faces", faces)):
        if rows.size and rows.max() >= mesh.num_vertices:
            row = int(np.argmax((rows >= mesh.num_vertices).any(axis=1)))
            raise ValueError(f"row {row} of {name} names a vertex that does not exist")
    is_used = np.zeros(mesh.num_vertices, bool)
    is_used[edges.ravel()] = True
    is_used[faces.ravel()] = True
    every = sides(faces)
    own, of_faces = _numbers(edges), _numbers(every)
    # A face with two equal corners has no edge between them.
    is_missing = (every[:, 0] != every[:, 1]) & ~np.isin(of_faces, own)
    if is_missing.any():
        row = int(np.argmax(is_missing)) // 3
        raise ValueError(f"row {row} of faces has an edge that is missing in edges: name the edges of faces there, too")
    is_loose = ~np.isin(own, of_faces)
    return Primitives(
        np.arange(mesh.num_vertices, dtype=np.uint32)[:, None],
        edges,
        faces,
        np.flatnonzero(~is_used).astype(np.uint32),
        np.flatnonzero(is_loose).astype(np.uint32),
    )


def sides(faces: NDArray[np.uint32]) -> NDArray[np.uint32]:
    """The edges of faces; an edge of two faces twice."""
    return faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)


def edges(faces: ArrayLike) -> NDArray[np.int32]:
    """Find the edges of faces.

    Parameters
    ----------
    faces : int array of shape (F, 3)
        The vertices of each face.

    Returns
    -------
    int32 array of shape (E, 2)
        The vertices of each edge, once, sorted.

    Examples
    --------
    >>> edges([[0, 1, 2], [1, 3, 2]]).tolist()
    [[0, 1], [0, 2], [1, 2], [1, 3], [2, 3]]
    """
    every = np.sort(sides(indices("faces", faces, (None, 3))), axis=1)
    return np.unique(every, axis=0).astype(np.int32)


def _numbers(edges: NDArray[np.uint32]) -> NDArray[np.uint64]:
    """Each edge as one number, in any direction."""
    low, high = np.sort(edges.astype(np.uint64), axis=1).T
    numbers: NDArray[np.uint64] = low << np.uint64(32) | high
    return numbers


def ends(mesh: SurfaceMesh, vertices_t0: ArrayLike, vertices_t1: ArrayLike) -> tuple[Floats, Floats, int]:
    """The positions at both ends, with z = 0 in two dimensions, and the dimension of the mesh."""
    if len(getattr(mesh, "planes", ())):
        raise ValueError("static planes are not supported: add triangles in their place")
    x0, x1 = coordinates("vertices_t0", vertices_t0), coordinates("vertices_t1", vertices_t1)
    columns: int = x0.shape[1]
    dim: int = getattr(mesh, "dim", columns)
    for name, x in (("vertices_t0", x0), ("vertices_t1", x1)):
        if len(x) != mesh.num_vertices:
            raise ValueError(f"{name} has {len(x)} rows, expected one for each of {mesh.num_vertices} vertices")
        if x.shape[1] != dim:
            raise ValueError(f"{name} has {x.shape[1]} columns, expected {dim}")
    return in_space(x0), in_space(x1), dim


def rule_of(mesh: SurfaceMesh) -> Optional[Callable[[int, int], object]]:
    """The rule for two vertices; None if all can collide."""
    rule: Optional[Callable[[int, int], object]] = getattr(mesh, "can_collide", None)
    if rule is not None and not callable(rule):
        raise TypeError(
            "can_collide of the mesh is not callable: give a matrix of groups to exact_ccd.Mesh, which these functions take"
        )
    return rule
