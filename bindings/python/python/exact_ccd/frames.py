"""The frames of a recorded motion: positions in an array, or mesh files."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from os import PathLike, fspath
from pathlib import Path
from typing import Any, NamedTuple, Optional, Protocol, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._arrays import as_array
from .groups import CanCollide
from .meshes import Mesh, MeshFile
from .welding import PerVertex, Weld, remaining, style_of, welded

FilePath = Union[str, PathLike[str]]


class Rules(NamedTuple):
    """The pairs of a mesh that can collide, and the names of its groups, see :class:`Mesh`."""

    groups: Optional[ArrayLike]
    can_collide: Optional[CanCollide]
    names: Optional[Sequence[str]] = None

    def of(self, kept: Optional[NDArray[np.int64]]) -> Rules:
        """The rules of the vertices that remain."""
        return self._replace(groups=remaining(self.groups, kept))


class FileSystem(Protocol):
    """The method of ``pyarrow.fs.FileSystem`` that is needed to read a file."""

    def open_input_file(self, path: str) -> Any: ...


class Frames(Protocol):
    """Frames of one mesh, which can be read in any order, and sent to another process."""

    @property
    def kept(self) -> Optional[NDArray[np.int64]]:
        """The vertices that remain, if some are welded."""
        ...

    def __len__(self) -> int: ...

    def __iter__(self) -> Iterator[NDArray[Any]]:
        """The positions in the order of time, read one frame at a time."""
        ...

    def mesh(self, rules: Rules) -> Mesh:
        """The mesh of all frames, with the pairs that can collide."""
        ...

    def part(self, first: int, last: int) -> Frames:
        """The frames from `first` to `last`, both included."""
        ...


@dataclass(frozen=True)
class ArrayFrames:
    """Frames in an array of shape (T, V, 3)."""

    positions: NDArray[Any]
    faces: ArrayLike
    edges: Optional[ArrayLike]
    kept: Optional[NDArray[np.int64]] = None
    """The vertices that remain, if some are welded."""

    @staticmethod
    def of(
        frames: Any, faces: ArrayLike, edges: Optional[ArrayLike], weld: Weld, apart: PerVertex = ()
    ) -> ArrayFrames:
        """The frames in an array, with vertices welded that coincide in all of them and have the same values."""
        positions = as_array("frames", frames)
        style = style_of(weld, False)
        if style is None:
            return ArrayFrames(positions, faces, edges)
        if positions.ndim != 3 or positions.dtype == object:
            raise TypeError("weld=True needs all frames before the first is examined: give an array of shape (T, V, 3)")
        mesh = Mesh(positions.shape[1], faces, edges)
        return ArrayFrames(positions, *welded(mesh._native, positions, style, apart))

    def __len__(self) -> int:
        return len(self.positions)

    def __iter__(self) -> Iterator[NDArray[Any]]:
        return iter(self.positions) if self.kept is None else (frame[self.kept] for frame in self.positions)

    def mesh(self, rules: Rules) -> Mesh:
        """The mesh of all frames, with the pairs that can collide."""
        if self.positions.ndim != 3:
            raise ValueError(f"frames has the shape {self.positions.shape}, expected (T, V, 3)")
        count = self.positions.shape[1] if self.kept is None else len(self.kept)
        return Mesh(count, self.faces, self.edges, *rules.of(self.kept))

    def part(self, first: int, last: int) -> ArrayFrames:
        """The frames from `first` to `last`, both included."""
        return replace(self, positions=self.positions[first : last + 1])


class FileFrames:
    """Frames in mesh files, of this machine or of a file system of pyarrow.

    Vertices that coincide in all frames and have the same values become one in STL files, which have no shared
    vertices, and with `weld`.
    """

    def __init__(
        self,
        files: Iterable[FilePath],
        filesystem: Optional[FileSystem] = None,
        weld: Weld = None,
        apart: PerVertex = (),
    ) -> None:
        self._filesystem = filesystem
        listed = [fspath(file) for file in files]
        self._mesh: Optional[str] = None
        if filesystem is None and len(listed) == 2 and _native.FrameSequence.is_cache(listed[1]):
            # Frames of a cache, whose mesh is in a file before it.
            self._mesh, *listed = listed
        self._places = [place for file in listed for place in self._within(file)]
        if not self._places:
            raise ValueError("there are no frames")
        self._first = next(self._read())
        self._faces, self._edges = self._first.faces, self._first.edges
        self.kept: Optional[NDArray[np.int64]] = None
        style = style_of(weld, all(_native.mesh_format(file) == "Stl" for file, _ in self._places))
        if style is not None:
            first = Mesh(self._first.vertices, self._first.faces, self._first.edges)
            self._faces, self._edges, self.kept = welded(first._native, self, style, apart)

    def _within(self, file: str) -> Iterator[tuple[str, int]]:
        """The frames of a file: the frame of a mesh file, the frames in arrays, or the files of a collection."""
        if self._filesystem is not None:
            yield file, 0
            return
        sequence = self._sequence(file)
        for frame in range(len(sequence)):
            place = sequence.file(frame)
            yield fspath(place), frame if Path(place) == Path(file) else 0

    def _sequence(self, file: str) -> _native.FrameSequence:
        """The frames in a file, or in a cache of the mesh."""
        if self._mesh is None:
            return _native.FrameSequence(file)
        return _native.FrameSequence(self._mesh, file)

    def __len__(self) -> int:
        return len(self._places)

    def __iter__(self) -> Iterator[NDArray[np.float64]]:
        for (file, _), frame in zip(self._places, _ahead(self._read())):
            same = np.array_equal(frame.faces, self._first.faces)
            if not same or not np.array_equal(frame.edges, self._first.edges):
                raise ValueError(f"{file} has other faces or edges than the first frame")
            yield frame.vertices if self.kept is None else frame.vertices[self.kept]

    def _read(self) -> Iterator[MeshFile]:
        """The meshes in the files."""
        name, sequence = "", None
        for file, frame in self._places:
            if self._filesystem is not None:
                with self._filesystem.open_input_file(file) as stream:
                    yield MeshFile(*_native.parse_mesh(stream.read(), file))
                continue
            if sequence is None or file != name:
                name, sequence = file, self._sequence(file)
            yield MeshFile(*sequence.read(frame))

    def mesh(self, rules: Rules) -> Mesh:
        """The mesh of all frames, with the pairs that can collide."""
        count = len(self._first.vertices) if self.kept is None else len(self.kept)
        return Mesh(count, self._faces, self._edges, *rules.of(self.kept))

    def names(self) -> Iterator[str]:
        """The names of the frames, for titles: the file, and the number in a file of several frames."""
        several = len({file for file, _ in self._places}) < len(self._places)
        return (f"{Path(file).name} {frame}" if several else Path(file).name for file, frame in self._places)

    def identity(self) -> list[tuple[str, int, int, int]]:
        """Name, number, size and time of change of each frame."""
        places = self._places if self._mesh is None else [(self._mesh, 0), *self._places]
        states = ((file, frame, Path(file).stat()) for file, frame in places)
        return [(file, frame, state.st_size, state.st_mtime_ns) for file, frame, state in states]

    def part(self, first: int, last: int) -> FileFrames:
        """The frames from `first` to `last`, both included."""
        part = object.__new__(FileFrames)
        part.__dict__.update(self.__dict__, _places=self._places[first : last + 1])
        return part


def _ahead(meshes: Iterator[MeshFile]) -> Iterator[MeshFile]:
    """The same meshes, each read while the one before it is in use."""
    with ThreadPoolExecutor(max_workers=1) as thread:
        coming = thread.submit(next, meshes, None)
        while (mesh := coming.result()) is not None:
            coming = thread.submit(next, meshes, None)
            yield mesh


def files_in(path: FilePath) -> Sequence[FilePath]:
    """The mesh files in a folder, in the order of the numbers in their names; a file itself."""
    folder = Path(path)
    if not folder.is_dir():
        return [path]
    return ordered(folder, folder.iterdir())


def ordered(folder: FilePath, files: Iterable[FilePath]) -> Sequence[FilePath]:
    """The mesh files of one format among the files of a folder, in the order of the numbers in their names."""
    formats = {fspath(file): _native.mesh_format(file) for file in files}
    meshes = [file for file, format in formats.items() if format is not None]
    if len({formats[file] for file in meshes}) != 1:
        raise ValueError(f"{folder}: expected mesh files of one format, such as .ply, .obj, .stl, .off or .vtu")
    return _native.in_order(meshes)
