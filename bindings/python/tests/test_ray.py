"""Audits and data sets on a Ray cluster of two nodes on this machine."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import exact_ccd
from exact_ccd import AuditReport
from exact_ccd.queries import POINTS
from documents import PROGRAMS, needs_ray, run
from generated import of_points, queries, write_queries
from hostile import CASES, integers, positions, survive, table

# No reports to the makers of Ray.
os.environ["RAY_USAGE_STATS_ENABLED"] = "0"
pytest.importorskip("ray", reason="ray is not installed: pip install 'ray[data]'")
pytest.importorskip("pyarrow", reason="pyarrow is not installed: pip install pyarrow")
if sys.platform != "linux":
    pytest.skip("processes of tasks are found in /proc, which only Linux has", allow_module_level=True)

import pyarrow as pa
import pyarrow.fs
import pyarrow.parquet
import ray
from ray.cluster_utils import Cluster

import exact_ccd.ray

SIDE = 16
"""The number of vertices along a side of each of two sheets."""
GRID = np.arange(SIDE * SIDE).reshape(SIDE, SIDE)
CORNERS = [GRID[:-1, :-1], GRID[1:, :-1], GRID[1:, 1:], GRID[:-1, 1:]]
A, B, C, D = (corner.ravel() for corner in CORNERS)
SHEET = np.concatenate([np.stack([A, B, C], 1), np.stack([A, C, D], 1)])
FACES = np.concatenate([SHEET, SHEET + GRID.size])


def recording(count: int, contact: int | None = None) -> np.ndarray:
    """Frames of two sheets with waves, above each other; they meet after the frame `contact`."""
    x, y = np.meshgrid(np.arange(SIDE, dtype=float), np.arange(SIDE, dtype=float), indexing="ij")
    frames = np.empty((count, 2, GRID.size, 3))
    for number in range(count):
        wave = np.sin(0.7 * x + 0.05 * number) * np.cos(0.6 * y)
        gap = 2.5 if contact is None or number <= contact else 1.0
        frames[number, 0] = np.stack([x, y, wave], -1).reshape(-1, 3)
        frames[number, 1] = np.stack([x + 0.3, y, gap - wave], -1).reshape(-1, 3)
    return frames.reshape(count, -1, 3)


def same(a: AuditReport, b: AuditReport) -> bool:
    """Return True if all bits are the same."""
    from exact_ccd.ray.chunks import to_json

    return to_json(a) == to_json(b)


@pytest.fixture(scope="module")
def cluster():
    """Two nodes of one core each: this process is connected to the first."""
    node = {"num_cpus": 1, "object_store_memory": 2**28}
    try:
        started = Cluster(initialize_head=True, head_node_args=node)
        started.add_node(**node)
    except Exception as error:
        # Its processes end by themselves if they do not start within half a minute.
        pytest.skip(f"Ray does not start on this machine, or not in time: {error}")
    # The processes of tasks find the modules where this one does.
    environment = {"env_vars": {"PYTHONPATH": os.pathsep.join(filter(None, sys.path))}}
    ray.init(address=started.address, log_to_driver=False, runtime_env=environment)
    started.wait_for_nodes()
    yield started
    ray.shutdown()
    started.shutdown()


def test_a_recording_of_the_caller(cluster, tmp_path: Path) -> None:
    frames = recording(9, contact=5)

    class Own:
        faces, times = FACES, None

        def __len__(self) -> int:
            return len(frames)

        def positions(self, index: int) -> np.ndarray:
            return frames[index]

    expected = exact_ccd.audit(frames, FACES)
    assert expected.violation is not None
    assert same(exact_ccd.ray.audit(Own(), steps=2), expected)
    with pytest.raises(ValueError, match="give the recording a method `identity`"):
        exact_ccd.ray.audit(Own(), results=tmp_path)


def test_a_recording_in_hdf5(cluster, tmp_path: Path) -> None:
    h5py = pytest.importorskip("h5py", reason="h5py is not installed: pip install h5py")
    frames = recording(9, contact=5)
    with h5py.File(tmp_path / "motion.h5", "w") as file:
        file["positions"], file["faces"] = frames, FACES
    expected = exact_ccd.audit(frames, FACES)
    for _ in range(2):
        assert same(exact_ccd.ray.audit(tmp_path / "motion.h5", steps=2, results=tmp_path / "results"), expected)


@pytest.mark.parametrize("steps", [499, 125, 32])
def test_any_number_of_chunks(cluster, steps: int) -> None:
    frames = recording(500, 471)
    # Two earlier violations at other times of their steps.
    frames[390:, GRID.size + 20, 2] -= 4.0
    frames[400:, GRID.size + 40, 2] -= 4.0
    expected = exact_ccd.audit(frames, FACES)
    assert expected.violation.frame == 389
    done = []
    report = exact_ccd.ray.audit(frames, FACES, steps=steps, progress=done.append)
    assert same(report, expected)
    # In the chunk of the violation and before, at least.
    assert sum(done) >= 389


def test_groups_rules_and_half_spaces(cluster, tmp_path) -> None:
    frames = recording(12, 6)
    groups = np.zeros(2 * GRID.size, int)
    settings = [
        {"groups": groups},
        {"can_collide": lambda i, j: abs(i - j) < 3},
        {"groups": groups, "half_spaces": [[[0, 0, -0.99], [0, 0, 1]]]},
        {"groups": groups, "can_collide": [[True]], "names": ["both"]},
        {"weld": True},
    ]
    for given in settings:
        assert same(exact_ccd.ray.audit(frames, FACES, steps=3, **given), exact_ccd.audit(frames, FACES, **given))
    assert exact_ccd.ray.audit(frames, FACES, steps=3, groups=groups, results=tmp_path).is_free
    named = {"groups": groups, "can_collide": [[True]], "names": ["both"], "results": tmp_path}
    reports = [exact_ccd.ray.audit(frames, FACES, steps=3, **named) for _ in range(2)]
    assert reports[0] == reports[1] and reports[0].violation.places[0].body == "both"
    # Other settings have other results.
    assert not exact_ccd.ray.audit(frames, FACES, steps=3, results=tmp_path).is_free
    with pytest.raises(ValueError, match="results are not kept for a function"):
        exact_ccd.ray.audit(frames, FACES, can_collide=lambda i, j: True, results=tmp_path)


def test_a_violation_at_rest_or_in_the_first_step(cluster) -> None:
    for shift in (0, 1):
        frames = recording(9)
        frames[shift:, GRID.size :, 2] -= 2.0
        expected = exact_ccd.audit(frames, FACES)
        assert expected.frames == shift + 1
        assert same(exact_ccd.ray.audit(frames, FACES, steps=2), expected)
    assert same(exact_ccd.ray.audit(recording(1), FACES), exact_ccd.audit(recording(1), FACES))


def test_an_error_counts_in_its_place(cluster) -> None:
    frames = recording(60, 30)
    frames[40, 5, 1] = np.nan
    assert exact_ccd.ray.audit(frames, FACES, steps=5).violation.frame == 30
    frames[20, 7, 2] = np.inf
    with pytest.raises(ValueError, match="frame 20: .*vertex 7 has z = inf"):
        exact_ccd.ray.audit(frames, FACES, steps=5)
    with pytest.raises(ValueError, match="steps and window"):
        exact_ccd.ray.audit(frames, FACES, steps=0)
    with pytest.raises(ValueError, match="there are no frames"):
        exact_ccd.ray.audit(frames[:0], FACES)
    with pytest.raises(TypeError, match="expected the faces"):
        exact_ccd.ray.audit(frames)
    with pytest.raises(ValueError, match="min_distance has a number that is not exactly a float64"):
        exact_ccd.ray.audit(frames, FACES, min_distance=2**53 + 1)
    with pytest.raises(TypeError, match="frames is a masked array"):
        exact_ccd.ray.audit(np.ma.array(frames), FACES)


def write_frames(folder: Path, frames: np.ndarray) -> None:
    faces = "".join(f"f {a} {b} {c}\n" for a, b, c in (FACES + 1).tolist())
    for number, frame in enumerate(frames):
        vertices = "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in frame.tolist())
        (folder / f"frame{number}.obj").write_text(vertices + faces)


def test_files_and_file_systems(cluster, tmp_path) -> None:
    folder = tmp_path / "frames"
    folder.mkdir()
    frames = recording(12, 10)
    write_frames(folder, frames)
    expected = exact_ccd.audit(frames, FACES)
    assert same(exact_ccd.audit(folder), expected)
    within = pyarrow.fs.SubTreeFileSystem(str(tmp_path), pyarrow.fs.LocalFileSystem())
    assert same(exact_ccd.ray.audit(folder, steps=3), expected)
    assert same(exact_ccd.ray.audit(f"file://{folder}", steps=3), expected)
    assert same(exact_ccd.ray.audit("frames", filesystem=within, steps=3), expected)
    listed = [folder / f"frame{number}.obj" for number in range(12)]
    assert same(exact_ccd.ray.audit(listed, steps=3), expected)
    assert same(exact_ccd.ray.audit([f"file://{file}" for file in listed], steps=3), expected)
    np.savez(tmp_path / "frames.npz", positions=frames, faces=FACES)
    assert same(exact_ccd.ray.audit(tmp_path / "frames.npz", steps=3), expected)


def test_finished_chunks_are_not_repeated(cluster, tmp_path) -> None:
    class Stopped(Exception):
        pass

    frames = recording(40, 35)
    done: list[int] = []

    def stop(count: int) -> None:
        done.append(count)
        if len(done) == 5:
            raise Stopped

    with pytest.raises(Stopped):
        exact_ccd.ray.audit(frames, FACES, steps=4, window=1, results=tmp_path, progress=stop)
    files = sorted(tmp_path.iterdir())
    assert len(files) == 5
    # A known result is not computed again: this one is wrong, and the answer shows it.
    expected = exact_ccd.audit(frames, FACES)
    assert same(exact_ccd.ray.audit(frames, FACES, steps=4, results=tmp_path), expected)
    files[0].write_text('{"frames": 3, "violation": {"frame": 1, "contact": null, "intersection": [7, 8]}}')
    known = exact_ccd.ray.audit(frames, FACES, steps=4, results=tmp_path)
    assert known.violation.intersection == (7, 8)
    # Another recording has other files in the same folder.
    frames[3, 0, 0] += 1e-9
    other = exact_ccd.ray.audit(frames, FACES, steps=4, results=tmp_path)
    assert same(other, exact_ccd.audit(frames, FACES))


def test_certificates_in_parts(cluster, tmp_path) -> None:
    for count, violation in [(12, 10), (12, 13), (9, 5)]:
        frames = recording(count, violation)
        exact_ccd.audit(frames, FACES, certificate=tmp_path / "whole")
        expected = (tmp_path / "whole").read_bytes()
        for steps in (1, 4, 100):
            # The second audit of a pair takes the parts that the first one has kept.
            for _ in range(2):
                given = {"steps": steps, "results": tmp_path / "results", "certificate": tmp_path / "parts"}
                assert same(exact_ccd.ray.audit(frames, FACES, **given), exact_ccd.audit(frames, FACES))
                assert (tmp_path / "parts").read_bytes() == expected
                (tmp_path / "parts").unlink()
    with pytest.raises(ValueError, match="nothing can be proved of a single frame"):
        exact_ccd.ray.audit(recording(1), FACES, certificate=tmp_path / "parts")


def test_data_sets(cluster, tmp_path) -> None:
    for kind in POINTS:
        points = queries(kind, 500)
        lists = pa.array(list(points.reshape(500, -1)), pa.list_(pa.float64()))
        table = pa.table({"kind": [kind] * 500, "points": lists, "id_a": np.arange(500)})
        pyarrow.parquet.write_table(table, tmp_path / f"{kind}.parquet", row_group_size=100)
    answered = exact_ccd.ray.answer_files(tmp_path)
    rows = pa.concat_tables(ray.get(answered.to_arrow_refs())).to_pandas()
    for kind in POINTS:
        part = rows[rows["kind"] == kind].sort_values("id_a")
        points = queries(kind, 500)
        np.testing.assert_array_equal(part["collides"], of_points(kind, points).collides())
        np.testing.assert_array_equal(part["count"], of_points(kind, points).count())
        np.testing.assert_array_equal(part["toi"], of_points(kind, points).time_of_impact())


def test_the_program(cluster, tmp_path) -> None:
    def run(*arguments: object) -> tuple[int, str, str]:
        command = [sys.executable, "-m", "exact_ccd.ray_program", "--address", cluster.address, *map(str, arguments)]
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
        # Relative paths begin at the working directory of this process, not of the processes of the cluster.
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, env=environment, timeout=300)
        return done.returncode, done.stdout, done.stderr

    np.savez(tmp_path / "frames.npz", positions=recording(12, 10), faces=FACES)
    status, output, errors = run("audit", "frames.npz", "--steps", 4)
    assert status == 1, errors
    assert json.loads(output)["violation"]["frame"] == 10
    points = queries("vf", 300)
    lists = pa.array(list(points.reshape(300, -1)), pa.list_(pa.float64()))
    truth = of_points("vf", points).collides()
    table = pa.table({"kind": ["vf"] * 300, "points": lists, "truth": truth ^ (np.arange(300) < 2)})
    pyarrow.parquet.write_table(table, tmp_path / "queries.parquet")
    status, output, errors = run("queries", "queries.parquet", "--output", "answers")
    assert status == 0, errors
    assert json.loads(output) == {"queries": 300, "colliding": int(truth.sum()), "wrong": 2}
    answers = pyarrow.parquet.read_table(tmp_path / "answers")
    assert sorted(answers["collides"].to_pylist()) == sorted(truth.tolist())
    status, _, errors = run("queries", "queries.parquet", "--output", "answers")
    assert status == 2 and "answers is not empty" in errors
    assert run("audit", tmp_path / "missing.ply")[0] == 2
    # An error in the task of a data set is no violation.
    pyarrow.parquet.write_table(table.set_column(1, "points", pa.array([[0.0] * 23] * 300)), tmp_path / "bad.parquet")
    status, _, errors = run("queries", "bad.parquet")
    assert status == 2 and "23 coordinates" in errors


@pytest.mark.parametrize("name", [name for name, code in PROGRAMS.items() if needs_ray(code)])
def test_programs_of_the_documentation(cluster, name: str, tmp_path) -> None:
    for folder in ("frames", "queries"):
        (tmp_path / folder).mkdir()
    write_frames(tmp_path / "frames", recording(5))
    write_queries(tmp_path / "queries" / "queries.parquet")
    path = os.pathsep.join(filter(None, sys.path))
    run(PROGRAMS[name], tmp_path, RAY_ADDRESS=cluster.address, PYTHONPATH=path)


def test_hostile_arguments(cluster, tmp_path) -> None:
    random = np.random.default_rng(1)
    answers = 0
    for _ in range(CASES):
        frames = [positions(random, 6, 3) for _ in range(3)]
        faces = integers(random, 6, 3, 3)
        edges = [None, integers(random, 6, 2, 2)][random.integers(2)]
        options = {
            "min_distance": [0.0, 0.0, 1.0, -1.0, np.nan, "a"][random.integers(6)],
            "steps": [1, 1, 2, 2**70, 0, -1, 1.5, None][random.integers(8)],
            "window": [None, None, 1, 2**70, 0][random.integers(5)],
            "results": [None, tmp_path][random.integers(2)],
        }
        answers += survive(lambda: exact_ccd.ray.audit(frames, faces, edges=edges, **options))
    assert 0 < answers < CASES

    def decide(rows) -> None:
        d = float(random.choice([0.0, 1.0, np.nan, -1.0], p=[0.6, 0.2, 0.1, 0.1]))
        try:
            pyarrow.parquet.write_table(rows, tmp_path / "rows.parquet")
            answered = exact_ccd.ray.answer_files(tmp_path / "rows.parquet", separation=d)
            answered.materialize()
        except (pa.ArrowException, ray.exceptions.RayError) as error:
            # An exception of the task, not the end of its process.
            assert not isinstance(error, ray.exceptions.WorkerCrashedError)
            raise ValueError(str(error)) from error

    answers = sum(survive(lambda: decide(table(random))) for _ in range(CASES))
    assert 0 < answers < CASES


def processes_of_tasks(raylet: int) -> list[int]:
    """The processes of a node that examine a chunk now."""
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            if parent_of(folder) == raylet and b"ray::examine_chunk" in (folder / "cmdline").read_bytes():
                found.append(int(folder.name))
        except (OSError, ValueError):
            continue
    return found


def parent_of(process: Path) -> int:
    """The parent of a process, by its folder in /proc."""
    return int((process / "stat").read_text().rsplit(")", 1)[1].split()[1])


def raylet_of(node) -> int:
    return node.all_processes["raylet"][0].process.pid


def test_a_worker_and_a_node_are_lost(cluster) -> None:
    # The last test: the cluster has one node afterwards, and Ray takes a while to notice it.
    frames = recording(500, 480)
    expected = exact_ccd.audit(frames, FACES)
    lost: list[str] = []

    def kill() -> None:
        """Kill a process at work on the first node, then the second node while it is at work."""
        first, second = cluster.head_node, cluster.list_all_nodes()[-1]
        deadline = time.monotonic() + 60
        while not lost and time.monotonic() < deadline:
            for process in processes_of_tasks(raylet_of(first)):
                os.kill(process, signal.SIGKILL)
                lost.append("worker")
                break
            time.sleep(0.001)
        while len(lost) == 1 and time.monotonic() < deadline:
            if processes_of_tasks(raylet_of(second)):
                cluster.remove_node(second, allow_graceful=False)
                lost.append("node")
            time.sleep(0.001)

    killer = threading.Thread(target=kill)
    killer.start()
    done: list[int] = []
    report = exact_ccd.ray.audit(frames, FACES, steps=25, progress=done.append)
    killer.join()
    assert lost == ["worker", "node"]
    assert same(report, expected)
    assert report.violation.frame == 480
