"""The part of the extension for Blender that runs without Blender."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType

import numpy as np

from exact_ccd import audit
from test_audits import frames
from test_meshes import FACES

WORDS = Path(__file__).parents[3] / "integrations" / "blender" / "exact_ccd_audit" / "words.py"


def load() -> ModuleType:
    spec = importlib.util.spec_from_file_location("words", WORDS)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_violations_name_the_objects() -> None:
    primitives, faces = load().primitives, np.array(FACES)
    objects = ["floor", "leaf"], faces, [3, 3]
    contact = audit(frames(3, 1, -3), faces).violation
    assert primitives(contact, *objects) == "leaf: vertex 0 and floor: face 0"
    crossing = audit(frames(-1), faces).violation
    assert primitives(crossing, *objects) == "leaf: edge 0 and floor: face 0"
