"""A violation in words, with the names of the objects."""

from __future__ import annotations

import numpy as np
from exact_ccd import Mesh, Violation

KINDS = {"v": "vertex", "e": "edge", "f": "face"}


def primitives(violation: Violation, names: list[str], faces: np.ndarray, counts: list[int]) -> str:
    """Both primitives of a contact or of an intersection, each by its object and its number there.

    `counts` are the numbers of vertices of the objects.
    """
    groups = np.repeat(np.arange(len(counts)), counts)
    mesh = Mesh(len(groups), faces, groups=groups, names=names)
    contact = violation.contact
    if contact is None:
        kinds, ids = "ef", violation.intersection
    else:
        kinds, ids = contact.kind, (contact.first, contact.second)
    first, second = (mesh.place(KINDS[kind], index) for kind, index in zip(kinds, ids))
    return f"{first} and {second}"
