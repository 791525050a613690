from collections.abc import Callable, Sequence
from os import PathLike
from pathlib import Path
from typing import Any, Literal, Optional, Union, final

import numpy as np
from numpy.typing import NDArray

_Floats = NDArray[np.float64]
_Integers = NDArray[np.uint32]
_Path = Union[str, PathLike[str]]
_Positions = NDArray[Union[np.float32, np.float64]]
_Queries = tuple[int, _Positions, _Positions, Optional[_Integers]]
_Settings = tuple[float, float, Optional[int]]
_PairColumns = tuple[NDArray[np.uint8], _Integers, NDArray[np.int64]]
_Columns = tuple[NDArray[np.int64], _PairColumns, _Floats, _Floats]
_Phase = Literal["loosen", "separate", "return", "follow"]
_Reason = Literal["pinned", "one-sided", "linked", "stalled", "rounds", "rounding", "stopped", "other"]

_BodyColumns = tuple[NDArray[np.uint8], NDArray[np.int64], _Integers, _Floats]

__all__ = [
    "KINDS",
    "Bodies",
    "CrossingError",
    "Detector",
    "FrameSequence",
    "HalfSpaces",
    "Mesh",
    "Page",
    "UncertifiedError",
    "Welding",
    "__version__",
    "collides",
    "impact",
    "in_order",
    "intervals",
    "mesh_format",
    "overlaps",
    "parse_mesh",
    "read_mesh",
    "repair",
    "repair_recording",
    "time_and_count",
    "time_of_impact",
    "turns",
]

__version__: str
KINDS: list[tuple[str, int]]

class CrossingError(ValueError):
    edge: int
    face: int

class UncertifiedError(RuntimeError):
    missing: int
    pairs: int
    first: Optional[str]

def collides(queries: _Queries, settings: _Settings) -> NDArray[np.bool_]: ...
def time_of_impact(queries: _Queries, settings: _Settings) -> _Floats: ...
def time_and_count(queries: _Queries, settings: _Settings) -> tuple[_Floats, NDArray[np.int64]]: ...
def intervals(queries: _Queries, settings: _Settings) -> tuple[NDArray[np.int64], _Floats]: ...
def impact(queries: _Queries, settings: _Settings) -> _Floats: ...
def overlaps(
    first: _Integers,
    second: _Integers,
    x0: _Floats,
    x1: _Floats,
    inflation: float,
    threads: Optional[int],
) -> _Integers: ...
def read_mesh(path: _Path) -> tuple[_Floats, _Integers, _Integers]: ...
def parse_mesh(contents: bytes, name: _Path) -> tuple[_Floats, _Integers, _Integers]: ...
def mesh_format(path: _Path) -> Optional[str]: ...
def in_order(paths: Sequence[_Path]) -> list[Path]: ...
def repair(
    mesh: Mesh,
    positions: _Positions,
    pinned: _Integers,
    single: bool,
    settings: tuple[float, int, Optional[float], Optional[int]],
    stop: Optional[Callable[[_Phase, int, int], object]],
) -> tuple[
    _Floats,
    Optional[tuple[int, int]],
    Optional[tuple[_Reason, str]],
    _Integers,
    _PairColumns,
    Optional[dict[str, Any]],
]: ...
def repair_recording(
    mesh: Mesh,
    positions: _Positions,
    pinned: _Integers,
    settings: tuple[float, int, Optional[float], Optional[int]],
    stop: Optional[Callable[[_Phase, int, int], object]],
) -> tuple[_Floats, list[dict[str, Any]], Optional[tuple[int, _Integers, _PairColumns]]]: ...
@final
class FrameSequence:
    def __new__(cls, path: _Path, cache: Optional[_Path] = None) -> FrameSequence: ...
    @staticmethod
    def is_cache(path: _Path) -> bool: ...
    def __len__(self) -> int: ...
    def file(self, frame: int) -> Path: ...
    def read(self, frame: int) -> tuple[_Floats, _Integers, _Integers]: ...

@final
class Welding:
    def __new__(cls) -> Welding: ...
    def restrict(self, positions: _Floats) -> None: ...
    def primitives(self, mesh: Mesh) -> tuple[_Integers, _Integers]: ...
    def along_edges(self, mesh: Mesh) -> None: ...
    def first_vertices(self) -> NDArray[np.int64]: ...

@final
class Mesh:
    def __new__(
        cls,
        vertex_count: int,
        faces: _Integers,
        edges: _Integers,
        groups: Optional[_Integers],
        matrix: Optional[NDArray[np.bool_]],
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
class HalfSpaces:
    def __new__(cls, rows: _Floats) -> HalfSpaces: ...
    def touching(self, positions: _Floats, distances: _Floats) -> Optional[tuple[int, int]]: ...

@final
class Page:
    def __new__(
        cls,
        title: str,
        mesh: Mesh,
        positions: _Floats,
        bodies: list[tuple[str, int, int]],
        ids: Optional[tuple[NDArray[np.int64], NDArray[np.int64]]],
    ) -> Page: ...
    def add_frame(self, label: str, positions: _Floats) -> None: ...
    def html(self, summary: list[str]) -> bytes: ...

@final
class Detector:
    def __new__(
        cls,
        mesh: Mesh,
        min_distance: Union[float, _Floats],
        inner_distance: Optional[float],
        threads: Optional[int],
        start_check: bool,
    ) -> Detector: ...
    def collides(self, x0: _Positions, x1: _Positions, until: float) -> NDArray[np.bool_]: ...
    def collision(self, x0: _Positions, x1: _Positions, until: float) -> _Columns: ...
    def collisions(self, x0: _Positions, x1: _Positions, until: float) -> _Columns: ...
    def free_step(
        self, x0: _Positions, x1: _Positions, keep: float, is_single: bool
    ) -> tuple[_Floats, _Floats, _Columns, NDArray[np.int64]]: ...
    def free_steps(
        self, x0: _Positions, x1: _Positions, keep: float, is_single: bool, pinned: _Integers
    ) -> tuple[_Floats, _Floats, int, _PairColumns]: ...
    def clearances(self, x: _Positions, cut_off: float) -> _Floats: ...
    def step(
        self, x0: _Positions, x1: _Positions, progress: Optional[Callable[[int], object]]
    ) -> tuple[list[NDArray[np.int64]], _Columns]: ...
    def certificate(self, x0: _Positions, x1: _Positions, at_rest: bool, is_continued: bool) -> bytes: ...
    def has_intersections(self, x: _Positions) -> bool: ...
    def intersections(self, x: _Positions, crossing: bool) -> _Integers: ...
    def show_intersections(self, page: Page, x: _Positions) -> None: ...
    def show_contacts(self, page: Page, x0: _Positions, x1: _Positions, all: bool) -> None: ...

@final
class Bodies:
    def __new__(
        cls,
        meshes: Sequence[tuple[Mesh, _Floats]],
        matrix: Optional[NDArray[np.bool_]],
        min_distance: float,
        threads: Optional[int],
    ) -> Bodies: ...
    def collides(self, poses0: _Floats, poses1: _Floats, until: float) -> bool: ...
    def collision(self, poses0: _Floats, poses1: _Floats, until: float) -> _BodyColumns: ...
    def collisions(self, poses0: _Floats, poses1: _Floats, until: float) -> _BodyColumns: ...
    def step(self, poses0: _Floats, poses1: _Floats) -> tuple[list[list[int]], _BodyColumns]: ...
    def distances(self, poses: _Floats, cut_off: float) -> tuple[NDArray[np.int64], _Floats, _Floats]: ...
    def free_step(self, poses0: _Floats, poses1: _Floats, keep: float) -> tuple[float, _Floats, _BodyColumns]: ...

def turns(mesh: Mesh, x0: _Floats, x1: _Floats) -> list[tuple[int, float, float, float]]: ...
