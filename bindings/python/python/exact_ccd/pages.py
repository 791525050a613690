"""Pages that show motions and their contacts in a browser."""

from __future__ import annotations

from collections.abc import Iterable
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Optional, Union

from numpy.typing import ArrayLike

from . import _native
from ._arrays import Floats, floats
from .contacts import Contact, primitives

if TYPE_CHECKING:
    from .meshes import Mesh


class Page:
    """A page under construction: frames in the order of time, and what touches in them."""

    def __init__(self, title: str, mesh: Mesh) -> None:
        self._title = title
        self._mesh = mesh
        self._native: Optional[_native.Page] = None
        self._last: list[Floats] = []

    def add_frame(self, label: str, positions: ArrayLike) -> None:
        """Add the next frame."""
        frame = floats("positions", positions, (self._mesh.vertex_count, 3))
        if self._native is None:
            self._native = _native.Page(self._title, self._mesh._native, frame)
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


def line(contact: Contact) -> str:
    """A contact in words."""
    ids = zip(primitives(contact.kind), (contact.first, contact.second), contact.places)
    first, second = (f"{kind} {index}" if place is None else str(place) for kind, index, place in ids)
    return f"contact at t = {contact.time}: {first} and {second}"
