"""The operator in Blender: `python integrations/blender/test.py`, with `pip install bpy` and exact-ccd.

A sphere of radius 1 falls from the height 3, with a key at each frame, so that its speed is constant.
"""

import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))
import exact_ccd_audit


def make(end: float) -> bpy.types.Object:
    """A sphere over a plane, which moves to a height in ten frames."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    exact_ccd_audit.register()
    bpy.ops.mesh.primitive_plane_add(size=6.0)
    bpy.ops.mesh.primitive_uv_sphere_add(segments=16, ring_count=8, location=(0.3, 0.2, 3.0))
    sphere = bpy.context.object
    for frame in range(1, 11):
        sphere.location.z = 3.0 + (end - 3.0) * (frame - 1) / 9
        sphere.keyframe_insert("location", frame=frame)
    bpy.context.scene.frame_start, bpy.context.scene.frame_end = 1, 10
    bpy.context.scene.frame_set(7)
    return sphere


def selected(item: bpy.types.Object) -> list[float]:
    """The heights of the selected vertices of an object, in its own coordinates."""
    return [vertex.co.z for vertex in item.data.vertices if vertex.select]


# Contact at the height 1: after 2 of 6 units, at frame 1 + 9 / 3, where Blender rounds to f32.
sphere = make(-3.0)
assert bpy.ops.scene.exact_ccd_audit() == {"FINISHED"}
scene = bpy.context.scene
frame = scene.frame_current + scene.frame_subframe
assert abs(frame - 4.0) < 1e-4, frame
# The lowest vertex of the sphere is the one that touches.
assert selected(sphere) == [min(vertex.co.z for vertex in sphere.data.vertices)], selected(sphere)
exact_ccd_audit.unregister()

# The distance is less than any distance among the sphere's own triangles. The contact is 0.02 earlier on a
# path of 6, which takes 9 frames.
make(-3.0)
assert bpy.ops.scene.exact_ccd_audit(min_distance=0.02) == {"FINISHED"}
scene = bpy.context.scene
frame = scene.frame_current + scene.frame_subframe
assert abs(frame - 3.97) < 1e-4, frame
exact_ccd_audit.unregister()

# A sphere that stops above the plane is free, and the scene stays at its frame.
make(1.5)
assert bpy.ops.scene.exact_ccd_audit() == {"FINISHED"}
assert bpy.context.scene.frame_current == 7
exact_ccd_audit.unregister()
print("the operator finds the contact, and no other")
