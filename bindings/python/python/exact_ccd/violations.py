"""The first place in a sequence of frames where a mesh touches itself."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, NamedTuple, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import as_array
from ._native import UncertifiedError
from ._records import by_value
from .contacts import Contact
from .detectors import Detector, Progress
from .groups import Place
from .half_spaces import HalfSpaces
from .turns import Turns


class Violation(NamedTuple):
    """A place where a mesh touches itself, see :func:`exact_ccd.audit`.

    Attributes
    ----------
    frame : int
        The frame at which the step begins, from 0.
    contact : Contact or None
        The earliest contact after that frame; its time is 0 at that frame and 1 at the next.
    intersection : tuple of int, or None
        In place of a contact: the indices of an edge and of a face that it passes through in the frame. A pair that
        only touches is a contact.
    half_space : tuple of int, or None
        In place of both: the number of a half space and the index of a vertex that is not apart from it in
        that frame. It reaches the half space in the step that leads there, if there is one.
    places : tuple of Place or None
        The bodies of the primitives: of both of the contact, or of the edge and the face, or of the vertex. None for
        a primitive without the name of a group.
    """

    frame: int
    contact: Optional[Contact]
    intersection: Optional[tuple[int, int]]
    half_space: Optional[tuple[int, int]] = None
    places: tuple[Optional[Place], ...] = ()


@by_value
class AuditReport(NamedTuple):
    """The result of :func:`exact_ccd.audit`.

    Attributes
    ----------
    frames : int
        The number of frames examined, up to the first violation.
    violation : Violation or None
        The first violation; None if all frames are free of contact, and the motion between them.
    vertices : int64 array of shape (V,), or None
        If vertices are welded, the numbers of the remaining vertices among the vertices of the frames.
    """

    frames: int
    violation: Optional[Violation]
    vertices: Optional[NDArray[np.int64]] = None

    @property
    def is_free(self) -> bool:
        """True if there is no violation."""
        return self.violation is None


def examine(
    detector: Detector,
    frames: Iterable[Any],
    first: int = 0,
    progress: Optional[Progress] = None,
    half_spaces: Optional[HalfSpaces] = None,
    examined: Optional[Callable[[Any], None]] = None,
    parts: Optional[list[bytes]] = None,
    turns: Optional[Turns] = None,
) -> tuple[int, Optional[Violation]]:
    """The number of the last frame examined, plus 1, and the first violation in frames from `first` on.

    Frame 0 is examined at rest; with groups or a rule, every frame. `examined` is called with each frame that is
    examined, and each step is added to `turns`. The certificates of steps are added to `parts`: the parts of all frames from 0 on, put together, are
    one certificate.
    """
    last: Optional[NDArray[np.float64]] = None
    done = first
    for number, frame in enumerate(frames, first):
        try:
            violation = _examine(detector, half_spaces, last, frame, number)
            if parts is not None and last is not None:
                parts.append(detector._certificate(last, frame, number == 1, number > 1))
        except ValueError as error:
            raise ValueError(f"frame {number}: {error}") from error
        except UncertifiedError as error:
            error.args = (f"frame {number}: {error}",)
            raise
        if turns is not None and last is not None:
            turns.add(last, frame, f"from frame {number - 1} to frame {number}")
        done = number + 1
        if examined is not None:
            examined(frame)
        if progress is not None:
            progress(1)
        if violation is not None:
            return done, violation
        # A copy: the iterator may reuse its array.
        last = np.array(as_array("frame", frame), np.float64)
    return done, None


def _examine(
    detector: Detector,
    half_spaces: Optional[HalfSpaces],
    last: Optional[ArrayLike],
    frame: ArrayLike,
    number: int,
) -> Optional[Violation]:
    """The violation in frame 0, or in the step that leads to another frame and in that frame."""
    if last is None and number > 0:
        return None
    if last is not None:
        contact = detector._earliest(last, frame)
        if contact is not None:
            return Violation(number - 1, contact, None, None, contact.places)
    # A rule or groups can leave out the contact by which an edge comes to pass through a face.
    mesh = detector.mesh
    if last is None or mesh.can_collide is not None or mesh.groups is not None:
        found = detector._crossings(frame)
        if len(found):
            edge, face = found[0].tolist()
            places = mesh.place("edge", edge), mesh.place("face", face)
            return Violation(number, None, (edge, face), None, places)
    if last is None:
        contact = detector._earliest(frame, frame)
        if contact is not None:
            return Violation(0, contact, None, None, contact.places)
    touching = None if half_spaces is None else half_spaces.touching(frame)
    return None if touching is None else Violation(number, None, None, touching, (mesh.place("vertex", touching[1]),))
