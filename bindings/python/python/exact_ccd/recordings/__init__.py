"""Recordings in the formats of other libraries, and in classes of the caller.

:func:`open_recording` opens HDF5 and VTKHDF (h5py), Zarr, USD (usd-core) and XDMF (meshio); :func:`exact_ccd.audit` calls
it for such files. :class:`Frames` is all that a recording needs, for other sources.
"""

from .opened import open_recording
from .protocol import Frames

__all__ = ["Frames", "open_recording"]
