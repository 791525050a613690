"""The extension: one operator, and its button among the properties of physics."""

from __future__ import annotations

import math

import bpy
import numpy as np
from bpy.props import FloatProperty
from exact_ccd import Violation, audit

from . import scene as scenes
from .words import primitives


class ExactCcdAudit(bpy.types.Operator):
    """Find the first contact of the visible meshes between two frames of the scene, exactly"""

    bl_idname = "scene.exact_ccd_audit"
    bl_label = "Audit Collisions"
    bl_options = {"REGISTER", "UNDO"}

    min_distance: FloatProperty(
        name="Distance",
        description="Primitives at most this far apart count as touching, also within one mesh",
        min=0.0,
        default=0.0,
        subtype="DISTANCE",
        unit="LENGTH",
    )

    def execute(self, context: bpy.types.Context) -> set[str]:
        """Audits the scene, goes to the first violation, and selects its vertices."""
        scene, objects = context.scene, scenes.bodies(context.scene)
        before = scene.frame_current
        scene.frame_set(scene.frame_start)
        _, faces, counts = scenes.evaluated(objects)
        try:
            report = audit(scenes.frames(scene, objects), faces, min_distance=self.min_distance)
        except ValueError as error:
            # Such as a modifier that changes the number of vertices.
            scene.frame_set(before)
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if report.violation is None:
            scene.frame_set(before)
            self.report({"INFO"}, f"free of contact: {report.frames} frames")
            return {"FINISHED"}
        names = [item.name for item in objects]
        self.show(scene, objects, faces, report.violation, primitives(report.violation, names, faces, counts))
        return {"FINISHED"}

    def show(
        self,
        scene: bpy.types.Scene,
        objects: list[bpy.types.Object],
        faces: np.ndarray,
        violation: Violation,
        words: str,
    ) -> None:
        """Goes to the frame of a violation, reports it in words, and selects its vertices."""
        frame = scene.frame_start + violation.frame
        contact = violation.contact
        if contact is None:
            scene.frame_set(frame)
            self.report({"WARNING"}, f"intersection at frame {frame}: {words}")
            _, face = violation.intersection
            vertices = faces[face].tolist()
        else:
            part, whole = math.modf(frame + contact.time)
            scene.frame_set(int(whole), subframe=part)
            self.report({"WARNING"}, f"contact at frame {whole + part:.6g}: {words}")
            vertices = contact.vertices.tolist()
        # Modifiers that add vertices change the numbers: then nothing is selected.
        if scenes.evaluated(objects)[2] == [len(item.data.vertices) for item in objects]:
            scenes.select(objects, vertices)


class ExactCcdPanel(bpy.types.Panel):
    """The button"""

    bl_idname = "SCENE_PT_exact_ccd_audit"
    bl_label = "Exact Collision Audit"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "scene"

    def draw(self, context: bpy.types.Context) -> None:
        """Draws the button."""
        self.layout.operator(ExactCcdAudit.bl_idname)


CLASSES = (ExactCcdAudit, ExactCcdPanel)


def register() -> None:
    """Adds the operator and the button."""
    for one in CLASSES:
        bpy.utils.register_class(one)


def unregister() -> None:
    """Removes them."""
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
