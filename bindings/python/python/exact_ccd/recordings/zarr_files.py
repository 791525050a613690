"""Recordings in arrays of Zarr."""

from __future__ import annotations

from typing import Any

import zarr

from .arrays import StoredArrays


class ZarrFrames(StoredArrays):
    """Frames in an array of a Zarr group, of version 2 or 3."""

    def _load(self) -> Any:
        return zarr.open_group(self._path, mode="r")
