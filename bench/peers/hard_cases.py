"""Other libraries on the hard cases: missed and false contacts, late times, crashes, calls without end. See bench/peers/hard.

Each peer answers in a process of its own. A call that takes more than the limit of processor time, or that ends the
process, is a finding, and the next query goes to a new process.
"""

import argparse
import multiprocessing
import os
import time
from collections import Counter, namedtuple
from importlib.metadata import version

import numpy
import pyarrow.parquet

from hard_peers import METHODS

Query = namedtuple("Query", "row kind name distance collides first points")
POINTS = {"vf": 4, "ee": 4, "ve": 3, "vv": 2}
TICKS = os.sysconf("SC_CLK_TCK")


def read(path, every):
    """Every so-many-th query of the file."""
    table = pyarrow.parquet.read_table(path)
    columns = {name: table[name].to_pylist() for name in table.column_names}
    for row in range(0, table.num_rows, every):
        at = {name: column[row] for name, column in columns.items()}
        points = [
            [numpy.array([at[f"t{t}_p{p}_{axis}"] for axis in "xyz"]) for p in range(POINTS[at["kind"]])] for t in (0, 1)
        ]
        first = (at["time_lower"], at["time_upper"]) if at["collides"] else None
        yield Query(row, at["kind"], at["class"], at["distance"], bool(at["collides"]), first, points)


def work(name, pipe):
    """Answers queries until the pipe is closed."""
    numpy.seterr(all="ignore")
    null = os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, 1)
    os.dup2(null, 2)
    answer = METHODS[name][0]()
    pipe.send("ready")
    while True:
        try:
            query = pipe.recv()
        except EOFError:
            return
        try:
            pipe.send(answer(query))
        except Exception as error:  # noqa: BLE001: any error of a peer is an answer here
            pipe.send(error.__class__.__name__)


def processor_seconds(pid):
    with open(f"/proc/{pid}/stat") as file:
        fields = file.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


class Worker:
    """A process of a peer."""

    def __init__(self, name):
        self.pipe, other = multiprocessing.Pipe()
        self.process = multiprocessing.Process(target=work, args=(name, other), daemon=True)
        self.process.start()
        other.close()
        self.pipe.recv()

    def ask(self, query, limit):
        """The answer, or "crash" or "no end"."""
        began = processor_seconds(self.process.pid)
        self.pipe.send(query)
        while not self.pipe.poll(0.05):
            if processor_seconds(self.process.pid) - began > limit:
                self.process.kill()
                return "no end"
        try:
            return self.pipe.recv()
        except EOFError:
            return "crash"

    def close(self):
        self.process.kill()
        self.process.join()


def finding(query, answer, is_step):
    """The kind of a wrong answer, or None."""
    if isinstance(answer, str):
        return answer
    contact, toi = answer
    truth = query.collides if is_step else query.first == (0.0, 0.0)
    if truth and not contact:
        return "missed"
    if contact and not truth:
        return "false"
    if contact and toi is not None and is_step:
        if not toi <= query.first[1]:
            return "late"
        if toi < query.first[0] - 0.01:
            return "early by 0.01 or more"
    return None


def simplicity(query):
    """Queries with few significant digits and small exponents come first."""
    numbers = [float(x) for now in query.points for point in now for x in point] + [query.distance]
    return sum(len(repr(x)) for x in numbers) + sum(x != 0 for x in numbers)


def compare(name, queries, limit, budget):
    """The number of answers, and the queries of each finding."""
    is_step = METHODS[name][1]
    worker, findings, count, stop = Worker(name), [], 0, time.monotonic() + budget
    for query in queries:
        if time.monotonic() > stop:
            break
        answer = worker.ask(query, limit)
        if answer in ("crash", "no end"):
            worker.close()
            worker = Worker(name)
        if answer is None:
            continue
        count += 1
        found = finding(query, answer, is_step)
        if found:
            findings.append((found, query, answer))
    worker.close()
    return count, findings


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("file", help="the Parquet file of the hard cases")
    parser.add_argument("--every", help="take each so-many-th query", type=int, default=1)
    parser.add_argument("--limit", help="processor seconds of a call", type=float, default=2.0)
    parser.add_argument("--budget", help="seconds of a peer", type=float, default=600.0)
    parser.add_argument("--only", help="the peer with this name", choices=METHODS)
    options = parser.parse_args()
    queries = list(read(options.file, options.every))
    packages = ["ipctk", "python-fcl", "coal", "trimesh", "mujoco", "warp-lang", "newton", "numpy"]
    print(f"{len(queries)} queries;", ", ".join(f"{package} {version(package)}" for package in packages))
    for name in [options.only] if options.only else METHODS:
        count, findings = compare(name, queries, options.limit, options.budget)
        print(f"\n### {name}: {count} answers\n\n| finding | queries | simplest | class | kind | d | truth | answer |")
        print("|---|---:|---:|---|---|---:|---|---|")
        for found, number in Counter(found for found, _, _ in findings).most_common():
            _, query, answer = min((x for x in findings if x[0] == found), key=lambda x: simplicity(x[1]))
            truth = f"from {query.first[0]!r} to {query.first[1]!r}" if query.first else "free"
            cells = [found, number, query.row, query.name, query.kind, repr(query.distance), truth, answer]
            print("|", " | ".join(str(cell) for cell in cells), "|", flush=True)


if __name__ == "__main__":
    main()
