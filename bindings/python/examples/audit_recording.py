"""The audit of a recording in an .npz file, as simulators in numpy, Newton or Warp write it.

``audit_recording.py FILE`` expects the arrays ``positions`` (T, V, 3) and ``faces`` (F, 3). Without a file,
a recording is made up.
"""

import sys
import tempfile
from pathlib import Path

import numpy as np

from exact_ccd import audit


def make_up(file: Path) -> None:
    """A vertex that falls through a triangle in ten frames."""
    positions = np.zeros((10, 4, 3), np.float32)
    positions[:, :3] = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    positions[:, 3, :2] = 0.25
    positions[:, 3, 2] = np.linspace(2.0, -1.0, 10)
    np.savez(file, positions=positions, faces=np.array([[0, 1, 2]]))


def main(file: Path) -> None:
    recording = np.load(file)
    report = audit(recording["positions"], recording["faces"])
    if report.violation is None:
        print(f"free of contact: {report.frames} frames")
    else:
        print(f"not free: {report.violation}")


if __name__ == "__main__":
    if len(sys.argv) > 1:
        main(Path(sys.argv[1]))
    else:
        with tempfile.TemporaryDirectory() as folder:
            made_up = Path(folder) / "recording.npz"
            make_up(made_up)
            main(made_up)
