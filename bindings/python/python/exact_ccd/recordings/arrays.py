"""Recordings in arrays of a hierarchy: HDF5 and Zarr."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Optional

import numpy as np
from numpy.typing import NDArray

from .topology import topology


class StoredArrays:
    """Frames in an array (T, V, 3) of a file, which is opened again after it was pickled."""

    def __init__(
        self,
        path: str,
        positions: str = "positions",
        faces: str = "faces",
        edges: str = "edges",
        times: str = "times",
    ) -> None:
        self._path, self._name = path, positions
        self._open: Any = None
        array = self._array(positions, required=True)
        if array.ndim != 3 or array.shape[2] != 3 or array.dtype.kind not in "fiu":
            raise ValueError(
                f"{path}: {positions} has the shape {tuple(array.shape)} and the type {array.dtype}, expected positions "
                "(T, V, 3) as numbers"
            )
        if array.shape[0] == 0:
            raise ValueError(f"{path}: {positions} has no frame")
        self._count = int(array.shape[0])
        loose = self._array(edges, required=False)
        cells = self._array(faces, required=True)
        self.faces, self.edges = topology(
            self.positions(0), cells[...], None if loose is None else loose[...]
        )
        stamps = self._array(times, required=False)
        self.times: Optional[NDArray[np.float64]] = None if stamps is None else np.asarray(stamps[...], np.float64)
        if self.times is not None and self.times.shape != (self._count,):
            raise ValueError(f"{path}: {times} has the shape {self.times.shape}, expected ({self._count},)")

    def _load(self) -> Any:
        """The root of the hierarchy."""
        raise NotImplementedError

    def _array(self, name: str, required: bool) -> Any:
        if self._open is None:
            self._open = self._load()
        if name in self._open and hasattr(self._open[name], "shape"):
            return self._open[name]
        if required:
            found = ", ".join(sorted(self._open)) or "none"
            raise ValueError(f"{self._path}: there is no array {name}; there are {found} (name it by an option)")
        return None

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_open": None}

    def __len__(self) -> int:
        return self._count

    def positions(self, index: int) -> NDArray[Any]:
        """The positions of a frame."""
        frame: NDArray[Any] = np.asarray(self._array(self._name, required=True)[index])
        return frame

    def identity(self) -> list[Any]:
        """The path, and the sizes and times of change of its files."""
        root = Path(self._path)
        files = sorted(file for file in root.rglob("*") if file.is_file()) if root.is_dir() else [root]
        states = [(str(file), file.stat().st_size, file.stat().st_mtime_ns) for file in files]
        return [self._name, *states]
