"""Meshes and scenes of trimesh."""

from __future__ import annotations

from typing import Any, NamedTuple, Optional

import numpy as np
from numpy.typing import NDArray

from ._arrays import floats, indices
from ._records import by_value
from .groups import CanCollide
from .meshes import Mesh


@by_value
class PlacedMesh(NamedTuple):
    """The mesh of a scene, see :func:`from_trimesh`.

    Attributes
    ----------
    mesh : Mesh
        All bodies, one group for each, with their names in the scene.
    positions : float64 array of shape (V, 3)
        The vertices of the bodies in their places.
    """

    mesh: Mesh
    positions: NDArray[np.float64]


def from_trimesh(scene: Any, *, can_collide: Optional[CanCollide] = None) -> PlacedMesh:
    """Take a ``trimesh.Scene`` or a ``trimesh.Trimesh`` as one mesh with its positions.

    The bodies of a scene are the nodes of its graph that have a geometry, in their order; each has the transform of
    its node, and an instance of a geometry is a body of its own. For the end of a step, move the nodes and call the
    function again: the mesh is the same.

    Parameters
    ----------
    scene : trimesh.Scene or trimesh.Trimesh
        The scene, or a single mesh, which has no groups.
    can_collide : bool array of shape (G, G) or callable, optional
        The pairs of bodies that can collide, see :class:`Mesh`. By default a body does not touch itself, and
        all others can collide.

    Returns
    -------
    PlacedMesh
        The mesh, and its positions.

    Raises
    ------
    TypeError
        If an object is neither, or a geometry has no faces, such as a path: the message names the node.

    Examples
    --------
    >>> import trimesh  # doctest: +SKIP
    >>> scene = trimesh.Scene()  # doctest: +SKIP
    >>> node = scene.add_geometry(trimesh.creation.box(), node_name="box")  # doctest: +SKIP
    >>> mesh, x0 = from_trimesh(scene)  # doctest: +SKIP
    >>> mesh.names  # doctest: +SKIP
    ('box',)
    """
    if not hasattr(scene, "graph"):
        if not _is_shape(scene):
            raise TypeError(f"expected a trimesh.Scene or a trimesh.Trimesh, not an object of type {type(scene).__name__}")
        positions = floats("vertices", scene.vertices, (None, 3))
        return PlacedMesh(Mesh(len(positions), scene.faces, can_collide=can_collide), positions)
    names = [str(name) for name in scene.graph.nodes_geometry]
    places, faces, counts = [np.empty((0, 3))], [np.empty((0, 3), np.int64)], [0]
    for name in scene.graph.nodes_geometry:
        matrix, key = scene.graph[name]
        body = scene.geometry[key]
        if not _is_shape(body):
            kind = type(body).__name__
            raise TypeError(f"the node {name!r} has a geometry of type {kind}, which has no faces: remove it")
        transform = floats(f"the transform of {name!r}", matrix, (4, 4))
        vertices = floats(f"the vertices of {name!r}", body.vertices, (None, 3))
        faces.append(indices(f"the faces of {name!r}", body.faces, (None, 3)).astype(np.int64) + sum(counts))
        places.append(vertices @ transform[:3, :3].T + transform[:3, 3])
        counts.append(len(vertices))
    groups = np.repeat(np.arange(len(names)), counts[1:])
    mesh = Mesh(sum(counts), np.vstack(faces), groups=groups, can_collide=can_collide, names=names)
    return PlacedMesh(mesh, np.vstack(places))


def _is_shape(value: object) -> bool:
    return hasattr(value, "vertices") and hasattr(value, "faces")
