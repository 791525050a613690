"""One vertex in place of several that coincide."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from exact_ccd import audit, read_mesh

# Two faces with a common side, and one that touches them in a corner: every face has vertices of its own.
CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0], [1, 1, 0], [2, 1, 0], [2, 2, 0]], float)
SPLIT = np.arange(9).reshape(3, 3)
ALONG_EDGES = [[0, 1, 2], [2, 1, 3], [4, 5, 6]]
EVERYWHERE = [[0, 1, 2], [2, 1, 3], [3, 4, 5]]


def write(path, vertices) -> None:
    """An OBJ file or an STL file of the faces."""
    if path.suffix == ".stl":
        corners = ["vertex {} {} {}\n".format(*vertex) for vertex in vertices.tolist()]
        facets = ["facet normal 0 0 0\nouter loop\n" + "".join(corners[i : i + 3]) + "endloop\nendfacet\n" for i in (0, 3, 6)]
        path.write_text(f"solid\n{''.join(facets)}endsolid\n")
        return
    lines = ["v {} {} {}\n".format(*vertex) for vertex in vertices.tolist()]
    path.write_text("".join(lines) + "".join("f {} {} {}\n".format(*face) for face in (SPLIT + 1).tolist()))


@pytest.mark.parametrize(
    ("ending", "weld", "faces"),
    [
        ("obj", None, SPLIT),
        ("obj", False, SPLIT),
        ("obj", True, ALONG_EDGES),
        ("stl", None, EVERYWHERE),
        ("stl", True, EVERYWHERE),
        ("stl", False, SPLIT),
    ],
)
def test_read_mesh(tmp_path, ending: str, weld, faces) -> None:
    path = tmp_path / f"mesh.{ending}"
    write(path, CORNERS)
    mesh = read_mesh(path, weld=weld)
    assert_array_equal(mesh.faces, faces)
    assert_array_equal(mesh.vertices[mesh.faces], CORNERS[SPLIT])
    assert len(mesh.vertices) == np.max(faces) + 1


def test_audits(tmp_path) -> None:
    """The seam is a contact unless it is welded. Corners of another body are not."""
    shifts = np.array([0.0, 1.0, 2.0])[:, None, None]
    frames = CORNERS + shifts
    frames[:, 6:] += [0, 0, 1]
    # In the last frame, the seam opens at one end.
    opening = frames.copy()
    opening[2, 3, 2] += 0.5
    for name, motion in (("whole", frames), ("opening", opening)):
        folder = tmp_path / name
        folder.mkdir()
        for number, frame in enumerate(motion):
            write(folder / f"{number}.obj", frame)
        for weld in (None, False):
            split = audit(motion, SPLIT, weld=weld)
            assert not split.is_free and split == audit(folder, weld=weld)
        welded = audit(motion, SPLIT, weld=True)
        assert welded.is_free == (name == "whole")
        assert welded == audit(folder, weld=True)


def test_vertices_with_other_values_stay_apart(tmp_path) -> None:
    frames = np.array([CORNERS, CORNERS + 1.0])
    frames[:, 6:] += [0, 0, 1]
    for number, frame in enumerate(frames):
        write(tmp_path / f"{number}.stl", frame)
    bodies = np.repeat([0, 1, 2], 3)
    for given in ((frames, SPLIT), (tmp_path,)):
        whole = audit(*given, weld=True)
        assert whole.is_free and whole.vertices.tolist() == [0, 1, 2, 5, 6, 7, 8]
        # The sides at the seam of two groups meet.
        report = audit(*given, weld=True, groups=bodies, names=["a", "b", "c"])
        assert report.vertices.tolist() == [*range(9)]
        assert {place.body for place in report.violation.places} == {"a", "b"}
        assert audit(*given, weld=True, groups=[7] * 9).vertices.tolist() == whole.vertices.tolist()
        assert not audit(*given, weld=True, min_distance=[0.0] * 3 + [0.125] * 6).is_free
        thick = audit(*given, weld=True, min_distance=[0.125] * 9)
        assert thick.is_free and thick.vertices.tolist() == whole.vertices.tolist()
        with pytest.raises(ValueError, match=r"groups has the shape \(7,\), expected \(9\)"):
            audit(*given, weld=True, groups=[0] * 7)
    assert audit(frames, SPLIT).vertices is None


def test_wrong_arguments(tmp_path) -> None:
    write(tmp_path / "mesh.obj", CORNERS)
    for call in (lambda: read_mesh(tmp_path / "mesh.obj", weld=1e-9), lambda: audit([CORNERS], SPLIT, weld="yes")):
        with pytest.raises(TypeError, match="weld is of type (float|str), expected True, False, or None"):
            call()
    with pytest.raises(TypeError, match="weld=True needs all frames before the first is examined"):
        audit(iter([CORNERS]), SPLIT, weld=True)
    with pytest.raises(ValueError, match="short.obj has other faces or edges than the first frame"):
        audit([tmp_path / "mesh.obj", _short(tmp_path)], weld=True)


def _short(folder):
    path = folder / "short.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    return path
