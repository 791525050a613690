"""The program ``exact-ccd-ray``."""

from __future__ import annotations

import argparse
import contextlib
import json
import logging
import sys
from typing import Any

USAGE = """Exact continuous collision detection by Ray, on the cores of this machine or on a cluster.

Exit status: 0 success, for `audit` free of contact; 1 violation; 2 error."""


def arguments() -> argparse.ArgumentParser:
    """The arguments of the program."""
    parser = argparse.ArgumentParser(
        prog="exact-ccd-ray", description=USAGE, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--address", help="the cluster, as for ray.init; by default RAY_ADDRESS, or this machine")
    commands = parser.add_subparsers(dest="command", required=True)
    audit = commands.add_parser("audit", help="certify that a mesh never touches itself in a sequence of frames")
    audit.add_argument("frames", nargs="+", metavar="FRAMES", help="mesh files in the order of time, or a folder")
    audit.add_argument("--steps", type=int, default=32, help="the number of steps of a task (32)")
    audit.add_argument("--results", metavar="DIR", help="keep finished chunks, so that a killed audit goes on")
    audit.add_argument("--certificate", metavar="FILE", help="write a proof of the answer, for exact-ccd-check")
    queries = commands.add_parser("queries", help="decide the queries in Parquet files, as of exact-ccd convert")
    queries.add_argument("files", nargs="+", metavar="FILES", help="Parquet files, or folders of them")
    queries.add_argument("--output", metavar="DIR", help="write the queries with their answers as Parquet files")
    for command in (audit, queries):
        command.add_argument("--min-distance", type=float, default=0.0, metavar="D", help="count D apart as touching")
    return parser


def run(options: argparse.Namespace) -> tuple[str, int]:
    """Run a command; its answer as JSON, and its exit status."""
    import ray

    command = _audit if options.command == "audit" else _queries
    with ray.init(address=options.address, log_to_driver=False, logging_level=logging.WARNING):
        return command(options)


def _audit(options: argparse.Namespace) -> tuple[str, int]:
    """The report of an audit, and 1 if there is a violation."""
    from .ray import audit
    from .ray.chunks import to_json

    report = audit(
        options.frames if len(options.frames) > 1 else options.frames[0],
        min_distance=options.min_distance,
        steps=options.steps,
        results=options.results,
        certificate=options.certificate,
    )
    return to_json(report), 0 if report.is_free else 1


def _queries(options: argparse.Namespace) -> tuple[str, int]:
    """The numbers of queries, of those in contact, and of those whose truth differs."""
    import pyarrow.fs
    import ray.data

    from .ray import answer_files
    from .ray.chunks import absolute, file_system

    if options.output is not None:
        place, folder = file_system(absolute(options.output), None)
        # Ray adds to the files of a folder, and all of them would be counted.
        if place.get_file_info(pyarrow.fs.FileSelector(folder, allow_not_found=True)):
            raise ValueError(f"{options.output} is not empty: name another folder")
    ray.data.DataContext.get_current().enable_progress_bars = False
    answered = answer_files(options.files, answers=["collides", "toi"], separation=options.min_distance)
    if options.output is not None:
        answered.write_parquet(absolute(options.output))
        answered = ray.data.read_parquet(absolute(options.output))
    table: dict[str, Any] = {"queries": 0, "colliding": 0, "wrong": None}
    for counts in answered.map_batches(_counts, batch_format="pyarrow", batch_size=None).iter_rows():
        for name, count in counts.items():
            table[name] = table[name] if count is None else (table[name] or 0) + count
    return json.dumps(table), 0


def _counts(batch: Any) -> Any:
    """A row with the number of the queries of a batch, of those in contact, and of those whose truth differs."""
    import pyarrow as pa
    import pyarrow.compute as pc

    wrong = None
    if "truth" in batch.column_names:
        wrong = pc.sum(pc.not_equal(batch["collides"], batch["truth"])).as_py()
    row = {"queries": batch.num_rows, "colliding": pc.sum(batch["collides"], min_count=0).as_py(), "wrong": wrong}
    return pa.Table.from_pylist([row], pa.schema([(name, pa.int64()) for name in row]))


def _message(error: Exception) -> str:
    """The message of an error, or of the error of a task that it passes on."""
    for one in (getattr(error, "cause", None), error):
        if isinstance(one, (ValueError, TypeError, OSError)):
            return str(one)
    # The text of an error of Ray contains the texts of its causes.
    return f"{type(error).__name__}: {error}"


def main() -> None:
    """Run the program with the arguments of the process, and end with its exit status."""
    options = arguments().parse_args()
    try:
        # Ray writes warnings of a cluster to the standard output, also with `log_to_driver=False`.
        with contextlib.redirect_stdout(sys.stderr):
            answer, status = run(options)
        sys.stdout.write(answer + "\n")
    except ImportError as error:
        sys.stderr.write(f"error: {error}; pip install 'ray[data]' pyarrow\n")
        status = 2
    except Exception as error:
        # Errors of Ray too: a lost cluster or a failed task is no violation.
        sys.stderr.write(f"error: {_message(error)}\n")
        status = 2
    sys.exit(status)


if __name__ == "__main__":
    main()
