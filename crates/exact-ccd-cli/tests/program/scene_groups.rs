//! The groups of a file as parts of a scene.

use serde_json::{Value, json};

use crate::folder::Folder;
use crate::scenes::json_of;
use crate::schema::Schema;

/// Two tiles as the objects of one file, `ground` below and `roof` above it. They share no vertices.
fn house(height: f64) -> String {
    let corners = |z: f64| format!("v 0 0 {z}\nv 1 0 {z}\nv 0 1 {z}\n");
    format!(
        "o ground\n{}o roof\n{}g ground\nf 1 2 3\ng roof\nf 4 5 6\n",
        corners(0.0),
        corners(height)
    )
}

#[test]
fn groups_of_a_file_are_left_out_by_name() {
    let folder = Folder::new();
    folder.write("start.obj", house(1.0));
    folder.write("end.obj", house(-1.0));
    folder.write("roof.obj", house(3.0));
    let scene = ["step", "start.obj", "end.obj", "--json"];
    let run = |rules: &[&str]| folder.run(&[&scene[..], rules].concat());
    let report = json_of(&run(&[]));
    assert_eq!(report["toi"], json!(0.5));
    assert_eq!(
        report["groups"],
        json!([
            {"part": "start", "name": "ground", "vertex_count": 3},
            {"part": "start", "name": "roof", "vertex_count": 3},
        ])
    );
    Schema::of_reports().assert("motion", &report);
    let toi = |rules: &[&str]| json_of(&run(rules))["toi"].clone();
    assert_eq!(toi(&["--ignore", "roof:ground"]), Value::Null);
    assert_eq!(toi(&["--ignore", "start/roof:start/ground"]), Value::Null);
    assert_eq!(toi(&["--ignore", "roof:roof"]), json!(0.5));
    assert_eq!(toi(&["--only", "start:roof"]), json!(0.5));
    assert_eq!(toi(&["--only", "roof:roof"]), Value::Null);
    // Welding keeps the names.
    assert_eq!(toi(&["--weld", "--ignore", "roof:ground"]), Value::Null);
    assert_eq!(
        run(&["--ignore", "roof:attic"]).error(),
        "there is no part or group attic; there are start, ground, roof"
    );
    let text = folder.run(&["step", "start.obj", "end.obj"]);
    assert!(text.stdout.contains("\ngroups: ground, roof\n"), "{text:?}");

    // A part before a group of this name, and a group that two parts have.
    let with = |rules: &[&str]| run(&[&["--with", "roof.obj"], rules].concat());
    assert_eq!(
        json_of(&with(&["--only", "roof:start/ground"]))["toi"],
        json!(0.0)
    );
    assert_eq!(
        with(&["--only", "roof:ground"]).error(),
        "several parts have a group ground: its names are start/ground, roof/ground and so on"
    );
}

#[test]
fn groups_of_gmsh_have_the_names_of_physical_groups() {
    let folder = Folder::new();
    let house = |height: f64| {
        format!(
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 5 \"the ground\"\n2 6 \"roof\"\n\
             $EndPhysicalNames\n$Nodes\n6\n1 0 0 0\n2 4 0 0\n3 0 0 4\n4 1 {height} 1\n5 2 {height} 1\n\
             6 1 {height} 2\n$EndNodes\n$Elements\n2\n1 2 2 5 1 1 2 3\n2 2 2 6 1 4 5 6\n$EndElements\n"
        )
    };
    folder.write("start.msh", house(1.0));
    folder.write("end.msh", house(-1.0));
    let run = |rules: &[&str]| folder.run(&[&["step", "start.msh", "end.msh", "--json"], rules].concat());
    let toi = |rules: &[&str]| json_of(&run(rules))["toi"].clone();
    assert_eq!(toi(&[]), json!(0.5));
    assert_eq!(toi(&["--ignore", "roof:the ground"]), Value::Null);
    assert_eq!(toi(&["--only", "roof:start/the ground"]), json!(0.5));
    assert_eq!(
        run(&["--only", "roof:6"]).error(),
        "there is no part or group 6; there are start, the ground, roof"
    );
}

/// Groups with common vertices: primitives of both are in both.
#[test]
fn groups_may_share_vertices() {
    let folder = Folder::new();
    // Two triangles of one strip as groups, and a triangle that falls through the second one.
    let strip = |z: f64| {
        format!(
            "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 4 4 0\nv 3 3 {z}\nv 3.5 3 {}\nv 3 3.5 {}\n\
             g left\nf 1 2 3\ng right\nf 3 2 4\ng tip\nf 5 6 7\n",
            z + 1.0,
            z + 1.0
        )
    };
    folder.write("start.obj", strip(1.0));
    folder.write("end.obj", strip(-1.0));
    let toi = |rules: &[&str]| {
        let run = folder.run(&[&["step", "start.obj", "end.obj", "--json"], rules].concat());
        json_of(&run)["toi"].clone()
    };
    assert_eq!(toi(&["--ignore", "tip:left"]), json!(0.5));
    assert_eq!(toi(&["--ignore", "tip:right"]), Value::Null);
    assert_eq!(toi(&["--only", "tip:right"]), json!(0.5));
}
