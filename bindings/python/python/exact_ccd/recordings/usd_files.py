"""Recordings in USD: time samples of the points of a mesh."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Optional

import numpy as np
from numpy.typing import NDArray
from pxr import Tf, Usd, UsdGeom, UsdSkel

from .topology import check_constant, topology


class UsdFrames:
    """The frames of one mesh: one at each time sample of its points and of the transforms around it."""

    def __init__(self, path: str, prim: Optional[str] = None) -> None:
        self._path, self._prim = path, prim
        self._stage: Any = None
        self._mesh: Any = None
        self._prim = str(self._geometry().GetPath())
        mesh = self._geometry()
        if mesh.GetPrim().HasAPI(UsdSkel.BindingAPI):
            raise ValueError(f"{path}: {self._prim} is moved by a skeleton, which is not evaluated: bake it to points")
        self._codes = self._time_codes() or [Usd.TimeCode.Default()]
        self._is_identity = all(self._transform(code) is None for code in self._codes)
        rate = mesh.GetPrim().GetStage().GetTimeCodesPerSecond()
        seconds = [code.GetValue() / rate for code in self._numbered()]
        self.times: Optional[NDArray[np.float64]] = np.array(seconds) if seconds else None
        counts, corners = self._cells(self._codes[0])
        for code in self._codes[1:]:
            for own, other in zip((counts, corners), self._cells(code)):
                check_constant(f"{path}, time code {code}", own, other)
        self.faces, self.edges = topology(self.positions(0), corners, counts=counts)

    def _geometry(self) -> Any:
        """The mesh."""
        if self._mesh is None:
            try:
                # Its primitives are valid as long as the stage exists.
                self._stage = Usd.Stage.Open(self._path)
            except Tf.ErrorException as error:
                raise ValueError(f"{self._path}: the contents are no USD: {error}") from error
            meshes = [UsdGeom.Mesh(prim) for prim in self._stage.Traverse() if prim.IsA(UsdGeom.Mesh)]
            found = [mesh for mesh in meshes if self._prim in (None, str(mesh.GetPath()))]
            if len(found) != 1:
                names = [str(mesh.GetPath()) for mesh in meshes]
                raise ValueError(f"{self._path}: the meshes are {', '.join(names) or 'none'}; name one by prim=PATH")
            self._mesh = found[0]
        return self._mesh

    def __getstate__(self) -> dict[str, Any]:
        # Time codes are numbers, or the default without samples.
        return {**self.__dict__, "_stage": None, "_mesh": None, "_codes": [code.GetValue() for code in self._numbered()]}

    def __setstate__(self, state: dict[str, Any]) -> None:
        codes = [Usd.TimeCode(code) for code in state["_codes"]] or [Usd.TimeCode.Default()]
        self.__dict__.update(state, _codes=codes)

    def _numbered(self) -> list[Any]:
        return [code for code in self._codes if not code.IsDefault()]

    def _time_codes(self) -> list[Any]:
        """The times of all samples, in order."""
        times = set(self._geometry().GetPointsAttr().GetTimeSamples())
        prim = self._geometry().GetPrim()
        while prim:
            if prim.IsA(UsdGeom.Xformable):
                times.update(UsdGeom.Xformable(prim).GetTimeSamples())
            prim = prim.GetParent()
        return [Usd.TimeCode(time) for time in sorted(times)]

    def _cells(self, code: Any) -> tuple[NDArray[Any], NDArray[Any]]:
        """The numbers of corners of the faces at a time, and their corners."""
        mesh = self._geometry()
        found = (mesh.GetFaceVertexCountsAttr().Get(code), mesh.GetFaceVertexIndicesAttr().Get(code))
        if None in found:
            raise ValueError(f"{self._path}: {self._prim} has no faces")
        counts, corners = (np.asarray(values, np.int64) for values in found)
        return counts, corners

    def _transform(self, code: Any) -> Optional[NDArray[np.float64]]:
        """The transform of the mesh to the world at a time; None if it moves nothing."""
        matrix = np.array(UsdGeom.XformCache(code).GetLocalToWorldTransform(self._geometry().GetPrim()))
        return None if np.array_equal(matrix, np.eye(4)) else matrix

    def __len__(self) -> int:
        return len(self._codes)

    def positions(self, index: int) -> NDArray[Any]:
        """The positions of a frame in the world."""
        code = self._codes[index]
        points = self._geometry().GetPointsAttr().Get(code)
        if points is None:
            raise ValueError(f"{self._path}: {self._prim} has no points at the time code {code}")
        local: NDArray[Any] = np.array(points).reshape(-1, 3)
        if self._is_identity:
            return local
        matrix = self._transform(code)
        if matrix is None:
            return local.astype(np.float64)
        # USD multiplies a row by a matrix: the products of x, y and z are added in this order, then the translation.
        x, y, z = (local[:, axis, None].astype(np.float64) for axis in range(3))
        moved: NDArray[Any] = x * matrix[0, :3] + y * matrix[1, :3] + z * matrix[2, :3] + matrix[3, :3]
        return moved

    def identity(self) -> list[Any]:
        """The path, the size and the time of change; a file that it refers to is not among them."""
        state = Path(self._path).stat()
        return [self._prim, (self._path, state.st_size, state.st_mtime_ns)]
