"""Two bodies in motion: python-fcl beside exact-ccd, on the meshes and motions of one file. See bench/peers/bodies."""

import json
import sys
import time

import fcl
import numpy as np


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
    """The time of contact by conservative advancement, and the milliseconds that it took: the least of three."""
    (q, r), places = case["quaternions"], case["places"]
    request = fcl.ContinuousCollisionRequest(
        ccd_motion_type=fcl.CCDMotionType.CCDM_LINEAR,
        gjk_solver_type=fcl.GJKSolverType.GST_LIBCCD,
        ccd_solver_type=fcl.CCDSolverType.CCDC_CONSERVATIVE_ADVANCEMENT,
    )
    ends = transform(q[1], places[0][1]), transform(r[1], places[1][1])
    times = []
    for _ in range(3):
        # Anew, since a call moves both.
        first, second = (
            body(mesh, quaternions[0], path[0])
            for mesh, quaternions, path in zip(case["meshes"], (q, r), places)
        )
        result = fcl.ContinuousCollisionResult()
        start = time.perf_counter()
        found = fcl.continuousCollide(first, ends[0], second, ends[1], request, result)
        times.append(1e3 * (time.perf_counter() - start))
    return found, min(times)


print("| case | contact at | exact-ccd, ms | fcl, ms | fcl / exact-ccd | fcl's time |")
print("|---|---:|---:|---:|---:|---:|")
for case in json.load(open(sys.argv[1], encoding="utf-8")):
    found, milliseconds = advance(case)
    own = case["milliseconds"]
    at = "free" if case["time"] is None else f"{case['time']:.6f}"
    print(f"| {case['name']} | {at} | {own:.2f} | {milliseconds:.0f} | {milliseconds / own:.1f} | {found:.4f} |")
