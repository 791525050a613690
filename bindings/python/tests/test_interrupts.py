"""Ctrl-C."""

from __future__ import annotations

import importlib.util
import subprocess
import sys
import time

import pytest

from exact_ccd import _native

LIMIT = 5.0
"""The seconds from Ctrl-C to the end of the process: one on an idle machine, more on a busy one."""

HARD = """
import numpy as np, exact_ccd
# Numbers that leave every query to integers, for minutes on one thread.
random = np.random.default_rng(0)
points = np.ldexp(random.normal(size=(100_000, 8, 3)), random.integers(-900, 900, (100_000, 8, 3)))
queries = exact_ccd.Queries("ee", points[:, :4], points[:, 4:])
"""
CROWD = """
import numpy as np, exact_ccd
# A mesh whose triangles are all near each other, and many in contact.
x = np.random.default_rng(0).normal(size=(90_000, 3))
faces = np.arange(len(x)).reshape(-1, 3)
detector = exact_ccd.Detector(exact_ccd.Mesh(len(x), faces))
"""
STACK = """
import numpy as np, exact_ccd
from exact_ccd import ipc
from types import SimpleNamespace
# Triangles in parallel planes: the boxes of their edges meet, and there is no contact.
corners = np.array([[200.0, -90.0, -110.0], [-110.0, 200.0, -90.0], [-90.0, -110.0, 200.0]])
x = np.concatenate([corners + height for height in np.linspace(0.0, 1.0, 200_000)])
faces = np.arange(len(x)).reshape(-1, 3)
detector = exact_ccd.Detector(exact_ccd.Mesh(len(x), faces))
edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
mesh = SimpleNamespace(num_vertices=len(x), edges=edges, faces=faces)
"""
TABLE = """
import pyarrow
table = pyarrow.table({"kind": ["ee"] * len(points), "points": list(points.reshape(len(points), -1))})
"""
RULE = """
detector = exact_ccd.Detector(exact_ccd.Mesh(len(x), faces, can_collide=lambda i, j: True))
"""
TANGLE = """
import numpy as np, exact_ccd
# Triangles that pass through each other: most rounds are slow, and there are many.
x = np.random.default_rng(1).normal(size=(6_000, 3))
faces = np.arange(len(x)).reshape(-1, 3)
"""
SLOW = {
    "collides": (HARD, 'queries.collides(separation=1.0, threads=1)'),
    "time_of_impact": (HARD, 'queries.time_of_impact(separation=1.0, threads=1)'),
    "count": (HARD, 'queries.count(separation=1.0, threads=1)'),
    "intervals": (HARD, 'queries.intervals(separation=1.0, threads=1)'),
    "impact": (HARD, 'queries.impact(separation=1.0)'),
    "answer_table": (HARD + TABLE, "exact_ccd.answer_table(table, separation=1.0)"),
    "a mesh collides": (STACK, "detector.collides(x, x)"),
    "collision": (STACK, "detector.collision(x, x)"),
    "free_step": (STACK, "detector.free_step(x, x)"),
    "free_steps": (CROWD, "detector.free_steps(x, x[::-1])"),
    "collisions": (CROWD, "detector.collisions(x, x[::-1])"),
    "step": (CROWD, "detector.step(x, x[::-1])"),
    "step with a rule": (STACK + RULE, "detector.step(x, x)"),
    "worlds": (STACK, "exact_ccd.Worlds(detector.mesh).collides(x[None], x[None])"),
    "intersections": (CROWD, "detector.intersections(x)"),
    "audit": (STACK, "exact_ccd.audit([x, x], faces)"),
    "repair": (TANGLE, "exact_ccd.repair(faces, x, max_rounds=2**32 - 1)"),
    "ipc.is_step_collision_free": (STACK, "ipc.is_step_collision_free(mesh, x, x)"),
    "ipc.compute_collision_free_stepsize": (STACK, "ipc.compute_collision_free_stepsize(mesh, x, x)"),
    "ipc.has_intersections": (STACK, "ipc.has_intersections(mesh, x)"),
}


@pytest.mark.skipif(sys.platform == "win32", reason="signals differ on Windows")
@pytest.mark.parametrize("name", SLOW)
def test_ctrl_c_ends_a_long_computation(name: str) -> None:
    import signal

    setting, call = SLOW[name]
    if name == "repair" and not hasattr(_native, "repair"):
        pytest.skip("the package is built without the feature repair")
    if TABLE in setting and importlib.util.find_spec("pyarrow") is None:
        pytest.skip("pyarrow is not installed: pip install pyarrow")
    process = subprocess.Popen(
        [sys.executable, "-c", f"{setting}print('ready', flush=True)\n{call}"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        # A background job of a shell inherits that the signal is ignored.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    try:
        assert process.stdout.readline() == "ready\n"
        with pytest.raises(subprocess.TimeoutExpired):
            process.wait(1.0)
        process.send_signal(signal.SIGINT)
        start = time.monotonic()
        _, errors = process.communicate(timeout=LIMIT)
    finally:
        process.kill()
    # Seen with `pytest -s`.
    print(f"{name}: {time.monotonic() - start:.2f} s")
    assert "KeyboardInterrupt" in errors
