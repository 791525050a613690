"""The visible meshes of a scene as arrays, frame by frame."""

from __future__ import annotations

from collections.abc import Iterator

import bpy
import numpy as np


def bodies(scene: bpy.types.Scene) -> list[bpy.types.Object]:
    """The visible meshes."""
    return [item for item in scene.objects if item.type == "MESH" and item.visible_get()]


def evaluated(objects: list[bpy.types.Object]) -> tuple[np.ndarray, np.ndarray, list[int]]:
    """The vertices in the world after all modifiers, the triangles, and the number of vertices of each object."""
    graph = bpy.context.evaluated_depsgraph_get()
    vertices, faces, counts = [np.empty((0, 3))], [np.empty((0, 3), np.int64)], []
    for item in objects:
        body = item.evaluated_get(graph)
        mesh = body.to_mesh()
        mesh.calc_loop_triangles()
        points = np.empty(3 * len(mesh.vertices), np.float32)
        mesh.vertices.foreach_get("co", points)
        corners = np.empty(3 * len(mesh.loop_triangles), np.int32)
        mesh.loop_triangles.foreach_get("vertices", corners)
        body.to_mesh_clear()
        world = np.array(body.matrix_world, np.float64)
        vertices.append(points.reshape(-1, 3) @ world[:3, :3].T + world[:3, 3])
        faces.append(corners.reshape(-1, 3) + sum(counts))
        counts.append(len(points) // 3)
    return np.vstack(vertices), np.vstack(faces), counts


def frames(scene: bpy.types.Scene, objects: list[bpy.types.Object]) -> Iterator[np.ndarray]:
    """The vertices at each frame of the scene."""
    for frame in range(scene.frame_start, scene.frame_end + 1):
        scene.frame_set(frame)
        yield evaluated(objects)[0]


def select(objects: list[bpy.types.Object], vertices: list[int]) -> None:
    """Selects these vertices, counted over all objects, and nothing else."""
    first = 0
    for item in objects:
        data, count = item.data, len(item.data.vertices)
        chosen = [first <= vertex < first + count for vertex in vertices]
        marks = np.zeros(count, bool)
        marks[[vertex - first for vertex, is_here in zip(vertices, chosen) if is_here]] = True
        data.polygons.foreach_set("select", np.zeros(len(data.polygons), bool))
        data.edges.foreach_set("select", np.zeros(len(data.edges), bool))
        data.vertices.foreach_set("select", marks)
        item.select_set(any(chosen))
        first += count
