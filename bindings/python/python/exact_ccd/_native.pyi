from collections.abc import Callable, Sequence
from os import PathLike
from typing import Optional, Union, final

import numpy as np
from numpy.typing import NDArray

_Floats = NDArray[np.float64]
_Integers = NDArray[np.uint32]
_Arrays = Union[_Floats, tuple[_Integers, _Floats, _Floats]]
_Columns = tuple[NDArray[np.uint8], _Integers, NDArray[np.int64], _Floats, _Floats]

__all__ = [
    "Detector",
    "Mesh",
    "__version__",
    "collides",
    "contact_count",
    "contact_times",
    "impacts",
    "main",
    "overlaps",
    "read_mesh",
    "time_of_impact",
]

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
def overlaps(
    first: _Integers,
    second: _Integers,
    x0: _Floats,
    x1: _Floats,
    distance: float,
    threads: Optional[int],
) -> _Integers: ...
def read_mesh(path: Union[str, PathLike[str]]) -> tuple[_Floats, _Integers, _Integers]: ...
@final
class Mesh:
    def __new__(
        cls,
        vertex_count: int,
        faces: _Integers,
        edges: _Integers,
        groups: Optional[_Integers],
        rule: Optional[Callable[[int, int], object]],
    ) -> Mesh: ...
    @property
    def vertex_count(self) -> int: ...
    @property
    def faces(self) -> _Integers: ...
    @property
    def edges(self) -> _Integers: ...
    @property
    def loose_edge_count(self) -> int: ...

@final
class Detector:
    def __new__(
        cls,
        mesh: Mesh,
        min_distance: Union[float, _Floats],
        inner_distance: Optional[float],
        threads: Optional[int],
    ) -> Detector: ...
    def earliest_contact(self, x0: _Floats, x1: _Floats) -> _Columns: ...
    def is_free(self, x0: _Floats, x1: _Floats) -> bool: ...
    def contacts(self, x0: _Floats, x1: _Floats, until: float) -> _Columns: ...
    def free_step(
        self, x0: _Floats, x1: _Floats, keep: float
    ) -> tuple[float, _Floats, _Columns, list[int]]: ...
    def step(
        self, x0: _Floats, x1: _Floats, progress: Optional[Callable[[int], object]]
    ) -> tuple[list[list[int]], _Columns]: ...
    def intersections(self, x: _Floats) -> _Integers: ...
