"""What Warp and Newton answer to one query at t = 0, on the CPU: see hard_peers.py.

Newton has no function about the time of contact of two moving primitives: its solvers of cloth compare distances at rest. These
functions are kernels, which Warp compiles once.
"""

import numpy
import warp
from newton._src.geometry.kernels import triangle_closest_point

warp.config.quiet = True


@warp.kernel
def triangles(points: warp.array(dtype=warp.vec3d), touch: warp.array(dtype=warp.int32)):
    touch[0] = warp.intersect_tri_tri(points[0], points[1], points[2], points[3], points[4], points[5])


@warp.kernel
def edges(points: warp.array(dtype=warp.vec3), distance: warp.array(dtype=float)):
    # An edge is a point where its squared length is 0.
    closest = warp.closest_point_edge_edge(points[0], points[1], points[2], points[3], 0.0)
    distance[0] = closest[2]


@warp.kernel
def vertex_and_face(points: warp.array(dtype=warp.vec3), distance: warp.array(dtype=float)):
    closest, _barycentric, _feature = triangle_closest_point(points[1], points[2], points[3], points[0])
    distance[0] = warp.length(closest - points[0])


def launched(kernel, points, point_type, number_type):
    """The number that a kernel computes from points."""
    result = warp.zeros(1, dtype=number_type, device="cpu")
    warp.launch(kernel, dim=1, inputs=[warp.array(points, dtype=point_type, device="cpu"), result], device="cpu")
    return result.numpy()[0]


def in_single_precision(query):
    """The points at t = 0, and the distance, if single precision holds all of these numbers."""
    exact = numpy.array(query.points[0]), numpy.float64(query.distance)
    rounded = [numbers.astype(numpy.float32) for numbers in exact]
    return rounded if all((a == b).all() for a, b in zip(exact, rounded)) else None


def sides(query, points, count):
    """The points of the first and the second primitive, the last of each repeated up to this number."""
    first = {"vf": 1, "ee": 2, "ve": 1, "vv": 1}[query.kind]
    return numpy.array([p for side in (points[:first], points[first:]) for p in [*side, side[-1], side[-1]][:count]])


def warp_triangles():
    """Two triangles, with equal corners for an edge or a vertex, in double precision."""

    def answer(query):
        if query.distance > 0:
            return None
        points = sides(query, query.points[0], 3)
        return bool(launched(triangles, points, warp.vec3d, warp.int32)), None

    return answer


def of_distance(kernel, placed):
    """The distance of a query whose numbers are of single precision, and whose points are placed as a kernel takes them."""

    def answer(query):
        numbers = in_single_precision(query)
        points = numbers and placed(query, numbers[0])
        if points is None:
            return None
        return bool(launched(kernel, points, warp.vec3, float) <= numbers[1]), None

    return answer


def warp_edges():
    """Two edges, of length zero for a vertex."""
    return of_distance(edges, lambda query, points: None if query.kind == "vf" else sides(query, points, 2))


def newton_vertex_and_face():
    """A vertex and the closest point of a face."""
    return of_distance(vertex_and_face, lambda query, points: points if query.kind == "vf" else None)
