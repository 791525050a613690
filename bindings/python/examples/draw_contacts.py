"""The contacts of a step in a picture: two links of a chain are pulled apart, off screen.

``pip install pyvista``; ``python draw_contacts.py PICTURE.png`` writes the picture.
"""

import sys

import numpy as np
import pyvista

from exact_ccd import Detector, Mesh

link = pyvista.ParametricTorus(ringradius=1.0, crosssectionradius=0.25, u_res=60, v_res=30).triangulate().clean()
ring = np.asarray(link.points, float)
# The second link stands upright, through the hole of the first.
upright = ring[:, [0, 2, 1]] * [1, 1, -1] + [1, 0, 0]
x0 = np.vstack([ring, upright])
x1 = x0 + np.repeat([[0.0, 0, 0], [0.8, 0, 0]], len(ring), axis=0)
triangles = link.faces.reshape(-1, 4)[:, 1:]
mesh = Mesh(len(x0), np.vstack([triangles, triangles + len(ring)]), groups=np.repeat([0, 1], len(ring)))

detector = Detector(mesh)
contacts, _, times = detector.first_contacts(x0, x1)
first = contacts[0]
print(f"{len(contacts)} contacts, the first of {first['kind']} at t = {first['time']}")

plotter = pyvista.Plotter(off_screen=True, window_size=(720, 400))
faces = np.hstack([np.full((len(mesh.faces), 1), 3), mesh.faces]).ravel()
surface = pyvista.PolyData((1 - first["time"]) * x0 + first["time"] * x1, faces)
surface["time of contact"] = np.where(np.isfinite(times), times, np.nan)
bar = {"title_font_size": 14, "label_font_size": 12, "position_y": 0.02}
plotter.add_mesh(surface, scalars="time of contact", nan_color="lightgrey", cmap="viridis_r", scalar_bar_args=bar)
plotter.add_mesh(pyvista.Sphere(radius=0.03, center=first["points"][0]), color="red")
plotter.camera_position = [(0.75, -4.4, 3.0), (0.75, 0, -0.15), (0, 0, 1)]
if len(sys.argv) > 1:
    plotter.screenshot(sys.argv[1])
