"""Rigid bodies that turn."""

from __future__ import annotations

import importlib.util
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_array_equal

import exact_ccd
from exact_ccd import Bodies, Detector, Mesh, MeshFile, Place, nearest_poses
from hostile import CASES, positions, survive

ROD = Mesh(2, [], edges=[[0, 1]])
BAR = ROD, [[1, 0, 0], [4, 0, 0]]
POST = ROD, [[2, 2, -1], [2, 2, 1]]
REST = [0, 0, 0, 1, 0, 0, 0]
TURNED = [0, 0, 0, 1, 0, 0, 1]
"""By a right angle about the z axis; the quaternion has not the length 1."""

TIME = 0.41421356237309503
"""tan(π / 8) = √2 − 1, rounded down."""

CORNERS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
QUADS = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
CUBE = [face for a, b, c, d in QUADS for face in ((a, b, c), (a, c, d))]


def random_poses(random: np.random.Generator, count: int) -> np.ndarray:
    return np.hstack([4 * random.normal(size=(count, 3)), random.normal(size=(count, 4))])


def test_a_bar_swings_into_a_post() -> None:
    bodies = Bodies([BAR, POST])
    assert len(bodies) == 2
    start, end = [REST, REST], [TURNED, REST]
    assert bodies.collides(start, end) is True
    assert bodies.collides(start, end, until=np.nextafter(TIME, 1)) and not bodies.collides(start, end, until=TIME)
    contact = bodies.collision(start, end)
    assert (contact.kind, contact.bodies.tolist(), contact.primitives.tolist()) == ("ee", [0, 1], [0, 0])
    assert contact.time == TIME and abs(contact.v - 0.5) < 1e-12
    # The bar is met at the distance √8 from the origin.
    assert abs(1 + 3 * contact.u - 8**0.5) < 1e-12
    assert abs(np.linalg.norm(contact.normal) - 1) < 1e-12 and contact == bodies.collision(start, end)
    table = bodies.collisions(start, end)
    assert table.dtype == exact_ccd.BODY_CONTACT and len(table) == 1 and table["time"][0] == TIME
    report = bodies.step(start, end)
    assert report.earliest == contact and report.colliding == (0, 1, 0, 0) and report.touching == (0, 0, 0, 0)
    assert bodies.collision(start, start) is None and len(bodies.collisions(start, start)) == 0


def test_contacts_have_the_names_of_bodies() -> None:
    start, end = [REST, REST], [TURNED, REST]
    places = (Place("bar", "edge", 0), Place("post", "edge", 0))
    bodies = Bodies([BAR, POST], names=["bar", "post"])
    assert bodies.names == ("bar", "post")
    assert bodies.collision(start, end).places == places
    assert bodies.step(start, end).earliest.places == places
    assert bodies.free_step(start, end).contact.places == places
    assert Bodies([BAR, POST]).collision(start, end).places == (None, None)
    with pytest.raises(ValueError, match="there are 1 names for 2 bodies, expected one for each"):
        Bodies([BAR, POST], names=["bar"])
    with pytest.raises(TypeError, match="name 1 is of type int, expected a str"):
        Bodies([BAR, POST], names=["bar", 2])


def test_a_certified_step() -> None:
    bodies = Bodies([BAR, POST])
    start, end = [REST, REST], [TURNED, REST]
    step = bodies.free_step(start, end, keep=0.5)
    assert step.size == 0.5 * TIME and step.poses.shape == (2, 7) and step.contact == bodies.collision(start, end)
    assert not bodies.collides(start, step.poses)
    assert_array_equal(step.poses[1], REST)
    assert abs(step.poses[0, 6] - step.size) < 1e-15
    full = bodies.free_step(start, [REST, [0, 0, 5, 1, 0, 0, 0]])
    assert full.size == 1.0 and full.contact is None and full.poses[1].tolist() == [0, 0, 5, 1, 0, 0, 0]


def test_without_turn_a_step_is_a_straight_one() -> None:
    """Every time is the time of the same mesh in straight motion."""
    random = np.random.default_rng(5)
    mesh = Mesh(16, np.vstack([CUBE, np.add(CUBE, 8)]), groups=[0] * 8 + [1] * 8)
    found = 0
    for _ in range(30):
        places = random.integers(-8, 9, (2, 2, 3)) / 2
        ends = [np.hstack([place, np.tile([2.0, 0, 0, 0], (2, 1))]) for place in places]
        straight = Detector(mesh).collision(*(np.vstack([CORNERS + place for place in end]) for end in places))
        contact = Bodies([(CUBE, CORNERS), (CUBE, CORNERS)]).collision(*ends)
        assert (contact is None) == (straight is None)
        if contact is not None and straight is not None:
            assert (contact.kind, contact.time) == (straight.kind, straight.time)
            found += 1
    assert 5 < found < 30


def test_the_pairs_of_bodies_that_can_collide() -> None:
    start, end = [REST] * 3, [TURNED, REST, REST]
    later = ROD, [[1, 3, -1], [1, 3, 1]]
    for matrix, pair in ((None, [0, 1]), ([[0, 0, 1], [0, 0, 1], [1, 1, 0]], [0, 2]), (np.zeros((3, 3)), None)):
        matrix = None if matrix is None else np.array(matrix, bool)
        contact = Bodies([BAR, POST, later], can_collide=matrix, threads=1).collision(start, end)
        assert pair is None and contact is None or contact.bodies.tolist() == pair


def test_a_minimum_distance() -> None:
    start, end = [REST, REST], [TURNED, REST]
    near = Bodies([BAR, POST], min_distance=0.25).collision(start, end)
    assert 0 < near.time < TIME
    step = Bodies([BAR, POST], min_distance=0.25).free_step(start, end)
    assert not Bodies([BAR, POST], min_distance=0.25).collides(start, step.poses)


def test_bodies_of_files_and_of_faces() -> None:
    start, end = [REST, REST], [REST, [3, 0, 0, 1, 0, 0, 0]]
    file = MeshFile(CORNERS + [4, 0, 0], np.array(CUBE, np.uint32), np.empty((0, 2), np.uint32))
    for meshes in ([(CUBE, CORNERS), file], iter([[Mesh(8, CUBE), CORNERS.tolist()], file])):
        bodies = Bodies(meshes)
        assert bodies.collision(end, start) is not None or bodies.collides(start, [[3, 0, 0, 1, 0, 0, 0], REST])
        assert bodies.collision(start, [[4, 0, 0, 1, 0, 0, 0], REST]).time == 0.5


def rotations(quaternions: np.ndarray) -> np.ndarray:
    """The matrices of quaternions, scalar first: by the products of q v q*."""
    w, v = quaternions[:, 0], quaternions[:, 1:]
    cross = np.cross(v[:, None], np.eye(3)[None]).swapaxes(1, 2)
    squares = (quaternions**2).sum(axis=1)[:, None, None]
    matrices = (w**2 - (v**2).sum(axis=1))[:, None, None] * np.eye(3)
    return (matrices + 2 * v[:, :, None] * v[:, None] + 2 * w[:, None, None] * cross) / squares


def test_rotations_of_scipy() -> None:
    given = random_poses(np.random.default_rng(2), 2)
    end = [REST, REST]
    # The order of scipy is x, y, z, w.
    rotation = SimpleNamespace(as_quat=lambda: np.roll(given[:, 3:], -1, axis=1))
    bodies = Bodies([BAR, POST])
    assert bodies.free_step((given[:, :3], rotation), end) == bodies.free_step(given, end)
    if importlib.util.find_spec("scipy") is None:
        pytest.skip("scipy is not installed: pip install scipy")
    from scipy.spatial.transform import Rotation

    turned = Rotation.from_rotvec([[0, 0, np.pi / 2], [0, 0, 0]])
    contact = bodies.collision([REST, REST], (np.zeros((2, 3)), turned))
    # Between quaternions of one length, half of the turn takes half of the time.
    assert abs(contact.time - 0.5) < 1e-12


def test_nearest_poses_of_matrices() -> None:
    random = np.random.default_rng(3)
    given = random_poses(random, 200)
    given[0, 3:], given[1, 3:], given[2, 3:] = [0, 1, 0, 0], [0, 0, 0, -2], [5, 0, 0, 0]
    matrices = np.tile(np.eye(4), (200, 1, 1))
    matrices[:, :3, :3], matrices[:, :3, 3] = rotations(given[:, 3:]), given[:, :3]
    poses, deviations = nearest_poses(matrices)
    assert_array_equal(poses[:, :3], given[:, :3])
    assert np.abs(rotations(poses[:, 3:]) - matrices[:, :3, :3]).max() < 1e-14 and deviations.max() < 1e-14
    assert (poses[:, 3] >= 0).all()
    # A rotation is the nearest one of itself with a symmetric positive factor: its polar decomposition.
    stretched = matrices.copy()
    factor = random.normal(size=(200, 3, 3)) * 0.1
    stretched[:, :3, :3] = matrices[:, :3, :3] @ (np.eye(3) + factor @ factor.swapaxes(1, 2))
    poses, deviations = nearest_poses(stretched)
    assert np.abs(rotations(poses[:, 3:]) - matrices[:, :3, :3]).max() < 1e-13
    expected = np.abs(stretched - matrices).max(axis=(1, 2))
    np.testing.assert_allclose(deviations, expected, rtol=1e-9, atol=1e-12)
    # No rotation is near a reflection.
    assert nearest_poses([np.diag([-1.0, 1, 1, 1])]).deviations[0] >= 1
    assert nearest_poses([]).poses.shape == (0, 7)


POSES = np.array([REST, REST], float)


def changed(body: int, column: int, value: float) -> np.ndarray:
    poses = POSES.copy()
    poses[body, column] = value
    return poses


WRONG = {
    "poses0 has the shape (1, 7), expected (2, 7)": lambda: Bodies([BAR, POST]).collides([REST], [REST]),
    "poses1 has the shape (2, 6)": lambda: Bodies([BAR, POST]).collides(POSES, POSES[:, :6]),
    "poses1: body 1: coordinate 2 of the place is not finite": lambda: Bodies([BAR, POST]).collision(
        POSES, changed(1, 2, np.inf)
    ),
    "poses0: body 0: component 1 of the quaternion is NaN": lambda: Bodies([BAR, POST]).step(
        changed(0, 4, np.nan), POSES
    ),
    "poses1: body 1: the quaternion is 0": lambda: Bodies([BAR, POST]).collisions(POSES, changed(1, 3, 0)),
    "body 1: the quaternion vanishes in the step": lambda: Bodies([BAR, POST]).free_step(POSES, changed(1, 3, -2)),
    "keep is 0": lambda: Bodies([BAR, POST]).free_step(POSES, POSES, keep=0.0),
    "the places of poses0 has the shape (1, 3), expected (2, 3)": lambda: Bodies([BAR, POST]).collides(
        (np.zeros((1, 3)), SimpleNamespace(as_quat=lambda: POSES[:, 3:])), POSES
    ),
    "positions of body 1 has the shape (2, 2), expected (N, 3)": lambda: Bodies([BAR, (ROD, [[0, 1], [1, 2]])]),
    "body 1: ": lambda: Bodies([BAR, (ROD, [[0, 1, np.nan], [1, 2, 3]])]),
    "body 0: 1 position": lambda: Bodies([(ROD, [[0, 1, 2]])]),
    "body 0 is of type Mesh, expected a tuple of a mesh and its positions": lambda: Bodies([ROD]),
    "can_collide has the shape (3, 3), expected (B, B), for 2 bodies": lambda: Bodies(
        [BAR, POST], can_collide=np.ones((3, 3), bool)
    ),
    "can_collide: ": lambda: Bodies([BAR, POST], can_collide=np.array([[True, True], [False, True]])),
    "min_distance: ": lambda: Bodies([BAR, POST], min_distance=-1.0),
    "threads is 0": lambda: Bodies([BAR, POST], threads=0),
    "matrices has the shape (2, 3, 3), expected (N, 4, 4)": lambda: nearest_poses(np.zeros((2, 3, 3))),
    "matrices: body 0: a number is not finite": lambda: nearest_poses(np.full((1, 4, 4), np.nan)),
    "matrices: body 1: the last row is not 0, 0, 0, 1": lambda: nearest_poses([np.eye(4), np.ones((4, 4))]),
}


@pytest.mark.parametrize("message", WRONG)
def test_wrong_arguments(message: str) -> None:
    with pytest.raises((TypeError, ValueError)) as error:
        WRONG[message]()
    assert message in str(error.value) and "_native" not in str(error.value)


@pytest.mark.parametrize("name", ["collides", "collision", "collisions", "step", "free_step"])
def test_hostile_poses(name: str) -> None:
    random = np.random.default_rng(len(name))
    call = getattr(Bodies([BAR, POST]), name)
    answers = sum(survive(lambda: call(positions(random, 2, 7), positions(random, 2, 7))) for _ in range(CASES))
    assert 0 < answers < CASES


def test_distances_contain_those_of_sampled_surfaces() -> None:
    random = np.random.default_rng(5)
    bodies = Bodies([(CUBE, CORNERS), (CUBE, CORNERS), (CUBE, CORNERS)])
    for _ in range(20):
        poses = random_poses(random, 3)
        found = bodies.distances(poses, np.finfo(float).max)
        assert found.bodies.tolist() == [[0, 1], [0, 2], [1, 2]]
        assert found.points.shape == (3, 2, 3)
        assert np.all(found.lower <= found.upper) and np.all(found.upper - found.lower < 1e-10)
        between = np.linalg.norm(found.points[:, 0] - found.points[:, 1], axis=1)
        apart = found.lower > 0
        assert np.all(np.abs(between - found.lower)[apart] < 1e-8)
        # Corners are points of the surfaces, and so are at least as far apart.
        corners = [CORNERS @ turn(pose[3:]).T + pose[:3] for pose in poses]
        for (i, j), lower in zip(found.bodies, found.lower):
            pairs = np.linalg.norm(corners[i][:, None] - corners[j][None], axis=2)
            assert pairs.min() >= lower - 1e-12


def turn(q: np.ndarray) -> np.ndarray:
    """The matrix of a quaternion, scalar first, of any length."""
    w, x, y, z = q / np.linalg.norm(q)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def test_a_cut_off_of_distances_is_a_number_of_at_least_zero() -> None:
    bodies = Bodies([BAR, POST])
    assert len(bodies.distances([REST, REST], 0.5).bodies) == 0
    with pytest.raises(ValueError, match="cut_off"):
        bodies.distances([REST, REST], -1.0)
    with pytest.raises(ValueError, match="poses"):
        bodies.distances([REST], 1.0)
