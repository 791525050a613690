"""Contacts between the bodies of a trimesh scene in motion: a box falls onto a sphere.

``pip install trimesh``
"""

import numpy as np
import trimesh

from exact_ccd import Detector, from_trimesh

scene = trimesh.Scene()
scene.add_geometry(trimesh.creation.icosphere(subdivisions=3), geom_name="sphere")
scene.add_geometry(trimesh.creation.box(extents=(1, 1, 1)), geom_name="box")


def positions(height: float) -> np.ndarray:
    """All vertices, with the box at a height."""
    scene.graph.update(frame_to="box", matrix=trimesh.transformations.translation_matrix((0.2, 0.1, height)))
    return from_trimesh(scene).positions


# One mesh of all bodies, with a named group for each: rigid bodies do not touch themselves.
detector = Detector(from_trimesh(scene).mesh)
x0, x1 = positions(3.0), positions(1.0)
step = detector.free_step(x0, x1, keep=0.9)
assert step.contact is not None and not detector.collides(x0, step.positions)
first, second = step.contact.places
print(f"{first} meets {second} at t = {step.contact.time}, at {step.contact.points[0]}")
print(f"free step: {step.size}")
