//! Files as other programs write them: read, or named, or refused with the remedy.

use std::path::{Path, PathBuf};

use crate::folder::{Folder, Run};

/// The folder of these files among the published data.
fn files() -> PathBuf {
    let default = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data");
    let data = std::env::var_os("EXACT_CCD_DATA").map_or(default, PathBuf::from);
    // The program runs in a folder of its own.
    data.canonicalize().unwrap().join("files")
}

/// A run of `audit` with files of this folder and further arguments.
fn audit(names: &[&str], more: &[&str]) -> Run {
    let paths: Vec<String> = names
        .iter()
        .map(|name| files().join(name).to_string_lossy().into_owned())
        .collect();
    let paths = paths.iter().map(String::as_str);
    let arguments: Vec<&str> = ["audit"]
        .into_iter()
        .chain(paths)
        .chain(more.iter().copied())
        .collect();
    Folder::new().run(&arguments)
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn files_of_other_programs_are_read() {
    for name in [
        "ascii-one-record-over-several-lines/end_solid.stl",
        "ascii-one-record-over-several-lines/quad.off",
        "gltf-required-texture-extension/box.gltf",
        "gmsh-older-versions/v1.msh",
        "gmsh-older-versions/v2.msh",
        "gmsh-older-versions/v40.msh",
        "obj-corner-with-slashes/a.obj",
        "ply-tristrips/strip.ply",
    ] {
        let run = audit(&[name], &[]);
        assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{name}: {run:?}");
    }
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn a_note_is_printed_once_and_is_in_json() {
    let run = audit(&["obj-with-two-coordinates/square.obj"], &["--json"]);
    let report: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    let note = report["notes"][0].as_str().unwrap();
    assert!(note.ends_with("square.obj: line 1: the vertices have two coordinates, and the third one is 0"));
    assert_eq!(run.stderr, format!("exact-ccd: note: {note}\n"));
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn a_node_that_moves_hits_another_one() {
    let run = audit(&["gltf-animation-ignored/anim.gltf"], &[]);
    assert_eq!(run.status, 1, "{run:?}");
    assert!(run.stdout.contains("contact between frame 0"), "{run:?}");
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn arrays_without_a_mesh_are_no_pass() {
    const FOLDER: &str = "npz-of-poses-is-free";
    let [poses, positions, faces, frames] = [
        "amass_like.npz",
        "positions_without_faces.npy",
        "faces.npy",
        "frames_without_faces",
    ]
    .map(|name| format!("{FOLDER}/{name}"));
    for (names, message) in [
        (&[&*poses][..], "not poses (compute the vertices of each frame"),
        (&[&faces], "name an array of faces with --faces FILE.npy"),
        (
            &[&positions, &faces],
            "name an array of faces with --faces FILE.npy",
        ),
        (&[&frames], "--positions NAME and --faces NAME"),
    ] {
        let run = audit(names, &[]);
        assert!(run.error().contains(message), "{run:?}");
    }
    let alone = audit(&[&positions], &[]);
    assert!(
        alone.stderr.contains("warning: ") && alone.stderr.contains("not read: faces, which"),
        "{alone:?}"
    );
    let faces = files().join(faces);
    let both = audit(&[&positions], &["--faces", &faces.to_string_lossy()]);
    assert_eq!((both.status, both.stderr.as_str()), (1, ""), "{both:?}");
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn each_part_of_a_collection_is_a_part() {
    let run = audit(&["pvd-parts/animation.pvd"], &[]);
    assert!(
        run.stdout
            .contains("part animation-0: vertices 0 to 7\npart animation-1: vertices 8 to 15\n"),
        "{run:?}"
    );
    let apart = audit(
        &["pvd-parts/animation.pvd"],
        &["--ignore", "animation-0:animation-1"],
    );
    assert_eq!(apart.status, 0, "{apart:?}");
}
