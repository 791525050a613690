"""The certificate of a sequence of frames."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from itertools import chain
from os import PathLike
from pathlib import Path
from typing import Any, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .contacts import Contact
from .meshes import Detector, Mesh, Progress, read_mesh

_Path = Union[str, PathLike[str]]
_FORMATS = {".ply", ".obj", ".stl", ".off", ".msh", ".vtu"}


class Violation(NamedTuple):
    """A place where a mesh touches itself, see :func:`audit`.

    Attributes
    ----------
    frame : int
        The frame at which the step begins, from 0.
    contact : Contact or None
        The earliest contact after that frame; its time is 0 at that frame and 1 at the next.
    intersection : tuple of int, or None
        In place of a contact: the indices of an edge and a face that meet in the first frame.
    """

    frame: int
    contact: Optional[Contact]
    intersection: Optional[tuple[int, int]]


class AuditReport(NamedTuple):
    """The result of :func:`audit`.

    Attributes
    ----------
    frames : int
        The number of frames examined, up to the first violation.
    violation : Violation or None
        The first violation; None if all frames are free of contact, and the motion between them.
    """

    frames: int
    violation: Optional[Violation]

    @property
    def is_free(self) -> bool:
        """True if there is no violation."""
        return self.violation is None


def audit(
    frames: Union[ArrayLike, Iterable[Any], _Path],
    faces: Optional[ArrayLike] = None,
    *,
    edges: Optional[ArrayLike] = None,
    min_distance: Union[float, ArrayLike] = 0.0,
    progress: Optional[Progress] = None,
    threads: Optional[int] = None,
) -> AuditReport:
    """Certify a recorded motion: the mesh never touches itself.

    The first frame is examined at rest: no edge may meet a face, no vertex a face, and no edge another
    edge. From each frame to the next, every vertex moves in a straight line, and no contact may occur. If
    there is none, no frame passes through itself, nor does the mesh at any time between. Primitives that
    share a vertex may touch.

    Parameters
    ----------
    frames : array of shape (T, V, 3), iterable of arrays (V, 3), file, folder, or iterable of files
        The positions in the order of time; or mesh files, or a folder of mesh files, which are taken in
        the order of the numbers in their names. Frames are read one at a time.
    faces : int array of shape (F, 3)
        The faces, if the frames are positions.
    edges : int array of shape (E, 2), optional
        Loose edges, if the frames are positions.
    min_distance : float or array of shape (V,)
        Primitives that come within this distance of each other count as touching, see :class:`Detector`.
    progress : callable, optional
        Called with the number of frames examined since its last call, as ``tqdm.update``.
    threads : int, optional
        The number of threads; by default that of the cores. The result does not depend on it.

    Raises
    ------
    ValueError
        If a frame has other vertices or faces than the first, or a coordinate that is not finite; the
        message names the frame.

    Examples
    --------
    A vertex moves through a triangle in the second step.

    >>> frames = np.zeros((3, 4, 3))
    >>> frames[:, :3] = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    >>> frames[:, 3] = [[0.25, 0.25, 2], [0.25, 0.25, 1], [0.25, 0.25, -3]]
    >>> report = audit(frames, [[0, 1, 2]])
    >>> report.violation.frame, report.violation.contact.time
    (1, 0.25)
    """
    detector, positions = _begin(frames, faces, edges, min_distance, threads)
    last: Optional[NDArray[np.float64]] = None
    count = 0
    for count, frame in enumerate(positions, 1):
        try:
            violation = _examine(detector, last, frame, count)
        except ValueError as error:
            raise ValueError(f"frame {count - 1}: {error}") from error
        if violation is not None:
            return AuditReport(count, violation)
        # A copy: the iterator may reuse its array.
        last = np.array(frame, np.float64)
        if progress is not None:
            progress(1)
    return AuditReport(count, None)


def _examine(
    detector: Detector, last: Optional[ArrayLike], frame: ArrayLike, count: int
) -> Optional[Violation]:
    """The violation in a frame, or in the step that leads to it; `count` frames with this one."""
    if last is None:
        found = detector.intersections(frame)
        if len(found):
            return Violation(0, None, (int(found[0, 0]), int(found[0, 1])))
        last = frame
    contact = detector.earliest_contact(last, frame)
    return None if contact is None else Violation(max(count - 2, 0), contact, None)


def _begin(
    frames: Any,
    faces: Optional[ArrayLike],
    edges: Optional[ArrayLike],
    min_distance: Union[float, ArrayLike],
    threads: Optional[int],
) -> tuple[Detector, Iterator[Any]]:
    """The detector of the mesh, and the positions of its frames."""
    if isinstance(frames, (str, PathLike)):
        frames = _files(Path(frames))
    remaining: Iterator[Any] = iter(frames)
    try:
        start = next(remaining)
    except StopIteration:
        raise ValueError("there are no frames") from None
    remaining = chain([start], remaining)
    if isinstance(start, (str, PathLike)):
        if faces is not None or edges is not None:
            raise TypeError("the faces and edges are those of the files")
        if Path(start).suffix.lower() == ".stl":
            raise ValueError(f"{start}: STL files have no shared vertices; use the program, exact-ccd audit")
        file = read_mesh(start)
        mesh = Mesh(file.vertices, file.faces, file.edges)
        remaining = (_positions(mesh, file) for file in remaining)
    elif faces is None:
        raise TypeError("expected the faces of the mesh")
    else:
        mesh = Mesh(len(start), faces, edges)
    return Detector(mesh, min_distance=min_distance, threads=threads), remaining


def _positions(mesh: Mesh, file: _Path) -> NDArray[np.float64]:
    """The positions in a file of the same mesh."""
    vertices, faces, edges = read_mesh(file)
    if not np.array_equal(faces, mesh.faces) or not np.array_equal(edges, mesh.loose_edges):
        raise ValueError(f"{file} has other faces or edges than the first frame")
    return vertices


def _files(path: Path) -> list[Path]:
    """The mesh files in a folder, in the order of the numbers in their names."""
    if not path.is_dir():
        return [path]
    files = [file for file in path.iterdir() if file.suffix.lower() in _FORMATS]
    if len({file.suffix.lower() for file in files}) != 1:
        raise ValueError(f"{path}: expected meshes of one format, .ply, .obj, .off, .msh or .vtu")
    return sorted(files, key=lambda file: (_by_number(file.name), file.name))


def _by_number(name: str) -> list[Union[str, int]]:
    """The text and the numbers in a name, alternately."""
    return [int(piece) if index % 2 else piece for index, piece in enumerate(re.split("([0-9]+)", name))]
