"""Properties of the answers to queries in arrays."""

from __future__ import annotations

import os
from typing import get_args

import numpy as np
import pytest
from numpy.testing import assert_array_equal

import exact_ccd
from exact_ccd.queries import POINTS
from generated import as_indices, queries

FUNCTIONS = [
    exact_ccd.collides,
    exact_ccd.time_of_impact,
    exact_ccd.contact_count,
    exact_ccd.contact_times,
    exact_ccd.impacts,
]


def assert_same(a, b) -> None:
    """The answers have the same bits."""
    if isinstance(a, tuple):
        for one, other in zip(a, b):
            assert_same(one, other)
    else:
        assert a.dtype == b.dtype and a.shape == b.shape
        assert a.tobytes() == b.tobytes()


@pytest.mark.parametrize("distance", [0.0, 1.0])
@pytest.mark.parametrize("kind", POINTS)
@pytest.mark.parametrize("function", FUNCTIONS)
def test_forms_and_threads_do_not_change_the_bits(function, kind, distance) -> None:
    # Several tasks. All times within a distance come from integers, which is slow.
    points = queries(kind, 5000 if distance == 0.0 or function is exact_ccd.collides else 300)
    first = function(kind, points, min_distance=distance)
    for threads in (1, 3):
        assert_same(first, function(kind, points, min_distance=distance, threads=threads))
    assert_same(first, function(kind, **as_indices(points), min_distance=distance))


@pytest.mark.parametrize("kind", POINTS)
def test_answers_agree_with_each_other(kind) -> None:
    points = queries(kind, 3000, seed=1)
    for distance in (0.0, 0.5):
        collides = exact_ccd.collides(kind, points, min_distance=distance)
        assert 0 < collides.sum() < len(points)
        toi = exact_ccd.time_of_impact(kind, points, min_distance=distance)
        assert_array_equal(~np.isnan(toi), collides)
        offsets, intervals = exact_ccd.contact_times(kind, points, min_distance=distance)
        assert_array_equal(np.diff(offsets) > 0, collides)
        assert_array_equal(intervals[offsets[:-1][collides], 0], toi[collides])
        assert (intervals[:, 0] <= intervals[:, 1]).all()
        impacts = exact_ccd.impacts(kind, points, min_distance=distance)
        assert impacts.dtype == exact_ccd.IMPACT
        assert_array_equal(impacts["time"], toi)
        gap = np.linalg.norm(impacts["points"][:, 0] - impacts["points"][:, 1], axis=1)[collides]
        # The time is rounded down, and the parameters are within 2**-32.
        assert (gap <= distance + 1e-7).all()


def test_contact_stays_contact_with_a_distance() -> None:
    points = queries("ee", 3000, seed=2)
    near = exact_ccd.time_of_impact("ee", points, min_distance=0.25)
    contact = exact_ccd.time_of_impact("ee", points)
    collides = ~np.isnan(contact)
    assert (near[collides] <= contact[collides]).all()


@pytest.mark.parametrize("kind", POINTS)
def test_points_of_contact_are_among_the_points(kind) -> None:
    """Also at the largest numbers, where a sum of rounded parts may exceed them."""
    largest = np.finfo(np.float64).max
    points = queries(kind, 2000, seed=3)
    points[..., 0] = largest
    impacts = exact_ccd.impacts(kind, points)
    found = impacts["points"][~np.isnan(impacts["time"])]
    assert len(found) > 10
    assert (found[..., 0] == largest).all()


def test_no_queries() -> None:
    assert list(POINTS) == list(get_args(exact_ccd.Kind))
    for kind in POINTS:
        points = queries(kind, 0)
        assert exact_ccd.collides(kind, points).shape == (0,)
        assert exact_ccd.contact_times(kind, points).intervals.shape == (0, 2)
        assert exact_ccd.impacts(kind, points).shape == (0,)


def test_conversions_are_exact() -> None:
    points = queries("vf", 300)
    expected = exact_ccd.time_of_impact("vf", points)
    big = points.astype(">f8")
    shifted = np.zeros(points.nbytes + 1, np.uint8)[1:].view(np.float64).reshape(points.shape)
    shifted[...] = points
    frozen = points.copy()
    frozen.flags.writeable = False
    same = [points.astype(kind) for kind in ("f2", "f4", "i1", "i2", "i4", "i8", "g")]
    for form in [*same, big, shifted, frozen, points.tolist(), np.asfortranarray(points)]:
        assert_same(expected, exact_ccd.time_of_impact("vf", form))
    assert_same(expected[::-1].copy(), exact_ccd.time_of_impact("vf", points[::-1]))
    assert_same(expected[::2].copy(), exact_ccd.time_of_impact("vf", points[::2]))


def test_indices_of_every_type() -> None:
    form = as_indices(queries("ee", 300))
    expected = exact_ccd.collides("ee", **form)
    for kind in ("i2", "u2", "i4", "u4", "i8", "u8", ">i4", ">u8"):
        indices = form["indices"].astype(kind)
        assert_array_equal(exact_ccd.collides("ee", **{**form, "indices": indices}), expected)


def test_errors_name_the_row() -> None:
    points = queries("vf", 5000)
    points[4321, 6, 1] = np.nan
    with pytest.raises(ValueError, match=r"row 4321: coordinate y of point 2 at t = 1 is NaN"):
        exact_ccd.collides("vf", points)
    points[70, 0, 0] = np.inf
    with pytest.raises(ValueError, match=r"row 70: coordinate x of point 0 at t = 0 is inf"):
        exact_ccd.impacts("vf", points)

    form = as_indices(queries("ve", 5000))
    form["indices"][4000, 1] = 15000
    with pytest.raises(ValueError, match=r"row 4000: .*vertex 15000, but there are only 15000"):
        exact_ccd.collides("ve", **form)
    indices = form["indices"].astype(np.int32)
    indices[7, 2] = -1
    with pytest.raises(ValueError, match="row 7 of indices"):
        exact_ccd.collides("ve", **{**form, "indices": indices})
    form["vertices_t1"][17, 2] = np.nan
    with pytest.raises(ValueError, match="vertex 17 has z = NaN at t = 1"):
        exact_ccd.collides("ve", **form)

    large = queries("vv", 10).astype(np.int64)
    large[3] = 2**53 + 1
    with pytest.raises(ValueError, match="row 3 of points has a number that is not exactly a float64"):
        exact_ccd.collides("vv", large)
    large[3] = 2**63 - 1
    with pytest.raises(ValueError, match="row 3 of points"):
        exact_ccd.collides("vv", large)
    large[3] = 2**60
    assert exact_ccd.collides("vv", large)[3]


def test_wrong_arguments() -> None:
    points = queries("vf", 3)
    with pytest.raises(ValueError, match=r"shape \(3, 8, 3\), expected \(N, 6, 3\)"):
        exact_ccd.collides("ve", points)
    with pytest.raises(ValueError, match="kind 'xy'"):
        exact_ccd.collides("xy", points)
    with pytest.raises(TypeError, match="complex128"):
        exact_ccd.collides("vf", points.astype(complex))
    with pytest.raises(TypeError, match="masked"):
        exact_ccd.collides("vf", np.ma.masked_array(points))
    with pytest.raises(TypeError, match="either points, or indices"):
        exact_ccd.collides("vf", points, indices=[[0, 1, 2, 3]])
    with pytest.raises(TypeError, match="either points, or indices"):
        exact_ccd.collides("vf", indices=[[0, 1, 2, 3]])
    for distance in (-1.0, np.nan, np.inf):
        with pytest.raises(ValueError, match="separation"):
            exact_ccd.collides("vf", points, min_distance=distance)
    for threads in (0, 2000):
        with pytest.raises(ValueError, match="expected an integer from 1 to 1024"):
            exact_ccd.collides("vf", queries("vf", 5000), threads=threads)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="the system has no fork")
def test_a_forked_process_has_threads_of_its_own() -> None:
    points = queries("vf", 20000)
    expected = exact_ccd.collides("vf", points, threads=2)
    child = os.fork()
    if child == 0:
        same = np.array_equal(exact_ccd.collides("vf", points, threads=2), expected)
        os._exit(0 if same else 1)
    assert os.waitpid(child, 0)[1] == 0
