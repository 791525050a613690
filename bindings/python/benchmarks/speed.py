"""Speed of the package beside the calls in Rust, and beside ipctk, on the published scenes.

    cargo build --release --package exact-ccd-bench --example python
    python benchmarks/speed.py [--reference ../../target/release/examples/python] [--scenes DIR] [--queries N]

The package must be installed from a release build. All calls of one comparison alternate; each figure is the
fastest of its runs, in seconds. The batches run on one thread, all else on all cores. With `--queries`, N queries
in Parquet files are answered by Ray, and beside it by pyarrow and one batch for each file.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import tempfile
import time
from pathlib import Path
from typing import Any, Callable

import numpy as np

import exact_ccd
from exact_ccd import ipc

ROUNDS = 5
RUNS = 3


def fastest(run: Callable[[], Any], runs: int = RUNS) -> float:
    """The seconds of the fastest of some runs."""

    def seconds() -> float:
        start = time.perf_counter()
        run()
        return time.perf_counter() - start

    return min(seconds() for _ in range(runs))


def scene(folder: Path) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Positions at both ends, and faces."""
    start, end = sorted((folder / "frames").glob("*.ply"), key=lambda file: int("".join(filter(str.isdigit, file.stem))))
    first, second = exact_ccd.read_mesh(start), exact_ccd.read_mesh(end)
    return first.vertices, second.vertices, first.faces


def beside_rust(reference: Path, folder: Path) -> None:
    x0, x1, faces = scene(folder)
    mesh = exact_ccd.Mesh(x0, faces)
    candidates = ipc.Candidates()
    flat = type("Mesh", (), {"num_vertices": len(x0), "edges": mesh.edges, "faces": faces})()
    candidates.build(flat, x0, x1)
    pairs = candidates.pairs["ee"]
    indices = np.resize(pairs, (1_000_000, 4))
    queries = exact_ccd.Queries("ee", x0, x1, indices)
    points = exact_ccd.Queries("ee", x0[indices], x1[indices])
    detector = exact_ccd.Detector(mesh)
    calls = {
        "indices": lambda: queries.collides(threads=1),
        "points": lambda: points.collides(threads=1),
        "collision": lambda: detector.collision(x0, x1),
    }
    best = {name: {"rust": np.inf, "python": np.inf} for name in calls}
    with tempfile.TemporaryDirectory() as raw:
        for name, array in {"indices": indices, "x0": x0, "x1": x1, "faces": faces}.items():
            array.tofile(Path(raw) / name)
        for _ in range(ROUNDS):
            rust = json.loads(subprocess.check_output([reference, raw, str(RUNS)]))
            for name, call in calls.items():
                best[name]["rust"] = min(best[name]["rust"], rust[name])
                best[name]["python"] = min(best[name]["python"], fastest(call))
    print(f"{folder.name}: {len(pairs)} pairs of edges, repeated to {len(indices)} queries")
    for name, times in best.items():
        print(f"  {name:18} rust {times['rust']:.5f}  python {times['python']:.5f}  "
              f"ratio {times['python'] / times['rust']:.3f}")


def beside_ipctk(folder: Path) -> None:
    import ipctk

    x0, x1, faces = scene(folder)
    edges = exact_ccd.Mesh(x0, faces).edges.astype(np.int32)
    mesh = ipctk.CollisionMesh(x0, edges, faces.astype(np.int32))
    print(f"{folder.name}: {len(faces)} faces")
    for name in ("is_step_collision_free", "compute_collision_free_stepsize"):
        ours, theirs = getattr(ipc, name), getattr(ipctk, name)
        best = [np.inf, np.inf]
        for _ in range(ROUNDS):
            best[0] = min(best[0], fastest(lambda: ours(mesh, x0, x1), 1))
            best[1] = min(best[1], fastest(lambda: theirs(mesh, x0, x1), 1))
        print(f"  {name:32} exact_ccd {best[0]:.5f}  ipctk {best[1]:.5f}  ratio {best[1] / best[0]:.1f}")


def beside_pyarrow(folder: Path, count: int) -> None:
    import pyarrow as pa
    import pyarrow.parquet as parquet
    import ray
    import ray.data

    from exact_ccd.ray import answer_files

    x0, x1, faces = scene(folder)
    mesh = exact_ccd.Mesh(x0, faces)
    candidates = ipc.Candidates()
    candidates.build(type("Mesh", (), {"num_vertices": len(x0), "edges": mesh.edges, "faces": faces})(), x0, x1)
    pairs = candidates.pairs["ee"]
    per_file = 250_000
    with tempfile.TemporaryDirectory() as data:
        for first in range(0, count, per_file):
            rows = np.arange(first, min(first + per_file, count)) % len(pairs)
            points = np.concatenate([x0[pairs[rows]], x1[pairs[rows]]], axis=1)
            offsets = pa.array(np.arange(0, points.size + 1, 24, dtype=np.int32))
            lists = pa.ListArray.from_arrays(offsets, pa.array(points.ravel()))
            table = pa.table({"kind": pa.array(["ee"] * len(rows)), "points": lists})
            parquet.write_table(table, Path(data) / f"{first}.parquet", row_group_size=1 << 16)
        # By default, the processes of Ray yield to all others.
        os.environ.setdefault("RAY_worker_niceness", "0")
        ray.init(log_to_driver=False)
        ray.data.DataContext.get_current().enable_progress_bars = False

        def by_pyarrow() -> int:
            tables = (parquet.read_table(file) for file in Path(data).iterdir())
            answers = (exact_ccd.answer_table(table, answers=["collides"], threads=None) for table in tables)
            return sum(int(np.count_nonzero(table["collides"])) for table in answers)

        def by_ray() -> int:
            answered = answer_files(data, answers=["collides"]).select_columns(["collides"])
            blocks = answered.iter_batches(batch_size=None, batch_format="pyarrow")
            return sum(int(np.count_nonzero(table["collides"])) for table in blocks)

        assert by_ray() == by_pyarrow()
        best = [np.inf, np.inf]
        for _ in range(RUNS):
            best[0] = min(best[0], fastest(by_pyarrow, 1))
            best[1] = min(best[1], fastest(by_ray, 1))
        ray.shutdown()
    print(f"{count} queries in Parquet: pyarrow and batches {best[0]:.2f}  answer_files {best[1]:.2f}  "
          f"ratio {best[1] / best[0]:.2f}")


def main() -> None:
    data = Path(os.environ.get("EXACT_CCD_DATA", "../../../shared/data"))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--reference", type=Path, default=Path("../../target/release/examples/python"))
    parser.add_argument("--scenes", type=Path, default=data / "scenes")
    parser.add_argument("--queries", type=int, default=0)
    arguments = parser.parse_args()
    if arguments.queries:
        beside_pyarrow(arguments.scenes / "rod-twist", arguments.queries)
        return
    beside_rust(arguments.reference, arguments.scenes / "rod-twist")
    for name in ("rod-twist", "cloth-ball", "cloth-funnel"):
        beside_ipctk(arguments.scenes / name)


if __name__ == "__main__":
    main()
