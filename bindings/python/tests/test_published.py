"""The answers for the published data sets agree with the ground truth."""

from __future__ import annotations

import csv
import io
import json
import re
from pathlib import Path

import numpy as np
import pytest

import exact_ccd
from generated import of_points
from published import data, program, read_queries

KINDS = {"vf": "vertex-face", "ee": "edge-edge"}


@pytest.mark.parametrize("kind", KINDS)
def test_handcrafted_queries(kind: str) -> None:
    files = sorted(data().glob(f"handcrafted/*/{KINDS[kind]}/*.csv"))
    assert files
    for file in files:
        points, truth = read_queries(file, kind)
        np.testing.assert_array_equal(of_points(kind, points).collides(), truth, str(file))
        np.testing.assert_array_equal(of_points(kind, points).count() != 0, truth, str(file))
        np.testing.assert_array_equal(~np.isnan(of_points(kind, points).time_of_impact()), truth, str(file))


@pytest.mark.parametrize("kind", ["vf", "ee", "ve", "vv"])
def test_separation(kind: str) -> None:
    files = [file for file in sorted(data().glob(f"separation/{kind}-*.csv")) if ".times" not in file.name]
    assert files
    for file in files:
        d = float(re.search(r"-d([0-9].*)\.csv$", file.name).group(1))
        points, truth = read_queries(file, kind)
        collides = of_points(kind, points).collides(separation=d)
        np.testing.assert_array_equal(collides, truth, str(file))
        times = of_points(kind, points).intervals(separation=d)
        toi = of_points(kind, points).time_of_impact(separation=d)
        impacts = of_points(kind, points).impact(separation=d)
        np.testing.assert_array_equal(impacts["time"], toi)
        counts = of_points(kind, points).count(separation=d)
        with open(file.with_suffix(".times.csv")) as text:
            rows = list(csv.DictReader(text))
        assert [int(row["query"]) for row in rows] == np.flatnonzero(truth).tolist()
        for row in rows:
            query = int(row["query"])
            intervals = [[float(end) for end in part.split(":")] for part in row["intervals"].split()]
            found = times.times[times.offsets[query] : times.offsets[query + 1]]
            assert found.tolist() == intervals, (file, query)
            assert toi[query] == float(row["toi"]), (file, query)
            assert d == 0.0 or counts[query] == int(row["count"]), (file, query)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("scene", ["rod-twist", "cloth-funnel"])
def test_scenes(scene: str, kind: str) -> None:
    folder = data() / "scenes" / scene
    (file,) = folder.glob(f"queries/*{kind}.csv")
    points, _ = read_queries(file, kind)
    (verdicts,) = folder.glob(f"mma_bool/*{kind}_mma_bool.json")
    truth = np.array(json.loads(Path(verdicts).read_text()))
    np.testing.assert_array_equal(of_points(kind, points).collides(), truth)
    toi = of_points(kind, points).time_of_impact()
    times = of_points(kind, points).intervals()
    counts = of_points(kind, points).count()
    with open(folder / "roots" / f"{kind}.csv") as text:
        for row in csv.DictReader(text):
            query = int(row["query"])
            assert toi[query] == float(row["toi"])
            if counts[query] >= 0:
                # Where contact lasts for an interval, the file has its first instant only.
                found = times.times[times.offsets[query] : times.offsets[query + 1], 0]
                assert found.tolist() == [float(time) for time in row["times"].split()]
                assert counts[query] == int(row["count"])


def assert_as_the_program(file: Path, kind: str, min_distance: float) -> None:
    """Verdicts, counts and times of a file of queries are those that the program prints."""
    output = program("queries", "--kind", kind, "--min-distance", repr(min_distance), file)
    rows = list(csv.DictReader(io.StringIO(output)))
    points, _ = read_queries(file, kind)
    collides = of_points(kind, points).collides(separation=min_distance)
    counts = of_points(kind, points).count(separation=min_distance)
    times = of_points(kind, points).time_of_impact(separation=min_distance)
    assert [row["contact"] for row in rows] == [str(int(contact)) for contact in collides.tolist()]
    assert [int(row["count"]) for row in rows] == counts.tolist()
    assert [float(row["toi"] or "nan") for row in rows] == pytest.approx(times.tolist(), rel=0, abs=0, nan_ok=True)


def test_all_files_of_queries_as_the_program() -> None:
    handcrafted = [(file, 0.0) for file in sorted(data().glob("handcrafted/*/*/*.csv"))]
    separation = [file for file in sorted(data().glob("separation/*.csv")) if ".times" not in file.name]
    near = [(file, float(re.search(r"-d([0-9].*)\.csv$", file.name).group(1))) for file in separation]
    assert handcrafted and near
    for file, d in handcrafted + near:
        kind = file.name[:2] if file in separation else {"vertex-face": "vf", "edge-edge": "ee"}[file.parent.name]
        assert_as_the_program(file, kind, d)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("scene", ["cloth-ball", "cloth-funnel", "rod-twist"])
def test_scenes_as_the_program(scene: str, kind: str, tmp_path: Path) -> None:
    parquet = pytest.importorskip("pyarrow.parquet", reason="pyarrow is not installed: pip install pyarrow")
    file = tmp_path / "scene.parquet"
    program("convert", "--kind", kind, "--answers", "-o", file, data() / "scenes" / scene)
    table = parquet.read_table(file)
    answered = exact_ccd.answer_table(table, threads=None)
    assert len(table) > 90
    for answer, expected in (("collides", "truth"), ("count", "count"), ("toi", "toi")):
        assert answered[answer].equals(table[expected]), answer
