"""Contacts between the bodies of a trimesh scene in motion: a box falls onto a sphere.

``pip install trimesh``
"""

import numpy as np
import trimesh

from exact_ccd import Detector, Mesh

scene = trimesh.Scene()
scene.add_geometry(trimesh.creation.icosphere(subdivisions=3), geom_name="sphere")
scene.add_geometry(trimesh.creation.box(extents=(1, 1, 1)), geom_name="box")
names = list(scene.graph.nodes_geometry)


def positions(height: float) -> np.ndarray:
    """All vertices, with the box at a height."""
    scene.graph.update(frame_to="box", matrix=trimesh.transformations.translation_matrix((0.2, 0.1, height)))
    vertices = []
    for name in names:
        transform, geometry = scene.graph[name]
        vertices.append(trimesh.transform_points(scene.geometry[geometry].vertices, transform))
    return np.vstack(vertices)


# One mesh of all bodies. A group for each: rigid bodies do not touch themselves.
geometries = [scene.geometry[scene.graph[name][1]] for name in names]
counts = [len(geometry.vertices) for geometry in geometries]
starts = np.concatenate([[0], np.cumsum(counts)[:-1]])
faces = np.vstack([geometry.faces + start for geometry, start in zip(geometries, starts)])
mesh = Mesh(sum(counts), faces, groups=np.repeat(np.arange(len(names)), counts))

detector = Detector(mesh)
x0, x1 = positions(3.0), positions(1.0)
step = detector.free_step(x0, x1, keep=0.9)
assert step.contact is not None and not detector.collides(x0, step.positions)
bodies = np.searchsorted(starts, step.contact.vertices, side="right") - 1
print(f"{names[bodies[0]]} meets {names[bodies[3]]} at t = {step.contact.time}, at {step.contact.points[0]}")
print(f"free step: {step.size}")
