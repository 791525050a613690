"""Single pairs of `exact_ccd.ipc`: the end of the time that is examined, without ipctk."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest

from exact_ccd import ipc

THIRD = 1 / 3
"""The float64 below 1/3."""

FACE = [0, 0, 0], [1, 0, 0], [0, 1, 0]
EDGE = [-1, 0, 0], [1, 0, 0]
PAIRS = {
    "point_point_ccd": ([0, 0, 1], [0, 0, 0], [0, 0, -2], [0, 0, 0]),
    "point_edge_ccd": ([0, 0, 1], *EDGE, [0, 0, -2], *EDGE),
    "point_triangle_ccd": ([0.25, 0.25, 1], *FACE, [0.25, 0.25, -2], *FACE),
    "edge_edge_ccd": ([0, -1, 1], [0, 1, 1], *EDGE, [0, -1, -2], [0, 1, -2], *EDGE),
}


@pytest.mark.parametrize("name", PAIRS)
@pytest.mark.parametrize("in_class", [False, True])
def test_a_contact_between_two_numbers(name: str, in_class: bool) -> None:
    """The contact is at 1/3 exactly."""
    assert Fraction(THIRD) < Fraction(1, 3) < Fraction(math.nextafter(THIRD, 1.0))
    if in_class:
        pytest.importorskip("ipctk", reason="ipctk is not installed: pip install ipctk")
        decide = getattr(ipc.ExactCCD(1.0), name)
    else:

        def decide(*arguments):
            return getattr(ipc, name)(*arguments, conservative_rescaling=1.0)

    free, hit = (False, math.inf), (True, THIRD)
    for tmax, expected in (
        (-1.0, free),
        (-0.0, free),
        (0.0, free),
        (math.nextafter(THIRD, 0.0), free),
        (THIRD, free),
        (math.nextafter(THIRD, 1.0), hit),
        (1.0, hit),
        (math.inf, hit),
    ):
        assert decide(*PAIRS[name], 0.0, tmax) == expected, tmax


@pytest.mark.parametrize("name", PAIRS)
def test_a_contact_at_a_number(name: str) -> None:
    """The contact is at 1/4 exactly; within the distance 1/4, it is so at 1/8."""
    points = np.array(PAIRS[name], float)
    half = len(points) // 2
    moving = 2 if name == "edge_edge_ccd" else 1
    points[half : half + moving, 2] = -3.0
    for d, time in ((0.0, 0.25), (0.5, 0.125)):
        for tmax in (time, math.nextafter(time, 1.0)):
            assert getattr(ipc, name)(*points, d, tmax, 1.0) == (True, time)
        assert getattr(ipc, name)(*points, d, math.nextafter(time, 0.0), 1.0) == (False, math.inf)


def test_a_contact_at_the_start() -> None:
    points = np.zeros((4, 3))
    for tmax, is_hit in ((0.0, True), (-0.0, True), (-5e-324, False)):
        assert ipc.point_point_ccd(*points, tmax=tmax)[0] == is_hit


@pytest.mark.parametrize("name", PAIRS)
def test_a_rescaling_of_single_precision(name: str) -> None:
    """The time is a float, at most the time of the contact."""
    hit, time = getattr(ipc, name)(*PAIRS[name], conservative_rescaling=np.float32(1.0))
    assert hit and type(time) is float and time == THIRD
