"""Many worlds at a time: the same answers as by a detector for each world."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_array_equal

import exact_ccd
from exact_ccd import Contact, CrossingError, Detector, Mesh, Worlds
from test_meshes import FACES, soup, two_triangles

COUNT = 7


def worlds_of(seed: int) -> tuple[Mesh, np.ndarray, np.ndarray]:
    """One mesh; some worlds move little, and are free."""
    mesh, x0, x1 = soup(seed, triangles=8)
    random = np.random.default_rng(seed)
    speeds = np.linspace(0.0, 1.0, COUNT)[:, None, None]
    shifts = random.integers(-2, 3, (COUNT, 1, 3))
    return mesh, x0 + shifts, x0 + shifts + speeds * (x1 - x0)


def rows(contact: np.ndarray) -> list:
    """The contact of each world, None if there is none."""
    return [Contact(*(row[name] for name in exact_ccd.CONTACT.names)) if row["kind"] else None for row in contact]


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize("settings", [{}, {"min_distance": 2**-10}, {"threads": 1}])
@pytest.mark.parametrize("rule", [None, lambda i, j: (i + j) % 3 != 0])
def test_the_answers_are_those_of_each_world(dtype, settings, rule) -> None:
    mesh, x0, x1 = worlds_of(0)
    mesh = Mesh(mesh.vertex_count, mesh.faces, mesh.loose_edges, can_collide=rule)
    x0, x1 = x0.astype(dtype), x1.astype(dtype)
    detector, worlds = Detector(mesh, **settings), Worlds(mesh, **settings)
    each = list(zip(x0, x1))

    collides = worlds.collides(x0, x1)
    assert collides.tolist() == [detector.collides(*ends) for ends in each]
    assert 0 < collides.sum() < COUNT
    early = [detector.collides(*ends, until=0.25) for ends in each]
    assert worlds.collides(x0, x1, until=0.25).tolist() == early
    earliest = worlds.collision(x0, x1)
    assert rows(earliest) == [detector.collision(*ends) for ends in each]
    assert_array_equal(~np.isnan(earliest["time"]), collides)
    offsets, contacts = worlds.collisions(x0, x1, until=0.5)
    for world, ends in enumerate(each):
        expected = detector.collisions(*ends, until=0.5)
        assert contacts[offsets[world] : offsets[world + 1]].tobytes() == expected.tobytes()
    free = worlds.free_step(x0, x1, keep=0.5)
    steps = [detector.free_step(*ends, keep=0.5) for ends in each]
    assert free.size.tolist() == [step.size for step in steps]
    assert_array_equal(free.positions, [step.positions for step in steps])
    assert rows(free.contact) == [step.contact for step in steps]
    assert_array_equal(free.touching, [step.touching for step in steps])
    report = worlds.step(x0, x1)
    reports = [detector.step(*ends) for ends in each]
    for name in ("candidates", "colliding", "touching"):
        assert_array_equal(getattr(report, name), [getattr(one, name) for one in reports])
    assert rows(report.earliest) == [one.earliest for one in reports]


def test_no_worlds() -> None:
    worlds, none = Worlds(Mesh(6, FACES)), np.empty((0, 6, 3))
    assert worlds.collides(none, none).shape == (0,)
    assert worlds.collision(none, none).dtype == exact_ccd.CONTACT
    assert worlds.free_step(none, none).positions.shape == (0, 6, 3)
    assert worlds.collisions(none, none).offsets.tolist() == [0]


def test_errors_name_the_first_world() -> None:
    x = np.repeat(two_triangles(1.0)[None], 5, axis=0)
    worlds = Worlds(Mesh(6, FACES), start_check=True)
    x[4, 0, 0] = np.inf
    x[3, 2, 1] = np.nan
    with pytest.raises(ValueError, match="world 3: at the start, vertex 2"):
        worlds.collides(x, x)
    x[3], x[4] = x[0], x[0]
    x[1] = [*two_triangles(1.0)[:3], [1, 1, -1], [1, 1, 1], [9, 1, 1]]
    with pytest.raises(CrossingError, match="world 1: at the start") as error:
        worlds.collision(x, x)
    assert (error.value.edge, error.value.face) == (3, 0)
    with pytest.raises(ValueError, match=r"x1 has the shape \[4, 6, 3\], expected that of x0: \[5, 6, 3\]"):
        worlds.collides(x, x[:4])
    with pytest.raises(ValueError, match=r"x0 has the shape \(6, 3\), expected \(N, 6, 3\)"):
        worlds.collides(x[0], x)


def test_an_exception_of_the_rule_ends_all_worlds() -> None:
    def rule(i: int, j: int) -> bool:
        raise KeyError("no such vertex")

    x0, x1 = (np.repeat(two_triangles(z)[None], 5, axis=0) for z in (1.0, -1.0))
    worlds = Worlds(Mesh(6, FACES, can_collide=rule))
    for _ in range(2):
        with pytest.raises(KeyError, match="no such vertex"):
            worlds.collides(x0, x1)
