"""Half spaces in audits."""

from __future__ import annotations

import numpy as np
import pytest

from exact_ccd import audit
from test_audits import frames
from test_meshes import FACES

GROUND = [[0, 0, -1], [0, 0, 2]]
"""All points at most at z = -1, with a normal of length 2."""


def test_the_first_violation() -> None:
    falling = frames(3, 1, 0.5)
    falling[:, 0, 2] = 0.0, -0.5, -1.0
    assert audit(falling[:2], FACES, half_spaces=[GROUND]).is_free
    report = audit(falling, FACES, half_spaces=[[[99, 0, 0], [-1, 0, 0]], GROUND])
    assert (report.frames, report.violation[:4]) == (3, (2, None, None, (1, 0)))
    # A contact in the step that leads there is earlier.
    falling[2, 3, 2] = -1.0
    assert audit(falling, FACES, half_spaces=[GROUND]).violation.half_space is None


def test_the_distance() -> None:
    rest = frames(3)
    for d, is_free in ((0.0, True), (0.5, True), (1.0, False), (np.nextafter(1.0, 0.0), True)):
        assert audit(rest, FACES, half_spaces=[GROUND], min_distance=d).is_free == is_free, d
    thickness = np.zeros(6)
    thickness[2] = 1.0
    report = audit(rest, FACES, half_spaces=[GROUND], min_distance=thickness)
    assert report.violation.half_space == (0, 2)


def test_a_sign_that_rounding_loses() -> None:
    """n . (x - p) is -m / 8 for these numbers; in floating-point numbers, it may be 0 or above."""
    m = 2.0**-1000
    x = np.array([[1.75, -0.9375, -0.9375]]) * m + 4 * m
    half_space = [np.full(3, 4 * m), np.ones(3)]
    assert audit([x], [], half_spaces=[half_space]).violation.half_space == (0, 0)
    assert audit([x + [[0.25 * m, 0, 0]]], [], half_spaces=[half_space]).is_free


def test_the_page(tmp_path) -> None:
    file = tmp_path / "audit.html"
    audit(frames(3, 1), FACES, view=file, half_spaces=[[[0, 0, 0.5], [0, 0, 1]]])
    assert "frame 0: vertex 0 is not apart from half space 0" in file.read_text("utf-8")


def test_errors() -> None:
    for message, rows in {
        "row 0 of half_spaces": [[[0, 0, 2**63 - 1], [0, 0, 1]]],
        "half space 1: the normal is": [np.eye(2, 3), np.zeros((2, 3))],
        "half_spaces has the shape": [[0, 0, 1]],
    }.items():
        with pytest.raises(ValueError, match=message):
            audit(frames(3), FACES, half_spaces=rows)
    bad = frames(3, 3)
    bad[1, 5, 0] = np.nan
    with pytest.raises(ValueError, match="frame 1: "):
        audit(bad, FACES, half_spaces=[GROUND])
