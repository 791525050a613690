"""Recordings in arrays of HDF5."""

from __future__ import annotations

from typing import Any

import h5py

from .arrays import StoredArrays


class Hdf5Frames(StoredArrays):
    """Frames in an array of an HDF5 file."""

    def _load(self) -> Any:
        return h5py.File(self._path, "r")
