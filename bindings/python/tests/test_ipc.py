"""The functions of ipctk, beside ipctk."""

from __future__ import annotations

import math

import numpy as np
import pytest

from exact_ccd import ipc

ipctk = pytest.importorskip("ipctk", reason="ipctk is not installed: pip install ipctk")


@pytest.fixture(autouse=True)
def threads():
    """ExactCCD sets the number of threads of ipctk to 1: back to all of them."""
    count = ipctk.get_num_threads()
    yield
    ipctk.set_num_threads(count)


def mesh_of(seed: int, dim: int, loose: bool):
    """A random mesh in motion: triangles or polylines, with loose points and edges."""
    random = np.random.default_rng(seed)
    size = 3 if dim == 3 else 2
    parts = int(random.integers(3, 15))
    count = size * parts
    primitives = np.arange(count, dtype=np.int32).reshape(-1, size)
    extra = (4 if dim == 3 else 0) + 3 if loose else 0
    total = count + extra
    if dim == 3:
        edges = np.vstack([primitives[:, [0, 1]], primitives[:, [1, 2]], primitives[:, [2, 0]]])
        if loose:
            edges = np.vstack([edges, [[count, count + 1], [count + 2, count + 3]]])
        faces = primitives
    else:
        edges, faces = primitives, np.empty((0, 3), np.int32)
    centres = np.repeat(random.uniform(-4, 4, (parts, dim)), size, axis=0)
    centres = np.vstack([centres, random.uniform(-4, 4, (extra, dim))])
    x0 = centres + random.normal(0, 0.5, (total, dim))
    x1 = x0 + random.normal(0, random.choice([0.1, 1.0, 4.0]), (total, dim))
    mesh = ipctk.CollisionMesh(x0, edges, faces)
    if random.random() < 0.5:
        patches = random.integers(0, 3, total).astype(np.int32)
        mesh.can_collide = ipctk.make_vertex_patches_filter(patches)
    return mesh, x0, x1


def meshes(count: int):
    """Meshes that ipctk accepts: without intersections at the start."""
    found = 0
    for seed in range(10 * count):
        mesh, x0, x1 = mesh_of(seed, 2 + seed % 2, loose=seed % 4 > 1)
        if found < count and not ipctk.has_intersections(mesh, x0):
            found += 1
            yield mesh, x0, x1
    assert found == count


def test_random_meshes() -> None:
    verdicts = []
    for mesh, x0, x1 in meshes(150):
        free = ipc.is_step_collision_free(mesh, x0, x1)
        verdicts.append(free)
        # ipctk never misses a contact, and reports some where there is none.
        if ipctk.is_step_collision_free(mesh, x0, x1):
            assert free
        size = ipc.compute_collision_free_stepsize(mesh, x0, x1, conservative_rescaling=1.0)
        assert (size == 1.0) == free
        assert size >= ipctk.compute_collision_free_stepsize(mesh, x0, x1)
        kept = ipc.compute_collision_free_stepsize(mesh, x0, x1)
        assert kept == (1.0 if free else pytest.approx(0.9 * size))
        assert free or ipctk.is_step_collision_free(mesh, x0, x0 + 0.5 * kept * (x1 - x0))
        assert ipc.has_intersections(mesh, x1) == ipctk.has_intersections(mesh, x1)
        candidates = ipc.Candidates()
        candidates.build(mesh, x0, x1)
        assert candidates.is_step_collision_free(mesh, x0, x1) == free
        all_at_once = candidates.compute_collision_free_stepsize(mesh, x0, x1, conservative_rescaling=1.0)
        assert all_at_once == pytest.approx(size)
    assert 20 < sum(verdicts) < 130


def test_random_meshes_with_a_distance() -> None:
    for mesh, x0, x1 in meshes(60):
        d = 0.01
        free = ipc.is_step_collision_free(mesh, x0, x1, d)
        if ipctk.is_step_collision_free(mesh, x0, x1, d):
            assert free
        size = ipc.compute_collision_free_stepsize(mesh, x0, x1, d, conservative_rescaling=1.0)
        assert size >= ipctk.compute_collision_free_stepsize(mesh, x0, x1, d)


DISTANCES = {
    "point_point_ccd": (4, ipctk.point_point_distance),
    "point_edge_ccd": (6, ipctk.point_edge_distance),
    "point_triangle_ccd": (8, ipctk.point_triangle_distance),
    "edge_edge_ccd": (8, ipctk.edge_edge_distance),
}


@pytest.mark.parametrize("dim", [2, 3])
def test_single_pairs(dim: int) -> None:
    random = np.random.default_rng(dim)
    tight = ipctk.TightInclusionCCD()
    exact = ipc.ExactCCD()
    for name in [*DISTANCES][: 2 * dim - 2]:
        count, squared_distance = DISTANCES[name]
        for case in range(200):
            points = random.normal(size=(count, dim))
            d = 0.0 if case % 2 else 0.2
            hit, toi = getattr(ipc, name)(*points, d, conservative_rescaling=1.0)
            their_hit, their_toi = getattr(tight, name)(*points, d)
            if d == 0.0:
                assert their_hit or not hit
                assert not hit or their_toi <= toi <= 1.0
            elif hit:
                # ipctk misses some of these, and has others too late.
                start, end = points[: count // 2], points[count // 2 :]
                distance = math.sqrt(squared_distance(*(start + toi * (end - start))))
                assert distance == pytest.approx(d) or toi == 0.0 and distance <= d
            else:
                assert not their_hit or their_toi > 0.0
            if hit:
                assert getattr(exact, name)(*points, d) == (True, 0.9 * toi)
                # The contact may be just above the float64 that it is rounded down to.
                assert getattr(ipc, name)(*points, d, tmax=math.nextafter(toi, 2.0)) == (True, 0.9 * toi)
                if toi > 0.0:
                    assert getattr(ipc, name)(*points, d, math.nextafter(toi, 0.0)) == (False, math.inf)
            else:
                assert toi == math.inf


def test_the_narrow_phase_of_ipctk() -> None:
    exact = ipc.ExactCCD()
    assert ipctk.get_num_threads() == 1
    for mesh, x0, x1 in meshes(20):
        expected = ipc.is_step_collision_free(mesh, x0, x1)
        assert ipctk.is_step_collision_free(mesh, x0, x1, narrow_phase_ccd=exact) == expected
        size = ipctk.compute_collision_free_stepsize(mesh, x0, x1, narrow_phase_ccd=exact)
        # A pair in contact between the fraction of an earlier time and that time is not examined in ipctk.
        assert size >= ipc.compute_collision_free_stepsize(mesh, x0, x1, narrow_phase_ccd=exact)
        assert size <= ipc.compute_collision_free_stepsize(mesh, x0, x1, conservative_rescaling=1.0)


def test_loose_points_and_edges() -> None:
    """A point meets another one, or a rod; the vertices have their numbers in the mesh."""
    x0 = np.array([[9.0, 0, 0], [9, 1, 0], [-1, 0, 0], [1, 0, 0], [0, 0, 1]])
    x1 = x0.copy()
    x1[4, 2] = -1.0
    mesh = ipctk.CollisionMesh(x0, np.array([[2, 3]]), np.empty((0, 3), int))
    assert ipc.compute_collision_free_stepsize(mesh, x0, x1, conservative_rescaling=0.5) == 0.25
    mesh.can_collide = ipctk.CollisionFilter(lambda i, j: {i, j} == {4, 2})
    assert not ipc.is_step_collision_free(mesh, x0, x1)
    mesh.can_collide = ipctk.CollisionFilter(lambda i, j: {i, j} == {4, 1})
    assert ipc.is_step_collision_free(mesh, x0, x1)


def test_the_rescaling_of_a_subclass() -> None:
    class Halves(ipc.ExactCCD):
        def __init__(self) -> None:
            super().__init__(0.5)

    x0 = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0.25, 0.25, 1]])
    x1 = x0 - [0, 0, 2] * (np.arange(4) == 3)[:, None]
    mesh = ipctk.CollisionMesh(x0, np.array([[0, 1], [1, 2], [2, 0]]), np.array([[0, 1, 2]]))
    candidates = ipc.Candidates()
    candidates.build(mesh, x0, x1)
    for size in (ipc.compute_collision_free_stepsize, candidates.compute_collision_free_stepsize):
        assert size(mesh, x0, x1, narrow_phase_ccd=Halves()) == 0.25
        assert size(mesh, x0, x1, narrow_phase_ccd=ipc.ExactCCD(0.25)) == 0.125
        assert size(mesh, x0, x1, narrow_phase_ccd=ipctk.TightInclusionCCD(conservative_rescaling=0.5)) == 0.45
        assert size(mesh, x0, x1, narrow_phase_ccd=Halves(), conservative_rescaling=1.0) == pytest.approx(0.5)


def test_refused() -> None:
    mesh, x0, x1 = mesh_of(1, 3, loose=False)
    with pytest.raises(ValueError, match="vertices_t1 has"):
        ipc.is_step_collision_free(mesh, x0, x1[:-1])
    for keep in (0.0, 1.5, math.nan):
        with pytest.raises(ValueError, match="conservative_rescaling"):
            ipc.compute_collision_free_stepsize(mesh, x0, x1, conservative_rescaling=keep)


FACE = [np.array(corner, float) for corner in ([0, 0, 0], [1, 0, 0], [0, 1, 0])]


@pytest.mark.parametrize("name", ["AdditiveCCD", "TightInclusionCCD"])
def test_narrow_phases_of_the_same_names(name: str) -> None:
    """Contact at 0.2 of a pair that approaches at constant speed, at three distances."""
    ours, theirs = getattr(ipc, name)(), getattr(ipctk, name)()
    assert ours.conservative_rescaling == theirs.conservative_rescaling
    for height in (1.0, 1e-2, 1e-4):
        start, end = np.array([0.25, 0.25, height]), np.array([0.25, 0.25, -4 * height])
        rod = FACE[0] + [-1, 0.25, 0], FACE[0] + [1, 0.25, 0]
        for method, points in [
            ("point_triangle_ccd", (start, *FACE, end, *FACE)),
            ("point_point_ccd", (start, FACE[0] + [0.25, 0.25, 0], end, FACE[0] + [0.25, 0.25, 0])),
            ("point_edge_ccd", (start, *rod, end, *rod)),
            ("edge_edge_ccd", (start - FACE[2], start + FACE[2], *FACE[:2], end - FACE[2], end + FACE[2], *FACE[:2])),
        ]:
            mine, other = getattr(ours, method)(*points), getattr(theirs, method)(*points)
            assert mine[0] is other[0] is True
            # ipctk stops there or before; its own tolerance is 1e-6 of the motion.
            assert other[1] <= mine[1] * (1 + 1e-9), (method, height)
            assert mine[1] - other[1] < (1e-2 if name == "TightInclusionCCD" and height < 1e-3 else 1e-4), (method, height)
    apart = np.array([0.25, 0.25, 0.5])
    assert ours.point_triangle_ccd(apart, *FACE, apart, *FACE) == (False, math.inf)
    names = ("p_t0", "t0_t0", "t1_t0", "t2_t0", "p_t1", "t0_t1", "t1_t1", "t2_t1")
    within = ours.point_triangle_ccd(**dict(zip(names, (apart, *FACE) * 2)), min_distance=0.5)
    assert within == (True, 0.0)


def test_the_factor_of_a_narrow_phase_of_this_module() -> None:
    mesh = ipctk.CollisionMesh(np.vstack([*FACE, [[0.25, 0.25, 1.0]]]), ipctk.edges([[0, 1, 2]]), [[0, 1, 2]])
    x0 = np.vstack([*FACE, [[0.25, 0.25, 1.0]]])
    x1 = x0 - [0, 0, 5] * (np.arange(4) == 3)[:, None]
    size = ipc.compute_collision_free_stepsize
    assert size(mesh, x0, x1) == size(mesh, x0, x1, narrow_phase_ccd=ipc.TightInclusionCCD()) == 0.18
    quarter = size(mesh, x0, x1, narrow_phase_ccd=ipc.AdditiveCCD(conservative_rescaling=0.25))
    assert quarter == size(mesh, x0, x1, conservative_rescaling=0.25) and abs(quarter - 0.05) < 1e-16
    # The default of ipctk comes nearer.
    assert 0.1999 < ipctk.compute_collision_free_stepsize(mesh, x0, x1) < 0.2


def test_potentials_of_ipctk_take_the_candidates() -> None:
    found, dhat = 0, 0.8
    for mesh, x, _ in meshes(20):
        if mesh.num_codim_vertices:
            # ipctk asks the rule with other numbers of these vertices.
            continue
        candidates = ipc.Candidates()
        candidates.build(mesh, x, inflation_radius=dhat / 2)
        ours, theirs = ipctk.NormalCollisions(), ipctk.NormalCollisions()
        ours.build(candidates.to_ipctk(mesh), mesh, x, dhat)
        theirs.build(mesh, x, dhat)
        barrier = ipctk.BarrierPotential(dhat, 1.0)
        energies = [barrier(collisions, mesh, x) for collisions in (ours, theirs)]
        assert len(ours) == len(theirs) and np.allclose(*energies, rtol=1e-12, atol=0.0)
        found += len(ours) > 0
    assert found > 5
