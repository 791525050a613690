//! `exact-ccd import`, and `exact-ccd simulate` of the same scenes.

use crate::folder::Folder;

const MESH: &str = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n\
                    $Elements\n1\n1 4 2 0 1 1 2 3 4\n$EndElements\n";

/// A tetrahedron falls on the ground.
const SCENE: &str =
    "shapes input 1\nmeshes/tet.msh 0 0.05 0  0 0 0  1 1 1\nground 0 0\ntime 0.2 0.02\nzoom 2\n";

fn folder() -> Folder {
    let folder = Folder::new();
    std::fs::create_dir_all(folder.path("meshes")).unwrap();
    std::fs::create_dir_all(folder.path("scenes")).unwrap();
    folder.write("meshes/tet.msh", MESH);
    folder.write("scenes/scene.txt", SCENE);
    folder
}

#[test]
fn a_scene_and_its_import_have_the_same_simulation() {
    let folder = folder();
    let run = folder.run(&["import", "scenes/scene.txt", "--output", "scene.toml"]);
    assert_eq!((run.status, run.stdout.as_str()), (0, ""));
    assert_eq!(
        run.stderr,
        "exact-ccd: note: scenes/scene.txt, line 5, `zoom`: ignored: it concerns the viewing and the output of IPC\n\
         exact-ccd: note: the meshes are in the folder scenes: simulate with `--meshes scenes`\n"
    );
    let printed = folder.run(&["import", "scenes/scene.txt"]);
    assert_eq!(printed.stdout, folder.read("scene.toml"));
    for arguments in [
        ["simulate", "scenes/scene.txt", "--output", "theirs"].as_slice(),
        &["simulate", "scene.toml", "--meshes", "scenes", "--output", "ours"],
    ] {
        assert_eq!(folder.run(arguments).status, 0);
    }
    for frame in ["000000", "000010"] {
        let [theirs, ours] = ["theirs", "ours"].map(|folder| format!("{folder}/frames/{frame}.ply"));
        let [theirs, ours] = [theirs, ours].map(|file| std::fs::read(folder.path(&file)).unwrap());
        assert_eq!(theirs, ours);
    }
}

/// An imported scene may have changes made by hand.
#[test]
fn an_import_replaces_no_file_without_being_told() {
    let folder = folder();
    folder.write("scene.toml", "changed by hand");
    let run = folder.run(&["import", "scenes/scene.txt", "--output", "scene.toml"]);
    let error =
        "exact-ccd: error: scene.toml: the file exists: replace it with --overwrite, or name another file\n";
    assert!(run.status == 2 && run.stderr.ends_with(error), "{run:?}");
    assert_eq!(folder.read("scene.toml"), "changed by hand");
    let run = folder.run(&[
        "import",
        "scenes/scene.txt",
        "--output",
        "scene.toml",
        "--overwrite",
    ]);
    assert_eq!(run.status, 0, "{run:?}");
    assert!(folder.read("scene.toml").starts_with("# Imported from "));
}

#[test]
fn errors_of_imports_have_status_2() {
    let folder = folder();
    folder.write("scene.txt", "energy MR\n");
    let run = folder.run(&["simulate", "scene.txt"]);
    assert_eq!(
        run.error(),
        "scene.txt, line 1, `energy`: exact-ccd has no counterpart of this elastic energy: write `energy NH` or \
         `energy FCR`"
    );
    let run = folder.run(&["import", "meshes/tet.msh"]);
    assert!(
        run.error().starts_with("meshes/tet.msh: expected a scene of IPC"),
        "{run:?}"
    );
}
