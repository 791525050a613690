"""Two bodies in motion: python-fcl beside exact-ccd, on the meshes and motions of one file. See bench/peers/bodies."""

import json
import statistics
import subprocess
import sys
import time

import fcl
import numpy as np

ROUNDS = 11


def transform(quaternion, place):
    q = np.array(quaternion)
    return fcl.Transform(q / np.linalg.norm(q), np.array(place))


def body(mesh, quaternion, place):
    points, faces = mesh
    model = fcl.BVHModel()
    model.beginModel(len(points), len(faces))
    model.addSubModel(np.array(points), np.array(faces))
    model.endModel()
    return fcl.CollisionObject(model, transform(quaternion, place))


def advance(case):
    """The time of contact by conservative advancement, and the milliseconds that it took."""
    (q, r), places = case["quaternions"], case["places"]
    request = fcl.ContinuousCollisionRequest(
        ccd_motion_type=fcl.CCDMotionType.CCDM_LINEAR,
        gjk_solver_type=fcl.GJKSolverType.GST_LIBCCD,
        ccd_solver_type=fcl.CCDSolverType.CCDC_CONSERVATIVE_ADVANCEMENT,
    )
    ends = transform(q[1], places[0][1]), transform(r[1], places[1][1])
    # Anew, since a call moves both.
    first, second = (
        body(mesh, quaternions[0], path[0]) for mesh, quaternions, path in zip(case["meshes"], (q, r), places)
    )
    result = fcl.ContinuousCollisionResult()
    start = time.perf_counter()
    found = fcl.continuousCollide(first, ends[0], second, ends[1], request, result)
    return found, 1e3 * (time.perf_counter() - start)


def main(folder, *command):
    """Take turns with the benchmark, a command that answers lines, and print medians."""
    own = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    own.stdout.readline()
    with open(f"{folder}/bodies.json", encoding="utf-8") as file:
        cases = json.load(file)
    print(f"Medians of {ROUNDS} rounds, in milliseconds.\n")
    print("| case | contact at | exact-ccd | fcl | fcl / exact-ccd | fcl's time |")
    print("|---|---:|---:|---:|---:|---:|")
    for index, case in enumerate(cases):
        times = []
        for _ in range(ROUNDS):
            own.stdin.write(f"{index}\n")
            own.stdin.flush()
            ours = float(own.stdout.readline())
            found, theirs = advance(case)
            times.append((ours, theirs))
        ours, theirs = (statistics.median(column) for column in zip(*times))
        at = "free" if case["time"] is None else f"{case['time']:.6f}"
        print(f"| {case['name']} | {at} | {ours:.2f} | {theirs:.0f} | {theirs / ours:.1f} | {found:.4f} |")
    own.communicate()


if __name__ == "__main__":
    main(*sys.argv[1:])
