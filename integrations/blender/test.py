"""The operator in Blender: `python integrations/blender/test.py`, with `pip install bpy` and exact-ccd.

A sphere falls through a plane. Its lowest vertex is at height 3 − 6 (f − 1) / 9 − 1 at frame f, if it falls at constant speed.
"""

import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))
import exact_ccd_audit


def make(end: float) -> bpy.types.Object:
    """A sphere over a plane, which moves to a height in ten frames, at constant speed."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    exact_ccd_audit.register()
    bpy.ops.mesh.primitive_plane_add(size=6.0)
    bpy.ops.mesh.primitive_uv_sphere_add(segments=16, ring_count=8, location=(0.3, 0.2, 3.0))
    sphere = bpy.context.object
    bpy.context.preferences.edit.keyframe_new_interpolation_type = "LINEAR"
    for frame, height in ((1, 3.0), (10, end)):
        sphere.location.z = height
        sphere.keyframe_insert("location", frame=frame)
    bpy.context.scene.frame_start, bpy.context.scene.frame_end = 1, 10
    bpy.context.scene.frame_set(7)
    return sphere


def selected(item: bpy.types.Object) -> list[float]:
    """The heights of the selected vertices of an object, in its own coordinates."""
    return [vertex.co.z for vertex in item.data.vertices if vertex.select]


# Contact at z = 1: after 2 of 6 units, at frame 1 + 9 / 3.
sphere = make(-3.0)
assert bpy.ops.scene.exact_ccd_audit() == {"FINISHED"}
scene = bpy.context.scene
frame = scene.frame_current + scene.frame_subframe
assert abs(frame - 4.0) < 1e-5, frame
# The lowest vertex of the sphere is the one that touches.
assert selected(sphere) == [min(vertex.co.z for vertex in sphere.data.vertices)], selected(sphere)
exact_ccd_audit.unregister()

# Within half a unit: half a unit earlier.
make(-3.0)
assert bpy.ops.scene.exact_ccd_audit(min_distance=0.5) == {"FINISHED"}
scene = bpy.context.scene
frame = scene.frame_current + scene.frame_subframe
assert abs(frame - 3.25) < 1e-5, frame
exact_ccd_audit.unregister()

# A sphere that stops above the plane is free, and the scene stays at its frame.
make(1.5)
assert bpy.ops.scene.exact_ccd_audit() == {"FINISHED"}
assert bpy.context.scene.frame_current == 7
exact_ccd_audit.unregister()
print("the operator finds the contact, and no other")
