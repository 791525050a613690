"""Certificates, which the independent checker verifies."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from exact_ccd import CrossingError, Detector, Mesh, UncertifiedError, audit
from test_meshes import FACES, two_triangles

MESH = Mesh(6, FACES)
CHECKER = Path(__file__).parents[3] / "crates" / "exact-ccd-check" / "Cargo.toml"


@pytest.fixture(scope="module")
def checker() -> list[str]:
    """The command of the checker: the program EXACT_CCD_CHECK, or the one that cargo builds from this repository."""
    if "EXACT_CCD_CHECK" in os.environ:
        return [os.environ["EXACT_CCD_CHECK"]]
    return ["cargo", "run", "--quiet", "--locked", "--manifest-path", str(CHECKER), "--"]


def write_ply(file: Path, positions: np.ndarray) -> Path:
    """Write a frame as the checker reads it."""
    lines = [
        "ply\nformat ascii 1.0\nelement vertex 6\nproperty double x\nproperty double y\nproperty double z",
        "element face 2\nproperty list uchar int vertex_indices\nend_header",
        *(" ".join(map(repr, point)) for point in positions.tolist()),
        *("3 {} {} {}".format(*face) for face in np.asarray(FACES).tolist()),
    ]
    file.write_text("\n".join(lines) + "\n")
    return file


def check(checker: list[str], certificate: Path, frames: list[Path]) -> tuple[int, str]:
    """The exit status and the sentences of the checker."""
    done = subprocess.run([*checker, certificate, *frames], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout


def program(*arguments: object) -> int:
    """The exit status of the program."""
    command = [sys.executable, "-m", "exact_ccd", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, check=False).returncode


@pytest.mark.parametrize(("heights", "distance"), [((2, 1), 0.0), ((2, -1), 0.0), ((2, -1), 0.25)])
def test_a_step(checker, tmp_path, heights, distance) -> None:
    x0, x1 = map(two_triangles, heights)
    frames = [write_ply(tmp_path / f"{name}.ply", x) for name, x in (("start", x0), ("end", x1))]
    certificate = Detector(MESH, min_distance=distance).certificate(x0, x1)
    (tmp_path / "proof").write_bytes(certificate)
    status, text = check(checker, tmp_path / "proof", frames)
    assert status == 0 and "No edge pierces a face at t = 0." in text
    assert ("after" in text) == (heights[1] < 0)
    # The file of the program has the same bytes.
    by_program = tmp_path / "by-program"
    assert program("step", *frames, "--min-distance", distance, "--certificate", by_program) == (heights[1] < 0)
    assert by_program.read_bytes() == certificate
    without = Detector(MESH, min_distance=distance).certificate(x0, x1, at_rest=False)
    assert len(without) < len(certificate)
    # It proves nothing about another motion.
    assert check(checker, tmp_path / "proof", [write_ply(tmp_path / "other.ply", two_triangles(-3)), *frames])[0] in (1, 2)


def test_an_audit(checker, tmp_path) -> None:
    heights = [3, 2, 1, -2, 5]
    frames = np.array([two_triangles(height) for height in heights])
    files = [write_ply(tmp_path / f"{number}.ply", frame) for number, frame in enumerate(frames)]
    report = audit(frames, FACES, certificate=tmp_path / "proof")
    assert (report.frames, report.violation.frame) == (4, 2)
    status, text = check(checker, tmp_path / "proof", files[:4])
    assert status == 0 and text.count("step from frame") == 3
    assert check(checker, tmp_path / "proof", files)[0] in (1, 2)
    by_program = tmp_path / "by-program"
    assert program("audit", *files, "--certificate", by_program) == 1
    assert by_program.read_bytes() == (tmp_path / "proof").read_bytes()
    # Of files, and with another number of threads.
    audit(files, threads=1, certificate=tmp_path / "of-files")
    assert (tmp_path / "of-files").read_bytes() == by_program.read_bytes()


def test_nothing_to_prove(tmp_path) -> None:
    pierced, apart = two_triangles(-1), two_triangles(2)
    with pytest.raises(CrossingError, match="passes through face 0"):
        Detector(MESH).certificate(pierced, apart)
    assert Detector(MESH).certificate(pierced, pierced, at_rest=False)
    for detector in (
        Detector(Mesh(6, FACES, groups=[0] * 6)),
        Detector(Mesh(6, FACES, can_collide=lambda a, b: True)),
        Detector(MESH, min_distance=np.zeros(6)),
        Detector(MESH, min_distance=1.0, inner_distance=0.5),
    ):
        with pytest.raises(ValueError, match="all pairs and one distance"):
            detector.certificate(apart, apart)
    proof = tmp_path / "proof"
    for frames in ([apart], [pierced, apart]):
        with pytest.raises(ValueError, match="nothing can be proved"):
            audit(frames, FACES, certificate=proof)
    for others in (
        {"half_spaces": [[[0, 0, -9], [0, 0, 1]]]},
        {"groups": [0] * 6},
        {"can_collide": lambda a, b: True},
        {"weld": True},
        {"min_distance": np.zeros(6)},
    ):
        with pytest.raises(ValueError, match="^a certificate is about all pairs and one distance"):
            audit([pierced], FACES, certificate=proof, **others)
    assert not proof.exists()


def test_pairs_without_a_proof(tmp_path) -> None:
    # Two points are within 0.5 of each other at t = 1/3 only, which is no float64.
    x0 = np.array([[0, 0, 0], [1, 0.5, 0]], float)
    x1 = np.array([[0, 0, 0], [-2, 0.5, 0]], float)
    faces = np.empty((0, 3), int)
    with pytest.raises(UncertifiedError, match="1 of 2 pairs not certified") as caught:
        Detector(Mesh(2, faces), min_distance=0.5).certificate(x0, x1)
    error = caught.value
    assert (error.missing, error.pairs, error.first) == (1, 2, "vertex 0 and vertex 1")
    with pytest.raises(UncertifiedError, match="frame 1: 1 of 2 pairs"):
        audit([x0, x1], faces, min_distance=0.5, certificate=tmp_path / "proof")
    assert not (tmp_path / "proof").exists()
