"""Sheets of cloth fall onto one that is held, by Newton's solver VBD on the CPU: every substep is audited exactly.

Needs newton and exact_ccd: python integrations/newton/audit.py [--frames N]
"""

import argparse

import newton
import numpy as np
import warp as wp

from exact_ccd import Detector, Mesh

CELLS, CELL = 24, 0.05
SUBSTEPS, FRAME = 10, 1 / 60


def sheets(count: int) -> newton.Model:
    """Square sheets above each other, each turned a little; two sides of the lowest one are held."""
    builder = newton.ModelBuilder()
    for level in range(count):
        builder.add_cloth_grid(
            pos=wp.vec3(0.0, 0.0, 1.0 + 0.08 * level),
            rot=wp.quat_from_axis_angle(wp.vec3(0.0, 0.0, 1.0), 0.3 * level),
            vel=wp.vec3(0.0, 0.0, -2.0 if level else 0.0),
            dim_x=CELLS,
            dim_y=CELLS,
            cell_x=CELL,
            cell_y=CELL,
            mass=0.001,
            fix_left=level == 0,
            fix_right=level == 0,
            tri_ke=1.0e3,
            tri_ka=1.0e3,
            tri_kd=1.0e-4,
            edge_ke=1.0e-2,
            edge_kd=1.0e-3,
            particle_radius=0.01,
        )
    builder.color()
    return builder.finalize(device="cpu")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--frames", type=int, default=60)
    parser.add_argument("--sheets", type=int, default=3)
    parser.add_argument("--iterations", type=int, default=10)
    arguments = parser.parse_args()
    wp.config.quiet = True
    model = sheets(arguments.sheets)
    solver = newton.solvers.SolverVBD(
        model,
        iterations=arguments.iterations,
        particle_enable_self_contact=True,
        particle_self_contact_margin=0.01,
        particle_self_contact_gap=0.005,
    )
    now, after = model.state(), model.state()
    control = model.control()
    detector = Detector(Mesh(model.particle_count, model.tri_indices.numpy().reshape(-1, 3)))
    intersecting = crossing = 0
    count = arguments.frames * SUBSTEPS
    for substep in range(count):
        now.clear_forces()
        solver.step(now, after, control, None, FRAME / SUBSTEPS)
        # Warp's arrays are read in place; numbers of single precision are exact in double precision.
        contact = detector.collision(now.particle_q, after.particle_q)
        pierced = detector.intersections(after.particle_q)
        if len(pierced) and not intersecting:
            print(f"substep {substep}: {len(pierced)} edges pierce faces")
        if contact is not None and not crossing:
            print(f"substep {substep}: {contact.kind} {contact.vertices.tolist()} touch at t = {contact.time}")
        intersecting += len(pierced) > 0
        crossing += contact is not None
        now, after = after, now
    height = np.from_dlpack(now.particle_q)[:, 2]
    print(
        f"{count} substeps of {model.particle_count} vertices: {intersecting} with intersections, {crossing} with contact "
        f"on straight paths; heights from {height.min():.2f} to {height.max():.2f}"
    )


if __name__ == "__main__":
    main()
