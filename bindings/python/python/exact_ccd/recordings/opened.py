"""The recording in a file, by its extension."""

from __future__ import annotations

import importlib
from os import fspath
from pathlib import Path
from typing import Any

from ..frames import FilePath
from .protocol import Frames

READERS = {
    ".h5": ("hdf5_files", "Hdf5Frames", "h5py"),
    ".hdf5": ("hdf5_files", "Hdf5Frames", "h5py"),
    ".vtkhdf": ("vtkhdf_files", "VtkHdfFrames", "h5py"),
    ".zarr": ("zarr_files", "ZarrFrames", "zarr"),
    ".usd": ("usd_files", "UsdFrames", "usd-core"),
    ".usda": ("usd_files", "UsdFrames", "usd-core"),
    ".usdc": ("usd_files", "UsdFrames", "usd-core"),
    ".usdz": ("usd_files", "UsdFrames", "usd-core"),
    ".xdmf": ("xdmf_files", "XdmfFrames", "meshio"),
    ".xmf": ("xdmf_files", "XdmfFrames", "meshio"),
}
"""For each extension, the module and the class of its reader, and the package that it needs."""


def has_reader(path: FilePath) -> bool:
    """Whether the extension of a path is one of these formats."""
    return Path(path).suffix.lower() in READERS


def open_recording(path: FilePath, **options: Any) -> Frames:
    """Open the recording in a file of HDF5, VTKHDF, Zarr, USD or XDMF.

    Frames are read when they are needed. Positions are in the unit and in the axes of the file.

    Parameters
    ----------
    path : path
        The file; its extension determines the format: .h5, .hdf5, .vtkhdf, .zarr (a folder), .usd, .usda, .usdc,
        .usdz, .xdmf or .xmf. ``docs/recordings.md`` of the repository says what is read of each.
    **options
        For HDF5 and Zarr, the names of the arrays: ``positions="positions"`` of shape (T, V, 3), ``faces="faces"``
        of shape (F, k), ``edges="edges"`` of shape (E, 2) and ``times="times"``; the last two may be missing. For
        USD, ``prim``, the path of the mesh, if there are several. For XDMF, ``displacement``, the name of the point
        data that are added to the points.

    Returns
    -------
    Frames
        The recording, for :func:`exact_ccd.audit`.

    Raises
    ------
    ImportError
        If the package for the format is not installed; the message has its name.
    OSError
        If the file cannot be read.
    ValueError
        If there is not one mesh in motion in the file; the message says what is missing.
    """
    suffix = Path(path).suffix.lower()
    if suffix not in READERS:
        raise ValueError(f"{fspath(path)}: unknown extension, expected one of {', '.join(READERS)}")
    module, name, package = READERS[suffix]
    if not Path(path).exists():
        raise FileNotFoundError(f"{fspath(path)}: no such file or folder")
    try:
        reader = getattr(importlib.import_module(f".{module}", __package__), name)
    except ImportError as error:
        raise ImportError(f"{fspath(path)}: {error}; pip install {package}") from error
    recording: Frames = reader(fspath(path), **options)
    return recording
