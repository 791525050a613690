"""Ctrl-C."""

from __future__ import annotations

import subprocess
import sys

import pytest

SLOW = {
    # Numbers that leave every query to integers, for minutes.
    "batch": """
import numpy as np, exact_ccd
random = np.random.default_rng(0)
points = np.ldexp(random.normal(size=(20_000, 8, 3)), random.integers(-900, 900, (20_000, 8, 3)))
print("ready", flush=True)
exact_ccd.impacts("ee", points, min_distance=1.0)
""",
    # A mesh whose pairs are all near each other.
    "step": """
import numpy as np, exact_ccd
x = np.random.default_rng(0).normal(size=(90_000, 3))
detector = exact_ccd.Detector(exact_ccd.Mesh(len(x), np.arange(len(x)).reshape(-1, 3)))
print("ready", flush=True)
detector.step(x, x[::-1])
""",
}


@pytest.mark.skipif(sys.platform == "win32", reason="signals differ on Windows")
@pytest.mark.parametrize("work", SLOW)
def test_ctrl_c_ends_a_long_computation(work: str) -> None:
    import signal

    process = subprocess.Popen(
        [sys.executable, "-c", SLOW[work]],
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
    try:
        _, errors = process.communicate(timeout=60)
    finally:
        process.kill()
    assert "KeyboardInterrupt" in errors
