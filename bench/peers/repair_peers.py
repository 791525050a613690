"""Repairs of meshes that intersect themselves: exact-ccd, pymeshfix and MeshLib. See bench/peers/repair."""

import sys
import time
from pathlib import Path

import exact_ccd
import meshlib.mrmeshnumpy as arrays
import meshlib.mrmeshpy as meshlib
import numpy as np
import pymeshfix
from scipy.spatial import cKDTree


def ours(points, faces):
    return np.asarray(exact_ccd.repair(faces, points).positions), faces


def meshfix(points, faces):
    fixed = pymeshfix.MeshFix(points, faces)
    fixed.repair(remove_smallest_components=False)
    return np.asarray(fixed.points), np.asarray(fixed.faces)


def meshlib_by(method):
    """MeshLib's local repair: the faces that intersect are relaxed, or cut out and filled."""

    def run(points, faces):
        mesh = arrays.meshFromFacesVerts(faces.astype(np.int32), points)
        settings = meshlib.SelfIntersections.Settings()
        settings.method = getattr(meshlib.SelfIntersections.Settings.Method, method)
        meshlib.SelfIntersections.fix(mesh, settings)
        mesh.pack()
        return arrays.getNumpyVerts(mesh), arrays.getNumpyFaces(mesh.topology)

    return run


METHODS = {
    "exact-ccd": ours,
    "pymeshfix": meshfix,
    "MeshLib, relaxed": meshlib_by("Relax"),
    "MeshLib, cut and filled": meshlib_by("CutAndFill"),
}


def pairs(points, faces):
    """The pairs of an edge and a face that have a common point, and share no vertex."""
    mesh = exact_ccd.Mesh(len(points), faces.astype(np.uint32))
    return len(exact_ccd.Detector(mesh).intersections(np.ascontiguousarray(points, float)))


def changed(points, faces, after, kept):
    """The numbers of faces that were removed and added: a vertex is the same within 1e-6 of the diagonal."""
    away, nearest = cKDTree(points).query(after)
    is_same = away < 1e-6 * np.linalg.norm(np.ptp(points, axis=0))
    index = np.where(is_same, nearest, -1 - np.arange(len(after)))
    before, now = ({tuple(sorted(face)) for face in some.tolist()} for some in (faces, index[kept]))
    return len(before - now), len(now - before)


def main():
    print(f"{'mesh':22} {'method':24} {'pairs':>6} {'removed':>7} {'added':>6} {'mean':>7} {'max':>7} {'s':>6}")
    for path in map(Path, sys.argv[1:]):
        file = exact_ccd.read_mesh(path)
        points, faces = np.array(file.vertices, float), np.array(file.faces)
        diagonal = np.linalg.norm(np.ptp(points, axis=0))
        print(f"{path.stem:22} {'before':24} {pairs(points, faces):6}")
        for name, method in METHODS.items():
            began = time.perf_counter()
            after, kept = method(points.copy(), faces.copy())
            seconds = time.perf_counter() - began
            if np.array_equal(kept, faces):
                away, removed, added = np.linalg.norm(after - points, axis=1), 0, 0
            else:
                # An upper bound of the distance to the surface.
                away = cKDTree(after).query(points)[0]
                removed, added = changed(points, faces, after, kept)
            away = away / diagonal
            print(
                f"{'':22} {name:24} {pairs(after, kept):6} {removed:7} {added:6} "
                f"{away.mean():7.4f} {away.max():7.4f} {seconds:6.1f}",
                flush=True,
            )


main()
