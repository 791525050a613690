"""Answers for the queries in Arrow tables."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Optional, TypeVar, get_args

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._arrays import Positions, positions
from .queries import POINTS, Kind, Queries, check_kind, settings

if TYPE_CHECKING:
    import pyarrow as pa

Answer = Literal["collides", "count", "toi"]
"""A column of :func:`answer_table`."""

_TYPES: dict[str, type] = {"collides": np.bool_, "count": np.int64, "toi": np.float64}

_Table = TypeVar("_Table")
_Settings = tuple[float, float, Optional[int]]


def answer_table(
    table: _Table,
    *,
    answers: Iterable[Answer] = ("collides", "count", "toi"),
    kind: Optional[Kind] = None,
    separation: float = 0.0,
    threads: Optional[int] = 1,
) -> _Table:
    """Decide the queries of a table, and return it with their answers as further columns.

    The columns ``kind`` and ``points`` and the answers ``count`` and ``toi`` are the same as in the Parquet files
    of ``exact-ccd convert``. All other columns are passed on.

    Parameters
    ----------
    table : pyarrow.Table, pyarrow.RecordBatch, polars.DataFrame, or an Arrow stream
        An Arrow stream is any object with ``__arrow_c_stream__``, such as a relation of DuckDB. The columns
        are

        - ``kind``: "vf", "ee", "ve" or "vv", which may differ from row to row;
        - ``points``: a list of 24 numbers, for "ve" 18, for "vv" 12: x, y and z of the points at t = 0, then
          the same at t = 1, in the order of :class:`Queries`. Lists of fixed size serve as well. float64 and
          float32 values are read where they are.
    answers : iterable of {"collides", "count", "toi"}
        The columns to add; each replaces a column of the same name:

        - ``collides``, bool: contact or none, as of :meth:`Queries.collides`;
        - ``count``, int64: the number of contact times, as of :meth:`Queries.count`;
        - ``toi``, float64: the first of them, as of :meth:`Queries.time_of_impact`; null if there is none.
    kind : {"vf", "ee", "ve", "vv"}, optional
        The kind of all queries, in place of the column.
    separation : float
        The distance at which primitives touch, see :meth:`Queries.collides`.
    threads : int or None
        The number of threads: by default 1, because Ray, Dask, Spark and others call functions like
        this one in many processes. None for all cores.

    Returns
    -------
    pyarrow.Table, pyarrow.RecordBatch or polars.DataFrame
        As the argument; a pyarrow.Table for another Arrow stream.

    Raises
    ------
    ImportError
        If pyarrow is missing: ``pip install pyarrow``.
    ValueError
        If a column is missing, or a row is wrong; the message names it, counted from 0.
    TypeError
        If a column has another type.

    Examples
    --------
    A vertex passes another one, or meets it.

    >>> import pyarrow
    >>> from exact_ccd import answer_table
    >>> points = [[-1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0], [-1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0]]
    >>> table = pyarrow.table({"kind": ["vv", "vv"], "points": points})
    >>> answer_table(table).select(["collides", "count", "toi"]).to_pylist()[1]
    {'collides': True, 'count': 1, 'toi': 0.5}
    """
    chosen = tuple(answers)
    for name in chosen:
        if name not in get_args(Answer):
            raise ValueError(f'answer {name!r}, expected "collides", "count" or "toi"')
    arrow = _as_arrow(table)
    columns = _answers(arrow, chosen, kind, settings(separation, 1.0, threads))
    for column, values in columns.items():
        index = arrow.schema.get_field_index(column)
        arrow = arrow.append_column(column, values) if index < 0 else arrow.set_column(index, column, values)
    result: _Table = _like(table, arrow)
    return result


def _as_arrow(table: Any) -> pa.Table:
    try:
        import pyarrow as pa
    except ImportError as error:
        raise ImportError("pyarrow is missing: pip install pyarrow") from error
    if isinstance(table, pa.Table):
        return table
    if isinstance(table, pa.RecordBatch):
        return pa.Table.from_batches([table])
    if _is_polars(table):
        # Strings of the usual type, where the stream has views.
        return table.to_arrow()
    if hasattr(table, "__arrow_c_stream__"):
        return pa.table(table)
    raise TypeError(f"{type(table).__name__} is not a table of Arrow: it has no __arrow_c_stream__")


def _like(table: Any, arrow: pa.Table) -> Any:
    """The table as the type of the argument."""
    import pyarrow as pa

    if isinstance(table, pa.RecordBatch):
        columns = [_one_chunk(column) for column in arrow.columns]
        return pa.RecordBatch.from_arrays(columns, schema=arrow.schema)
    if _is_polars(table):
        import polars

        return polars.from_arrow(arrow)
    return arrow


def _is_polars(table: Any) -> bool:
    return type(table).__module__.split(".")[0] == "polars"


def _one_chunk(column: pa.ChunkedArray) -> pa.Array:
    return column.chunk(0) if column.num_chunks == 1 else column.combine_chunks()


def _answers(
    table: pa.Table, names: tuple[Answer, ...], kind: Optional[Kind], options: _Settings
) -> dict[str, pa.Array]:
    """The columns of answers."""
    import pyarrow as pa

    found = {name: np.zeros(table.num_rows, _TYPES[name]) for name in names}
    kinds = _Kinds.all(kind) if kind is not None else _Kinds.of(_column(table, "kind"))
    first = 0
    for chunk in _column(table, "points").chunks:
        for of, places in kinds.within(first, len(chunk)):
            rows = np.arange(first, first + len(chunk)) if places is None else first + places
            points = _points(of, chunk if places is None else chunk.take(pa.array(places)), rows)
            for name, values in _decide(of, points, rows, names, options).items():
                if places is None:
                    found[name][first : first + len(chunk)] = values
                else:
                    found[name][rows] = values
        first += len(chunk)
    return {name: pa.array(values, from_pandas=True) for name, values in found.items()}


def _column(table: pa.Table, name: str) -> pa.ChunkedArray:
    if table.schema.get_field_index(name) < 0:
        raise ValueError(f"there is no column {name!r}, or there are several")
    return table.column(name)


class _Kinds(NamedTuple):
    """The kind of each row, by its place in `names`."""

    names: list[Kind]
    codes: Optional[NDArray[np.int32]]

    @classmethod
    def all(cls, kind: Kind) -> _Kinds:
        """One kind for all rows."""
        check_kind(kind)
        return cls([kind], None)

    @classmethod
    def of(cls, column: pa.ChunkedArray) -> _Kinds:
        """The kinds in a column."""
        import pyarrow as pa

        values = column.type.value_type if pa.types.is_dictionary(column.type) else column.type
        is_text = (pa.types.is_string, pa.types.is_large_string, pa.types.is_string_view)
        if not any(test(values) for test in is_text):
            raise TypeError(f"the column kind has the type {column.type}, expected strings")
        if column.null_count:
            raise ValueError(f"row {_first(column.is_null())}: the kind is null")
        encoded = column.cast(pa.string()).dictionary_encode().combine_chunks()
        names = encoded.dictionary.to_pylist()
        codes = encoded.indices.to_numpy()
        for code, name in enumerate(names):
            check_kind(name, f"row {np.argmax(codes == code)}: ")
        return cls(names, codes)

    def within(self, first: int, count: int) -> Iterator[tuple[Kind, Optional[NDArray[np.intp]]]]:
        """The kinds of some rows, and the places of each among them, if not all."""
        if self.codes is None or len(self.names) == 1:
            yield self.names[0], None
            return
        codes = self.codes[first : first + count]
        for code, name in enumerate(self.names):
            places = np.flatnonzero(codes == code)
            if len(places):
                yield name, None if len(places) == count else places


def _points(kind: Kind, lists: Any, rows: NDArray[np.intp]) -> Positions:
    """The points of queries, without a copy of contiguous float64 values. `rows` are their numbers."""
    import pyarrow as pa
    import pyarrow.compute as pc

    if isinstance(lists.type, pa.BaseExtensionType):
        lists = lists.storage
    is_list = (pa.types.is_list, pa.types.is_large_list, pa.types.is_fixed_size_list)
    if not any(test(lists.type) for test in is_list):
        raise TypeError(f"the column points has the type {lists.type}, expected lists of numbers")
    if lists.null_count:
        raise ValueError(f"row {rows[_first(lists.is_null())]}: the points are null")
    width = 6 * POINTS[kind]
    lengths = pc.list_value_length(lists).to_numpy(zero_copy_only=False)
    if (lengths != width).any():
        row = int(np.argmax(lengths != width))
        raise ValueError(f'row {rows[row]}: {lengths[row]} coordinates, expected {width} for "{kind}"')
    values = lists.flatten()
    if values.null_count:
        raise ValueError(f"row {rows[_first(values.is_null()) // width]}: a coordinate is null")
    numbers = values.to_numpy(zero_copy_only=False)
    return positions("points", numbers.reshape(-1, 2 * POINTS[kind], 3), (None, 2 * POINTS[kind], 3), rows)


def _first(mask: Any) -> int:
    """The place of the first true value."""
    return int(np.argmax(mask.to_numpy(zero_copy_only=False)))


def _decide(
    kind: Kind, points: Positions, rows: NDArray[np.intp], names: tuple[Answer, ...], options: _Settings
) -> dict[Answer, NDArray[Any]]:
    """The answers for queries of one kind."""
    count = POINTS[kind]
    arguments = (Queries(kind, points[:, :count], points[:, count:])._arrays, options)
    try:
        if names == ("collides",):
            return {"collides": _native.collides(*arguments)}
        if "count" in names:
            times, counts = _native.time_and_count(*arguments)
        else:
            times, counts = _native.time_of_impact(*arguments), np.empty(0, np.int64)
    except ValueError as error:
        wrong = ~np.isfinite(points).all(axis=(1, 2))
        if wrong.any():
            raise ValueError(f"row {rows[np.argmax(wrong)]}: a coordinate is not finite") from error
        raise
    every: dict[Answer, NDArray[Any]] = {"collides": ~np.isnan(times), "count": counts, "toi": times}
    return {name: every[name] for name in names}
