"""The audit of an animation in Blender: all visible meshes, from frame to frame.

``blender --background scene.blend --python blender_audit.py`` in a Blender whose Python has exact-ccd, or
``python blender_audit.py scene.blend`` with ``pip install bpy``. Without a file, a scene is made up.

The first violation is printed, and its vertices are selected at its frame.
"""

import sys
from collections.abc import Iterator

import bpy
import numpy as np

from exact_ccd import audit


def make_up() -> None:
    """A sphere that falls through a plane in ten frames."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.mesh.primitive_plane_add(size=6.0)
    bpy.ops.mesh.primitive_uv_sphere_add(segments=16, ring_count=8, location=(0.3, 0.2, 3.0))
    sphere = bpy.context.object
    for frame, height in ((1, 3.0), (10, -3.0)):
        sphere.location.z = height
        sphere.keyframe_insert("location", frame=frame)
    bpy.context.scene.frame_start, bpy.context.scene.frame_end = 1, 10


def evaluated(objects: list) -> tuple[np.ndarray, np.ndarray]:
    """The vertices in the world after all modifiers, and the triangles."""
    graph = bpy.context.evaluated_depsgraph_get()
    vertices, faces, count = [], [], 0
    for item in objects:
        body = item.evaluated_get(graph)
        mesh = body.to_mesh()
        mesh.calc_loop_triangles()
        points = np.empty(3 * len(mesh.vertices), np.float32)
        mesh.vertices.foreach_get("co", points)
        corners = np.empty(3 * len(mesh.loop_triangles), np.int32)
        mesh.loop_triangles.foreach_get("vertices", corners)
        world = np.array(body.matrix_world)
        vertices.append(points.reshape(-1, 3) @ world[:3, :3].T + world[:3, 3])
        faces.append(corners.reshape(-1, 3) + count)
        count += len(mesh.vertices)
        body.to_mesh_clear()
    return np.vstack(vertices), np.vstack(faces)


def frames(objects: list) -> Iterator[np.ndarray]:
    """The vertices at each frame of the animation."""
    scene = bpy.context.scene
    for frame in range(scene.frame_start, scene.frame_end + 1):
        scene.frame_set(frame)
        yield evaluated(objects)[0]


def select(objects: list, vertices: list[int]) -> None:
    """Select these vertices among those of all objects."""
    for item in objects:
        count = len(item.data.vertices)
        chosen = [vertex for vertex in vertices if 0 <= vertex < count]
        item.data.polygons.foreach_set("select", [False] * len(item.data.polygons))
        item.data.edges.foreach_set("select", [False] * len(item.data.edges))
        item.data.vertices.foreach_set("select", [vertex in chosen for vertex in range(count)])
        vertices = [vertex - count for vertex in vertices]


def main(file: str) -> None:
    if file:
        bpy.ops.wm.open_mainfile(filepath=file)
    elif not bpy.data.filepath:
        make_up()
    scene = bpy.context.scene
    scene.frame_set(scene.frame_start)
    objects = [item for item in scene.objects if item.type == "MESH" and item.visible_get()]
    report = audit(frames(objects), evaluated(objects)[1])
    if report.violation is None:
        print(f"free of contact: {report.frames} frames")
        return
    first = scene.frame_start + report.violation.frame
    contact = report.violation.contact
    if contact is None:
        print(f"the meshes intersect at frame {first}")
        return
    print(f"contact at frame {first + contact.time}: {contact.kind}, at {contact.points[0]}")
    scene.frame_set(first, subframe=min(contact.time, 0.999))
    # Modifiers that add vertices change the numbers: then nothing is selected.
    if sum(len(item.data.vertices) for item in objects) == len(evaluated(objects)[0]):
        select(objects, contact.vertices.tolist())


if __name__ == "__main__":
    # Blender passes on what follows "--".
    given = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else sys.argv[1:]
    main(next((argument for argument in given if argument.endswith(".blend")), ""))
