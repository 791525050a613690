from collections.abc import Sequence
from typing import Optional, Union

import numpy as np
from numpy.typing import NDArray

_Floats = NDArray[np.float64]
_Arrays = Union[_Floats, tuple[NDArray[np.uint32], _Floats, _Floats]]

__version__: str

def main(arguments: Sequence[str]) -> int: ...
def collides(
    kind: str, arrays: _Arrays, min_distance: float, threads: Optional[int]
) -> NDArray[np.bool_]: ...
def time_of_impact(
    kind: str, arrays: _Arrays, min_distance: float, threads: Optional[int]
) -> _Floats: ...
def contact_count(
    kind: str, arrays: _Arrays, min_distance: float, threads: Optional[int]
) -> NDArray[np.int64]: ...
def contact_times(
    kind: str, arrays: _Arrays, min_distance: float, threads: Optional[int]
) -> tuple[NDArray[np.int64], _Floats]: ...
def impacts(kind: str, arrays: _Arrays, min_distance: float, threads: Optional[int]) -> _Floats: ...
