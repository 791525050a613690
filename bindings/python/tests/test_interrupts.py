"""Ctrl-C."""

from __future__ import annotations

import subprocess
import sys
import time

import pytest

HARD = """
import numpy as np, exact_ccd
# Numbers that leave every query to integers, for minutes.
random = np.random.default_rng(0)
points = np.ldexp(random.normal(size=(20_000, 8, 3)), random.integers(-900, 900, (20_000, 8, 3)))
"""
CROWD = """
import numpy as np, exact_ccd
# A mesh whose pairs are all near each other.
x = np.random.default_rng(0).normal(size=(90_000, 3))
faces = np.arange(len(x)).reshape(-1, 3)
detector = exact_ccd.Detector(exact_ccd.Mesh(len(x), faces))
"""
SLOW = {
    "impacts": (HARD, 'exact_ccd.impacts("ee", points, min_distance=1.0)'),
    "contact_times": (HARD, 'exact_ccd.contact_times("ee", points, min_distance=1.0, threads=1)'),
    "step": (CROWD, "detector.step(x, x[::-1])"),
    "contacts": (CROWD, "detector.contacts(x, x[::-1])"),
    "intersections": (CROWD, "detector.intersections(x)"),
    "audit": (CROWD, "exact_ccd.audit([x, x[::-1]], faces)"),
}


@pytest.mark.skipif(sys.platform == "win32", reason="signals differ on Windows")
@pytest.mark.parametrize("name", SLOW)
def test_ctrl_c_ends_a_long_computation(name: str) -> None:
    import signal

    setting, call = SLOW[name]
    process = subprocess.Popen(
        [sys.executable, "-c", f"{setting}print('ready', flush=True)\n{call}"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        # A background job of a shell inherits that the signal is ignored.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    assert process.stdout.readline() == "ready\n"
    with pytest.raises(subprocess.TimeoutExpired):
        process.wait(1.0)
    process.send_signal(signal.SIGINT)
    start = time.monotonic()
    try:
        _, errors = process.communicate(timeout=60)
    finally:
        process.kill()
    # Seen with `pytest -s`.
    print(f"{name}: {time.monotonic() - start:.2f} s")
    assert "KeyboardInterrupt" in errors
