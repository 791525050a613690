"""The certificate of a sequence of frames, by tasks of Ray."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from os import PathLike, fspath
from typing import Any, NamedTuple, Optional, Union

import numpy as np
import pyarrow.fs
import ray
from numpy.typing import ArrayLike, NDArray

from .._arrays import as_array, distances
from ..audits import in_files, parts_of, write_certificate
from ..frames import ArrayFrames, FileFrames, FilePath, Frames, Rules, ordered
from ..groups import CanCollide
from ..half_spaces import HalfSpaces
from ..violations import AuditReport, examine
from ..welding import PerVertex, Weld, per_vertex, remaining
from ..detectors import Detector, Progress
from .chunks import Chunk, Finished, Results, absolute, chunks, digest, file_system


def audit(
    frames: Union[ArrayLike, Iterable[Any], FilePath],
    faces: Optional[ArrayLike] = None,
    *,
    edges: Optional[ArrayLike] = None,
    groups: Optional[ArrayLike] = None,
    can_collide: Optional[CanCollide] = None,
    names: Optional[Sequence[str]] = None,
    weld: Weld = None,
    half_spaces: Optional[ArrayLike] = None,
    min_distance: Union[float, ArrayLike] = 0.0,
    filesystem: Optional[pyarrow.fs.FileSystem] = None,
    steps: int = 32,
    window: Optional[int] = None,
    results: Optional[FilePath] = None,
    progress: Optional[Progress] = None,
    retries: int = 100,
    certificate: Optional[FilePath] = None,
) -> AuditReport:
    """Certify a recorded motion by tasks of Ray: the same report as :func:`exact_ccd.audit`, bit for bit.

    Each task examines a chunk of steps on one core. Two chunks share the frame between them, and only frame
    0 is examined at rest. The violation in the earliest chunk is the answer, whichever is found first: the
    later chunks are cancelled, and the earlier ones are awaited. A task whose process or machine is lost runs
    again. An error of a frame counts in its place, as if the frames were examined one after the other.

    Parameters
    ----------
    frames, faces, edges, groups, can_collide, names, weld, half_spaces, min_distance
        As for :func:`exact_ccd.audit`. Files must be at the same place on all machines. An array is sent in
        chunks. An object with the attributes of :class:`exact_ccd.Frames` is sent whole; `results` need a method
        ``identity``, whose value is another one for other frames.
    filesystem : pyarrow.fs.FileSystem, optional
        The file system of the files and of the results, in place of the file systems of the machines.
        Addresses such as ``s3://bucket/frames`` in `frames` name one too. Its files are meshes with one frame each.
    steps : int
        The number of steps of a chunk.
    window : int, optional
        The largest number of chunks in work at once; by default twice the number of cores of the cluster.
    results : path, optional
        A folder for the results of finished chunks. The same audit, started again with the same folder, does
        not repeat them. Files count as the same by name, size and time of change. Not with a function
        `can_collide`, as two functions cannot be compared: a matrix of groups can.
    progress : callable, optional
        Called with the number of steps done since its last call, as ``tqdm.update``.
    retries : int
        The number of times that a task may be lost with its process or machine.
    certificate : path, optional
        As of :func:`exact_ccd.audit`, with the same bytes: each task makes the part of its chunk, and this process
        writes them one after the other.

    Raises
    ------
    ValueError
        As for :func:`exact_ccd.audit`.
    """
    apart = per_vertex(groups, min_distance)
    source, identity = _open(frames, faces, edges, filesystem, weld, apart, results is not None)
    if len(source) == 0:
        raise ValueError("there are no frames")
    if steps < 1 or window is not None and window < 1:
        raise ValueError("steps and window must be 1 or more")
    if results is not None and callable(can_collide):
        raise ValueError("results are not kept for a function can_collide: give a matrix of groups, or no results")
    parts_of(certificate, min_distance, half_spaces, groups, can_collide, weld or None)
    distance = remaining(distances(min_distance, None), source.kept)
    settings = Settings(distance, Rules(groups, can_collide, names), half_spaces)
    # The caller gets the errors of the mesh and of the settings, before any task begins.
    settings.detector(source, threads=None)
    settings.planes()
    kept: Optional[Results] = None
    if results is not None:
        place, folder = file_system(results, filesystem)
        arrays = (groups, can_collide, half_spaces)
        given = (settings.distance, *(None if value is None else np.asarray(value) for value in arrays))
        named = None if names is None else list(names)
        kept = Results(folder, digest(*given, named, weld, *identity), place)
    if not ray.is_initialized():
        ray.init()
    work = _Work(source, settings, kept, progress, retries, certificate is not None)
    report, parts = work.run(window or 2 * max(1, int(ray.cluster_resources().get("CPU", 1))), steps)
    if certificate is not None:
        write_certificate(certificate, parts)
    return report._replace(vertices=source.kept)


class Settings(NamedTuple):
    """All that an audit depends on besides its frames."""

    distance: NDArray[np.float64]
    rules: Rules
    half_spaces: Optional[ArrayLike]

    def detector(self, frames: Frames, threads: Optional[int]) -> Detector:
        """The detector of the mesh of the frames."""
        return Detector(frames.mesh(self.rules), min_distance=self.distance, threads=threads)

    def planes(self) -> Optional[HalfSpaces]:
        """The half spaces."""
        return None if self.half_spaces is None else HalfSpaces(self.half_spaces, self.distance)


def examine_chunk(part: Frames, settings: Settings, first: int, is_certified: bool) -> Finished:
    """The result of a chunk, whose first frame has this number."""
    parts: Optional[list[bytes]] = [] if is_certified else None
    detector = settings.detector(part, threads=1)
    report = AuditReport(*examine(detector, part, first, half_spaces=settings.planes(), parts=parts))
    return Finished(report, None if parts is None else b"".join(parts))


_examine_chunk = ray.remote(num_cpus=1)(examine_chunk)


class _Work(NamedTuple):
    """An audit in chunks."""

    frames: Frames
    settings: Settings
    results: Optional[Results]
    progress: Optional[Progress]
    retries: int
    is_certified: bool

    def run(self, window: int, steps: int) -> tuple[AuditReport, list[bytes]]:
        """The report of the earliest chunk with a violation or an error; of the last one if there is none.

        The parts of the certificate come from the chunks up to the one of the report, in order.
        """
        parts: dict[Chunk, bytes] = {}
        coming = chunks(len(self.frames), steps)
        running: dict[Any, Chunk] = {}
        end: Optional[tuple[Chunk, Union[AuditReport, Exception]]] = None

        def keep(chunk: Chunk, finished: Finished) -> AuditReport:
            if finished.part is not None:
                parts[chunk] = finished.part
            return finished.report

        try:
            while True:
                while end is None and len(running) < window:
                    chunk = next(coming, None)
                    if chunk is None:
                        break
                    known = None if self.results is None else self.results.read(chunk, self.is_certified)
                    if known is None:
                        running[self._start(chunk)] = chunk
                        continue
                    self._advance(chunk)
                    report = keep(chunk, known)
                    if report.violation is not None:
                        end = chunk, report
                if not running:
                    break
                (done, *_), _ = ray.wait(list(running), num_returns=1)
                chunk = running.pop(done)
                finished = self._finish(chunk, done)
                outcome = finished if isinstance(finished, Exception) else keep(chunk, finished)
                if isinstance(outcome, Exception) or outcome.violation is not None:
                    end = chunk, outcome
                    for later in [task for task, other in running.items() if other > chunk]:
                        del running[later]
                        ray.cancel(later)
        finally:
            for task in running:
                ray.cancel(task)
        if end is None:
            return AuditReport(len(self.frames), None), [parts[chunk] for chunk in sorted(parts)]
        last, outcome = end
        if isinstance(outcome, Exception):
            raise outcome
        return outcome, [parts[chunk] for chunk in sorted(parts) if chunk <= last]

    def _start(self, chunk: Chunk) -> Any:
        part = self.frames.part(chunk.first, chunk.last)
        task = _examine_chunk.options(max_retries=self.retries)
        return task.remote(part, self.settings, chunk.first, self.is_certified)

    def _finish(self, chunk: Chunk, task: Any) -> Union[Finished, Exception]:
        try:
            finished: Finished = ray.get(task)
        except ray.exceptions.RayTaskError as error:
            cause: Exception = error.cause if isinstance(error.cause, Exception) else error
            return cause
        except ray.exceptions.RayError as error:
            lost: Exception = error
            return lost
        if self.results is not None:
            self.results.write(chunk, finished)
        self._advance(chunk)
        return finished

    def _advance(self, chunk: Chunk) -> None:
        if self.progress is not None:
            self.progress(chunk.last - chunk.first)


def _open(
    frames: Any,
    faces: Optional[ArrayLike],
    edges: Optional[ArrayLike],
    filesystem: Optional[pyarrow.fs.FileSystem],
    weld: Weld,
    apart: PerVertex,
    is_identified: bool,
) -> tuple[Frames, list[Any]]:
    """The frames, and all that distinguishes them from others, if it is wanted."""
    listed = list(frames) if isinstance(frames, (list, tuple)) else [frames]
    is_path = all(isinstance(frame, (str, PathLike)) for frame in listed) and len(listed) > 0
    if is_path and (filesystem is not None or "://" in fspath(listed[0])):
        return _on(filesystem, [fspath(path) for path in listed], faces, edges, weld, apart)
    if is_path:
        paths = [absolute(path) for path in listed]
        frames = paths if isinstance(frames, (list, tuple)) else paths[0]
    files = in_files(frames, faces, edges, weld, apart)
    if files is not None:
        return files, files.identity() if is_identified else []
    if faces is None:
        raise TypeError("expected the faces of the mesh")
    array = as_array("frames", frames)
    if array.dtype == object:
        raise TypeError("expected an array of shape (T, V, 3), or files; other iterables are for exact_ccd.audit")
    return ArrayFrames.of(array, faces, edges, weld, apart), [array, np.asarray(faces), None if edges is None else np.asarray(edges)]


def _on(
    filesystem: Optional[pyarrow.fs.FileSystem],
    paths: list[str],
    faces: Optional[ArrayLike],
    edges: Optional[ArrayLike],
    weld: Weld,
    apart: PerVertex,
) -> tuple[Frames, list[Any]]:
    """The frames in files or folders on a file system of pyarrow."""
    if faces is not None or edges is not None:
        raise TypeError("faces and edges come from the files: leave them out")
    files: list[FilePath] = []
    place = filesystem
    for path in paths:
        place, inside = file_system(path, filesystem)
        info = place.get_file_info(inside)
        if info.type == pyarrow.fs.FileType.Directory:
            selected = place.get_file_info(pyarrow.fs.FileSelector(inside))
            files.extend(ordered(inside, [file.path for file in selected]))
        else:
            files.append(inside)
    found = place.get_file_info([fspath(file) for file in files]) if place is not None else []
    return FileFrames(files, place, weld, apart), [(info.path, info.size, info.mtime_ns) for info in found]
