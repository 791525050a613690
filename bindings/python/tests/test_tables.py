"""Tables of Arrow."""

from __future__ import annotations

import sys

import numpy as np
import pytest

import exact_ccd
from exact_ccd.queries import POINTS
from exact_ccd.tables import _points
from generated import of_points, queries
from published import program

pa = pytest.importorskip("pyarrow", reason="pyarrow is not installed: pip install pyarrow")


def table_of(kind: str, count: int, seed: int = 0):
    """A table of generated queries, and their points."""
    points = queries(kind, count, seed)
    lists = pa.array(list(points.reshape(count, -1)), pa.list_(pa.float64()))
    return pa.table({"kind": [kind] * count, "points": lists, "id_a": np.arange(count)}), points


def mixed(count: int):
    """A table of queries of all kinds in random order, in three chunks, and the expected answers."""
    parts = [table_of(kind, count) for kind in POINTS]
    order = np.random.default_rng(0).permutation(count * len(parts))
    table = pa.concat_tables([table for table, _ in parts]).combine_chunks().take(pa.array(order))
    table = pa.concat_tables([table.slice(0, 7), table.slice(7, count), table.slice(7 + count)])
    times = [of_points(kind, points).time_of_impact() for kind, (_, points) in zip(POINTS, parts)]
    counts = [of_points(kind, points).count() for kind, (_, points) in zip(POINTS, parts)]
    return table, np.concatenate(times)[order], np.concatenate(counts)[order]


def assert_answers(table, times, counts) -> None:
    """The columns have these answers."""
    expected = [None if np.isnan(time) else time for time in times.tolist()]
    assert table["toi"].to_pylist() == expected
    assert table["count"].to_pylist() == counts.tolist()
    assert table["collides"].to_pylist() == [time is not None for time in expected]


@pytest.mark.parametrize("kind", POINTS)
def test_one_kind(kind: str) -> None:
    table, points = table_of(kind, 300)
    answered = exact_ccd.answer_table(table)
    assert answered.column_names == ["kind", "points", "id_a", "collides", "count", "toi"]
    assert_answers(answered, of_points(kind, points).time_of_impact(), of_points(kind, points).count())
    without = exact_ccd.answer_table(table.drop_columns("kind"), kind=kind)
    assert without["toi"].equals(answered["toi"])
    for answers in (["toi"], ["collides"], ["collides", "toi"], []):
        assert exact_ccd.answer_table(table, answers=answers).equals(
            answered.select(table.column_names + answers)
        )
    near = exact_ccd.answer_table(table, separation=0.5, threads=None)
    assert near["toi"].to_numpy(zero_copy_only=False).tobytes() == (
        of_points(kind, points).time_of_impact(separation=0.5).tobytes()
    )


def test_mixed_kinds_and_chunks() -> None:
    table, times, counts = mixed(200)
    assert_answers(exact_ccd.answer_table(table), times, counts)
    batch = table.combine_chunks().to_batches()[0]
    answered = exact_ccd.answer_table(batch.slice(5, 60))
    assert isinstance(answered, pa.RecordBatch)
    assert_answers(answered, times[5:65], counts[5:65])
    # Answers of before are replaced.
    assert exact_ccd.answer_table(answered).equals(answered)
    assert exact_ccd.answer_table(batch.slice(0, 0)).num_rows == 0
    assert exact_ccd.answer_table(table.slice(0, 0)).num_rows == 0


@pytest.mark.parametrize("form", ["large", "fixed", "float32", "dictionary"])
def test_other_types_of_columns(form: str) -> None:
    table, points = table_of("ee", 100)
    types = {"large": pa.large_list(pa.float64()), "fixed": pa.list_(pa.float64(), 24), "float32": pa.list_(pa.float32())}
    expected = exact_ccd.answer_table(table, answers=["toi"])["toi"]
    if form in types:
        table = table.set_column(1, "points", table["points"].cast(types[form]))
    else:
        table = table.set_column(0, "kind", table["kind"].dictionary_encode())
    for part in (table, table.slice(20)):
        assert exact_ccd.answer_table(part)["toi"].to_pylist() == expected.to_pylist()[-len(part) :]


@pytest.mark.parametrize("kind", POINTS)
@pytest.mark.parametrize("is_fixed", [False, True])
def test_points_are_not_copied(kind: str, is_fixed: bool) -> None:
    table, points = table_of(kind, 50)
    width = points[0].size
    lists = table["points"].chunk(0)
    if is_fixed:
        lists = pa.FixedSizeListArray.from_arrays(lists.flatten(), width)
    view = _points(kind, lists.slice(10, 30), np.arange(10, 40))
    np.testing.assert_array_equal(view, points[10:40])
    assert view.ctypes.data == lists.flatten().buffers()[1].address + 10 * width * 8


def test_the_files_of_convert(tmp_path) -> None:
    import pyarrow.parquet as parquet

    points = queries("vf", 40).reshape(-1, 3)
    rows = "".join(",".join(f"{int(x)},1" for x in point) + "\n" for point in points)
    (tmp_path / "queries.csv").write_text(rows)
    files = [tmp_path / "plain.parquet", tmp_path / "answered.parquet"]
    for file, answers in zip(files, ([], ["--answers"])):
        program("convert", "--kind", "vf", *answers, "-o", file, tmp_path / "queries.csv")
    plain, answered = (parquet.read_table(file) for file in files)
    assert exact_ccd.answer_table(plain, answers=["count", "toi"]).equals(answered)


def test_polars() -> None:
    polars = pytest.importorskip("polars", reason="polars is not installed: pip install polars")
    table, times, counts = mixed(50)
    for frame in (polars.from_arrow(table), polars.from_arrow(table).with_columns(polars.col("kind").cast(polars.Categorical))):
        answered = exact_ccd.answer_table(frame)
        assert isinstance(answered, polars.DataFrame)
        assert_answers(answered.to_arrow(), times, counts)
    table, points = table_of("vv", 20)
    fixed = polars.from_arrow(table).with_columns(polars.col("points").list.to_array(12))
    assert_answers(
        exact_ccd.answer_table(fixed).to_arrow(), of_points("vv", points).time_of_impact(), of_points("vv", points).count()
    )


def test_duckdb() -> None:
    duckdb = pytest.importorskip("duckdb", reason="duckdb is not installed: pip install duckdb")
    table, times, counts = mixed(50)
    with duckdb.connect() as connection:
        connection.register("queries", table)
        answered = exact_ccd.answer_table(connection.sql("select * from queries"))
        assert_answers(answered, times, counts)
        connection.register("answered", answered)
        ((colliding,),) = connection.sql("select count(*) from answered where collides").fetchall()
    assert colliding == (~np.isnan(times)).sum()


def test_errors() -> None:
    table, points = table_of("vf", 10)
    lists = table["points"].to_pylist()

    def with_points(row: int, value) -> pa.Table:
        return table.set_column(1, "points", pa.array([*lists[:row], value, *lists[row + 1 :]]))

    with pytest.raises(ValueError, match="no column 'points'"):
        exact_ccd.answer_table(table.drop_columns("points"))
    with pytest.raises(ValueError, match="no column 'kind'"):
        exact_ccd.answer_table(table.drop_columns("kind"))
    with pytest.raises(TypeError, match="the type int64"):
        exact_ccd.answer_table(table.set_column(1, "points", table["id_a"]))
    with pytest.raises(TypeError, match="points has the dtype"):
        exact_ccd.answer_table(table.set_column(1, "points", pa.array([["x"] * 24] * 10)))
    with pytest.raises(ValueError, match="row 4: the points are null"):
        exact_ccd.answer_table(with_points(4, None))
    with pytest.raises(ValueError, match="row 5: a coordinate is null"):
        exact_ccd.answer_table(with_points(5, [None, *lists[5][1:]]))
    with pytest.raises(ValueError, match='row 6: 23 coordinates, expected 24 for "vf"'):
        exact_ccd.answer_table(with_points(6, lists[6][1:]))
    infinite = with_points(7, [np.inf, *lists[7][1:]])
    for wrong in (infinite, pa.concat_tables([infinite.slice(0, 3), infinite.slice(3)])):
        with pytest.raises(ValueError, match="row 7: a coordinate is not finite"):
            exact_ccd.answer_table(wrong)
    with pytest.raises(ValueError, match="row 2: kind 'xy'"):
        exact_ccd.answer_table(table.set_column(0, "kind", pa.array(["vf", "vf", "xy"] + ["vf"] * 7)))
    with pytest.raises(ValueError, match="row 1: the kind is null"):
        exact_ccd.answer_table(table.set_column(0, "kind", pa.array(["vf", None] + ["vf"] * 8)))
    exact = pa.array([[0] * 12] * 2, pa.list_(pa.int64()))
    large = pa.array([[0] * 12, [2**53 + 1] + [0] * 11], pa.list_(pa.int64()))
    with pytest.raises(ValueError, match="row 3 of points has a number that is not exactly a float64"):
        exact_ccd.answer_table(pa.table({"kind": ["vv"] * 4, "points": pa.chunked_array([exact, large])}))
    with pytest.raises(ValueError, match="answer 'time'"):
        exact_ccd.answer_table(table, answers=["time"])
    with pytest.raises(TypeError, match="dict is not a table of Arrow"):
        exact_ccd.answer_table({})
    with pytest.raises(ValueError, match="separation"):
        exact_ccd.answer_table(table, separation=-1.0)


def test_without_pyarrow(monkeypatch) -> None:
    table, _ = table_of("vf", 1)
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    with pytest.raises(ImportError, match="pyarrow is missing: pip install pyarrow$"):
        exact_ccd.answer_table(table)
