"""MuJoCo's convex collision detection against exact decisions: pairs of random polytopes, far and near, apart and overlapping.

Needs mujoco, numpy, scipy and exact_ccd: python integrations/mujoco/oracle.py [--pairs N]
"""

import argparse

import mujoco
import numpy as np
from scipy.spatial import ConvexHull

from exact_ccd import Detector, Mesh, Queries

# Distances up to which MuJoCo searches, in the unit of the coordinates; the polytopes have a size of about 1.
CUT_OFF = 4.0


def polytope(random: np.random.Generator, count: int) -> tuple[np.ndarray, np.ndarray]:
    """The corners and faces of the hull of random points with small dyadic coordinates."""
    points = random.integers(-16, 17, (count, 3)) / 16
    hull = ConvexHull(points)
    return points[hull.vertices], np.searchsorted(hull.vertices, hull.simplices)


def numbers(array: np.ndarray) -> str:
    return " ".join(repr(x) for x in array.ravel().tolist())


def scene(shapes: list[tuple[np.ndarray, np.ndarray]], shift: np.ndarray, native: bool) -> mujoco.MjModel:
    """Two bodies of one mesh each, the second one shifted."""
    assets = "".join(
        f'<mesh name="{name}" vertex="{numbers(corners)}" face="{numbers(faces)}"/>'
        for name, (corners, faces) in zip("ab", shapes)
    )
    bodies = "".join(
        f'<body pos="{numbers(place)}"><freejoint/><geom type="mesh" mesh="{name}" margin="0"/></body>'
        for name, place in zip("ab", (np.zeros(3), shift))
    )
    flag = "enable" if native else "disable"
    return mujoco.MjModel.from_xml_string(
        f'<mujoco><compiler inertiafromgeom="true"/><option><flag nativeccd="{flag}"/></option>'
        f"<asset>{assets}</asset><worldbody>{bodies}</worldbody></mujoco>"
    )


def world(model: mujoco.MjModel, data: mujoco.MjData, geom: int) -> np.ndarray:
    """The corners of a geom in the world, as MuJoCo has them: turned to the axes of inertia, in single precision."""
    mesh = model.geom_dataid[geom]
    begin = model.mesh_vertadr[mesh]
    corners = model.mesh_vert[begin : begin + model.mesh_vertnum[mesh]].astype(float)
    return corners @ data.geom_xmat[geom].reshape(3, 3).T + data.geom_xpos[geom]


class Truth:
    """Exact decisions about two polytopes with these corners."""

    def __init__(self, a: np.ndarray, b: np.ndarray) -> None:
        # The hulls of the corners as they are, whatever rounding made of faces that were flat.
        hulls = [ConvexHull(corners) for corners in (a, b)]
        faces = [hulls[0].simplices, hulls[1].simplices + len(a)]
        # Without a common point of the surfaces, the first corner says whether one polytope is inside the other.
        self.nested = any(
            (hull.equations @ np.append(corner, 1) < 0).all() for hull, corner in zip(hulls, (b[0], a[0]))
        )
        self.x = np.concatenate([a, b])
        self.mesh = Mesh(len(self.x), np.concatenate(faces))
        edges = self.mesh.edges
        of_a, of_b = (edges[(edges[:, 0] < len(a)) == side] for side in (True, False))
        vertices = [np.arange(len(a)), np.arange(len(a), len(self.x))]
        pairs = [
            np.concatenate([product(vertices[i][:, None], faces[1 - i]) for i in (0, 1)]),
            product(of_a, of_b),
        ]
        self.queries = [Queries(kind, self.x, self.x, rows) for kind, rows in zip(("vf", "ee"), pairs)]

    def overlaps(self) -> bool:
        """True if the polytopes have a common point."""
        return self.nested or self.within(0.0) or len(Detector(self.mesh).intersections(self.x)) > 0

    def within(self, distance: float) -> bool:
        """True if the surfaces come within a distance: decided exactly."""
        return any(queries.collides(separation=distance, threads=1).any() for queries in self.queries)


def product(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """All pairs of rows, side by side."""
    return np.hstack([np.repeat(a, len(b), axis=0), np.tile(b, (len(a), 1))])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--pairs", type=int, default=500)
    arguments = parser.parse_args()
    for native in (True, False):
        random = np.random.default_rng(5)
        apart = false = missed = 0
        errors = []
        for _ in range(arguments.pairs):
            shapes = [polytope(random, 12) for _ in "ab"]
            # From deep overlap to a distance of about 1.
            direction = random.normal(size=3)
            shift = direction / np.linalg.norm(direction) * random.uniform(0.5, 3.0)
            model = scene(shapes, shift, native)
            data = mujoco.MjData(model)
            mujoco.mj_forward(model, data)
            truth = Truth(*(world(model, data, geom) for geom in (0, 1)))
            distance = mujoco.mj_geomDistance(model, data, 0, 1, CUT_OFF, None)
            if truth.overlaps():
                missed += distance > 0
                continue
            apart += 1
            if distance <= 0:
                false += 1
                continue
            # The exact distance is above the lower bound and at most the upper one, found by bisection of decisions.
            low, high = 0.0, 2 * CUT_OFF
            for _ in range(40):
                middle = (low + high) / 2
                low, high = (low, middle) if truth.within(middle) else (middle, high)
            errors.append((distance - high) / high)
        errors = np.array(errors)
        print(
            f"{'native' if native else 'libccd'}: {arguments.pairs} pairs, {apart} apart: {false} taken for contact, "
            f"{missed} of {arguments.pairs - apart} contacts missed; relative error of distances: "
            f"median {np.median(abs(errors)):.1e}, largest {errors.max():+.1e}, least {errors.min():+.1e}"
        )


if __name__ == "__main__":
    main()
