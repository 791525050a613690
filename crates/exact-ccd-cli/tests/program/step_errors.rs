//! Mesh files that `exact-ccd step` cannot use.

use exact_ccd_mesh::Frame;

use crate::folder::Folder;
use crate::meshes::{fall, obj, off, ply, tip_above_square};

/// Runs the step with this file as its end. The error must contain the name of the file and all of
/// `expected`.
#[track_caller]
fn assert_error(file: &str, contents: impl AsRef<[u8]>, expected: &[&str]) {
    let folder = fall(1.0, -2.0);
    folder.write(file, contents);
    for arguments in [
        &["step", "start.ply", file][..],
        &["step", "start.ply", file, "--json"],
    ] {
        let run = folder.run(arguments);
        assert_eq!(run.stdout, "");
        let error = run.error();
        assert!(error.contains(file), "{error}");
        for word in expected {
            assert!(error.contains(word), "{word} in {error}");
        }
    }
}

#[test]
fn a_missing_file() {
    let folder = fall(1.0, -2.0);
    for arguments in [
        ["step", "start.ply", "missing.ply"],
        ["step", "missing.ply", "end.ply"],
    ] {
        let run = folder.run(&arguments);
        assert_eq!(run.stdout, "");
        assert!(run.error().starts_with("missing.ply: "), "{run:?}");
    }
}

#[test]
fn a_folder_in_place_of_a_file() {
    let folder = fall(1.0, -2.0);
    std::fs::create_dir(folder.path("folder.ply")).unwrap();
    let run = folder.run(&["step", "start.ply", "folder.ply"]);
    assert!(run.error().starts_with("folder.ply: "), "{run:?}");
}

#[test]
fn an_extension_without_a_format() {
    assert_error("mesh.txt", "", &[".ply, .obj, .stl, .off, .msh, .vtu"]);
    assert_error("mesh", "", &[".ply, .obj, .stl, .off, .msh, .vtu"]);
}

#[test]
fn a_file_cut_short_anywhere() {
    let frame = tip_above_square(-2.0);
    let folder = fall(1.0, -2.0);
    for (name, contents) in [("cut.ply", ply(&frame)), ("cut.off", off(&frame).into_bytes())] {
        // The last line break of a text may be missing.
        for length in (0..contents.len() - 1).step_by(7) {
            folder.write(name, &contents[..length]);
            let run = folder.run(&["step", "start.ply", name]);
            assert!(run.error().contains(name), "{length} bytes: {run:?}");
        }
    }
}

#[test]
fn a_face_index_out_of_range() {
    let off = off(&tip_above_square(-2.0));
    assert_error(
        "end.off",
        off.replace("3 4 5 6", "3 4 5 7"),
        &["face 2", "vertex 7"],
    );
    assert_error("end.off", off.replace("3 4 5 6", "3 4 5 -1"), &["face 2", "-1"]);
    let obj = obj(&tip_above_square(-2.0));
    assert_error(
        "end.obj",
        obj.replace("f 5 6 7", "f 5 6 8"),
        &["face 3", "vertex 8"],
    );
    let mut binary = ply(&tip_above_square(-2.0));
    let last = binary.len() - 4;
    binary[last..].copy_from_slice(&7_u32.to_le_bytes());
    assert_error("end.ply", binary, &["face 2", "vertex 7"]);
}

#[test]
fn a_face_of_too_few_corners() {
    let off = off(&tip_above_square(-2.0));
    assert_error(
        "end.off",
        off.replace("3 4 5 6", "2 4 5"),
        &["face 2", "at least 3"],
    );
    let obj = obj(&tip_above_square(-2.0));
    assert_error("end.obj", obj.replace("f 5 6 7", "f 5"), &["face 3", "at least"]);
}

/// A polygon is the fan of its triangles: another mesh than one triangle.
#[test]
fn a_polygon_in_place_of_a_triangle() {
    let off = off(&tip_above_square(-2.0));
    assert_error(
        "end.off",
        off.replace("3 4 5 6", "4 4 5 6 0"),
        &["face 2", "the same mesh"],
    );
}

#[test]
fn a_coordinate_that_is_no_finite_number() {
    let off = off(&tip_above_square(-2.0));
    for value in ["nan", "inf", "-inf", "1e999"] {
        assert_error("end.off", off.replace("0.75 0.5", &format!("0.75 {value}")), &[]);
    }
}

#[test]
fn another_mesh_at_the_end() {
    let Frame { mesh, positions } = tip_above_square(-2.0);
    let with_faces = |faces| ply(&Frame::new(positions.clone(), faces).unwrap());

    let mut more = positions.clone();
    more.push([0.0; 3]);
    let more = ply(&Frame::new(more, mesh.faces().to_vec()).unwrap());
    assert_error("more.ply", more, &["start.ply", "7 vertices", "8"]);

    let fewer = with_faces(mesh.faces()[..2].to_vec());
    assert_error("fewer.ply", fewer, &["start.ply", "3 faces", "2"]);

    let mut turned = mesh.faces().to_vec();
    turned[1].rotate_left(1);
    assert_error(
        "turned.ply",
        with_faces(turned),
        &["start.ply", "face 1", "[2, 1, 3]", "[1, 3, 2]"],
    );
}

#[cfg(unix)]
#[test]
fn a_name_with_a_line_break_stays_on_one_line() {
    let run = Folder::new().run(&["step", "one\ntwo.ply", "three\r\nfour.ply"]);
    assert!(run.error().contains("two.ply: "), "{run:?}");
}
