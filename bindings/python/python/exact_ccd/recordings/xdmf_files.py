"""Recordings in XDMF: a mesh at rest, and displacements of its points."""

from __future__ import annotations

import contextlib
from pathlib import Path
from typing import Any, Optional

import meshio
import numpy as np
from numpy.typing import NDArray

from .topology import topology


class XdmfFrames:
    """The steps of a time series of meshio, whose points move by one of their arrays."""

    def __init__(self, path: str, displacement: Optional[str] = None) -> None:
        self._path, self._displacement = path, displacement
        with self._reader() as reader:
            points, cells = reader.read_points_cells()
            self._points = _in_space(np.asarray(points, np.float64))
            self._count = int(reader.num_steps)
            if self._count == 0:
                raise ValueError(f"{path}: there are no steps")
            data = [reader.read_data(step) for step in range(self._count)]
        names = sorted(data[0][1])
        if displacement is None:
            raise ValueError(
                f"{path}: the points of an XDMF series rest; name the point data that move them by displacement=NAME: "
                f"there are {', '.join(names) or 'none'}"
            )
        if any(displacement not in step[1] for step in data):
            raise ValueError(f"{path}: there are no point data {displacement} in all steps; there are {', '.join(names)}")
        self.times: Optional[NDArray[np.float64]] = np.array([float(step[0]) for step in data])
        kinds = {block.type for block in cells}
        if not kinds <= {"triangle", "quad"}:
            raise ValueError(f"{path}: cells of the kinds {sorted(kinds)}, expected triangles and quads")
        counts = np.concatenate([np.full(len(block.data), block.data.shape[1]) for block in cells])
        corners = np.concatenate([np.ravel(block.data) for block in cells])
        self.faces, self.edges = topology(self.positions(0), corners, counts=counts)

    @contextlib.contextmanager
    def _reader(self) -> Any:
        with meshio.xdmf.TimeSeriesReader(self._path) as reader:
            yield reader

    def __len__(self) -> int:
        return self._count

    def positions(self, index: int) -> NDArray[np.float64]:
        """The positions of a frame: the sums of points and displacements, rounded."""
        with self._reader() as reader:
            reader.read_points_cells()
            _, data, _ = reader.read_data(index)
        return self._points + _in_space(np.asarray(data[self._displacement], np.float64))

    def identity(self) -> list[Any]:
        """The paths, sizes and times of change of the file and of the data beside it."""
        path = Path(self._path)
        files = [path, *sorted(path.parent.glob(f"{path.stem}*.h5"))]
        states = [(str(file), file.stat().st_size, file.stat().st_mtime_ns) for file in files]
        return [self._displacement, *states]


def _in_space(vectors: NDArray[np.float64]) -> NDArray[np.float64]:
    """Vectors of three coordinates; in the plane, the third one is 0."""
    return np.pad(vectors, ((0, 0), (0, 3 - vectors.shape[1])))
