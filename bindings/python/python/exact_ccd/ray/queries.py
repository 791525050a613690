"""Answers for the queries in Parquet files, by tasks of Ray."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import partial
from os import PathLike
from typing import TYPE_CHECKING, Any, Optional, Union

import pyarrow.fs
import pyarrow.parquet
import ray.data
from numpy.typing import NDArray

from ..frames import FilePath
from ..queries import Kind
from ..tables import Answer, answer_table
from .chunks import absolute, file_system

if TYPE_CHECKING:
    from ray.data import Dataset


def answer_files(
    files: Union[FilePath, Iterable[FilePath]],
    *,
    answers: Iterable[Answer] = ("collides", "count", "toi"),
    kind: Optional[Kind] = None,
    separation: float = 0.0,
    filesystem: Optional[pyarrow.fs.FileSystem] = None,
) -> Dataset:
    """Decide the queries in Parquet files, and return them with their answers as further columns.

    Each file is read by the task that decides its queries, one group of rows at a time. Of the columns, only those
    that are selected afterwards leave that task.

    Parameters
    ----------
    files : path or iterable of paths
        Files with the columns of :func:`exact_ccd.answer_table`. A folder stands for all its files whose names end
        in ``.parquet``. Paths are valid on all machines, or are addresses such as ``s3://bucket/queries``.
    answers, kind, separation
        As for :func:`exact_ccd.answer_table`.
    filesystem : pyarrow.fs.FileSystem, optional
        The file system of the files, in place of the file systems of the machines. Addresses name one too.

    Returns
    -------
    ray.data.Dataset
        Computed when it is consumed, one core for each file. The rows of a file are in order, the files may be in
        another one.

    Raises
    ------
    ValueError
        If there are no files.

    Examples
    --------
    >>> answer_files("queries/", answers=["collides"]).select_columns(["collides"]).sum("collides")  # doctest: +SKIP
    107
    """
    listed = [files] if isinstance(files, (str, PathLike)) else files
    found: list[dict[str, str]] = []
    place = filesystem
    for path in listed:
        place, inside = file_system(absolute(path) if filesystem is None else path, filesystem)
        found.extend({"file": file} for file in _files(place, inside))
    if not found:
        raise ValueError("there are no Parquet files")
    answer = partial(answer_table, answers=tuple(answers), kind=kind, separation=separation)

    def answered(batch: dict[str, Any]) -> Iterator[pyarrow.Table]:
        with pyarrow.parquet.ParquetFile(str(batch["file"][0]), filesystem=place) as file:
            for group in range(file.num_row_groups):
                yield answer(file.read_row_group(group, use_threads=False))

    return ray.data.from_items(found, override_num_blocks=len(found)).map_batches(answered, batch_size=1)


def _files(filesystem: pyarrow.fs.FileSystem, path: str) -> list[str]:
    """The Parquet files in a folder, or the file itself."""
    if filesystem.get_file_info(path).type != pyarrow.fs.FileType.Directory:
        return [path]
    selected = filesystem.get_file_info(pyarrow.fs.FileSelector(path, recursive=True))
    return sorted(file.path for file in selected if file.path.endswith(".parquet"))
