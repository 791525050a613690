"""Positions and faces of PLY files, for the comparison with ipctk."""

import numpy as np

NUMBERS = {
    "char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4", "float": "f4", "double": "f8",
    "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2", "int32": "i4", "uint32": "u4",
    "float32": "f4", "float64": "f8",
}  # fmt: skip
ORDERS = {"binary_little_endian": "<", "binary_big_endian": ">"}


def read_header(file, path):
    """The order of bytes, and each element with its count and the lines of its properties."""
    order, elements = None, []
    while (line := file.readline().decode("ascii").split()) != ["end_header"]:
        match line:
            case ["format", kind, _]:
                order = ORDERS.get(kind)
            case ["element", name, count]:
                elements.append((name, int(count), []))
            case ["property", *words]:
                elements[-1][2].append(words)
            case []:
                raise SystemExit(f"{path}: no end_header")
    if order is None:
        raise SystemExit(f"{path}: expected a binary PLY file")
    return order, elements


def row(properties, order):
    """The type of a row. A list has three members: the corners of a triangle."""
    fields = []
    for words in properties:
        match words:
            case ["list", count, kind, name]:
                fields += [(f"{name} count", order + NUMBERS[count]), (name, order + NUMBERS[kind], 3)]
            case [kind, name]:
                fields.append((name, order + NUMBERS[kind]))
    return np.dtype(fields)


def read_ply(path):
    """Positions and faces of a binary PLY file whose faces are triangles; it may have other properties, such as colours."""
    with open(path, "rb") as file:
        order, elements = read_header(file, path)
        rows = {name: np.fromfile(file, row(properties, order), count) for name, count, properties in elements}
    vertices, faces = rows["vertex"], rows["face"]
    corners = next((name for name in ("vertex_indices", "vertex_index") if name in faces.dtype.names), None)
    if corners is None or not (faces[f"{corners} count"] == 3).all():
        raise SystemExit(f"{path}: expected triangles")
    positions = np.stack([vertices[axis].astype(np.float64) for axis in "xyz"], axis=1)
    return np.asfortranarray(positions), np.asfortranarray(faces[corners].astype(np.int32))
