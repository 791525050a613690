"""Whole steps: exact-ccd against ipctk, on the same frames, in turns. See bench/peers/step."""

import argparse
import json
import os
import re
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import ipctk
import numpy as np

from ply import read_ply

BROAD_PHASES = {
    "LBVH": ipctk.LBVH,
    "HashGrid": ipctk.HashGrid,
    "SweepAndPrune": ipctk.SweepAndPrune,
}
NARROW_PHASES = {
    "TightInclusionCCD": ipctk.TightInclusionCCD,
    "AdditiveCCD": ipctk.AdditiveCCD,
}
FREE_FRACTION = 0.9


def write_ply(path, positions, faces):
    """The file that read_ply reads, with f64 coordinates."""
    header = (
        "ply\nformat binary_little_endian 1.0\n"
        f"element vertex {len(positions)}\n"
        "property double x\nproperty double y\nproperty double z\n"
        f"element face {len(faces)}\n"
        "property list uchar int vertex_indices\nend_header\n"
    )
    rows = np.zeros(len(faces), np.dtype([("count", "u1"), ("corners", "<i4", 3)]))
    rows["count"], rows["corners"] = 3, faces
    with open(path, "wb") as file:
        file.write(header.encode("ascii"))
        file.write(np.ascontiguousarray(positions, "<f8").tobytes())
        file.write(rows.tobytes())


class Ipctk:
    """One combination of a broad and a narrow phase."""

    def __init__(self, mesh, broad, narrow, ask, min_distance):
        self.name = f"ipctk {broad} + {narrow}"
        self.mesh, self.broad, self.narrow = mesh, BROAD_PHASES[broad], NARROW_PHASES[narrow]
        self.min_distance = min_distance
        self.ask = {
            "step": ipctk.compute_collision_free_stepsize,
            "any": ipctk.is_step_collision_free,
        }[ask]

    def run(self, x0, x1, _files, repeat):
        seconds = []
        for _ in range(repeat):
            clock = time.perf_counter()
            answer = self.ask(
                self.mesh, x0, x1, self.min_distance, broad_phase=self.broad(), narrow_phase_ccd=self.narrow()
            )
            seconds.append(time.perf_counter() - clock)
        return statistics.median(seconds), answer


class Exact:
    """`exact-ccd step`, without the time that it takes to read the files."""

    def __init__(self, program, flags, threads):
        self.name = " ".join(["exact-ccd step", *flags])
        self.program, self.flags = program, flags
        self.environment = {**os.environ, "RAYON_NUM_THREADS": str(threads)}
        # Of all contacts.
        self.candidates, self.contacts = 0, 0

    def run(self, _x0, _x1, files, repeat):
        # ipctk does not look for intersections at the start either.
        unchecked = "--no-start-check"
        command = [self.program, "step", *files, unchecked, "--json", "--repeat", str(repeat), *self.flags]
        done = subprocess.run(command, capture_output=True, text=True, env=self.environment)
        if done.returncode not in (0, 1):
            raise SystemExit(done.stderr)
        report = json.loads(done.stdout)
        phases = report["seconds"]
        seconds = phases["broad"] + phases["narrow"]
        if "--any" in self.flags:
            return seconds, report["collision_free"]
        self.candidates, self.contacts = (sum(report.get(name, {}).values()) for name in ("candidates", "colliding"))
        return seconds, 1.0 if report["toi"] is None else report["toi"]


def medians(contestants, options, x0, x1, files):
    """The median seconds of each, and what it answered, all of them in turns.

    In each turn all answer as many times, and the median counts: nobody has to start with cold caches.
    """
    seconds = [[] for _ in contestants]
    answers = [None] * len(contestants)
    for _ in range(options.rounds):
        for index, contestant in enumerate(contestants):
            time_taken, answer = contestant.run(x0, x1, files, options.repeat)
            if answers[index] not in (None, answer):
                raise SystemExit(f"{contestant.name} answers {answers[index]}, then {answer}")
            answers[index] = answer
            seconds[index].append(time_taken)
    return [statistics.median(times) for times in seconds], answers


def print_table(title, contestants, seconds, answers, file):
    """One row for each; the last column tells how many times as fast the first is."""
    print(f"\n### {title}\n\n| | ms | answer | times ours |\n|---|---:|---:|---:|", file=file)
    for contestant, taken, answer in zip(contestants, seconds, answers):
        print(f"| {contestant.name} | {1e3 * taken:.1f} | {answer} | {taken / seconds[0]:.1f} |", file=file, flush=True)


class Summary:
    """One row for each scene and number of threads, with the times of all contestants in ms.

    Where one of them counts all contacts, it has the counts, and the time of that one for each candidate.
    """

    def __init__(self, title):
        self.title, self.header, self.rows = title, None, []

    def add(self, row, contestants, seconds):
        self.header = [contestant.name for contestant in contestants]
        self.rows.append([row, *(f"{1e3 * taken:.1f}" for taken in seconds)])
        for contestant, taken in zip(contestants, seconds):
            candidates = getattr(contestant, "candidates", 0)
            if candidates > 0:
                self.header += ["candidates", "contacts", "ns a candidate"]
                self.rows[-1] += [str(candidates), str(contestant.contacts), f"{1e9 * taken / candidates:.0f}"]

    def print(self):
        if self.rows:
            print(f"\n### {self.title}, in ms\n\n| scene, threads | {' | '.join(self.header)} |")
            print("|---|" + "---:|" * len(self.header))
            for row in self.rows:
                print(f"| {' | '.join(row)} |")


def compare(scene, options, threads, summaries):
    """All questions about one scene."""
    row = f"{scene.name}, {threads}"
    steps, decisions, free_decisions = summaries
    # With the summary alone, the tables of each scene are its progress.
    file = sys.stderr if options.summary else sys.stdout
    ipctk.set_num_threads(threads)
    frames = sorted((scene / "frames").glob("*.ply"), key=frame_number)[:2]
    (x0, faces), (x1, _) = map(read_ply, frames)
    mesh = ipctk.CollisionMesh(x0, ipctk.edges(faces), faces)
    files = [str(frame) for frame in frames]

    d = options.min_distance
    # The shortest decimal that reads back to the same f64.
    distance = ["--min-distance", repr(d)] if d > 0 else []

    def ours(*flags):
        return Exact(options.program, [*flags, *distance], threads)

    def theirs(ask, *broad_phases):
        return [Ipctk(mesh, b, n, ask, d) for b in broad_phases for n in options.narrow]

    title = f"{scene.name}, {threads} thread{'s' * (threads > 1)}"
    if d > 0:
        title += f", minimum distance {d!r}"
    contestants = [ours("--toi"), ours(), *theirs("step", *options.broad)]
    seconds, answers = medians(contestants, options, x0, x1, files)
    print_table(f"{title}: the collision-free step", contestants, seconds, answers, file)
    steps.add(row, contestants, seconds)
    ours_is_largest = answers[0] >= max(answers[2:])
    print(f"\nOur step is {'' if ours_is_largest else 'NOT '}at least as large as theirs.", file=file)
    if options.only_step:
        return
    size = FREE_FRACTION * min(answers[2:])

    contestants = [ours("--any"), *theirs("any", *options.broad)]
    result = medians(contestants, options, x0, x1, files)
    print_table(f"{title}: yes or no", contestants, *result, file)
    decisions.add(row, contestants, result[0])

    if size == 0:
        print("\nNo step is free: a pair is within the minimum distance at the start.", file=file)
        return
    with tempfile.TemporaryDirectory() as folder:
        free = np.asfortranarray(x0 + size * (x1 - x0))
        end = str(Path(folder) / "end.ply")
        write_ply(end, free, faces)
        result = medians(contestants, options, x0, free, [files[0], end])
        print_table(f"{title}: yes or no, on a step that is free", contestants, *result, file)
        free_decisions.add(row, contestants, result[0])


def frame_number(path):
    """Frames are numbered."""
    digits = re.findall(r"\d+", path.stem)
    return int(digits[-1]) if digits else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="the program exact-ccd")
    parser.add_argument("scenes", help="a folder of scenes, each with a folder of frames", type=Path)
    parser.add_argument("--rounds", help="how often it is each one's turn", type=int, default=5)
    parser.add_argument("--repeat", help="how often it answers then", type=int, default=3)
    parser.add_argument("--threads", help="how many threads", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--broad", help="broad phases of ipctk", nargs="+", default=["LBVH"], choices=BROAD_PHASES)
    narrow = list(NARROW_PHASES)
    parser.add_argument("--narrow", help="narrow phases of ipctk", nargs="+", default=narrow, choices=narrow)
    parser.add_argument("--only", help="the scene with this name")
    parser.add_argument("--summary", help="only the tables of all scenes", action="store_true")
    parser.add_argument("--only-step", help="only the collision-free step", action="store_true")
    parser.add_argument("--min-distance", help="the distance to keep", type=float, default=0.0, metavar="D")
    options = parser.parse_args()
    # A warning for each pair that starts within the minimum distance would take longer than the answer.
    ipctk.set_logger_level(ipctk.LoggerLevel.error)
    titles = ("The collision-free step", "Yes or no", "Yes or no, on a step that is free")
    summaries = [Summary(title) for title in titles]
    for threads in options.threads:
        for scene in sorted(options.scenes.iterdir()):
            if (scene / "frames").is_dir() and options.only in (None, scene.name):
                compare(scene, options, threads, summaries)
    for summary in summaries:
        summary.print()


if __name__ == "__main__":
    main()
