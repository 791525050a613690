"""Half spaces that no vertex may enter."""

from __future__ import annotations

from typing import Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _native
from ._arrays import distances, floats


class HalfSpaces:
    """Half spaces, and the distances that vertices keep from them: one for all, or one for each vertex.

    The signed distance of a vertex in linear motion is linear in time: the vertex is apart in a whole step
    if and only if it is apart at both ends. So frames are examined at rest.
    """

    def __init__(self, half_spaces: ArrayLike, min_distance: Union[float, ArrayLike]) -> None:
        rows = floats("half_spaces", half_spaces, (None, 2, 3))
        self._native = _native.HalfSpaces(rows.reshape(-1, 6))
        self._distances = np.atleast_1d(distances(min_distance, None))

    def touching(self, positions: ArrayLike) -> Optional[tuple[int, int]]:
        """The first half space with a vertex that is not apart from it, and that vertex, decided exactly."""
        return self._native.touching(floats("positions", positions, (None, 3)), self._distances)
