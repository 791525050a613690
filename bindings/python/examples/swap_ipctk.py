"""The line search of a solver that uses ipctk: only the import differs."""

import numpy as np

# from ipctk import compute_collision_free_stepsize, is_step_collision_free
from exact_ccd.ipc import compute_collision_free_stepsize, is_step_collision_free


class SurfaceMesh:
    """A mesh in place of ``ipctk.CollisionMesh``, which is taken as it is."""

    num_vertices = 4
    edges = np.array([[0, 1], [1, 2], [2, 0]])
    faces = np.array([[0, 1, 2]])


mesh = SurfaceMesh()
x0 = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.25, 0.25, 1]])
x1 = x0.copy()
x1[3, 2] = -1.0

assert not is_step_collision_free(mesh, x0, x1)
alpha = compute_collision_free_stepsize(mesh, x0, x1)
# With 1, x1 itself is certified: the sum is rounded.
x = x0 + alpha * (x1 - x0) if alpha < 1.0 else x1
assert is_step_collision_free(mesh, x0, x)
print(f"step size {alpha}")
