//! Several files as one scene, the order of frames, polygons and split vertices.

use exact_ccd_files::{NamedPart, write_ply_with_parts};
use exact_ccd_mesh::Frame;
use serde_json::{Value, json};

use crate::folder::{Folder, Run};
use crate::meshes::{obj, ply, tip_above_square};

/// A triangle parallel to the floor, as an OBJ file.
pub(crate) fn tile(x: f64, z: f64) -> String {
    let positions = vec![[x, 0.0, z], [x + 1.0, 0.0, z], [x, 1.0, z]];
    obj(&Frame::new(positions, vec![[0, 1, 2]]).unwrap())
}

pub(crate) fn note(run: &Run) -> &str {
    run.stderr.strip_suffix('\n').unwrap_or_default()
}

pub(crate) fn json_of(run: &Run) -> Value {
    serde_json::from_str(&run.stdout).unwrap()
}

/// Files of a tile `a` that falls from 2 to −2, a tile `b` that rises from 1 to 3, and a `floor` at 0.
pub(crate) fn tiles() -> Folder {
    let folder = Folder::new();
    folder.write("a.obj", tile(0.0, 2.0));
    folder.write("a-end.obj", tile(0.0, -2.0));
    folder.write("b.obj", tile(0.25, 1.0));
    folder.write("b-end.obj", tile(0.25, 3.0));
    folder.write("floor.obj", tile(-0.25, 0.0));
    folder
}

#[test]
fn pairs_of_files_are_parts_of_one_scene() {
    let folder = tiles();
    let run = folder.run(&["step", "a.obj", "a-end.obj", "--toi"]);
    assert_eq!(run.status, 0, "{run:?}");
    let both = ["step", "a.obj", "a-end.obj", "b.obj", "b-end.obj"];
    let report = json_of(&folder.run(&[&both[..], &["--json"]].concat()));
    // They meet where 2 − 4 t = 1 + 2 t.
    assert_eq!(report["toi"], json!(1.0 / 6.0));
    assert_eq!(
        report["parts"],
        json!([
            {"name": "a", "first_vertex": 0, "vertex_count": 3, "is_obstacle": false},
            {"name": "b", "first_vertex": 3, "vertex_count": 3, "is_obstacle": false},
        ])
    );
    let run = folder.run(&both);
    assert!(
        run.stdout.starts_with(
            "read: 6 vertices, 6 edges, 2 faces, 2 components\npart a: vertices 0 to 2\npart b: vertices 3 to 5\ncontact"
        ),
        "{run:?}"
    );
    let run = folder.run(&["step", "a.obj", "a-end.obj", "b.obj"]);
    assert_eq!(
        run.error(),
        "b.obj: there is no end to this start: expected pairs of files, START END"
    );
}

#[test]
fn obstacles_rest_and_do_not_collide_with_each_other() {
    let folder = tiles();
    let run = folder.run(&["step", "a.obj", "a-end.obj", "--with", "floor.obj", "--json"]);
    assert_eq!((run.status, &json_of(&run)["toi"]), (1, &json!(0.5)));
    assert_eq!(json_of(&run)["parts"][1]["is_obstacle"], json!(true));
    // Two obstacles in the same place.
    let run = folder.run(&[
        "step",
        "b.obj",
        "b-end.obj",
        "--with",
        "floor.obj",
        "--with",
        "second=floor.obj",
        "--json",
    ]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{run:?}");
    assert_eq!(json_of(&run)["parts"][2]["name"], "second");

    let run = folder.run(&["audit", "a.obj", "a-end.obj", "--with", "floor.obj", "--as-given"]);
    assert_eq!(run.status, 1);
    assert!(
        run.stdout
            .contains("contact between frame 0 (a.obj) and frame 1 (a-end.obj) at t = 0.5: "),
        "{run:?}"
    );
    let run = folder.run(&["audit", "b.obj", "b-end.obj", "--with", "floor.obj", "--as-given"]);
    assert_eq!(run.status, 0, "{run:?}");
}

#[test]
fn parts_are_left_out_by_name() {
    let folder = tiles();
    let scene = [
        "step",
        "a.obj",
        "a-end.obj",
        "b.obj",
        "b-end.obj",
        "--with",
        "floor.obj",
        "--json",
    ];
    let toi = |rules: &[&str]| json_of(&folder.run(&[&scene[..], rules].concat()))["toi"].clone();
    assert_eq!(toi(&[]), json!(1.0 / 6.0));
    assert_eq!(toi(&["--ignore", "a:b"]), json!(0.5));
    assert_eq!(toi(&["--ignore", "b:a", "--ignore", "floor:a"]), Value::Null);
    assert_eq!(toi(&["--only", "a:floor"]), json!(0.5));
    assert_eq!(toi(&["--only", "b:floor"]), Value::Null);
    let report = json_of(&folder.run(&[&scene[..], &["--only", "a:floor", "--only", "a:b"]].concat()));
    assert_eq!(report["only"], json!(["a:floor", "a:b"]));
    let run = folder.run(&[&scene[..7], &["--ignore", "a:b"]].concat());
    assert!(run.stdout.contains("\nignored: a:b\n"), "{run:?}");
    let run = folder.run(&[&scene[..], &["--only", "floor:floor"]].concat());
    assert_eq!(
        run.error(),
        "--only floor:floor: both are obstacles, which are not compared with each other: name a part that moves"
    );
    let run = folder.run(&[&scene[..], &["--only", "a:ceiling"]].concat());
    assert_eq!(
        run.error(),
        "there is no part or group ceiling; there are a, b, floor"
    );
}

/// The names in PLY files select pairs, as those of files do.
#[test]
fn names_in_files_are_names_of_parts() {
    let folder = Folder::new();
    for (frame, height) in [1.0, -1.0].into_iter().enumerate() {
        let part = |name: &str, vertices| NamedPart {
            name: name.to_owned(),
            vertices,
        };
        let parts = [part("square", 0..4), part("a tip", 4..7)];
        let mut file = Vec::new();
        write_ply_with_parts(&mut file, &tip_above_square(height), &parts).unwrap();
        folder.write(&format!("{frame}.ply"), file);
    }
    let audit = |rules: &[&str]| folder.run(&[&["audit", "0.ply", "1.ply"], rules].concat());
    assert_eq!(audit(&[]).status, 1);
    assert_eq!(audit(&["--ignore", "a tip:square"]).status, 0);
    assert_eq!(audit(&["--only", "square:square"]).status, 0);
    assert_eq!(audit(&["--only", "a tip:square"]).status, 1);
    // The name of the file stands for all of its vertices.
    assert_eq!(audit(&["--ignore", "0:0"]).status, 0);
    let unknown = audit(&["--ignore", "tip:square"]);
    assert_eq!(
        unknown.error(),
        "there is no part or group tip; there are 0, square, a tip"
    );
    assert_eq!(audit(&["--weld", "--ignore", "a tip:square"]).status, 0);
}

#[test]
fn parts_that_intersect_at_the_start_count_only_if_they_can_collide() {
    let folder = Folder::new();
    folder.write("mesh.ply", ply(&tip_above_square(-1.0)));
    let upright = Frame::new(
        vec![[0.25, 0.25, -1.0], [0.25, 0.5, 1.0], [0.5, 0.25, 1.0]],
        vec![[0, 1, 2]],
    )
    .unwrap();
    folder.write("flat.obj", tile(0.0, 0.0));
    folder.write("upright.ply", ply(&upright));
    let scene = ["step", "flat.obj", "flat.obj", "--with", "upright.ply"];
    assert_eq!(folder.run(&scene).status, 1);
    let run = folder.run(&[&scene[..], &["--ignore", "flat:upright"]].concat());
    assert_eq!(run.status, 0);
    assert!(run.stdout.contains("\nfree of contact\n"), "{run:?}");
    let run = folder.run(&["audit", "flat.obj", "--with", "upright.ply"]);
    assert_eq!(run.status, 1);
    let run = folder.run(&[
        "audit",
        "flat.obj",
        "--with",
        "upright.ply",
        "--ignore",
        "flat:upright",
    ]);
    assert_eq!(run.status, 0);
}

#[test]
fn frames_are_taken_in_the_order_of_their_numbers() {
    let folder = Folder::new();
    // The order of a shell: f1, f10, f11, f2. The tip reaches the square in frame 11 only.
    for (frame, height) in [(1, 4.0), (2, 3.0), (10, 2.0), (11, -1.0)] {
        folder.write(&format!("f{frame}.ply"), ply(&tip_above_square(height)));
    }
    let files = ["audit", "f1.ply", "f10.ply", "f11.ply", "f2.ply"];
    let run = folder.run(&files);
    assert!(
        run.stdout
            .contains("contact between frame 2 (f10.ply) and frame 3 (f11.ply)"),
        "{run:?}"
    );
    assert_eq!(
        note(&run),
        "exact-ccd: note: the frames are sorted by the numbers in their names; --as-given keeps the order given\n\
         exact-ccd: warning: numbers are missing in the names of the frames: 3 to 9; the frames around a gap are \
         one step"
    );
    let run = folder.run(&[&files[..], &["--as-given"]].concat());
    assert!(
        run.stdout
            .contains("contact between frame 1 (f10.ply) and frame 2 (f11.ply)"),
        "{run:?}"
    );
    assert_eq!(note(&run), "");
    let run = folder.run(&["audit", "f1.ply", "f2.ply", "--json"]);
    assert_eq!((note(&run), json_of(&run).get("notes")), ("", None));
    let run = folder.run(&["audit", "f10.ply", "f2.ply", "--json"]);
    assert_eq!(json_of(&run)["notes"].as_array().unwrap().len(), 1);

    // In a folder, too, a missing number is worth a warning.
    std::fs::create_dir(folder.path("frames")).unwrap();
    for frame in [0, 1, 3] {
        folder.write(&format!("frames/{frame}.ply"), ply(&tip_above_square(1.0)));
    }
    let run = folder.run(&["audit", "frames"]);
    assert!(
        note(&run).starts_with("exact-ccd: warning: numbers are missing in the names of the frames: 2; "),
        "{run:?}"
    );

    // And in the path of a simulation, the time steps and increments that it does not have.
    std::fs::create_dir(folder.path("path")).unwrap();
    let names = [
        "000001-000",
        "000001-001",
        "000002-000",
        "000005-000",
        "000005-003",
    ];
    let files = names.map(|name| format!("path/{name}.ply"));
    for file in &files {
        folder.write(file, ply(&tip_above_square(1.0)));
    }
    for frames in [vec!["path"], files.iter().map(String::as_str).collect()] {
        let run = folder.run(&[vec!["audit"], frames].concat());
        assert_eq!(
            note(&run),
            "exact-ccd: warning: numbers are missing in the names of the frames: 3 to 4, in 5: 1 to 2; the frames \
             around a gap are one step"
        );
    }
}

#[test]
fn two_recordings_in_a_folder_are_worth_a_warning() {
    let folder = Folder::new();
    let mut files = Vec::new();
    for name in ["a_0", "a_1", "b_0", "b_1"] {
        files.push(format!("frames/{name}.ply"));
        std::fs::create_dir_all(folder.path("frames")).unwrap();
        folder.write(files.last().unwrap(), ply(&tip_above_square(1.0)));
    }
    let warning = "exact-ccd: warning: the names of the frames differ in more than numbers: frames/b_0.ply follows \
                   frames/a_1.ply, as if both were of one motion";
    let run = folder.run(&["audit", "frames"]);
    assert_eq!((run.status, note(&run)), (0, warning));
    let mut arguments = vec!["audit"];
    arguments.extend(files.iter().map(String::as_str));
    let run = folder.run(&arguments);
    assert_eq!(note(&run), format!("{warning}; --as-given omits this warning"));
    arguments.push("--as-given");
    assert_eq!(note(&folder.run(&arguments)), "");
}

#[test]
fn polygons_are_counted_or_refused() {
    let folder = Folder::new();
    let quad = |z: f64| format!("v 0 0 {z}\nv 1 0 {z}\nv 1 1 {z}\nv 0 1 {z}\nf 1 2 3 4\n");
    folder.write("start.obj", quad(0.0));
    folder.write("end.obj", quad(1.0));
    let run = folder.run(&["step", "start.obj", "end.obj"]);
    assert!(
        run.stdout.starts_with(
            "read: 4 vertices, 5 edges, 2 faces, 1 component; 1 polygon triangulated as a fan from its lowest vertex\n"
        ),
        "{run:?}"
    );
    for command in [&["step", "start.obj", "end.obj"][..], &["audit", "start.obj"]] {
        let run = folder.run(&[command, &["--triangles-only"]].concat());
        assert_eq!(
            run.error(),
            "start.obj: line 5: face 1 has 4 corners, but only triangles are allowed"
        );
    }
}

#[test]
fn files_larger_than_allowed_are_refused() {
    let folder = Folder::new();
    let text = |z: f64| format!("v 0 0 {z:?}\nv 1 0 {z:?}\nv 1 1 {z:?}\nf 1 2 3\n");
    folder.write("start.obj", text(0.0));
    folder.write("end.obj", text(1.0));
    let size = text(0.0).len();
    for command in [
        ["step", "start.obj", "end.obj"],
        ["audit", "start.obj", "end.obj"],
    ] {
        let run = |size: usize| folder.run(&[&command[..], &["--max-size", &size.to_string()]].concat());
        let allowed = run(size);
        assert_eq!(allowed.status, 0, "{allowed:?}");
        let (refused, limit) = (run(size - 1), size - 1);
        assert_eq!(
            refused.error(),
            format!("start.obj: more than {limit} bytes, the size that --max-size allows")
        );
    }
}

#[test]
fn points_alone_touch_where_they_coincide() {
    let folder = Folder::new();
    folder.write("start.obj", "v 0 0 0\nv 2 0 0\n");
    folder.write("swapped.obj", "v 2 0 0\nv 0 0 0\n");
    for command in ["step", "audit"] {
        let run = |end: &str, options: &[&str]| {
            let run = folder.run(&[&[command, "start.obj", end, "--json", "--points"], options].concat());
            (run.status, json_of(&run)["contact"].clone())
        };
        let (status, contact) = run("swapped.obj", &[]);
        assert_eq!(
            (status, &contact["kind"], &contact["ids"]),
            (1, &json!("vv"), &json!([0, 1]))
        );
        assert_eq!(contact["time"], json!({"lower": 0.5, "upper": 0.5}));
        assert_eq!(run("start.obj", &[]), (0, Value::Null));
        assert_eq!(run("start.obj", &["--min-distance", "2"]).0, 1);
    }
}

#[test]
fn a_file_of_two_frames_is_a_step() {
    let folder = Folder::new();
    for (name, height) in [("a.vtu", 1.0), ("b.vtu", -1.0), ("c.vtu", -2.0)] {
        let mut file = Vec::new();
        exact_ccd_files::write_vtu(&mut file, &tip_above_square(height)).unwrap();
        folder.write(name, file);
    }
    let collection = |files: &[&str]| {
        let mut collection = Vec::new();
        let entries: Vec<_> = (0..).map(f64::from).zip(files.iter().copied()).collect();
        exact_ccd_files::write_pvd(&mut collection, entries).unwrap();
        collection
    };
    folder.write("two.pvd", collection(&["a.vtu", "b.vtu"]));
    folder.write("three.pvd", collection(&["a.vtu", "b.vtu", "c.vtu"]));
    let run = folder.run(&["step", "two.pvd", "--json"]);
    assert_eq!((run.status, &json_of(&run)["toi"]), (1, &json!(0.5)));
    assert_eq!(
        folder.run(&["step", "a.vtu"]).error(),
        "a.vtu: 1 frame, expected 2; add the file of the end"
    );
    assert_eq!(
        folder.run(&["step", "three.pvd"]).error(),
        "three.pvd: 3 frames, expected 2; `exact-ccd audit` examines longer motions"
    );
}

/// Several series are one scene: a part of `--with` that moves collides with all others and with itself.
#[test]
fn several_series_are_parts_of_one_audit() {
    let folder = Folder::new();
    for name in ["cloth", "body"] {
        std::fs::create_dir(folder.path(name)).unwrap();
    }
    // The tiles meet at 0.75, a quarter of the way from frame 1 to frame 2.
    for (frame, [cloth, body]) in [[2.0, 0.0], [1.0, 0.5], [0.0, 1.5]].into_iter().enumerate() {
        folder.write(&format!("cloth/{frame}.obj"), tile(0.0, cloth));
        folder.write(&format!("body/{frame}.obj"), tile(0.25, body));
    }
    let scene = ["audit", "cloth", "--with", "body"];
    let report = json_of(&folder.run(&[&scene[..], &["--json"]].concat()));
    assert_eq!(report["contact"]["frame"], json!(1));
    assert_eq!(report["contact"]["time"], json!({"lower": 0.25, "upper": 0.25}));
    assert_eq!(report["parts"][1]["name"], json!("body"));
    assert_eq!(report["parts"][1]["is_obstacle"], json!(false));
    let run = folder.run(&[&scene[..], &["--ignore", "cloth:body"]].concat());
    assert_eq!(run.status, 0, "{run:?}");
    // A folder, or the first of several files, may have a name.
    for frames in [
        &["top=cloth"][..],
        &["top=cloth/0.obj", "cloth/1.obj", "cloth/2.obj"],
    ] {
        let run = folder.run(&[&["audit"], frames, &["--with", "body", "--ignore", "top:body"]].concat());
        assert_eq!(run.status, 0, "{run:?}");
    }

    std::fs::remove_file(folder.path("body/2.obj")).unwrap();
    assert_eq!(
        folder.run(&scene).error(),
        "body: 2 frames, expected 3 as of cloth, or 1 of a mesh at rest"
    );
}
