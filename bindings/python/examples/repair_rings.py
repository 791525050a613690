"""Two rings that overlap come apart, decided exactly; then with one of them as an obstacle, in single precision."""

import numpy as np

from exact_ccd import Detector, Mesh, repair

m, n = 24, 12  # the cells of a ring along and across
i, j = (index.ravel() for index in np.mgrid[:m, :n])
a, b, c, d = ((i + p) % m * n + (j + q) % n for p, q in ((0, 0), (1, 0), (1, 1), (0, 1)))
ring = np.vstack([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
u, v = 2 * np.pi * i / m, 2 * np.pi * j / n
radius = 1 + 0.3 * np.cos(v)
x = np.column_stack([radius * np.cos(u), radius * np.sin(u), 0.3 * np.sin(v)])
mesh = Mesh(2 * m * n, np.vstack([ring, ring + m * n]))
tangled = np.vstack([x, x + [0.1, 0.2, 0.45]])

result = repair(mesh, tangled, seconds=60)
if result.change is None or result.before is None:
    raise SystemExit(f"not repaired: {result.message}")
print(f"{result.before[0]} edges passed through faces, now {len(Detector(mesh).intersections(result.positions))} do")
print(f"largest displacement: {result.change.max_displacement:.1%} of the diagonal of the box around both")

# The first ring is an obstacle, and a gap remains. Its vertices keep their bits, which have to be float32 then.
gap = 0.01
single = repair(mesh, tangled.astype(np.float32), pinned=range(m * n), min_distance=gap, dtype=np.float32)
print(f"beside an obstacle: {'free' if single.repaired else single.message}")
assert not Detector(mesh, min_distance=gap).collides(single.positions, single.positions)
