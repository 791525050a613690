"""Recordings in the formats of other libraries, each in a file that its library wrote."""

from __future__ import annotations

import pickle
import struct
from pathlib import Path
from typing import Any, Callable

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from exact_ccd import audit, open_recording
from test_meshes import FACES, two_triangles

TIMES = [0.0, 0.25, 0.5, 0.75]


def motion() -> np.ndarray:
    """Four frames, whose numbers are float32; the third step has a contact."""
    frames = np.array([two_triangles(height) for height in (3.0, 1.5, 1.0, -3.0)])
    frames[1:, :, 0] += 0.1
    return frames.astype(np.float32).astype(np.float64)


def write_obj(path: Path, vertices: np.ndarray) -> None:
    lines = ["v {!r} {!r} {!r}".format(*row) for row in vertices.tolist()]
    path.write_text("\n".join([*lines, *("f {} {} {}".format(*row) for row in np.add(FACES, 1).tolist()), ""]))


def as_ply(folder: Path) -> Any:
    for number, frame in enumerate(motion()):
        header = "ply\nformat binary_little_endian 1.0\nelement vertex 6\n"
        header += "".join(f"property float {axis}\n" for axis in "xyz")
        header += "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
        body = frame.astype("<f4").tobytes() + b"".join(struct.pack("<B3i", 3, *face) for face in FACES)
        (folder / f"{number}.ply").write_bytes(header.encode() + body)
    return folder


def as_npz(folder: Path) -> Any:
    np.savez(folder / "motion.npz", positions=motion(), faces=FACES)
    return folder / "motion.npz"


def as_npz_series(folder: Path) -> Any:
    for number, frame in enumerate(motion()):
        np.savez(folder / f"{number}.npz", positions=frame, faces=FACES)
    return folder


def as_pc2(folder: Path) -> Any:
    write_obj(folder / "mesh.obj", np.zeros((6, 3)))
    header = struct.pack("<12siiffi", b"POINTCACHE2\0", 1, 6, 0.0, 1.0, 4)
    (folder / "motion.pc2").write_bytes(header + motion().astype("<f4").tobytes())
    return [folder / "mesh.obj", folder / "motion.pc2"]


def as_mdd(folder: Path) -> Any:
    write_obj(folder / "mesh.obj", np.zeros((6, 3)))
    header = struct.pack(">ii4f", 4, 6, *TIMES)
    (folder / "motion.mdd").write_bytes(header + motion().astype(">f4").tobytes())
    return [folder / "mesh.obj", folder / "motion.mdd"]


def as_hdf5(folder: Path) -> Any:
    h5py = pytest.importorskip("h5py")
    with h5py.File(folder / "motion.h5", "w") as file:
        file.create_dataset("positions", data=motion().astype(np.float32), chunks=(1, 6, 3), compression="gzip")
        file["faces"], file["times"] = FACES, TIMES
    return folder / "motion.h5"


def as_zarr(folder: Path) -> Any:
    zarr = pytest.importorskip("zarr")
    group = zarr.open_group(str(folder / "motion.zarr"), mode="w")
    for name, array in (("positions", motion().astype(np.float32)), ("faces", np.array(FACES)), ("times", np.array(TIMES))):
        stored = group.create_array(name, shape=array.shape, dtype=array.dtype, chunks=(1, *array.shape[1:]))
        stored[...] = array
    return folder / "motion.zarr"


def as_usd(folder: Path) -> Any:
    pytest.importorskip("pxr", reason="usd-core is not installed")
    from pxr import Usd, UsdGeom, Vt

    stage = Usd.Stage.CreateNew(str(folder / "motion.usdc"))
    stage.SetTimeCodesPerSecond(4.0)
    mesh = UsdGeom.Mesh.Define(stage, "/World/Cloth")
    mesh.CreateFaceVertexCountsAttr([3, 3])
    mesh.CreateFaceVertexIndicesAttr(np.ravel(FACES).tolist())
    for code, frame in enumerate(motion()):
        mesh.CreatePointsAttr().Set(Vt.Vec3fArray.FromNumpy(frame.astype(np.float32)), code)
    stage.Save()
    return folder / "motion.usdc"


def as_vtkhdf(folder: Path) -> Any:
    pytest.importorskip("h5py")
    pytest.importorskip("vtkmodules", reason="vtk is not installed")
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
    from vtkmodules.vtkIOHDF import vtkHDFWriter

    class Source(VTKPythonAlgorithmBase):
        def __init__(self) -> None:
            super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")

        def RequestInformation(self, request: Any, inputs: Any, outputs: Any) -> int:
            information = outputs.GetInformationObject(0)
            information.Set(Pipeline.TIME_STEPS(), TIMES, len(TIMES))
            information.Set(Pipeline.TIME_RANGE(), [TIMES[0], TIMES[-1]], 2)
            return 1

        def RequestData(self, request: Any, inputs: Any, outputs: Any) -> int:
            information = outputs.GetInformationObject(0)
            time = information.Get(Pipeline.UPDATE_TIME_STEP()) if information.Has(Pipeline.UPDATE_TIME_STEP()) else 0.0
            points, polygons = vtkPoints(), vtkCellArray()
            points.SetData(numpy_to_vtk(motion()[TIMES.index(time)].astype(np.float32), deep=True))
            for face in FACES:
                polygons.InsertNextCell(3, face)
            output = vtkPolyData.GetData(outputs)
            output.SetPoints(points)
            output.SetPolys(polygons)
            output.GetInformation().Set(output.DATA_TIME_STEP(), time)
            return 1

    source, writer = Source(), vtkHDFWriter()
    writer.SetInputConnection(source.GetOutputPort())
    writer.SetFileName(str(folder / "motion.vtkhdf"))
    writer.SetWriteAllTimeSteps(True)
    assert writer.Write()
    return folder / "motion.vtkhdf"


def as_object(folder: Path) -> Any:
    return Recording()


class Recording:
    """A recording in memory."""

    faces = FACES
    times = None

    def __len__(self) -> int:
        return 4

    def positions(self, index: int) -> np.ndarray:
        return motion()[index]


FORMS: list[Callable[[Path], Any]] = [
    as_ply, as_npz, as_npz_series, as_pc2, as_mdd, as_hdf5, as_zarr, as_usd, as_vtkhdf, as_object
]
READ = [as_hdf5, as_zarr, as_usd, as_vtkhdf]


@pytest.mark.parametrize("form", FORMS)
def test_every_form_has_the_same_report(form: Callable[[Path], Any], tmp_path: Path) -> None:
    expected = audit(motion(), FACES)
    assert (expected.frames, expected.violation.frame) == (4, 2)
    assert audit(form(tmp_path)) == expected
    for settings in ({"min_distance": 1.25}, {"groups": [0] * 6}, {"weld": True}):
        report = audit(form(tmp_path), **settings)
        assert report == audit(motion(), FACES, **settings), settings


@pytest.mark.parametrize("form", READ)
def test_frames_are_read_exactly_and_in_any_order(form: Callable[[Path], Any], tmp_path: Path) -> None:
    recording = open_recording(form(tmp_path))
    assert len(recording) == 4
    assert_array_equal(recording.faces, FACES)
    assert_array_equal(recording.times, TIMES)
    for index in (3, 0, 2):
        assert_array_equal(recording.positions(index), motion()[index])
    copy = pickle.loads(pickle.dumps(recording))
    assert_array_equal(copy.positions(1), motion()[1])
    assert copy.identity() == recording.identity()


def test_a_page_names_frames_and_times(tmp_path: Path) -> None:
    audit(as_hdf5(tmp_path), view=tmp_path / "page.html")
    assert "frame 1, time 0.25" in (tmp_path / "page.html").read_text()


def test_an_xdmf_series_is_moved_by_displacements(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    meshio = pytest.importorskip("meshio")
    pytest.importorskip("h5py")
    frames = motion()
    # meshio writes the data to the working folder.
    monkeypatch.chdir(tmp_path)
    with meshio.xdmf.TimeSeriesWriter("motion.xdmf") as writer:
        writer.write_points_cells(frames[0], [("triangle", np.array(FACES))])
        for time, frame in zip(TIMES, frames):
            writer.write_data(time, point_data={"u": frame - frames[0]})
    monkeypatch.chdir("/")
    recording = open_recording(tmp_path / "motion.xdmf", displacement="u")
    assert_array_equal(recording.times, TIMES)
    assert audit(recording).violation.frame == audit(frames, FACES).violation.frame
    for index in range(4):
        assert_array_equal(recording.positions(index), frames[0] + (frames[index] - frames[0]))
    with pytest.raises(ValueError, match="by displacement=NAME: there are u"):
        open_recording(tmp_path / "motion.xdmf")


def test_polygons_are_fans_as_in_mesh_files(tmp_path: Path) -> None:
    h5py = pytest.importorskip("h5py")
    frames = np.zeros((1, 5, 3))
    frames[0, :, :2] = [[0, 0], [1, 0], [1, 1], [0, 1], [2, 2]]
    with h5py.File(tmp_path / "quads.h5", "w") as file:
        file["x"], file["f"], file["edges"] = frames, [[2, 3, 0, 1]], [[2, 4]]
    recording = open_recording(tmp_path / "quads.h5", positions="x", faces="f")
    assert_array_equal(recording.faces, [[0, 1, 2], [0, 2, 3]])
    assert recording.times is None
    assert audit(recording).is_free


def test_transforms_of_usd_place_the_mesh(tmp_path: Path) -> None:
    pytest.importorskip("pxr", reason="usd-core is not installed")
    from pxr import Gf, Usd, UsdGeom

    stage = Usd.Stage.CreateNew(str(tmp_path / "moved.usda"))
    UsdGeom.Xform.Define(stage, "/World").AddTranslateOp().Set(Gf.Vec3d(8, 0, 0))
    mesh = UsdGeom.Mesh.Define(stage, "/World/Box")
    mesh.CreateFaceVertexCountsAttr([3])
    mesh.CreateFaceVertexIndicesAttr([0, 1, 2])
    mesh.CreatePointsAttr([(0, 0, 0), (1, 0, 0), (0, 1, 0)])
    up = UsdGeom.Xformable(mesh).AddTranslateOp()
    up.Set(Gf.Vec3d(0, 0, 0.5), 0.0)
    up.Set(Gf.Vec3d(0, 0, 2.5), 24.0)
    stage.Save()
    recording = open_recording(tmp_path / "moved.usda")
    assert_array_equal(recording.times, [0.0, 1.0])
    assert_array_equal(recording.positions(1), [[8, 0, 2.5], [9, 0, 2.5], [8, 1, 2.5]])


def test_what_cannot_be_read_is_refused(tmp_path: Path) -> None:
    h5py = pytest.importorskip("h5py")
    with pytest.raises(ValueError, match="unknown extension, expected one of .h5"):
        open_recording(tmp_path / "motion.abc")
    with pytest.raises(FileNotFoundError, match="no such file or folder"):
        audit(tmp_path / "missing.h5")
    with h5py.File(tmp_path / "other.h5", "w") as file:
        file["points"], file["faces"] = np.zeros((4, 3)), FACES
    with pytest.raises(ValueError, match="no array positions; there are faces, points"):
        audit(tmp_path / "other.h5")
    with pytest.raises(ValueError, match=r"points has the shape \(4, 3\)"):
        open_recording(tmp_path / "other.h5", positions="points")
    with h5py.File(tmp_path / "wrong.h5", "w") as file:
        file["positions"], file["faces"] = np.zeros((1, 4, 3)), FACES
    with pytest.raises(ValueError, match="names vertex 4, but there are 4 vertices"):
        audit(tmp_path / "wrong.h5")
    with pytest.raises(TypeError, match="faces and edges come from the recording"):
        audit(Recording(), FACES)


def test_a_coordinate_that_is_not_finite_is_named() -> None:
    class Wrong(Recording):
        def positions(self, index: int) -> np.ndarray:
            frame = motion()[index]
            frame[4, 1] = np.nan if index == 1 else 0.5
            return frame

    with pytest.raises(ValueError, match="frame 1: .*vertex 4"):
        audit(Wrong())


def test_a_usd_mesh_with_other_faces_is_refused(tmp_path: Path) -> None:
    file = as_usd(tmp_path)
    from pxr import Usd, UsdGeom

    stage = Usd.Stage.Open(str(file))
    mesh = UsdGeom.Mesh(stage.GetPrimAtPath("/World/Cloth"))
    mesh.GetFaceVertexIndicesAttr().Set([0, 1, 2, 3, 4, 5], 0.0)
    mesh.GetFaceVertexIndicesAttr().Set([0, 1, 2, 3, 5, 4], 2.0)
    stage.Save()
    with pytest.raises(ValueError, match="time code 2.*the faces change"):
        audit(file)
