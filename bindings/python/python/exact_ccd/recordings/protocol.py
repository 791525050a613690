"""Recordings of the caller, and the frames that an audit makes of them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any, Optional, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._arrays import as_array
from ..frames import Rules
from ..meshes import Mesh
from ..welding import PerVertex, Weld, style_of, welded


class Frames(Protocol):
    """A recording: frames of one mesh, which are read when they are needed.

    Any object with these attributes is one; it need not be derived from this class. To be sent to tasks of
    Ray, it has to be possible to pickle it.

    Examples
    --------
    >>> class Falling:
    ...     faces = [[0, 1, 2]]
    ...     times = None
    ...
    ...     def __len__(self):
    ...         return 3
    ...
    ...     def positions(self, index):
    ...         return [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.25, 0.25, 2 - 1.5 * index]]
    >>> from exact_ccd import audit
    >>> audit(Falling()).violation.frame
    1
    """

    @property
    def faces(self) -> ArrayLike:
        """The faces, integers of shape (F, 3), the same ones in all frames."""
        ...

    @property
    def times(self) -> Optional[ArrayLike]:
        """The time of each frame, or None. No answer depends on it."""
        ...

    def __len__(self) -> int:
        """The number of frames."""
        ...

    def positions(self, index: int) -> ArrayLike:
        """Read the positions of a frame.

        Parameters
        ----------
        index : int
            The number of the frame, from 0.

        Returns
        -------
        array of shape (V, 3)
            The positions.
        """
        ...


def is_recording(value: object) -> bool:
    """Whether a value has the attributes of :class:`Frames`."""
    return callable(getattr(value, "positions", None)) and hasattr(value, "faces") and hasattr(value, "__len__")


@dataclass(frozen=True)
class RecordedFrames:
    """The frames of a recording from `first` to before `end`, with vertices welded that coincide in all of them."""

    recording: Frames
    first: int
    end: int
    vertex_count: int
    faces: ArrayLike
    edges: Optional[ArrayLike]
    kept: Optional[NDArray[np.int64]] = None
    """The vertices that remain, if some are welded."""

    @staticmethod
    def of(recording: Frames, weld: Weld = None, apart: PerVertex = ()) -> RecordedFrames:
        """All frames of a recording, which may have loose `edges`, too."""
        if len(recording) == 0:
            raise ValueError("there are no frames")
        count = len(as_array("frame 0", recording.positions(0)))
        frames = RecordedFrames(
            recording, 0, len(recording), count, recording.faces, getattr(recording, "edges", None)
        )
        style = style_of(weld, False)
        if style is None:
            return frames
        mesh = Mesh(count, frames.faces, frames.edges)
        faces, edges, kept = welded(mesh._native, frames, style, apart)
        return replace(frames, faces=faces, edges=edges, kept=kept)

    def __len__(self) -> int:
        return self.end - self.first

    def __iter__(self) -> Iterator[NDArray[Any]]:
        for index in range(self.first, self.end):
            positions = as_array(f"frame {index}", self.recording.positions(index))
            yield positions if self.kept is None else positions[self.kept]

    def mesh(self, rules: Rules) -> Mesh:
        """The mesh of all frames, with the pairs that can collide."""
        count = self.vertex_count if self.kept is None else len(self.kept)
        return Mesh(count, self.faces, self.edges, *rules.of(self.kept))

    def part(self, first: int, last: int) -> RecordedFrames:
        """The frames from `first` to `last`, both included."""
        return replace(self, first=self.first + first, end=min(self.first + last + 1, self.end))

    def names(self) -> Iterator[str]:
        """The names of the frames, for titles: their numbers, and their times, if there are some."""
        times = self.recording.times
        for index in range(self.first, self.end):
            yield f"frame {index}" if times is None else f"frame {index}, time {np.asarray(times)[index]}"

    def identity(self) -> list[Any]:
        """All that distinguishes the recording from others."""
        own = getattr(self.recording, "identity", None)
        if own is None:
            raise ValueError(
                "results are kept for files and arrays: give the recording a method `identity`, whose value is another "
                "one for other frames"
            )
        return list(own())
