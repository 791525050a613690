"""Generated queries with small integer coordinates; many of them are degenerate."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from exact_ccd import Queries
from exact_ccd.queries import POINTS


def queries(kind: str, count: int, seed: int = 0) -> NDArray[np.float64]:
    """The points of queries of a kind, at t = 0, then at t = 1."""
    random = np.random.default_rng(seed)
    return random.integers(-3, 4, (count, 2 * POINTS[kind], 3)).astype(np.float64)


def write_queries(file: Path) -> None:
    """Write queries of all kinds as a Parquet file."""
    import pyarrow as pa
    import pyarrow.parquet

    rows = [(kind, row) for kind in POINTS for row in queries(kind, 20).reshape(20, -1).tolist()]
    kinds, points = zip(*rows)
    pyarrow.parquet.write_table(pa.table({"kind": kinds, "points": points}), file)


def of_points(kind: str, points) -> Queries:
    """The queries with these points, of shape (N, 2 P, 3)."""
    count = points.shape[1] // 2
    return Queries(kind, points[:, :count], points[:, count:])


def of_vertices(kind: str, points: NDArray[np.float64]) -> tuple:
    """The arguments of the same queries by the indices of vertices; each vertex belongs to one query."""
    count, both, _ = points.shape
    half = both // 2
    vertices = np.arange(count * half, dtype=np.uint32).reshape(count, half)
    return kind, points[:, :half].reshape(-1, 3), points[:, half:].reshape(-1, 3), vertices
