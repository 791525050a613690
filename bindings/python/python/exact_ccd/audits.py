"""The certificate of a sequence of frames."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, count
from os import PathLike
from pathlib import Path
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import as_array
from .frames import ArrayFrames, FileFrames, FilePath, Rules, files_in
from .groups import CanCollide
from .half_spaces import HalfSpaces
from .detectors import Detector, Progress
from .meshes import Mesh
from .pages import Page, line
from .recordings.opened import has_reader, open_recording
from .recordings.protocol import Frames as Recording
from .recordings.protocol import RecordedFrames, is_recording
from .turns import Turns
from .violations import AuditReport, Violation, examine
from .welding import PerVertex, Weld, per_vertex, remaining, style_of


def audit(
    frames: Union[ArrayLike, Iterable[Any], FilePath, Recording],
    faces: Optional[ArrayLike] = None,
    *,
    edges: Optional[ArrayLike] = None,
    groups: Optional[ArrayLike] = None,
    can_collide: Optional[CanCollide] = None,
    names: Optional[Sequence[str]] = None,
    weld: Weld = None,
    half_spaces: Optional[ArrayLike] = None,
    min_distance: Union[float, ArrayLike] = 0.0,
    progress: Optional[Progress] = None,
    threads: Optional[int] = None,
    view: Optional[FilePath] = None,
    certificate: Optional[FilePath] = None,
) -> AuditReport:
    """Certify a recorded motion: the mesh never touches itself.

    The first frame is examined at rest: no edge may meet a face, no vertex a face, and no edge another
    edge. From each frame to the next, every vertex moves in a straight line, and no contact may occur. If
    there is none, no frame passes through itself, nor does the mesh at any time between. With `groups` or
    `can_collide`, this holds for the pairs that can collide, and every frame is examined for edges that meet
    faces: a pair that cannot collide may have led there. An edge that passes through a face between two
    frames only is not found then. Primitives that share a vertex may touch; `docs/pairs.md` of the repository lists all pairs that are never a contact.

    With `half_spaces`, no vertex may touch one of them in any frame, hence at any time between.

    Parameters
    ----------
    frames : array of shape (T, V, 3), iterable of arrays (V, 3), file, folder, iterable of files, or Frames
        The positions in the order of time; or mesh files, or a folder of mesh files of one format, which
        are taken in the order of the numbers in their names. A file is a mesh of any format of
        :func:`read_mesh`, a collection of ParaView (.pvd, .series), arrays of numpy (.npz), or a file of
        :func:`open_recording` (HDF5, VTKHDF, Zarr, USD, XDMF); a mesh and a cache of its positions (.pc2, .mdd) are two
        files in a list. Any object with the attributes of :class:`Frames` is a recording, too. Frames are read one
        at a time.
    faces : int array of shape (F, 3)
        The faces, if the frames are positions.
    edges : int array of shape (E, 2), optional
        Loose edges, if the frames are positions.
    groups, can_collide, names : int array of shape (V,), bool array of shape (G, G) or callable, list of str, optional
        The pairs that can collide, and the names of the bodies, see :class:`Mesh`.
    weld : bool, optional
        Make one vertex of several that coincide in all frames, as the option ``--weld`` of the program does; by default
        in STL files only, see :func:`read_mesh`. Vertices of several groups or thicknesses stay apart. The numbers
        of vertices in results index :attr:`AuditReport.vertices`; the faces keep their numbers. Frames
        that are positions have to be an array.
    half_spaces : array of shape (H, 2, 3), optional
        Half spaces that no vertex may touch, nor come within the minimum distance of: for each, a point of
        its boundary, and the outward normal, of any length.
    min_distance : float or array of shape (V,)
        Primitives that come within this distance of each other count as touching, see :class:`Detector`.
    progress : callable, optional
        Called with the number of frames examined since its last call, as ``tqdm.update``.
    threads : int, optional
        The number of threads; by default the number of cores. The result does not depend on it.
    view : path, optional
        An HTML file to write, which shows the frames that were examined and the violation in a browser. It
        needs no network.
    certificate : path, optional
        A file to write: the proof of the report, for the program exact-ccd-check and PLY files of the same
        frames (docs/certificates.md). It is about all pairs and one distance: without `groups`,
        `can_collide`, `weld`, `half_spaces` and thicknesses.

    Returns
    -------
    AuditReport
        The number of frames examined, and the first violation.

    Raises
    ------
    ValueError
        If a frame has other vertices or faces than the first, or a coordinate that is not finite; the
        message names the frame. If a certificate is wanted, and there is nothing to prove: of a single frame,
        or if the first one has a violation.
    UncertifiedError
        If some pairs have no proof. No certificate is written.

    Warns
    -----
    UserWarning
        For each connected part that turns by more than 10° between two frames as a rigid body: its vertices move in
        straight lines, on which it shrinks. :class:`Bodies` turn exactly.

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
    apart = per_vertex(groups, min_distance)
    mesh, positions, kept = _begin(frames, faces, edges, Rules(groups, can_collide, names), weld, apart)
    min_distance = remaining(min_distance, kept)
    detector = Detector(mesh, min_distance=min_distance, threads=threads)
    planes = None if half_spaces is None else HalfSpaces(half_spaces, min_distance)
    parts = parts_of(certificate, min_distance, half_spaces, groups, can_collide, weld or None)
    page = None if view is None else Page("Audit", mesh)
    titles: Iterator[str] = map("frame {}".format, count())
    if isinstance(positions, (FileFrames, RecordedFrames)):
        titles = positions.names()

    def show(frame: Any) -> None:
        if page is not None:
            page.add_frame(next(titles), frame)

    turns = Turns(mesh)
    examined = examine(
        detector, positions, progress=progress, half_spaces=planes, examined=show, parts=parts, turns=turns
    )
    turns.warn(stacklevel=2)
    report = AuditReport(*examined, kept)
    if page is not None and view is not None:
        _write(page, view, detector, report)
    if certificate is not None and parts is not None:
        write_certificate(certificate, parts)
    return report


def parts_of(certificate: Optional[FilePath], min_distance: Any, *others: object) -> Optional[list[bytes]]:
    """The parts of a certificate, if one is wanted, before the first frame."""
    if certificate is None:
        return None
    if np.ndim(min_distance) > 0 or any(other is not None for other in others):
        raise ValueError(
            "a certificate is about all pairs and one distance of the vertices in the files: "
            "leave out half spaces, groups, can_collide, weld and thicknesses"
        )
    return []


def write_certificate(certificate: FilePath, parts: Iterable[bytes]) -> None:
    """Write the parts of a certificate to a file."""
    whole = b"".join(parts)
    if not whole:
        raise ValueError(
            "no certificate: nothing can be proved of a single frame, nor if the mesh touches itself in the first frame"
        )
    Path(certificate).write_bytes(whole)


def _write(page: Page, file: FilePath, detector: Detector, report: AuditReport) -> None:
    """Write the page of an audit."""
    lines = [f"frames examined: {report.frames}"]
    violation = report.violation
    if violation is None:
        lines = ["free of contact", f"examined: {report.frames} frames, and the straight motion between them, at all times"]
    elif violation.contact is not None:
        page.add_contacts(detector._native, every=False)
        place = "frame" if report.frames == 1 else "step"
        lines.insert(0, f"{place} {violation.frame}: {line(violation.contact)}")
    elif violation.intersection is not None:
        page.add_intersections(detector._native)
        edge, face = _words(violation, ("edge", "face"), violation.intersection)
        lines.insert(0, f"frame {violation.frame}: {edge} meets {face}")
    elif violation.half_space is not None:
        number, index = violation.half_space
        (vertex,) = _words(violation, ("vertex",), (index,))
        lines.insert(0, f"frame {violation.frame}: {vertex} is not apart from half space {number}")
    page.write(file, lines)


def _words(violation: Violation, kinds: Iterable[str], ids: Iterable[int]) -> list[str]:
    """The primitives of a violation in words: by their bodies, if these have names."""
    named = zip(kinds, ids, violation.places)
    return [f"{kind} {index}" if place is None else str(place) for kind, index, place in named]


def _begin(
    frames: Any,
    faces: Optional[ArrayLike],
    edges: Optional[ArrayLike],
    rules: Rules,
    weld: Weld,
    apart: PerVertex,
) -> tuple[Mesh, Iterable[Any], Optional[NDArray[np.int64]]]:
    """The mesh, the positions of its frames, and the vertices that remain, if some are welded."""
    files = in_files(frames, faces, edges, weld, apart)
    if files is not None:
        return files.mesh(rules), files, files.kept
    if style_of(weld, False) is not None and faces is not None:
        array = ArrayFrames.of(frames, faces, edges, weld, apart)
        return array.mesh(rules), array, array.kept
    if hasattr(frames, "__dlpack__"):
        # A tensor need not be iterable.
        frames = as_array("frames", frames)
    if isinstance(frames, np.ndarray) and frames.ndim != 3:
        raise ValueError(f"frames has the shape {frames.shape}, expected (T, V, 3)")
    following: Iterator[Any] = iter(frames)
    try:
        start = next(following)
    except StopIteration:
        raise ValueError("there are no frames") from None
    if isinstance(start, (str, PathLike)):
        return _begin([start, *following], faces, edges, rules, weld, apart)
    if faces is None:
        raise TypeError("expected the faces of the mesh")
    if isinstance(faces, Mesh):
        raise TypeError("faces is a Mesh, expected an array: mesh.faces")
    return Mesh(len(as_array("frames", start)), faces, edges, *rules), chain([start], following), None


def in_files(
    frames: Any, faces: Optional[ArrayLike], edges: Optional[ArrayLike], weld: Weld, apart: PerVertex
) -> Union[FileFrames, RecordedFrames, None]:
    """The frames, if they are in files or in a recording: a path of a file or folder, a list of files, or frames."""
    if isinstance(frames, (str, PathLike)) and has_reader(frames):
        frames = open_recording(frames)
    if is_recording(frames):
        _refuse_other(faces, edges, "recording")
        return RecordedFrames.of(frames, weld, apart)
    if isinstance(frames, (str, PathLike)):
        files = files_in(frames)
    elif isinstance(frames, (list, tuple)) and frames and isinstance(frames[0], (str, PathLike)):
        files = frames
    else:
        return None
    _refuse_other(faces, edges, "files")
    return FileFrames(files, None, weld, apart)


def _refuse_other(faces: Optional[ArrayLike], edges: Optional[ArrayLike], place: str) -> None:
    """Refuse faces and edges beside the faces and edges of files."""
    if faces is not None or edges is not None:
        raise TypeError(f"faces and edges come from the {place}: leave them out")
