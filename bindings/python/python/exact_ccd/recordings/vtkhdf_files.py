"""Recordings in VTKHDF: surfaces (PolyData) and unstructured grids of triangles, with steps."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Optional

import h5py
import numpy as np
from numpy.typing import NDArray

from .topology import check_constant, topology

_TRIANGLE, _POLYGON, _QUAD = 5, 7, 9
"""The types of cells of VTK that are faces."""


class VtkHdfFrames:
    """The steps of a VTKHDF file of one piece; a file without steps is one frame."""

    def __init__(self, path: str) -> None:
        self._path = path
        self._file: Any = None
        root = self._root()
        kind = root.attrs.get("Type", b"")
        self._type = kind.decode() if isinstance(kind, bytes) else str(kind)
        if self._type not in ("PolyData", "UnstructuredGrid"):
            raise ValueError(f"{path}: the type is {self._type!r}, expected PolyData or UnstructuredGrid")
        steps = root.get("Steps")
        self._count = 1 if steps is None else int(steps.attrs["NSteps"])
        self.times: Optional[NDArray[np.float64]] = None
        if steps is not None:
            self.times = np.asarray(steps["Values"][...], np.float64)
        first = self._cells(0)
        for frame in range(1, self._count):
            for own, other in zip(first, self._cells(frame)):
                check_constant(f"{path}, frame {frame}", own, other)
        counts, corners = first
        self.faces, self.edges = topology(self.positions(0), corners, counts=counts)

    def _root(self) -> Any:
        if self._file is None:
            self._file = h5py.File(self._path, "r")
        if "VTKHDF" not in self._file:
            raise ValueError(f"{self._path}: there is no group VTKHDF")
        return self._file["VTKHDF"]

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_file": None}

    def _step(self, name: str, frame: int, default: int) -> int:
        """A number of the steps, for a frame."""
        steps = self._root().get("Steps")
        return default if steps is None or name not in steps else int(np.ravel(steps[name][frame])[0])

    def _part(self, frame: int) -> int:
        """The piece of a frame."""
        if self._step("NumberOfParts", frame, len(self._root()["NumberOfPoints"]) // self._count) != 1:
            raise ValueError(f"{self._path}, frame {frame}: several pieces, expected one (merge them)")
        return self._step("PartOffsets", frame, frame)

    def _cells(self, frame: int) -> tuple[NDArray[Any], NDArray[Any]]:
        """The numbers of corners of the faces of a frame, and their corners."""
        root, part = self._root(), self._part(frame)
        group = root
        if self._type == "PolyData":
            for name in ("Vertices", "Lines", "Strips"):
                if name in root and np.any(root[name]["NumberOfCells"][...]):
                    raise ValueError(f"{self._path}: {name} are not read, expected Polygons alone")
            group = root["Polygons"]
        cell = self._step("CellOffsets", frame, 0)
        corner = self._step("ConnectivityIdOffsets", frame, 0)
        if self._type == "PolyData" and "Steps" in root:
            # A column for each kind of cells: vertices, lines, polygons, strips.
            cell = int(np.ravel(root["Steps"]["CellOffsets"][frame])[2])
            corner = int(np.ravel(root["Steps"]["ConnectivityIdOffsets"][frame])[2])
        count, length = int(group["NumberOfCells"][part]), int(group["NumberOfConnectivityIds"][part])
        # The offsets of each piece have one number more than it has cells.
        offsets = group["Offsets"][cell + self._pieces_before(group, cell) :][: count + 1]
        counts = np.diff(np.asarray(offsets, np.int64))
        if self._type == "UnstructuredGrid":
            types = np.unique(root["Types"][cell : cell + count])
            if not set(types.tolist()) <= {_TRIANGLE, _POLYGON, _QUAD}:
                raise ValueError(f"{self._path}: cells of the types {types.tolist()}, expected faces (5, 7 or 9)")
        return counts, np.asarray(group["Connectivity"][corner : corner + length], np.int64)

    def _pieces_before(self, group: Any, cell: int) -> int:
        """The number of pieces whose cells are before a cell."""
        ends = np.cumsum(group["NumberOfCells"][...])
        return int(np.count_nonzero(ends <= cell)) if cell else 0

    def __len__(self) -> int:
        return self._count

    def positions(self, index: int) -> NDArray[Any]:
        """The positions of a frame."""
        root, part = self._root(), self._part(index)
        count = int(root["NumberOfPoints"][part])
        before = int(np.sum(root["NumberOfPoints"][:part]))
        first = self._step("PointOffsets", index, before)
        frame: NDArray[Any] = np.asarray(root["Points"][first : first + count])
        return frame

    def identity(self) -> list[Any]:
        """The path, the size and the time of change."""
        state = Path(self._path).stat()
        return [(self._path, state.st_size, state.st_mtime_ns)]
