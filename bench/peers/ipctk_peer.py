"""The narrow phases of ipctk, the IPC Toolkit's Python package, as peers of `exact-ccd bench --peer`.

The protocol is described in docs/benchmark.md. Each query is one call of the binding, timed here, in this process.
"""

import json
import os
import sys
import time

import ipctk
import numpy


class Linear(ipctk.NonlinearTrajectory):
    """A point that moves in a straight line, for the method that takes any trajectory."""

    def __init__(self, start, end):
        super().__init__()
        self.start, self.velocity = start, end - start

    def __call__(self, t):
        return self.start + t * self.velocity

    def max_distance_from_linear(self, t0, t1):
        return 0.0


def linear(method, kind):
    """A method that takes the eight points."""
    ask = {"vf": method.point_triangle_ccd, "ee": method.edge_edge_ccd}[kind]
    return lambda points: (ask, points)


def nonlinear(method, kind):
    """A method that takes four trajectories; making these is not part of its time."""
    ask = {"vf": method.point_triangle_ccd, "ee": method.edge_edge_ccd}[kind]
    return lambda points: (ask, [Linear(points[i], points[i + 4]) for i in range(4)])


# Names, with the default parameters of ipctk, and whether a method may miss a contact: AdditiveCCD has no bound for its
# rounding errors.
METHODS = {
    "ipctk TI": (linear, ipctk.TightInclusionCCD(), False),
    "ipctk ACCD": (linear, ipctk.AdditiveCCD(), True),
    "ipctk NLCCD": (nonlinear, ipctk.NonlinearCCD(), False),
}


def call_ns(prepare, method):
    """The least time of a call: for a vertex that stays far from a face. NonlinearCCD calls back into Python for each
    position."""
    points = [numpy.array([100.0 * (i % 4 == 0), float(i % 4 == 1), float(i % 4 == 2)]) for i in range(8)]
    ask, arguments = prepare(method, "vf")(points)
    best = float("inf")
    for _ in range(2000):
        clock = time.perf_counter_ns()
        ask(*arguments)
        best = min(best, time.perf_counter_ns() - clock)
    return float(best)


def answer(request, queries):
    """For each query: nanoseconds, 1 for contact or 0, and the time of impact or NaN."""
    prepare, method, _ = METHODS[request["method"]]
    prepare = prepare(method, request["kind"])
    begin = time.perf_counter_ns()
    for query in queries:
        ask, arguments = prepare([point.copy() for point in query])
        clock = time.perf_counter_ns()
        contact, toi = ask(*arguments)
        now = time.perf_counter_ns()
        yield now - clock, float(contact), toi if contact else float("nan")
        if now - begin > request["limit_ns"]:
            return


def main():
    # Output of the library must not get between the answers.
    reader, writer = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    ipctk.set_logger_level(ipctk.LoggerLevel.error)
    methods = [
        {
            "name": name,
            "false_negatives": false_negatives,
            "false_positives": True,
            "time": "conservative",
            "call_ns": call_ns(prepare, method),
        }
        for name, (prepare, method, false_negatives) in METHODS.items()
    ]
    writer.write(json.dumps({"methods": methods}).encode() + b"\n")
    writer.flush()
    for line in reader:
        request = json.loads(line)
        size = request["queries"]
        queries = numpy.frombuffer(reader.read(24 * 8 * size), dtype="<f8").reshape(size, 8, 3)
        answers = numpy.array(list(answer(request, queries)), dtype="<f8")
        writer.write(f"{len(answers)}\n".encode() + answers.tobytes())
        writer.flush()


if __name__ == "__main__":
    main()
