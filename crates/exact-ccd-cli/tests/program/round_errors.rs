//! The errors of `exact-ccd round`.

use exact_ccd::{Query, VertexFace};
use exact_ccd_mesh::Frame;

use crate::folder::Folder;
use crate::meshes::{ply, tip_above_square};
use crate::queries::pass;
use crate::query_rows::{file, rows};

/// The run fails with this error and writes nothing.
#[track_caller]
fn assert_error(folder: &Folder, arguments: &[&str], expected: &str) {
    let run = folder.run(&[&["round", "--output", "rounded", "--plot", "plot.svg"], arguments].concat());
    assert_eq!(run.stdout, "");
    assert_eq!(run.error(), expected);
    assert!(!folder.path("rounded").exists() && !folder.path("plot.svg").exists());
}

#[test]
fn files_that_are_not_meshes_without_a_kind() {
    let folder = Folder::new();
    folder.write("vf.csv", rows(&pass(), ""));
    assert_error(
        &folder,
        &["vf.csv"],
        "vf.csv: expected a mesh file, .ply, .obj, .stl, .off, .msh, .vtu, .vtp, .vtk, .glb, .gltf, .npy or .npz, \
         or --kind for a query file",
    );
}

#[test]
fn files_that_cannot_be_read() {
    let folder = Folder::new();
    folder.write("cut.off", "OFF\n3 1 0\n0 0 0\n");
    folder.write(
        "thirds.csv",
        rows(&pass(), "").replacen(",8,8,8\n", ",8,1,3\n", 1),
    );
    for (arguments, name) in [
        (&["missing.ply"][..], "missing.ply: "),
        (&["cut.off"], "cut.off: "),
        (&["--kind", "ee", "missing.csv"], "missing.csv: "),
        (
            &["--kind", "vf", "thirds.csv"],
            "thirds.csv, line 1: z of p at t = 0: ",
        ),
    ] {
        let run = folder.run(&[&["round", "--output", "rounded"], arguments].concat());
        assert!(run.error().starts_with(name), "{run:?}");
        assert!(!folder.path("rounded").exists());
    }
}

#[test]
fn a_rounded_mesh_is_a_ply_file() {
    let folder = Folder::new();
    folder.write("mesh.ply", ply(&tip_above_square(0.1)));
    for name in ["rounded.obj", "rounded.ply.gz"] {
        let run = folder.run(&["round", "mesh.ply", "--output", name]);
        assert!(run.error().ends_with("name one that ends in .ply"), "{run:?}");
        assert!(!folder.path(name).exists());
    }
}

/// A query whose first point is at `x` on this axis at t = 1; all other coordinates of it are
/// shifted by 1 or not at all.
fn far(axis: usize, x: f64) -> Query<VertexFace> {
    let mut points = [[[0.0; 3], [0.0; 3], [1.0; 3], [1.0; 3]]; 2];
    points[1][0][axis] = x;
    Query::<VertexFace>::new(points[0], points[1]).unwrap()
}

#[test]
fn coordinates_too_far_apart_on_an_axis() {
    let folder = Folder::new();
    folder.write("sound.csv", file(&[pass(), pass()]));
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        // −1e308 and 0 are to be shifted by 2e308; 0 and f64::MAX by f64::MAX, to twice that.
        for x in [-1e308, f64::MAX] {
            let query = far(axis, x);
            folder.write("far.csv", file(&[pass(), query, far(axis, 0.0)]));
            let too_large = format!("on the {name} axis, the coordinates are too large to be shifted");
            assert_error(
                &folder,
                &["--kind", "vf", "--per-query", "sound.csv", "far.csv"],
                &format!("far.csv, query 1: {too_large}"),
            );
            let shared = folder.run(&["round", "--kind", "vf", "sound.csv", "far.csv"]);
            assert!(shared.error().ends_with(&too_large), "{shared:?}");

            let [start, end] = query
                .points()
                .map(|points| Frame::new(points.to_vec(), vec![]).unwrap());
            folder.write("start.ply", ply(&start));
            folder.write("end.ply", ply(&end));
            assert_error(&folder, &["start.ply", "end.ply"], &too_large);
        }
    }
}

#[test]
fn two_meshes_of_one_name() {
    let folder = Folder::new();
    let mesh = ply(&Frame::new(vec![[0.0; 3]], vec![]).unwrap());
    folder.write("mesh.ply", &mesh);
    folder.write("mesh.obj", "v 0 0 0\n");
    let file = std::path::Path::new("rounded").join("mesh.ply");
    assert_error(
        &folder,
        &["mesh.ply", "mesh.obj"],
        &format!("two meshes would be written to {}", file.display()),
    );
}

#[test]
fn data_that_cannot_be_written() {
    let folder = Folder::new();
    folder.write("vf.csv", rows(&pass(), ""));
    folder.write("mesh.ply", ply(&Frame::new(vec![[0.0; 3]], vec![]).unwrap()));
    folder.write("other.ply", ply(&Frame::new(vec![[0.0; 3]], vec![]).unwrap()));
    for arguments in [
        &["--kind", "vf", "vf.csv", "--output", "missing/file"][..],
        &["--kind", "vf", "vf.csv", "--plot", "missing/file"],
        &["mesh.ply", "--output", "missing/file"],
        // A file is no folder.
        &["mesh.ply", "other.ply", "--output", "mesh.ply/file"],
    ] {
        let run = folder.run(&[&["round"], arguments].concat());
        assert_eq!(run.stdout, "");
        let error = run.error();
        assert!(
            error.starts_with("cannot write m") && error.contains("/file: "),
            "{error}"
        );
    }
}
