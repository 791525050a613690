"""What a newcomer calls first, and the messages that answer."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from exact_ccd import Bodies, Detector, Mesh, MeshFile, NotebookPage, Worlds, _native, audit, from_trimesh, read_mesh, repair
from test_meshes import FACES, two_triangles


@pytest.mark.parametrize("name", ["missing.ply", "missing.npz", "missing", "missing/folder.ply"])
def test_a_missing_file(name: str, tmp_path: Path) -> None:
    for call in (audit, lambda file: audit([file, file]), read_mesh):
        with pytest.raises(FileNotFoundError, match=name):
            call(tmp_path / name)


def test_arrays_in_place_of_a_mesh() -> None:
    x0, x1 = two_triangles(1.0), two_triangles(-1.0)
    assert Detector(x0, FACES).collision(x0, x1) == Detector(Mesh(6, FACES)).collision(x0, x1)
    assert Worlds(x0, FACES).collides(x0[None], x1[None]).all()
    for kind in (Detector, Worlds):
        with pytest.raises(TypeError, match=rf"expected an exact_ccd.Mesh, or the vertices and the faces: {kind.__name__}\("):
            kind(x0)
        with pytest.raises(TypeError, match=f"all arguments of {kind.__name__} after it are given by name"):
            kind(Mesh(6, FACES), 0.5)


def test_the_text_of_a_mesh_file() -> None:
    file = MeshFile(two_triangles(1.0), np.array(FACES, np.uint32), np.empty((0, 2), np.uint32))
    assert repr(file) == "<exact_ccd.MeshFile: 6 vertices, 2 faces, 0 loose edges>"


def test_a_build_without_repair(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delattr(_native, "repair", raising=False)
    with pytest.raises(ImportError, match="--config-settings build-args='--features repair'"):
        repair(FACES, two_triangles(1.0))


def test_a_page_in_a_notebook(tmp_path: Path) -> None:
    file = tmp_path / "step.html"
    Detector(Mesh(6, FACES)).step(two_triangles(1.0), two_triangles(-1.0), view=file)
    shown = NotebookPage(file, height=300)._repr_html_()
    assert shown.startswith('<iframe srcdoc="&lt;!doctype html&gt;') and "height: 300px" in shown
    # The page does not end the attribute that contains it.
    assert shown.count('"') == 4


def test_meshes_of_trimesh() -> None:
    trimesh = pytest.importorskip("trimesh", reason="trimesh is not installed: pip install trimesh")
    box = trimesh.creation.box()
    scene = trimesh.Scene()
    move = trimesh.transformations.translation_matrix
    scene.add_geometry(box, node_name="floor", geom_name="box")
    # Another body with the same geometry, turned and scaled by its node.
    turn = trimesh.transformations.rotation_matrix(0.3, [1, 2, 3]) @ np.diag([2.0, 2.0, 2.0, 1.0])
    scene.graph.update(frame_to="leaf", geometry="box", matrix=move([0, 0, 3]) @ turn)
    mesh, x0 = from_trimesh(scene)
    assert mesh.names == ("floor", "leaf") and mesh.vertex_count == 2 * len(box.vertices)
    assert_array_equal(mesh.groups, np.repeat([0, 1], len(box.vertices)))
    assert_array_equal(mesh.faces, np.vstack([box.faces, box.faces + len(box.vertices)]))
    expected = trimesh.transform_points(box.vertices, move([0, 0, 3]) @ turn)
    assert_array_equal(x0[: len(box.vertices)], box.vertices)
    assert np.allclose(x0[len(box.vertices) :], expected, rtol=0, atol=1e-12)
    scene.graph.update(frame_to="leaf", geometry="box", matrix=turn)
    again, x1 = from_trimesh(scene)
    assert again == mesh
    places = Detector(mesh).collision(x0, x1).places
    assert {place.body for place in places} == {"floor", "leaf"}
    alone, positions = from_trimesh(box)
    assert alone == Mesh(len(box.vertices), box.faces) and np.array_equal(positions, box.vertices)
    rest = [0, 0, 0, 1, 0, 0, 0]
    assert Bodies([box, box]).collision([rest, [0, 0, 5, 1, 0, 0, 0]], [rest, rest]).time > 0.5
    scene.add_geometry(trimesh.load_path([[0, 0, 0], [1, 1, 1]]), node_name="line")
    with pytest.raises(TypeError, match="the node 'line' has a geometry of type Path3D, which has no faces"):
        from_trimesh(scene)
    with pytest.raises(TypeError, match="expected a trimesh.Scene or a trimesh.Trimesh, not an object of type int"):
        from_trimesh(3)


def turned(degrees: float) -> np.ndarray:
    """A rod that is turned about the z axis, and a triangle that rests below it."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[-c, -s, 1], [c, s, 1], [0, 0, 0], [8, 0, 0], [0, 8, 0]])


def test_a_part_that_turns_is_a_warning() -> None:
    named = {"groups": [0, 0, 1, 1, 1], "names": ["arm", "floor"]}
    for rules, body in (({}, "the part with vertex 0"), (named, "arm")):
        mesh = Mesh(5, [[2, 3, 4]], edges=[[0, 1]], **rules)
        for name in ("collision", "free_step", "step"):
            detector = Detector(mesh)
            with pytest.warns(UserWarning, match=f"^{body} turns by 171.0° in the step as a rigid body") as caught:
                getattr(detector, name)(turned(0), turned(171))
            assert len(caught) == 1 and caught[0].filename == __file__
        frames = [turned(0), turned(5), turned(171), turned(172)]
        with pytest.warns(UserWarning, match=f"^{body} turns by 166.0° from frame 1 to frame 2") as caught:
            assert audit(frames, [[2, 3, 4]], edges=[[0, 1]], **rules).is_free
        assert len(caught) == 1 and caught[0].filename == __file__


def test_small_turns_are_no_warning(recwarn: pytest.WarningsRecorder) -> None:
    mesh = Mesh(5, [[2, 3, 4]], edges=[[0, 1]])
    Detector(mesh).free_step(turned(0), turned(4))
    assert audit([turned(0), turned(4)], mesh.faces, edges=mesh.loose_edges).is_free
    assert not recwarn.list
