"""Properties of the answers to queries in arrays."""

from __future__ import annotations

import os
from typing import get_args

import numpy as np
import pytest
from numpy.testing import assert_array_equal

import exact_ccd
from exact_ccd import Queries
from exact_ccd.queries import POINTS
from generated import of_points, of_vertices, queries

VERBS = ["collides", "time_of_impact", "count", "intervals", "impact"]


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
@pytest.mark.parametrize("verb", VERBS)
def test_forms_and_threads_do_not_change_the_bits(verb, kind, distance) -> None:
    # Several tasks. All times within a distance come from integers, which is slow.
    points = queries(kind, 5000 if distance == 0.0 or verb == "collides" else 300)
    first = getattr(of_points(kind, points), verb)(separation=distance)
    for threads in (1, 3):
        assert_same(first, getattr(of_points(kind, points), verb)(separation=distance, threads=threads))
    assert_same(first, getattr(Queries(*of_vertices(kind, points)), verb)(separation=distance))


@pytest.mark.parametrize("kind", POINTS)
def test_the_last_time_that_counts(kind) -> None:
    """A query counts if its exact first time is at most the last time. A time between two float64 exceeds the lower."""
    points = of_points(kind, queries(kind, 3000, seed=4))
    toi, every = points.time_of_impact(), points.intervals()
    for until in (-1.0, 0.0, 0.5, 1.0, np.inf):
        until_then = points.time_of_impact(until=until)
        early = ~np.isnan(until_then)
        assert not (early & ~(toi <= until)).any() and not (~early & (toi < until)).any()
        assert_array_equal(until_then[early], toi[early])
        assert_array_equal(points.collides(until=until), early)
        assert_array_equal(points.count(until=until) != 0, early)
        assert_array_equal(points.impact(until=until)["time"], until_then)
        lengths = np.diff(points.intervals(until=until).offsets)
        assert_array_equal(lengths, np.where(early, np.diff(every.offsets), 0))
    assert 0 < np.isnan(points.time_of_impact(until=0.5)).sum() - np.isnan(toi).sum()
    third = Queries("vv", [[[0, 0, 0], [1, 0, 0]]], [[[3, 0, 0], [1, 0, 0]]])
    rounded = third.time_of_impact()[0]
    assert not third.collides(until=rounded)[0] and third.collides(until=np.nextafter(rounded, 1))[0]


@pytest.mark.parametrize("kind", POINTS)
def test_answers_agree_with_each_other(kind) -> None:
    points = queries(kind, 3000, seed=1)
    for distance in (0.0, 0.5):
        collides = of_points(kind, points).collides(separation=distance)
        assert 0 < collides.sum() < len(points)
        toi = of_points(kind, points).time_of_impact(separation=distance)
        assert_array_equal(~np.isnan(toi), collides)
        offsets, intervals = of_points(kind, points).intervals(separation=distance)
        assert_array_equal(np.diff(offsets) > 0, collides)
        assert_array_equal(intervals[offsets[:-1][collides], 0], toi[collides])
        assert (intervals[:, 0] <= intervals[:, 1]).all()
        impacts = of_points(kind, points).impact(separation=distance)
        assert impacts.dtype == exact_ccd.IMPACT
        assert_array_equal(impacts["time"], toi)
        gap = np.linalg.norm(impacts["points"][:, 0] - impacts["points"][:, 1], axis=1)[collides]
        # The time is rounded down, and the parameters are within 2**-32.
        assert (gap <= distance + 1e-7).all()


def test_contact_stays_contact_with_a_distance() -> None:
    points = queries("ee", 3000, seed=2)
    near = of_points("ee", points).time_of_impact(separation=0.25)
    contact = of_points("ee", points).time_of_impact()
    collides = ~np.isnan(contact)
    assert (near[collides] <= contact[collides]).all()


@pytest.mark.parametrize("kind", POINTS)
def test_points_of_contact_are_among_the_points(kind) -> None:
    """Also at the largest numbers, where a sum of rounded parts may exceed them."""
    largest = np.finfo(np.float64).max
    points = queries(kind, 2000, seed=3)
    points[..., 0] = largest
    impacts = of_points(kind, points).impact()
    found = impacts["points"][~np.isnan(impacts["time"])]
    assert len(found) > 10
    assert (found[..., 0] == largest).all()


def test_no_queries() -> None:
    assert list(POINTS) == list(get_args(exact_ccd.Kind))
    for kind in POINTS:
        points = queries(kind, 0)
        assert of_points(kind, points).collides().shape == (0,)
        assert of_points(kind, points).intervals().times.shape == (0, 2)
        assert of_points(kind, points).impact().shape == (0,)


def test_conversions_are_exact() -> None:
    points = queries("vf", 300)
    expected = of_points("vf", points).time_of_impact()
    big = points.astype(">f8")
    shifted = np.zeros(points.nbytes + 1, np.uint8)[1:].view(np.float64).reshape(points.shape)
    shifted[...] = points
    frozen = points.copy()
    frozen.flags.writeable = False
    same = [points.astype(kind) for kind in ("f2", "f4", "i1", "i2", "i4", "i8", "g")]
    for form in [*same, big, shifted, frozen, np.asfortranarray(points), np.asfortranarray(points, np.float32)]:
        assert_same(expected, of_points("vf", form).time_of_impact())
        assert_same(expected[::-1].copy(), of_points("vf", form[::-1]).time_of_impact())
        assert_same(expected[::2].copy(), of_points("vf", form[::2]).time_of_impact())
        x0, x1 = form[:, :4].reshape(-1, 3), form[:, 4:].reshape(-1, 3)
        assert_same(expected, Queries("vf", x0, x1, np.arange(1200).reshape(-1, 4)).time_of_impact())
    assert_same(expected, Queries("vf", points[:, :4].tolist(), points[:, 4:].tolist()).time_of_impact())


def test_indices_of_every_type() -> None:
    kind, x0, x1, vertices = of_vertices("ee", queries("ee", 300))
    expected = Queries(kind, x0, x1, vertices).collides()
    for dtype in ("i2", "u2", "i4", "u4", "i8", "u8", ">i4", ">u8"):
        assert_array_equal(Queries(kind, x0, x1, vertices.astype(dtype)).collides(), expected)


def test_errors_name_the_row() -> None:
    points = queries("vf", 5000)
    points[4321, 6, 1] = np.nan
    with pytest.raises(ValueError, match=r"row 4321: coordinate y of point 2 at t = 1 is NaN"):
        of_points("vf", points).collides()
    points[70, 0, 0] = np.inf
    with pytest.raises(ValueError, match=r"row 70: coordinate x of point 0 at t = 0 is inf"):
        of_points("vf", points).impact()

    kind, x0, x1, vertices = of_vertices("ve", queries("ve", 5000))
    vertices[4000, 1] = 15000
    with pytest.raises(ValueError, match="row 4000: vertex 15000, expected one below 15000"):
        Queries(kind, x0, x1, vertices).collides()
    negative = vertices.astype(np.int32)
    negative[7, 2] = -1
    with pytest.raises(ValueError, match="row 7 of vertices"):
        Queries(kind, x0, x1, negative)
    x1[17, 2] = np.nan
    with pytest.raises(ValueError, match="vertex 17 has z = NaN at t = 1"):
        Queries(kind, x0, x1, vertices).collides()

    large = queries("vv", 10).astype(np.int64)
    large[3] = 2**53 + 1
    with pytest.raises(ValueError, match="row 3 of x0 has a number that is not exactly a float64"):
        of_points("vv", large).collides()
    large[3] = 2**63 - 1
    with pytest.raises(ValueError, match="row 3 of x0"):
        of_points("vv", large).collides()
    large[3] = 2**60
    assert of_points("vv", large).collides()[3]


def test_wrong_arguments() -> None:
    x = np.zeros((3, 4, 3))
    with pytest.raises(ValueError, match=r"x0 has the shape \(3, 4, 3\), expected \(N, 3, 3\)"):
        Queries("ve", x, x)
    with pytest.raises(ValueError, match=r"x1 has the shape \(2, 4, 3\), expected that of x0: \(3, 4, 3\)"):
        Queries("vf", x, x[:2])
    with pytest.raises(ValueError, match="kind 'xy'"):
        Queries("xy", x, x)
    with pytest.raises(TypeError, match="complex128"):
        Queries("vf", x.astype(complex), x)
    with pytest.raises(TypeError, match="masked"):
        Queries("vf", np.ma.masked_array(x), x)
    for distance in (-1.0, np.nan, np.inf):
        with pytest.raises(ValueError, match="separation"):
            Queries("vf", x, x).collides(separation=distance)
    for threads in (0, 2000):
        with pytest.raises(ValueError, match="expected an integer from 1 to 1024"):
            Queries("vf", x, x).collides(threads=threads)


def test_texts() -> None:
    points = of_points("ve", queries("ve", 7))
    assert len(points) == len(Queries(*of_vertices("ve", queries("ve", 7)))) == 7
    assert repr(points) == '<exact_ccd.Queries: 7 of kind "ve">' and points.kind == "ve"


@pytest.mark.skipif(not hasattr(os, "fork"), reason="the system has no fork")
def test_a_forked_process_has_threads_of_its_own() -> None:
    points = queries("vf", 20000)
    expected = of_points("vf", points).collides(threads=2)
    child = os.fork()
    if child == 0:
        same = np.array_equal(of_points("vf", points).collides(threads=2), expected)
        os._exit(0 if same else 1)
    assert os.waitpid(child, 0)[1] == 0
