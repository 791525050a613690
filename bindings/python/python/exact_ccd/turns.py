"""Warnings about bodies that turn in a step, while their vertices move in straight lines."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _native
from ._arrays import Floats, floats
from .meshes import Mesh


class Turns:
    """The worst turn of each connected part of a mesh in a sequence of steps."""

    def __init__(self, mesh: Mesh) -> None:
        self._mesh = mesh
        # By the first vertex of the part: the shrinkage, and the words of the warning.
        self._worst: dict[int, tuple[float, str]] = {}

    def add(self, x0: ArrayLike, x1: ArrayLike, step: str) -> None:
        """Add a step, with its name in the warning."""
        shape = (self._mesh.vertex_count, 3)
        start, end = (_whole(name, x, shape) for name, x in (("x0", x0), ("x1", x1)))
        for vertex, angle, shrinkage, steps in _native.turns(self._mesh._native, start, end):
            if shrinkage > self._worst.get(vertex, (0.0, ""))[0]:
                place = self._mesh.place("vertex", vertex)
                body = f"the part with vertex {vertex}" if place is None else place.body
                words = (
                    f"{body} turns by {angle:.1f}° {step} as a rigid body, but vertices move in straight lines: "
                    f"halfway, they are up to {100 * shrinkage:.1f} % of its size too near to the axis, and the answer "
                    f"is about this smaller body; {steps:.0f} steps in place of this one keep that below 0.1 %, and "
                    "Bodies turn exactly"
                )
                self._worst[vertex] = shrinkage, words

    def warn(self, stacklevel: int) -> None:
        """Warn of each part that turns, in its worst step."""
        for _, words in self._worst.values():
            warnings.warn(words, stacklevel=stacklevel + 1)


def _whole(name: str, x: Any, shape: tuple[int, int]) -> Floats:
    return np.ascontiguousarray(floats(name, x, shape))
