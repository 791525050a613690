"""One vertex in place of several that coincide in every frame."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, Literal, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._arrays import Indices, floats

Weld = Optional[bool]
"""True to weld along edges, False not to weld; None for STL files only."""

Style = Literal["everywhere", "along edges"]


class Welded(NamedTuple):
    """The primitives with the new vertices, and for each new vertex the first of the vertices that it replaces."""

    faces: Indices
    edges: Indices
    kept: NDArray[np.int64]


def style_of(weld: Weld, is_stl: bool) -> Optional[Style]:
    """The vertices to weld: all that coincide in STL files, the ends of coinciding edges in others; None for none."""
    if weld is not None and not isinstance(weld, (bool, np.bool_)):
        raise TypeError(f"weld is of type {type(weld).__name__}, expected True, False, or None for STL files only")
    if not (is_stl if weld is None else weld):
        return None
    return "everywhere" if is_stl else "along edges"


PerVertex = Sequence[tuple[str, ArrayLike]]
"""Arguments with a value for each vertex, by their names."""


def per_vertex(groups: Optional[ArrayLike], min_distance: Union[float, ArrayLike]) -> PerVertex:
    """The arguments of an audit that have a value for each vertex."""
    given = [] if groups is None else [("groups", groups)]
    return [*given, ("min_distance", min_distance)] if np.ndim(min_distance) > 0 else given


def welded(mesh: _native.Mesh, frames: Iterable[Any], style: Style, apart: PerVertex = ()) -> Welded:
    """Weld the vertices of a mesh that coincide in all of these frames, and have the same values."""
    count = mesh.vertex_count
    welding = _native.Welding()
    for name, values in apart:
        # Vertices with other values are in other places of one more frame.
        welding.restrict(np.outer(floats(name, values, (count,)), [1.0, 0.0, 0.0]))
    for number, frame in enumerate(frames):
        welding.restrict(floats(f"frame {number}", frame, (count, 3)))
    if style == "along edges":
        welding.along_edges(mesh)
    faces, edges = welding.primitives(mesh)
    return Welded(faces, edges, welding.first_vertices())


def remaining(values: Any, kept: Optional[NDArray[np.int64]]) -> Any:
    """The values of the vertices that remain; one value for all as it is."""
    return values if kept is None or values is None or np.ndim(values) == 0 else np.asarray(values)[kept]
