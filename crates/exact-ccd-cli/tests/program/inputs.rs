//! Inputs that are not there, or are something else, and outputs that cannot be written: each error names the
//! file and has an instruction.

use crate::folder::Folder;
use crate::meshes::fall;
use crate::simulate;

/// A step, an empty folder, a text, and bytes that are no text.
fn folder() -> Folder {
    let folder = fall(1.0, -1.0);
    std::fs::create_dir(folder.path("empty")).unwrap();
    std::fs::create_dir_all(folder.path("data/vertex-face")).unwrap();
    folder.write("text.txt", "text\n");
    folder.write("bytes.toml", [0xff, 0xfe, 0x00]);
    folder.write("scene.toml", simulate::SCENE);
    folder
}

#[track_caller]
fn assert_error(folder: &Folder, arguments: &[&str], expected: &str) {
    let run = folder.run(arguments);
    let error = run.error();
    assert!(
        error.starts_with(expected),
        "{arguments:?}: {error}\nexpected {expected}"
    );
}

#[test]
fn a_missing_input_is_named_with_what_it_should_be() {
    let folder = folder();
    let missing = "no such file or folder, expected";
    let remedy = ": check the name, and the folder in which the program runs";
    for (arguments, expected) in [
        (&["audit", "no"][..], "a mesh file, or a folder or a list of them"),
        (
            &["audit", "start.ply", "no"],
            "a mesh file, or a folder or a list of them",
        ),
        (
            &["audit", "start.ply", "--with", "no"],
            "a mesh file, or a folder or a list of them",
        ),
        (&["step", "no", "end.ply"], "a mesh file"),
        (&["step", "start.ply", "no"], "a mesh file"),
        (&["queries", "no"], "a query file, CSV or Parquet"),
        (&["queries", "--kind", "vf", "no"], "a query file, CSV or Parquet"),
        (
            &["convert", "no", "-o", "out.csv"],
            "a query file, CSV or Parquet, or the folder of a scene",
        ),
        (&["round", "no"], "a mesh file, or a query file with --kind"),
        (
            &["round", "--kind", "vf", "no"],
            "a mesh file, or a query file with --kind",
        ),
        (&["bench", "no"], "a folder of data sets"),
        (&["import", "no"], "a scene of IPC or of PolyFEM"),
        (
            &["simulate", "no"],
            "a scene in TOML, or one of IPC or of PolyFEM",
        ),
    ] {
        assert_error(&folder, arguments, &format!("no: {missing} {expected}{remedy}"));
    }
}

#[test]
fn a_folder_in_place_of_a_file_is_named() {
    let folder = folder();
    for arguments in [
        &["step", "empty", "end.ply"][..],
        &["step", "start.ply", "empty"],
        &["queries", "empty"],
        &["queries", "--kind", "vf", "empty"],
        &["round", "empty"],
        &["import", "empty"],
        &["simulate", "empty"],
    ] {
        assert_error(&folder, arguments, "empty: this is a folder, expected ");
    }
    assert_error(
        &folder,
        &["bench", "text.txt"],
        "text.txt: this is no folder, expected a folder of data sets",
    );
    assert_error(
        &folder,
        &["audit", "empty"],
        "empty: no mesh file in the folder, expected .ply, .obj,",
    );
    assert_error(
        &folder,
        &["convert", "--kind", "vf", "empty", "-o", "out.csv"],
        "empty/frames: no such file or folder, expected the frames of a scene of the published data sets",
    );
}

#[test]
fn a_folder_of_data_sets_without_queries_is_an_error() {
    assert_error(
        &folder(),
        &["bench", "data"],
        "data: expected folders `edge-edge` or `vertex-face` with",
    );
}

#[test]
fn bytes_in_place_of_a_scene_are_named() {
    assert_error(
        &folder(),
        &["simulate", "bytes.toml"],
        "bytes.toml, line 1, the file: found bytes that are no text in UTF-8, expected a scene in TOML",
    );
}

/// An output without a place is found before anything is computed, so that nothing is printed.
#[test]
fn outputs_without_a_place_are_named_with_a_remedy() {
    let folder = folder();
    for name in ["folder.csv", "folder.html"] {
        std::fs::create_dir(folder.path(name)).unwrap();
    }
    for (option, file, remedy) in [
        ("--all", "no/all.csv", "make its folder first"),
        ("--view", "no/page.html", "make its folder first"),
        (
            "--all",
            "folder.csv",
            "name a file, as there is a folder of this name",
        ),
        (
            "--view",
            "folder.html",
            "name a file, as there is a folder of this name",
        ),
        (
            "--paraview",
            "text.txt",
            "name another folder, as there is a file of this name",
        ),
    ] {
        for command in ["step", "audit"] {
            let run = folder.run(&[command, "start.ply", "end.ply", option, file]);
            let error = run.error();
            assert!(error.starts_with(&format!("cannot write {file}: ")), "{error}");
            assert!(error.ends_with(remedy), "{error}");
            assert_eq!(run.stdout, "");
        }
    }
}

/// An option whose file is left out takes the first mesh behind it for its file.
#[test]
fn no_answer_replaces_a_mesh() {
    let folder = folder();
    let read = |name: &str| std::fs::read(folder.path(name)).unwrap();
    let before = read("start.ply");
    for option in ["--view", "--certificate", "--output", "-o"] {
        for command in ["step", "audit"] {
            let run = folder.run(&[command, option, "start.ply", "start.ply", "end.ply"]);
            assert_eq!((run.status, run.stdout.as_str()), (2, ""), "{run:?}");
            assert!(run.stderr.contains("start.ply"), "{run:?}");
            assert_eq!(read("start.ply"), before);
        }
    }
    // A collection of frames has the extension of no mesh file.
    let list = r#"<VTKFile type="Collection"><Collection><DataSet file="start.ply"/></Collection></VTKFile>"#;
    folder.write("frames.pvd", list);
    for command in [&["audit", "start.ply"][..], &["step", "start.ply", "end.ply"]] {
        for option in ["--output", "--certificate"] {
            let run = folder.run(&[command, &[option, "frames.pvd"]].concat());
            assert!(
                run.status == 2 && run.stderr.contains("would be replaced"),
                "{run:?}"
            );
            assert_eq!(read("frames.pvd"), list.as_bytes());
        }
    }
    // Another name of an input is compared with it.
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("frames.pvd", folder.path("answer.txt")).unwrap();
        for command in [
            &["audit", "frames.pvd"][..],
            &["audit", "a=frames.pvd"],
            &["audit", "start.ply", "--with", "frames.pvd"],
            &["step", "frames.pvd", "end.ply"],
        ] {
            let run = folder.run(&[command, &["--output", "answer.txt"]].concat());
            assert!(run.error().contains("would replace this input"), "{run:?}");
            assert_eq!(read("frames.pvd"), list.as_bytes());
        }
        let run = folder.run(&["audit", "frames.pvd", "--certificate", "answer.txt"]);
        assert!(run.error().contains("would replace this input"), "{run:?}");
    }
    folder.write("vf.csv", "0,1,0,1,0,1,1\n".repeat(8));
    let before = read("vf.csv");
    for output in ["vf.csv", "./vf.csv"] {
        let run = folder.run(&["queries", "--kind", "vf", "vf.csv", "-o", output]);
        assert!(run.error().contains("would replace this input"), "{run:?}");
        for option in ["-o", "--plot"] {
            let run = folder.run(&["round", "--kind", "vf", "vf.csv", option, output]);
            assert!(run.error().contains("would replace this input"), "{run:?}");
        }
        assert_eq!(read("vf.csv"), before);
    }
}

#[test]
fn a_folder_for_paraview_replaces_no_input() {
    let folder = folder();
    let impact = ["step", "start.ply", "end.ply", "--paraview", "out"];
    assert_eq!(folder.run(&impact).status, 1);
    let read = |name: &str| std::fs::read(folder.path(name)).unwrap();
    for (name, command) in [
        (
            "out/impact.vtu",
            &["step", "out/impact.vtu", "out/impact.vtu"][..],
        ),
        (
            "out/impact.vtu",
            &["audit", "end.ply", "--with", "out/impact.vtu"],
        ),
        ("out/contacts.vtp", &["audit", "out"]),
    ] {
        let before = read(name);
        let run = folder.run(&[command, &["--paraview", "out"]].concat());
        assert!(run.error().contains("would replace this input"), "{run:?}");
        assert_eq!(read(name), before);
    }
}

#[test]
fn two_answers_are_two_files() {
    let folder = folder();
    std::fs::create_dir(folder.path("sub")).unwrap();
    let step = ["step", "start.ply", "end.ply", "--all", "one.csv"];
    for option in ["--output", "--certificate"] {
        for name in ["./one.csv", "sub/../one.csv"] {
            let run = folder.run(&[&step[..], &[option, name]].concat());
            let expected = "two answers would be written to this file: name another one";
            assert!(run.error().ends_with(expected), "{run:?}");
            assert!(!folder.path("one.csv").exists(), "{run:?}");
        }
    }
}
