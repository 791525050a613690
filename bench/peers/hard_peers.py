"""The answers of the peers of bench/peers/hard to one query, each by one call of its library.

A method takes a query and returns if there is contact, and the time of it or None; or None if the query is none that
it takes. Each names the question that it answers: the whole step, or t = 0 alone.
"""

from fractions import Fraction


def ipctk_step(name):
    """The narrow phases of the IPC Toolkit: conservative, for all kinds and distances."""
    import ipctk

    ipctk.set_logger_level(ipctk.LoggerLevel.off)
    method = getattr(ipctk, name)()
    calls = {
        "vf": method.point_triangle_ccd,
        "ee": method.edge_edge_ccd,
        "ve": method.point_edge_ccd,
        "vv": method.point_point_ccd,
    }

    def answer(query):
        points = [point.copy() for now in query.points for point in now]
        return calls[query.kind](*points, min_distance=query.distance)

    return answer


def triangle(library, points):
    """A mesh of one triangle. With equal corners it is an edge or a point."""
    if library.__name__.startswith("coal"):
        mesh = library.BVHModelOBBRSS()
        mesh.beginModel(1, 3)
        mesh.addTriangle(*points)
    else:
        mesh = library.BVHModel()
        mesh.beginModel(3, 1)
        mesh.addSubModel(points, [[0, 1, 2]])
    mesh.endModel()
    return mesh


def coal_rest():
    """A triangle and a sphere about the vertex with the distance as its radius."""
    import coal

    def answer(query):
        if query.kind != "vf":
            return None
        start = query.points[0]
        place = coal.Transform3s()
        place.setTranslation(start[0])
        mesh, sphere = triangle(coal, start[1:]), coal.Sphere(query.distance)
        result = coal.collide(
            mesh, coal.Transform3s(), sphere, place, coal.CollisionRequest(), coal.CollisionResult()
        )
        return result > 0, None

    return answer


def fcl_rest():
    """The same in FCL."""
    import fcl
    import numpy

    def answer(query):
        if query.kind != "vf":
            return None
        start = query.points[0]
        mesh = fcl.CollisionObject(triangle(fcl, numpy.array(start[1:])), fcl.Transform())
        sphere = fcl.CollisionObject(fcl.Sphere(query.distance), fcl.Transform(start[0]))
        return fcl.collide(mesh, sphere, fcl.CollisionRequest(), fcl.CollisionResult()) > 0, None

    return answer


def fcl_step():
    """Two meshes of one triangle each, with equal corners for an edge or a vertex, that do not turn or deform."""
    import fcl
    import numpy

    def path(now, then):
        moves = {tuple(Fraction(b) - Fraction(a) for a, b in zip(p, q)) for p, q in zip(now, then)}
        if len(moves) != 1:
            return None
        move = [float(x) for x in next(iter(moves))]
        corners = numpy.array((list(now) + [now[-1]] * 2)[:3])
        return fcl.CollisionObject(triangle(fcl, corners), fcl.Transform()), fcl.Transform(numpy.array(move))

    def answer(query):
        first = {"vf": 1, "ee": 2, "ve": 1, "vv": 1}[query.kind]
        start, end = query.points
        if query.distance > 0:
            return None
        bodies = path(start[:first], end[:first]), path(start[first:], end[first:])
        if None in bodies:
            return None
        (a, a_end), (b, b_end) = bodies
        result = fcl.ContinuousCollisionResult()
        time = fcl.continuousCollide(a, a_end, b, b_end, fcl.ContinuousCollisionRequest(), result)
        return bool(result.is_collide), time

    return answer


def trimesh_rest():
    """The point of the triangle that is closest to the vertex."""
    import numpy
    import trimesh

    def answer(query):
        if query.kind != "vf":
            return None
        vertex, *corners = query.points[0]
        closest = trimesh.triangles.closest_point(numpy.array([corners]), numpy.array([vertex]))[0]
        return bool(numpy.linalg.norm(closest - vertex) <= query.distance), None

    return answer


def mujoco_rest():
    """Two capsules, whose radii add up to the distance. MuJoCo takes sizes from 1e-15 to 1e10."""
    import mujoco
    import numpy

    def answer(query):
        sizes = numpy.abs([query.points[0][1] - query.points[0][0], query.points[0][-1] - query.points[0][-2]])
        magnitude = numpy.abs(query.points[0]).max()
        if query.kind != "ee" or not 2e-14 <= query.distance <= 1e6 or magnitude > 1e6:
            return None
        if sizes.max(axis=1).min() < 1e-9:
            return None
        geoms = ""
        for ends in (query.points[0][:2], query.points[0][2:]):
            numbers = " ".join(repr(float(x)) for end in ends for x in end)
            geoms += f'<body><freejoint/><geom type="capsule" fromto="{numbers}" size="{query.distance / 2!r}"/></body>'
        model = mujoco.MjModel.from_xml_string(f"<mujoco><worldbody>{geoms}</worldbody></mujoco>")
        data = mujoco.MjData(model)
        mujoco.mj_forward(model, data)
        return data.ncon > 0, None

    return answer


def of_warp(name):
    """Kernels of Warp, which are compiled for the CPU at the first call."""
    import warp_peers

    return getattr(warp_peers, name)()


# Names, methods, and true if the question is about the whole step; else it is about t = 0.
METHODS = {
    "ipctk TightInclusionCCD": (lambda: ipctk_step("TightInclusionCCD"), True),
    "ipctk AdditiveCCD": (lambda: ipctk_step("AdditiveCCD"), True),
    "FCL continuousCollide": (fcl_step, True),
    "FCL collide": (fcl_rest, False),
    "Coal collide": (coal_rest, False),
    "trimesh closest_point": (trimesh_rest, False),
    "MuJoCo capsules": (mujoco_rest, False),
    "Warp intersect_tri_tri": (lambda: of_warp("warp_triangles"), False),
    "Warp closest_point_edge_edge": (lambda: of_warp("warp_edges"), False),
    "Newton triangle_closest_point": (lambda: of_warp("newton_vertex_and_face"), False),
}
