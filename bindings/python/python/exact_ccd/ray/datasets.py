"""Answers for the queries of a data set."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Optional

from ..queries import Kind
from ..tables import Answer, answer_table

if TYPE_CHECKING:
    from ray.data import Dataset


def answer_dataset(
    dataset: Dataset,
    *,
    answers: Iterable[Answer] = ("collides", "count", "toi"),
    kind: Optional[Kind] = None,
    separation: float = 0.0,
) -> Dataset:
    """Decide the queries of a data set, and return it with their answers as further columns.

    Parameters
    ----------
    dataset : ray.data.Dataset
        With the columns of :func:`exact_ccd.answer_table`, as of ``ray.data.read_parquet``.
    answers, kind, separation
        As for :func:`exact_ccd.answer_table`.

    Returns
    -------
    ray.data.Dataset
        Computed when it is consumed, block by block, one core for each. The answers do not depend on the
        blocks.

    Examples
    --------
    >>> import ray.data
    >>> dataset = ray.data.read_parquet("queries/")  # doctest: +SKIP
    >>> answer_dataset(dataset, answers=["collides"]).sum("collides")  # doctest: +SKIP
    107
    """
    return dataset.map_batches(
        answer_table,
        batch_size=None,
        batch_format="pyarrow",
        zero_copy_batch=True,
        fn_kwargs={"answers": tuple(answers), "kind": kind, "separation": separation, "threads": 1},
    )
