"""The published data sets, in the folder that the variable EXACT_CCD_DATA names."""

from __future__ import annotations

import csv
import os
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from exact_ccd.queries import POINTS


def data() -> Path:
    """The folder, or a skipped test if there is none."""
    folder = Path(os.environ.get("EXACT_CCD_DATA", Path(__file__).parents[4] / "shared" / "data"))
    if not folder.is_dir():
        pytest.skip(f"no published data in {folder}: set EXACT_CCD_DATA")
    return folder


def program(*arguments: object) -> str:
    """The output of the program, or a skipped test if it is not installed."""
    if shutil.which("exact-ccd", path=sysconfig.get_path("scripts")) is None:
        pytest.skip("the program is not installed: pip install ./crates/exact-ccd-cli")
    command = [sys.executable, "-m", "exact_ccd", *map(str, arguments)]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def read_queries(file: Path, kind: str) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """Points and truth of a query file of seven columns; each rational is exactly a float64."""
    with file.open() as text:
        rows = [[int(number) for number in row] for row in csv.reader(text)]
    coordinates = np.array([[row[0] / row[1], row[2] / row[3], row[4] / row[5]] for row in rows])
    points = 2 * POINTS[kind]
    truth = np.array([row[6] == 1 for row in rows]) if len(rows[0]) == 7 else np.zeros(len(rows), bool)
    return coordinates.reshape(-1, points, 3), truth[::points]
