"""Pages that show motions and their contacts in a browser."""

from __future__ import annotations

from collections.abc import Iterable
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._arrays import Floats, floats
from .contacts import Contact, primitives
from .groups import numbers_in

if TYPE_CHECKING:
    from .meshes import Mesh


Range = tuple[str, int, int]
"""The name of a body, its first vertex, and the vertex after its last one."""

Ids = tuple[NDArray[np.int64], NDArray[np.int64]]
"""The index of each vertex and of each face in its body; -1 for a face of several bodies."""


class Page:
    """A page under construction: frames in the order of time, and what touches in them.

    The named groups of the mesh are its bodies, each with a row in the list by which it can be hidden, if the vertices of
    each are consecutive.
    """

    def __init__(self, title: str, mesh: Mesh) -> None:
        self._title = title
        self._mesh = mesh
        self._native: Optional[_native.Page] = None
        self._last: list[Floats] = []

    def add_frame(self, label: str, positions: ArrayLike) -> None:
        """Add the next frame."""
        frame = floats("positions", positions, (self._mesh.vertex_count, 3))
        if self._native is None:
            self._native = _native.Page(self._title, self._mesh._native, frame, *bodies(self._mesh))
        self._native.add_frame(label, frame)
        # A copy: the caller may reuse the array.
        self._last = [*self._last[-1:], frame.copy()]

    def add_intersections(self, detector: _native.Detector) -> None:
        """Add the edges and faces that meet in the last frame."""
        if self._native is not None:
            detector.show_intersections(self._native, self._last[-1][None])

    def add_contacts(self, detector: _native.Detector, every: bool) -> None:
        """Add the contacts between the last two frames: every one, or the earliest."""
        if self._native is not None:
            detector.show_contacts(self._native, self._last[0][None], self._last[-1][None], every)

    def write(self, file: Union[str, PathLike[str]], summary: Iterable[str]) -> None:
        """Write the page, with lines about the answer; it has no frames then."""
        if self._native is not None:
            Path(file).write_bytes(self._native.html([*summary]))


def bodies(mesh: Mesh) -> tuple[list[Range], Optional[Ids]]:
    """The bodies of a mesh, and the ids in them; none if groups have no names, or a group is not consecutive."""
    groups, names = mesh.groups, mesh.names
    if groups is None or names is None or not groups.size:
        return [], None
    starts = np.flatnonzero(np.diff(groups.astype(np.int64), prepend=-1))
    found = groups[starts].tolist()
    if len(set(found)) < len(found):
        return [], None
    ends = [*starts[1:].tolist(), len(groups)]
    ranges = [(names[group], start, end) for group, start, end in zip(found, starts.tolist(), ends)]
    vertices = np.arange(mesh.vertex_count, dtype=np.uint32)[:, None]
    return ranges, (numbers_in(groups, vertices), numbers_in(groups, mesh.faces))


def line(contact: Contact) -> str:
    """A contact in words."""
    ids = zip(primitives(contact.kind), (contact.first, contact.second), contact.places)
    first, second = (f"{kind} {index}" if place is None else str(place) for kind, index, place in ids)
    return f"contact at t = {contact.time}: {first} and {second}"
