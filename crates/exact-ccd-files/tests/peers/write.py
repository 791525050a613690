"""Writes one motion with trimesh, meshio, pyvista and numpy, each in all formats that it has.

Usage: write.py FOLDER. Needs: pip install trimesh meshio pyvista scipy.

A house (a prism over a pentagon) falls by 2 onto a floor from height 1, so that contact begins at t = 1/2. Each
pair of files is NAME.0.EXTENSION and NAME.1.EXTENSION; files of several frames are NAME.EXTENSION. Standard output
has one line for each: the kind of the mesh (polygons, triangles, soup, solids), then the files. The exit status is 3
if a package is missing.
"""

import sys
from pathlib import Path

try:
    import meshio
    import numpy as np
    import pyvista
    import trimesh
    import vtk
except ImportError as error:
    print(error, file=sys.stderr)
    sys.exit(3)

FOLDER = Path(sys.argv[1])

OUTLINE = [[0, 0], [1, 0], [1, 0.75], [0.5, 1.25], [0, 0.75]]
HOUSE = [[x, y, z] for y in (0, 1) for x, z in OUTLINE]
FLOOR = [[-1, -1, 0], [2, -1, 0], [2, 2, 0], [-1, 2, 0]]
QUADS = [[k, (k + 1) % 5, 5 + (k + 1) % 5, 5 + k] for k in range(5)] + [[13, 10, 11, 12]]
PENTAGONS = [[4, 3, 2, 1, 0], [7, 8, 9, 5, 6]]
BOX = [[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1, 2)]
SLAB = [[x, y, z] for z in (-1, 0) for y in (-1, 2) for x in (-1, 3)]
HEXAHEDRA = [[0, 1, 4, 3, 6, 7, 10, 9], [1, 2, 5, 4, 7, 8, 11, 10], [12, 13, 15, 14, 16, 17, 19, 18]]


def fan(polygon):
    least = polygon.index(min(polygon))
    turned = polygon[least:] + polygon[:least]
    return [[turned[0], turned[k], turned[k + 1]] for k in range(1, len(turned) - 1)]


TRIANGLES = [triangle for polygon in QUADS + PENTAGONS for triangle in fan(polygon)]


def positions(falling, resting, time):
    return np.array([[x, y, z + 1 - 2 * time] for x, y, z in falling] + resting, dtype=np.float64)


def write(kind, name, extension, writer, *arguments):
    """Calls the writer for both times."""
    files = [FOLDER / f"{name}.{time}.{extension}" for time in (0, 1)]
    if extension == "gltf":
        # The buffers are in other files, with the same names for every mesh.
        files = [file.with_suffix("") / file.name for file in files]
    for time, file in enumerate(files):
        file.parent.mkdir(exist_ok=True)
        writer(str(file), time, *arguments)
    print(kind, *(file.relative_to(FOLDER) for file in files))


def with_meshio(file, time, options):
    cells = [("quad", QUADS), ("polygon", PENTAGONS)]
    meshio.Mesh(positions(HOUSE, FLOOR, time), cells).write(file, **options)


def triangles_with_meshio(file, time, options):
    meshio.Mesh(positions(HOUSE, FLOOR, time), [("triangle", TRIANGLES)]).write(file, **options)


def solids_with_meshio(file, time, options):
    meshio.Mesh(positions(BOX, SLAB, time), [("hexahedron", HEXAHEDRA)]).write(file, **options)


def poly_data(time):
    faces = np.hstack([[len(face), *face] for face in QUADS + PENTAGONS])
    return pyvista.PolyData(positions(HOUSE, FLOOR, time), faces)


def with_pyvista(file, time, options):
    poly_data(time).save(file, **options)


def described_with_pyvista(file, time, options):
    """With texts beside the mesh, as pyvista keeps the metadata of other libraries."""
    mesh = poly_data(time)
    mesh.user_dict["source"] = "a house" * 20
    mesh.field_data["names"] = ["house", "", "the floor"]
    mesh.save(file, **options)


def triangles_with_pyvista(file, time):
    faces = np.hstack([[3, *face] for face in TRIANGLES])
    pyvista.PolyData(positions(HOUSE, FLOOR, time), faces).save(file)


def grid(time):
    cells = np.hstack([[8, *cell] for cell in HEXAHEDRA])
    return pyvista.UnstructuredGrid(cells, np.full(len(HEXAHEDRA), 12), positions(BOX, SLAB, time))


def solids_with_pyvista(file, time, options):
    grid(time).save(file, **options)


def polygons_in_a_grid(file, time):
    faces = [*QUADS, *PENTAGONS]
    cells = np.hstack([[len(face), *face] for face in faces])
    kinds = [9 if len(face) == 4 else 7 for face in faces]
    pyvista.UnstructuredGrid(cells, kinds, positions(HOUSE, FLOOR, time)).save(file)


def with_vtk(file, time, mesh, mode, compressor, header):
    writer = vtk.vtkXMLUnstructuredGridWriter() if file.endswith("vtu") else vtk.vtkXMLPolyDataWriter()
    writer.SetFileName(file)
    writer.SetInputData(mesh(time))
    {"ascii": writer.SetDataModeToAscii, "binary": writer.SetDataModeToBinary}.get(
        mode, writer.SetDataModeToAppended
    )()
    writer.SetEncodeAppendedData(mode == "base64")
    {"zlib": writer.SetCompressorTypeToZLib, "lz4": writer.SetCompressorTypeToLZ4}.get(
        compressor, writer.SetCompressorTypeToNone
    )()
    writer.SetBlockSize(96)
    {"UInt32": writer.SetHeaderTypeToUInt32, "UInt64": writer.SetHeaderTypeToUInt64}[header]()
    if mode == "binary":
        writer.SetByteOrderToBigEndian()
    assert writer.Write() == 1


def legacy_with_vtk(file, time, mesh, binary, version):
    data = mesh(time)
    writer = vtk.vtkPolyDataWriter() if mesh is poly_data else vtk.vtkUnstructuredGridWriter()
    writer.SetFileName(file)
    writer.SetInputData(data)
    writer.SetFileType(2 if binary else 1)
    writer.SetFileVersion(version)
    assert writer.Write() == 1


def mesh_of_trimesh(time):
    return trimesh.Trimesh(positions(HOUSE, FLOOR, time), TRIANGLES, process=False)


def with_trimesh(file, time, options):
    mesh_of_trimesh(time).export(file, **options)


def scene_with_trimesh(file, time):
    """The house moves by the transform of its node, below a node that is turned by a right angle and back."""
    house = trimesh.Trimesh(np.array(HOUSE, float), TRIANGLES[:10] + TRIANGLES[12:], process=False)
    floor = trimesh.Trimesh(np.array(FLOOR, float), np.array(TRIANGLES[10:12]) - 10, process=False)
    turn = np.array([[0, 0, 1, 0], [1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 1]], float)
    back = turn.T @ trimesh.transformations.translation_matrix([0, 0, 1 - 2 * time])
    scene = trimesh.Scene()
    scene.graph.update("turn", "world", matrix=turn)
    scene.add_geometry(house, node_name="house", geom_name="house", parent_node_name="turn", transform=back)
    scene.add_geometry(floor, node_name="floor", geom_name="floor")
    scene.export(file)


def with_numpy():
    both = np.stack([positions(HOUSE, FLOOR, time) for time in (0, 1)])
    faces = np.array(TRIANGLES)
    np.savez(FOLDER / "numpy.npz", positions=both, faces=faces)
    np.savez_compressed(
        FOLDER / "numpy_small.npz",
        vertices=np.asfortranarray(both.astype(np.float32)),
        triangles=np.asfortranarray(faces.astype(np.uint16)),
    )
    np.savez(FOLDER / "numpy_big_endian.npz", points=both.astype(">f8"), faces=faces.astype(">i4"))
    np.savez(FOLDER / "numpy_half.npz", positions=both.astype(np.float16), faces=faces)
    # A list with counts, as mesh.faces of pyvista.
    np.savez(FOLDER / "numpy_counts.npz", points=both, faces=np.insert(faces, 0, 3, axis=1).ravel())
    for name in ("numpy", "numpy_small", "numpy_big_endian", "numpy_half", "numpy_counts"):
        print("frames", f"{name}.npz")


for extension in ("vtu", "vtk"):
    write("polygons", "meshio", extension, with_meshio, {})
for extension, options in (
    ("obj", {}), ("off", {}), ("ply", {"binary": True}), ("ply", {"binary": False}), ("stl", {"binary": False}),
    ("stl", {"binary": True}), ("vtu", {}), ("vtu", {"binary": False}), ("vtk", {}), ("vtk", {"binary": False}),
    ("msh", {"file_format": "gmsh"}), ("msh", {"file_format": "gmsh", "binary": False}),
    ("msh", {"file_format": "gmsh22"}), ("vtk", {"file_format": "vtk42"}),
):
    name = "_".join(["meshio_triangles", *map(str, options.values())])
    kind = "soup" if extension == "stl" else "triangles"
    write(kind, name, extension, triangles_with_meshio, options)
for extension, options in (("vtu", {}), ("vtk", {}), ("msh", {"file_format": "gmsh"})):
    write("solids", "meshio_solids", extension, solids_with_meshio, options)
for extension in ("vtp", "vtk", "ply"):
    for binary in (True, False):
        write("polygons", f"pyvista_{binary}", extension, with_pyvista, {"binary": binary})
for extension in ("vtp", "vtk"):
    for binary in (True, False):
        write("polygons", f"pyvista_texts_{binary}", extension, described_with_pyvista, {"binary": binary})
write("soup", "pyvista", "stl", triangles_with_pyvista)
write("polygons", "pyvista", "obj", with_pyvista, {})
for extension in ("vtu", "vtk"):
    write("solids", "pyvista_solids", extension, solids_with_pyvista, {})
    write("polygons", "pyvista_grid", extension, polygons_in_a_grid)
for kind, extension, mesh in (("polygons", "vtp", poly_data), ("solids", "vtu", grid)):
    for mode in ("ascii", "binary", "base64", "raw"):
        for compressor in ("none", "zlib", "lz4"):
            for header in ("UInt32", "UInt64"):
                name = f"vtk_{mode}_{compressor}_{header}"
                write(kind, name, extension, with_vtk, mesh, mode, compressor, header)
for binary in (True, False):
    for version in (42, 51):
        write("polygons", f"vtk_legacy_{binary}_{version}", "vtk", legacy_with_vtk, poly_data, binary, version)
        write("solids", f"vtk_legacy_grid_{binary}_{version}", "vtk", legacy_with_vtk, grid, binary, version)
for extension in ("obj", "ply", "off", "glb", "gltf"):
    write("triangles", "trimesh", extension, with_trimesh, {})
write("soup", "trimesh", "stl", with_trimesh, {})
write("triangles", "trimesh_text", "ply", with_trimesh, {"encoding": "ascii"})
for extension in ("glb", "gltf"):
    write("parts", "trimesh_scene", extension, scene_with_trimesh)
with_numpy()
