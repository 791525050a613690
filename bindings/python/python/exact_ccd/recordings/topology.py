"""The faces of a recording, by the rules of all mesh files."""

from __future__ import annotations

import io
from typing import Any, Optional

import numpy as np
from numpy.typing import NDArray

from .. import _native


def topology(
    positions: Any, faces: Any, edges: Optional[Any] = None, counts: Optional[Any] = None
) -> tuple[NDArray[np.uint32], NDArray[np.uint32]]:
    """The triangles and the loose edges of positions (V, 3) and faces (F, k), as of an archive of numpy.

    With `counts`, the faces are a list, and have these numbers of corners. A polygon becomes a fan of triangles from
    its lowest vertex, and wrong faces are errors, as in mesh files.
    """
    arrays: dict[str, Any] = {"positions": np.asarray(positions, np.float64), "faces": np.asarray(faces, np.int64)}
    if counts is not None:
        corners = np.split(arrays["faces"], np.cumsum(counts)[:-1])
        arrays["faces"] = np.concatenate([part for count, list_ in zip(counts, corners) for part in ([count], list_)])
    if edges is not None:
        arrays["edges"] = np.asarray(edges, np.int64)
    archive = io.BytesIO()
    np.savez(archive, **arrays)
    _, triangles, loose = _native.parse_mesh(archive.getvalue(), "recording.npz")
    return triangles, loose


def check_constant(name: str, first: Any, values: Any) -> None:
    """Refuse faces that change."""
    if not np.array_equal(first, values):
        raise ValueError(f"{name}: the faces change, expected the same ones in all frames")
