//! Files whose names say another format, compressed files, and files without a mesh.

use std::io::Write;
use std::path::PathBuf;

use super::temporary;
use exact_ccd_files::{Contents, Format, FrameSequence, MeshFile, Polygons, parse_frame, read_frame};

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

fn gzip(data: &[u8]) -> Vec<u8> {
    let mut writer = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::best());
    writer.write_all(data).unwrap();
    writer.finish().unwrap()
}

fn file(name: &str, contents: impl AsRef<[u8]>) -> PathBuf {
    temporary(&format!("contents/{name}"), contents)
}

#[track_caller]
fn assert_error(name: &str, contents: impl AsRef<[u8]>, message: &str) {
    let error = read_frame(file(name, contents)).unwrap_err().to_string();
    assert!(error.ends_with(&format!("{name}: {message}")), "{error}");
}

#[test]
fn gzip_is_read_by_name() {
    let twice = [gzip(&TRIANGLE.as_bytes()[..10]), gzip(&TRIANGLE.as_bytes()[10..])].concat();
    for contents in [gzip(TRIANGLE.as_bytes()), twice] {
        let frame = read_frame(file("triangle.obj.gz", contents)).unwrap();
        assert_eq!(frame, parse_frame(TRIANGLE.as_bytes(), Format::Obj).unwrap());
    }
    assert_error(
        "plain.obj.gz",
        TRIANGLE,
        "the contents are not compressed, expected data compressed by gzip; remove .gz from the name of the \
         file, or compress it",
    );
    assert_error(
        "squeezed.obj",
        gzip(TRIANGLE.as_bytes()),
        "the contents are compressed by gzip, expected Wavefront OBJ; add .gz to the name of the file, or \
         decompress it",
    );
}

#[test]
fn data_that_expand_without_bound_are_errors() {
    let bomb = gzip(&vec![b'\n'; 50 << 20]);
    assert!(bomb.len() < 100_000);
    let limit = 200 * bomb.len() + (1 << 20);
    assert_error(
        "bomb.obj.gz",
        &bomb,
        &format!(
            "the data expand to more than {limit} bytes, the most for a file of this size; \
             write the file without compression and without repeated data"
        ),
    );
}

#[test]
fn files_that_are_something_else_say_so() {
    for (name, contents, message) in [
        (
            "page.obj",
            "\n<!DOCTYPE HTML><html>",
            "the contents are an HTML page, expected Wavefront OBJ; download the file itself: the page is \
             about it, or has an error message",
        ),
        (
            "lines.obj",
            "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r\n",
            "the contents are text with lines that end in CR alone, expected lines that end in LF, or in CR and LF; \
             convert the ends of its lines",
        ),
        (
            "pointer.ply",
            "version https://git-lfs.github.com/spec/v1\n",
            "the contents are a pointer of Git LFS, expected PLY; fetch the file itself with `git lfs pull`",
        ),
        (
            "mesh.obj",
            "ply\nformat ascii 1.0\n",
            "the contents are PLY, expected Wavefront OBJ; rename the file to end in .ply",
        ),
        (
            "mesh.msh",
            "\n(1 \"meshio 5.3.5\")\n(2 3)\n",
            "the contents are a mesh of ANSYS Fluent, expected Gmsh MSH; write the format of Gmsh, in meshio with \
             `file_format=\"gmsh\"`",
        ),
        (
            "mesh.stl",
            "glTF\x02\0\0\0",
            "the contents are binary glTF, expected STL; rename the file to end in .glb",
        ),
        (
            "data.off",
            "\x01\x02\0\x03",
            "the contents are binary data, expected OFF; export the mesh again",
        ),
        (
            "off.obj",
            "OFF\n3 1 0\n",
            "the contents are OFF, expected Wavefront OBJ; rename the file to end in .off",
        ),
        (
            "facets.obj",
            "solid cube\nfacet normal 0 0 1\n",
            "the contents are STL as text, expected Wavefront OBJ; rename the file to end in .stl",
        ),
        (
            "obj.stl",
            format!("# from a program\n\n{TRIANGLE}").as_str(),
            "the contents are Wavefront OBJ, expected STL; rename the file to end in .obj",
        ),
        (
            "surface.obj",
            "<?xml version=\"1.0\"?>\n<!-- a surface -->\n<VTKFile type=\"PolyData\"/>",
            "the contents are VTK PolyData, expected Wavefront OBJ; rename the file to end in .vtp",
        ),
        (
            "grid.vtp",
            "<VTKFile type='UnstructuredGrid'/>",
            "the contents are VTK UnstructuredGrid, expected VTK PolyData; rename the file to end in .vtu",
        ),
        (
            "list.vtu",
            "<VTKFile type='Collection'/>",
            "the contents are a list of files of ParaView, expected VTK UnstructuredGrid; rename the file to end \
             in .pvd",
        ),
        (
            "page.vtu",
            "<?xml version='1.0'?><html></html>",
            "the contents are an HTML page, expected VTK UnstructuredGrid; download the file itself: the page is \
             about it, or has an error message",
        ),
        (
            "scene.obj",
            "<?xml version='1.0'?><scene/>",
            "the contents are XML, expected Wavefront OBJ; choose a file with a mesh, or export the mesh as OBJ \
             or PLY",
        ),
        (
            "nothing.ply",
            " \n",
            "the contents are empty, expected PLY; export the mesh again",
        ),
    ] {
        assert_error(name, contents, message);
    }
}

#[test]
fn sequences_of_something_else_say_so() {
    for (name, contents, message) in [
        (
            "pointer.npz",
            &b"version https://git-lfs.github.com/spec/v1\n"[..],
            "the contents are a pointer of Git LFS, expected numpy .npz; fetch the file itself with `git lfs \
             pull`",
        ),
        (
            "array.npz",
            b"\x93NUMPY\x01\0",
            "the contents are a numpy array, expected numpy .npz; rename the file to end in .npy",
        ),
        (
            "archive.npy",
            b"PK\x03\x04",
            "the contents are a zip archive, expected numpy .npy; rename the file to end in .npz",
        ),
    ] {
        assert_error(name, contents, message);
        let error = FrameSequence::open(file(name, contents), Polygons::Refuse).unwrap_err();
        assert!(
            error.to_string().ends_with(&format!("{name}: {message}")),
            "{error}"
        );
    }
}

#[test]
fn known_formats_without_a_reader_name_the_export_that_works() {
    for (name, format, export) in [
        ("cloth.abc", "Alembic", "OBJ or PLY"),
        ("cloth.USDC", "USD", "numpy.savez"),
        ("cloth.fbx.gz", "FBX", "with Animation"),
        ("image.vti", "a structured grid of VTK", "extract_surface()"),
        (
            "cloth.pc2",
            "a cache of positions alone",
            "audit MESH.obj CACHE.pc2",
        ),
        (
            "cloth.mdd",
            "a cache of positions alone",
            "give its mesh before it",
        ),
        ("cloth.bgeo", "Houdini's own format", ".obj or .ply"),
        ("cloth.bgeo.sc", "Houdini's own format", ".obj or .ply"),
        (
            "cloth.pkl",
            "a pickle of Python, which may run code when it is loaded",
            "numpy.savez",
        ),
        ("cloth.hdf5", "HDF5", "numpy.savez"),
        ("walk.bvh", "a motion of bones", "OBJ or PLY"),
    ] {
        let error = read_frame(file(name, "")).unwrap_err().to_string();
        assert!(
            error.contains(&format!("{name}: there is no reader for {format}; ")),
            "{error}"
        );
        assert!(error.contains(export), "{error}");
    }
    assert_error(
        "mesh.obj",
        "PXR-USDC and more",
        "the contents are USD, expected Wavefront OBJ; export each frame as OBJ or PLY with the same \
         vertices (in Blender: File > Export > Wavefront (.obj) with Animation), or write positions and faces \
         with numpy.savez",
    );
}

#[test]
fn a_file_without_a_mesh_says_what_it_has() {
    assert_error(
        "empty.off",
        "OFF\n0 0 0\n",
        "no face, no edge and no point: the file has 0 vertices, 0 points, 0 edges, 0 faces and 0 cells with \
         volume; choose a file with a mesh",
    );
    let points = MeshFile::parse(b"v 0 0 0\nv 1 0 0\n", Format::Obj, Polygons::default()).unwrap();
    assert_eq!(
        points.contents.to_string(),
        "2 vertices, 0 edges, 0 faces, 2 points, 2 components"
    );
}

#[test]
fn a_ply_file_may_have_points_only() {
    let points = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n\
                  property float z\nend_header\n0 0 0\n1 0 0\n";
    let file = MeshFile::parse(points.as_bytes(), Format::Ply, Polygons::default()).unwrap();
    assert_eq!((file.contents.loose_vertices, file.contents.edges), (2, 0));
    // Other lists are not read, nor edges without the ids of their vertices.
    for element in [
        "element cell 0\nproperty list int int vertex_indices\n",
        "element edge 0\nproperty int start\n",
    ] {
        let other = points.replace("end_header", &format!("{element}end_header"));
        let error = parse_frame(other.as_bytes(), Format::Ply).unwrap_err();
        let expected = ": expected an element `face` in the header, found none; export the mesh with its vertices and faces";
        assert!(error.to_string().ends_with(expected), "{error}");
    }
}

#[test]
fn contents_count_loose_elements_and_parts() {
    let obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 2\nv 9 9 9\nf 1 2 3\nl 4 5\n";
    let frame = parse_frame(obj.as_bytes(), Format::Obj).unwrap();
    assert_eq!(
        Contents::of(&frame).to_string(),
        "6 vertices, 4 edges, 1 face, 1 loose edge, 1 point, 3 components"
    );
}

#[test]
fn a_series_lists_files_and_times() {
    file("a.obj", TRIANGLE);
    file("b.obj", TRIANGLE.replace("0 1 0", "0 2 0"));
    let series = r#"{"file-series-version": "1.0", "files": [
        {"name": "a.obj", "time": 0}, {"name": "b.obj", "time": 0.25}]}"#;
    let sequence = FrameSequence::open(file("list.obj.series", series), Polygons::Refuse).unwrap();
    assert_eq!((sequence.len(), sequence.time(1)), (2, Some(0.25)));
    assert_eq!(sequence.read(1).unwrap().frame.positions[2], [0.0, 2.0, 0.0]);
    let error = sequence.read(2).unwrap_err().to_string();
    assert!(error.ends_with("expected a frame below 2, found 2"), "{error}");
    for (contents, message) in [
        ("{", "line 1: expected JSON, found `"),
        ("[]", "expected a list `files`, found none"),
        (
            r#"{"files": [{"name": "a.obj", "time": 0}, {"name": "b.obj", "time": 0}]}"#,
            "or a list for each part), found `a.obj` and `b.obj` at the time 0",
        ),
        (
            r#"{"files": [{"name": "a.obj", "time": 0.5}, {"name": "b.obj", "time": 0.25}]}"#,
            "expected files sorted by time (sort the list), found `b.obj` at the time 0.25 after `a.obj` at 0.5",
        ),
        (
            r#"{"files": [3]}"#,
            "expected a file with `name` and `time`, found `3`",
        ),
    ] {
        let path = file("wrong.series", contents);
        let error = FrameSequence::open(path, Polygons::Refuse)
            .err()
            .unwrap()
            .to_string();
        assert!(error.contains(message), "{error}");
    }
}
