"""A bar swings into a post; two gears turn against each other for a whole turn, until one turns a little faster."""

import numpy as np
from numpy.typing import NDArray

from exact_ccd import Bodies, Mesh

rod = Mesh(2, [], edges=[[0, 1]])
bodies = Bodies([(rod, [[1, 0, 0], [4, 0, 0]]), (rod, [[2, 2, -1], [2, 2, 1]])])
rest = [0, 0, 0, 1, 0, 0, 0]  # x, y, z, and the quaternion, scalar first, of any length
turned = [0, 0, 0, 1, 0, 0, 1]  # by a right angle about the z axis
contact = bodies.collision([rest, rest], [turned, rest])
assert contact is not None
print(f"the bar meets the post at t = {contact.time}, by an arc of {2 * np.degrees(np.arctan(contact.time)):.1f}°")
step = bodies.free_step([rest, rest], [turned, rest])
print(f"the step of size {step.size:.3f} is free: {not bodies.collides([rest, rest], step.poses)}")

teeth, steps = 12, 12
i = np.arange(2 * teeth)
j = (i + 1) % len(i)
radii = np.where(i % 2 == 0, 1.25, 1.0)
star = np.column_stack([radii * np.cos(np.pi * i / teeth), radii * np.sin(np.pi * i / teeth), 0 * radii])
gear = np.vstack([star - [0, 0, 0.1], star + [0, 0, 0.1], [[0, 0, -0.1], [0, 0, 0.1]]])
a, b, c, d = i, j, i + len(i), j + len(i)
below, above = (np.full_like(i, 2 * len(i) + k) for k in (0, 1))  # the middles of both sides
faces = np.vstack([np.column_stack(corners) for corners in ((a, b, d), (a, d, c), (b, a, below), (c, d, above))])
gears = Bodies([(faces, gear), (faces, gear)])


def poses(first: float, second: float) -> NDArray[np.float64]:
    """The gears after turns by these angles about their axes, 2.3 apart."""
    return np.array([[x, 0, 0, np.cos(a / 2), 0, 0, np.sin(a / 2)] for x, a in ((0.0, first), (2.3, second))])


for ratio in (1.0, 1.02):
    phase = np.pi * (1 + 1 / teeth)  # a tooth of one between two of the other
    angles = 2 * np.pi * np.arange(steps + 1) / steps
    frames = [poses(angle, phase - ratio * angle) for angle in angles]
    hits = (gears.collision(*ends) for ends in zip(frames, frames[1:]))
    found = next(((number, hit) for number, hit in enumerate(hits) if hit is not None), None)
    verdict = "free" if found is None else f"contact in step {found[0]} at t = {found[1].time:.4f}"
    print(f"gears with the ratio {ratio}: {verdict}")
