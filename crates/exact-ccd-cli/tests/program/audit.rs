//! Reports of `exact-ccd audit`.

use exact_ccd_mesh::Frame;
use serde_json::{Value, json};

use crate::folder::{Folder, Run};
use crate::meshes::{off, ply, stl, tip_above_square};
use crate::step::answer;

/// A folder with `0.ply`, `1.ply` and so on, the tip at these heights.
fn heights(heights: &[f64]) -> Folder {
    let folder = Folder::new();
    for (frame, &height) in heights.iter().enumerate() {
        folder.write(&format!("{frame}.ply"), ply(&tip_above_square(height)));
    }
    folder
}

#[track_caller]
fn assert_report(run: &Run, status: i32, report: &str) {
    assert_eq!(answer(run), report);
    assert_eq!(run.status, status);
}

const CONTACT: &str = "at t = 0.3333333333333333: vertex 4 and face 1 (vertices 2, 1, 3)";

#[test]
fn a_free_sequence_has_status_0() {
    let folder = heights(&[1.0, 3.0, 0.5, 0.25]);
    let run = folder.run(&["audit", "0.ply", "1.ply", "2.ply", "3.ply"]);
    assert_report(&run, 0, "free of contact\nframes: 4 of 4 examined\n");
}

#[test]
fn the_first_contact_is_named_with_its_frames() {
    let folder = heights(&[3.0, 1.0, -2.0, 5.0]);
    let run = folder.run(&["audit", "0.ply", "1.ply", "2.ply", "3.ply"]);
    let report =
        format!("contact between frame 1 (1.ply) and frame 2 (2.ply) {CONTACT}\nframes: 3 of 4 examined\n");
    assert_report(&run, 1, &report);
}

#[test]
fn an_edge_that_pierces_a_face_in_the_first_frame_is_named() {
    let folder = heights(&[-1.0, 3.0]);
    // The tip is below the square, the other two vertices above. The first of its sides is edge 5.
    let frame = tip_above_square(-1.0);
    assert_eq!(frame.mesh.edges()[5], [4, 5]);
    let run = folder.run(&["audit", "0.ply", "1.ply"]);
    let report = "intersection in frame 0 (0.ply): edge 5 (vertices 4, 5) and face 1 (vertices 2, 1, 3)\n\
                  frames: 1 of 2 examined\n";
    assert_report(&run, 1, report);
}

#[test]
fn a_single_frame_is_examined_at_rest() {
    let folder = heights(&[1.0, 0.0]);
    assert_report(
        &folder.run(&["audit", "0.ply"]),
        0,
        "free of contact at rest: one frame has no motion\nframes: 1 of 1 examined\n",
    );
    let run = folder.run(&["audit", "1.ply"]);
    // The tip touches the face, and no edge passes through it.
    let report = "contact in frame 0 (1.ply): vertex 4 and face 1 (vertices 2, 1, 3)\n\
                  frames: 1 of 1 examined\n";
    assert_report(&run, 1, report);
}

#[test]
fn a_folder_is_taken_in_the_order_of_its_numbers() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("frames")).unwrap();
    for frame in 0..12 {
        let contents = ply(&tip_above_square(f64::from(10 - frame)));
        folder.write(&format!("frames/f{frame}.ply"), contents);
    }
    folder.write("frames/notes.txt", "not a mesh");
    let run = folder.run(&["audit", "frames"]);
    // The tip reaches the square in frame 10.
    let report = "contact between frame 9 (frames/f9.ply) and frame 10 (frames/f10.ply) at t = 1: \
                  vertex 4 and face 1 (vertices 2, 1, 3)\nframes: 11 of 12 examined\n";
    assert_report(&run, 1, report);
}

#[test]
fn decimals_in_names_are_in_order_or_refused() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("even")).unwrap();
    std::fs::create_dir(folder.path("odd")).unwrap();
    for (name, height) in [("0.50", 1.0), ("1.00", -2.0), ("0.25", 3.0)] {
        folder.write(&format!("even/t{name}.ply"), ply(&tip_above_square(height)));
    }
    for (name, height) in [("0.5", 1.0), ("0.25", 3.0), ("0.75", -2.0)] {
        folder.write(&format!("odd/t{name}.ply"), ply(&tip_above_square(height)));
    }
    let report = |run: &Run, files: [&str; 2]| {
        let [before, after] = files;
        let report = format!(
            "contact between frame 1 ({before}) and frame 2 ({after}) {CONTACT}\nframes: 3 of 3 examined\n"
        );
        assert_eq!(run.stderr, "");
        assert_report(run, 1, &report);
    };
    report(
        &folder.run(&["audit", "even"]),
        ["even/t0.50.ply", "even/t1.00.ply"],
    );
    let error = "the order of odd/t0.25.ply and odd/t0.5.ply is not certain: the point in their numbers may be \
                 that of a decimal, or between two numbers; give the files in order with --as-given, or give \
                 all numbers the same number of digits";
    assert_eq!(folder.run(&["audit", "odd"]).error(), error);
    let files = ["odd/t0.25.ply", "odd/t0.5.ply", "odd/t0.75.ply"];
    assert_eq!(folder.run(&[&["audit"], &files[..]].concat()).error(), error);
    let run = folder.run(&[&["audit", "--as-given"], &files[..]].concat());
    report(&run, ["odd/t0.5.ply", "odd/t0.75.ply"]);
    assert_eq!(
        folder.run(&["audit", "odd", "--as-given"]).error(),
        "odd: --as-given needs files: those of a folder are not given in an order"
    );
}

#[test]
fn json_names_the_violation() {
    let folder = heights(&[3.0, 1.0, -2.0, -1.0]);
    let report = |arguments: &[&str]| -> (i32, Value) {
        let run = folder.run(&[&["audit", "--json"], arguments].concat());
        assert_eq!((run.stderr.as_str(), run.stdout.lines().count()), ("", 1));
        let mut report: Value = serde_json::from_str(&run.stdout).unwrap();
        let seconds = report.as_object_mut().unwrap().remove("seconds").unwrap();
        let read = report.as_object_mut().unwrap().remove("read").unwrap();
        assert_eq!((&read["vertices"], &read["faces"]), (&json!(7), &json!(3)));
        for name in ["read", "examine", "total"] {
            assert!(seconds[name].as_f64().is_some_and(|value| value >= 0.0), "{name}");
        }
        (run.status, report)
    };
    let free = json!({"version": 1, "command": "audit", "min_distance": 0.0, "collision_free": true, "frames": 2, "examined": 2,
        "intersection": null, "contact": null, "toi": null});
    assert_eq!(report(&["0.ply", "1.ply"]), (0, free));
    let zero = json!({"lower": 0.0, "upper": 0.0});
    let contact = json!({"version": 1, "command": "audit", "min_distance": 0.0, "collision_free": false, "frames": 3,
        "examined": 3, "intersection": null, "toi": 0.3333333333333333, "contact": {
            "frame": 1, "files": ["1.ply", "2.ply"], "kind": "vf", "ids": [4, 1], "vertices": [[4], [2, 1, 3]],
            "time": {"lower": 0.3333333333333333, "upper": 0.33333333333333337},
            "point": [0.75, 0.5, 1.1102230246251565e-16], "normal": [0.0, 0.0, 1.0], "parameters": [0.5, 0.25],
            "distance": zero,
    }});
    assert_eq!(report(&["0.ply", "1.ply", "2.ply"]), (1, contact));
    let intersection = json!({"version": 1, "command": "audit", "min_distance": 0.0, "collision_free": false,
        "frames": 1, "examined": 1, "contact": null, "toi": null, "intersection": {
            "frame": 0, "files": ["3.ply"], "kind": "ef", "ids": [5, 1], "vertices": [[4, 5], [2, 1, 3]], "time": zero,
            "point": [0.75 + 0.25 / 2.0, 0.5, 0.0], "normal": null, "parameters": null, "distance": zero,
    }});
    assert_eq!(report(&["3.ply"]), (1, intersection));
}

#[test]
fn the_seconds_have_the_writing_of_files() {
    let folder = heights(&[3.0, 1.0, -2.0]);
    for (options, phases) in [
        (&[][..], &["examine", "read"][..]),
        (&["--all", "all.csv"], &["examine", "read", "write"]),
        (&["--paraview", "out"], &["examine", "read", "write"]),
        (&["--view", "page.html"], &["examine", "read", "write"]),
    ] {
        let run = folder.run(&[&["audit", "--json", "0.ply", "1.ply", "2.ply"], options].concat());
        let report: Value = serde_json::from_str(&run.stdout).unwrap();
        let mut seconds = report["seconds"].as_object().unwrap().clone();
        let total = seconds.remove("total").unwrap().as_f64().unwrap();
        let sum: f64 = seconds.values().map(|value| value.as_f64().unwrap()).sum();
        assert!((total - sum).abs() < 1e-9, "{run:?}");
        assert_eq!(seconds.keys().collect::<Vec<_>>(), phases, "{options:?}");
    }
}

#[test]
fn stl_files_are_welded_over_all_frames() {
    let folder = Folder::new();
    for (frame, height) in [3.0, 1.0, -2.0].into_iter().enumerate() {
        folder.write(&format!("{frame}.stl"), stl(&tip_above_square(height)));
    }
    let run = folder.run(&["audit", "0.stl", "1.stl", "2.stl"]);
    // The ids are those in the file, three for each facet.
    let report = "contact between frame 1 (1.stl) and frame 2 (2.stl) at t = 0.3333333333333333: \
                  vertex 6 and face 1 (vertices 2, 1, 5)\nframes: 3 of 3 examined\n";
    assert_report(&run, 1, report);
    let run = folder.run(&["audit", "0.stl", "1.stl"]);
    assert_report(&run, 0, "free of contact\nframes: 2 of 2 examined\n");
}

#[test]
fn formats_may_be_mixed_if_named_one_by_one() {
    let folder = heights(&[3.0]);
    folder.write("1.off", off(&tip_above_square(1.0)));
    let run = folder.run(&["audit", "0.ply", "1.off"]);
    assert_report(&run, 0, "free of contact\nframes: 2 of 2 examined\n");
    let error = folder.run(&["audit", "."]);
    assert_eq!(
        error.error(),
        ".: meshes of several formats, PLY (./0.ply) and OFF (./1.off), expected one: name the files of one of them in \
         place of the folder"
    );
}

/// Two tetrahedra, one above the other, as a Gmsh file.
fn tetrahedra(height: f64) -> String {
    let above = format!(
        "0.5 0.5 {height}\n1 0.5 {0}\n0.5 1 {0}\n0.5 0.5 {0}\n",
        height + 1.0
    );
    format!(
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 9 1 9\n3 1 0 9\n1\n2\n3\n4\n5\n6\n7\n8\n9\n\
         0 0 -1\n4 0 -1\n0 4 -1\n1 1 0\n{above}0.5 0.5 0.75\n$EndNodes\n\
         $Elements\n1 2 1 2\n3 1 4 2\n1 1 2 3 4\n2 5 6 7 8\n$EndElements\n"
    )
}

#[test]
fn of_tetrahedra_only_the_surface_is_examined() {
    let folder = Folder::new();
    // The last node belongs to no tetrahedron, and the second one passes over it.
    for (name, height) in [("0.msh", 1.0), ("1.msh", 0.5), ("2.msh", -3.0)] {
        folder.write(name, tetrahedra(height));
    }
    let run = folder.run(&["audit", "0.msh", "1.msh"]);
    assert_report(&run, 0, "free of contact\nframes: 2 of 2 examined\n");
    assert_eq!(folder.run(&["audit", "0.msh", "1.msh", "2.msh"]).status, 1);
}

#[test]
fn errors_name_the_file() {
    let folder = heights(&[3.0, 1.0]);
    let Frame { mesh, positions } = tip_above_square(0.5);
    let fewer = Frame::new(positions, mesh.faces()[..2].to_vec()).unwrap();
    folder.write("2.ply", ply(&fewer));
    let run = folder.run(&["audit", "0.ply", "1.ply", "2.ply"]);
    assert_eq!(run.stdout, "");
    assert_eq!(
        run.error(),
        "1.ply and 2.ply: 3 faces at the start, 2 at the end, expected the same mesh"
    );
    folder.write("0.stl", stl(&tip_above_square(0.5)));
    folder.write("2.stl", stl(&fewer));
    assert_eq!(
        folder.run(&["audit", "0.stl", "2.stl"]).error(),
        "0.stl and 2.stl: 9 vertices at the start, 6 at the end, expected the same mesh"
    );
    folder.write("3.ply", "ply\n");
    let run = folder.run(&["audit", "0.ply", "3.ply"]);
    assert!(run.error().starts_with("3.ply: line 2: "), "{run:?}");
    let run = folder.run(&["audit", "missing.ply"]);
    assert!(run.error().starts_with("missing.ply: "), "{run:?}");
    std::fs::create_dir(folder.path("empty")).unwrap();
    let error = folder.run(&["audit", "empty"]);
    assert_eq!(
        error.error(),
        "empty: no mesh file in the folder, expected .ply, .obj, .stl, .off, .msh, .vtu, .vtp, .vtk, .glb, .gltf, \
         .npy or .npz"
    );
}

#[test]
fn a_collection_is_taken_in_the_order_of_its_times() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("frames")).unwrap();
    let files = [("b.vtu", 3.0), ("a.vtu", 1.0), ("c.vtu", -2.0)];
    let list = |name: &str, times: [f64; 3]| {
        let mut collection = Vec::new();
        let entries = times.into_iter().zip(files.map(|(name, _)| name));
        exact_ccd_files::write_pvd(&mut collection, entries).unwrap();
        folder.write(name, collection);
    };
    for (name, height) in files {
        let mut file = Vec::new();
        exact_ccd_files::write_vtu(&mut file, &tip_above_square(height)).unwrap();
        folder.write(&format!("frames/{name}"), file);
    }
    list("frames/all.pvd", [-1.0, 0.25, 0.5]);
    let run = folder.run(&["audit", "frames/all.pvd"]);
    let report = format!(
        "contact between frame 1 (frames/a.vtu) and frame 2 (frames/c.vtu) {CONTACT}\n\
         frames: 3 of 3 examined, from time -1 to 0.5\n"
    );
    assert_report(&run, 1, &report);

    // Files of one time are parts of a frame, and not frames after each other.
    list("frames/parts.pvd", [0.0, 1.0, 1.0]);
    let error = folder.run(&["audit", "frames/parts.pvd"]).error().to_owned();
    assert!(
        error.starts_with("frames/parts.pvd: expected one file for each time (make one file of the parts"),
        "{error}"
    );
    assert!(
        error.ends_with("found `a.vtu` and `c.vtu` at the time 1"),
        "{error}"
    );
    list("frames/back.pvd", [2.0, 1.0, 3.0]);
    let error = folder.run(&["audit", "frames/back.pvd"]).error().to_owned();
    assert!(
        error.ends_with("found `a.vtu` at the time 1 after `b.vtu` at 2"),
        "{error}"
    );

    let mut nothing = Vec::new();
    exact_ccd_files::write_pvd(&mut nothing, [(0.0, ""); 0]).unwrap();
    folder.write("nothing.pvd", nothing);
    assert!(
        folder
            .run(&["audit", "nothing.pvd"])
            .error()
            .starts_with("nothing.pvd: no frame, expected at least one")
    );
    folder.write("broken.pvd", "<VTKFile/>");
    let run = folder.run(&["audit", "broken.pvd"]);
    assert_eq!(
        run.error(),
        "broken.pvd: line 1: expected an attribute `type`, found none"
    );
}

/// A vertex in a half space is a violation at rest, in the frame that ends the step of the contact. The
/// decision is exact: the boundary touches, and the next f64 above it does not.
#[test]
fn half_spaces_are_not_entered() {
    let folder = heights(&[1.0, 0.5, 0.25]);
    let files = ["audit", "0.ply", "1.ply", "2.ply"];
    let at = |height: f64, options: &[&str]| {
        let half_space = format!("0,0,{height:?},0,0,3");
        let moving = [
            "--with",
            "floor=0.ply",
            "--ignore",
            "0:floor",
            "--half-space",
            &half_space,
        ];
        folder.run(&[&files[..], &moving, options].concat())
    };
    // The square is at 0 in all frames, the other corners of the tip are above it.
    let square = at(0.0, &[]);
    assert_eq!(square.status, 1);
    assert!(
        square.stdout.contains(
            "\ncontact in frame 0 (0.ply): 0: vertex 0 and half space 0\n  at (0, 0, 0), normal (0, 0, 1);"
        ),
        "{square:?}"
    );
    assert_eq!(at(-5e-324, &[]).status, 0);
    let within = |d: &str| at(-0.125, &["--min-distance", d]).status;
    assert_eq!([within("0.125"), within("0.12499999999999999")], [1, 0]);

    // In a frame of its own, the tip alone.
    let tip = |height: f64| {
        let positions = vec![[0.25, 0.25, height], [1.0, 0.0, 4.0], [0.0, 1.0, 4.0]];
        ply(&Frame::new(positions, vec![[0, 1, 2]]).unwrap())
    };
    for (frame, height) in [1.0, 0.5, 0.25, 0.75].into_iter().enumerate() {
        folder.write(&format!("tip{frame}.ply"), tip(height));
    }
    let run = |height: &str, options: &[&str]| {
        let half_space = format!("9 9 {height} 0 0 1");
        let files = [
            "audit",
            "tip0.ply",
            "tip1.ply",
            "tip2.ply",
            "tip3.ply",
            "--half-space",
            &half_space,
        ];
        folder.run(&[&files[..], options].concat())
    };
    let first = |height: &str| {
        let run = run(height, &["--json", "--paraview", "out"]);
        let report: Value = serde_json::from_str(&run.stdout).unwrap();
        report["contact"].clone()
    };
    assert_eq!(first("0.24999999999999997"), Value::Null);
    assert_eq!(
        first("0.25"),
        json!({
            "frame": 2, "files": ["tip2.ply"], "kind": "vh", "ids": [0, 0], "vertices": [[0], []], "time": {"lower": 0.0, "upper": 0.0},
            "point": [0.25, 0.25, 0.25], "normal": [0.0, 0.0, 1.0], "parameters": null,
            "distance": {"lower": 0.0, "upper": 0.0},
        })
    );
    let impact = exact_ccd_files::read_frame(folder.path("out/impact.vtu")).unwrap();
    assert_eq!(impact.positions[0], [0.25, 0.25, 0.25]);
    let all = run("0.6", &["--all", "all.csv"]);
    assert!(
        all.stdout.contains("violations: 2, in 2 of the frames"),
        "{all:?}"
    );
    let rows = folder.read("all.csv");
    let frames: Vec<&str> = rows.lines().skip(1).filter_map(|row| row.get(..7)).collect();
    assert_eq!(frames, ["1,vh,0,", "2,vh,0,"]);

    for bad in [
        "0,0,0",
        "0,0,0,0,0,0",
        "0,0,0,0,0,NaN",
        "0,0,inf,0,0,1",
        "a,0,0,0,0,1",
        "",
    ] {
        let run = folder.run(&["audit", "0.ply", "--half-space", bad]);
        assert_eq!(run.status, 2, "{bad}");
        assert!(run.stderr.contains("expected"), "{run:?}");
    }
}
