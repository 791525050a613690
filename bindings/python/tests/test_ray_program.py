"""The program ``exact-ccd-ray`` and its output, without a cluster."""

from __future__ import annotations

import json
import sys

import numpy as np
import pytest

import exact_ccd

ray = pytest.importorskip("ray", reason="ray is not installed: pip install 'ray[data]'")

from exact_ccd import ray_program
from exact_ccd.ray.chunks import from_json, to_json


@pytest.mark.parametrize(
    ("error", "message"),
    [
        (ValueError("a bad number"), "a bad number"),
        (ray.exceptions.RayError("a lost cluster"), "RayError: a lost cluster"),
        (ray.exceptions.NodeDiedError("a lost node"), "a lost node"),
        (ray.exceptions.RayTaskError("check", "traceback", TypeError("a bad column")), "a bad column"),
        # As of a data set.
        (ray.exceptions.RayTaskError("check", "row 3", ray.exceptions.UserCodeException("failed")), "row 3"),
        (RuntimeError("another"), "RuntimeError: another"),
        (ImportError("no module"), "no module; pip install 'ray[data]' pyarrow"),
    ],
)
def test_every_error_has_status_2(error: Exception, message: str, monkeypatch, capsys) -> None:
    """Status 1 is a violation."""

    def run(options) -> int:
        raise error

    monkeypatch.setattr(ray_program, "run", run)
    monkeypatch.setattr(sys, "argv", ["exact-ccd-ray", "audit", "frames.npz"])
    with pytest.raises(SystemExit) as end:
        ray_program.main()
    assert end.value.code == 2
    printed = capsys.readouterr().err
    assert printed.startswith("error: ") and message in printed


def no_constant(name: str) -> None:
    raise ValueError(f"{name} is not JSON")


def test_reports_are_json() -> None:
    # Two rods at rest in one place, which have no normal.
    resting = exact_ccd.audit(np.zeros((1, 4, 3)), np.empty((0, 3), int), edges=[[0, 1], [2, 3]])
    assert np.isnan(resting.violation.contact.normal).all()
    # A point falls through a face.
    frames = np.zeros((3, 4, 3))
    frames[:, :3] = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    frames[:, 3] = [[0.25, 0.1, 2], [0.25, 0.1, 1], [0.25, 0.1, -2]]
    falling = exact_ccd.audit(frames, [[0, 1, 2]])
    assert falling.violation.contact.normal.tolist() == [0.0, 0.0, 1.0]
    free = exact_ccd.audit(frames[:2], [[0, 1, 2]])
    for report in (resting, falling, free):
        text = to_json(report)
        json.loads(text, parse_constant=no_constant)
        again = from_json(text)
        assert (again.frames, to_json(again)) == (report.frames, text)
        if report.violation is not None:
            for ours, theirs in zip(again.violation.contact, report.violation.contact):
                np.testing.assert_array_equal(ours, theirs)
                assert np.asarray(ours).dtype == np.asarray(theirs).dtype


def test_messages_of_a_cluster_are_no_part_of_the_answer(monkeypatch, capsys) -> None:
    def answer(options: object) -> tuple[str, int]:
        print("(raylet) WARNING: many processes")
        return '{"is_free": true}', 0

    monkeypatch.setattr(ray_program, "run", answer)
    monkeypatch.setattr(sys, "argv", ["exact-ccd-ray", "audit", "frames"])
    with pytest.raises(SystemExit, match="0"):
        ray_program.main()
    output, errors = capsys.readouterr()
    assert json.loads(output) == {"is_free": True} and "raylet" in errors
