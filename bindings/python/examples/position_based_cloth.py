"""A cloth falls onto a post and the floor, by position based dynamics: with a step for every vertex, one for all, none.

``python position_based_cloth.py STEPS PICTURE.png`` draws the end after that many steps, by matplotlib.
"""

import sys
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from exact_ccd import Detector, Mesh, audit

n, gap, steps = 15, 0.02, int(sys.argv[1]) if len(sys.argv) > 1 else 60
grid = np.arange(n * n).reshape(n, n)
a, b, c, d = (part.ravel() for part in (grid[:-1, :-1], grid[1:, :-1], grid[:-1, 1:], grid[1:, 1:]))
post = n * n + np.array([[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])
mesh = Mesh(n * n + 5, np.vstack([np.column_stack([a, b, c]), np.column_stack([b, d, c]), post]))
cloth = np.stack([*np.meshgrid(*2 * [np.linspace(-1, 1, n)]), np.full((n, n), 0.6)], axis=-1).reshape(-1, 3)
cloth[:, 2] += 0.05 * np.sin(9 * cloth[:, 0] + 5 * cloth[:, 1])  # without it, the folds would be symmetric
corners = [[-0.3, -0.3, -1.0], [0.3, -0.3, -1.0], [0.3, 0.3, -1.0], [-0.3, 0.3, -1.0], [0.1, 0.05, 0.3]]
start = np.vstack([cloth, corners])
springs = mesh.edges[(mesh.edges < n * n).all(axis=1)]
lengths = np.linalg.norm(start[springs[:, 0]] - start[springs[:, 1]], axis=1)
degrees = np.bincount(springs.ravel(), minlength=len(start)).clip(1)[:, None]
detector = Detector(mesh, min_distance=gap, inner_distance=gap / 4)
Floats = NDArray[np.float64]
limits: dict[str, Callable[[Floats, Floats], Floats]] = {
    "a step for every vertex": lambda x, y: detector.free_steps(x, y).positions,
    "one step for all": lambda x, y: detector.free_step(x, y).positions,
    "no limit": lambda x, y: y,
}
ends = {}
for limit, limited in limits.items():
    x, velocity, frames = start, np.zeros_like(start), [start]
    for _ in range(steps):
        velocity[: n * n, 2] -= 0.001
        proposed = x + 0.98 * velocity
        for _ in range(15):  # each spring moves its ends half of the way to its length, on average
            along = proposed[springs[:, 1]] - proposed[springs[:, 0]]
            along *= (1 - lengths / np.linalg.norm(along, axis=1))[:, None]
            for end, sign in ((0, 1), (1, -1)):
                pulls = [np.bincount(springs[:, end], along[:, axis], len(x)) for axis in range(3)]
                proposed += sign * np.column_stack(pulls) / degrees
            proposed[: n * n, 2] = proposed[: n * n, 2].clip(-1)
            proposed[n * n :] = start[n * n :]
        after = limited(x, proposed)
        velocity, x = after - x, after
        frames.append(x)
    collisions = sum(Detector(mesh).collides(*pair) for pair in zip(frames, frames[1:]))
    verdict = "free" if audit(np.stack(frames), mesh.faces).violation is None else "not free"
    ends[limit] = x
    print(f"{limit}: {verdict}, {collisions} steps with contact, mean height {x[: n * n, 2].mean():.2f}")

if len(sys.argv) > 2:
    import matplotlib.pyplot as plt

    figure = plt.figure(figsize=(9, 3.4), layout="tight")
    for place, (limit, x) in enumerate(ends.items()):
        axes: Any = figure.add_subplot(1, 3, place + 1, projection="3d")
        axes.plot_trisurf(*x.T, triangles=mesh.faces, color="lightblue", edgecolor="k", linewidth=0.2)
        axes.set(title=limit, xlim=(-1, 1), ylim=(-1, 1), zlim=(-1, 0.6), box_aspect=(2, 2, 1.6))
        axes.set_axis_off()
    figure.savefig(sys.argv[2], dpi=110)
