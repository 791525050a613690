//! Ids in reports, lists and pages are the ids in the files.

use serde_json::{Value, json};

use crate::folder::{Folder, Run};

fn json_of(run: &Run) -> Value {
    serde_json::from_str(&run.stdout).unwrap()
}

/// Two faces with a seam between them, and a small one at this height. No two share a vertex.
fn seam(height: f64) -> String {
    format!(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n\
         v 0.25 0.25 {height}\nv 0.25 0.5 {top}\nv 0.5 0.25 {top}\nf 1 2 3\nf 4 5 6\nf 7 8 9\n",
        top = height + 5.0
    )
}

/// A cube below z = 1, a point that nothing has, a square and a triangle whose tip is above the cube, as VTK.
fn solids(height: f64) -> String {
    format!(
        "<VTKFile type='UnstructuredGrid' byte_order='LittleEndian'><UnstructuredGrid><Piece>\n<Points>\n\
         <DataArray type='Float64' format='ascii'>9 9 9 0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1\n\
         0.5 0.25 {height} 0.75 0.25 8 0.5 0.5 8 20 0 0 21 0 0 21 1 0 20 1 0</DataArray></Points>\n<Cells>\n\
         <DataArray type='Int64' Name='connectivity' format='ascii'>1 2 3 4 5 6 7 8 12 13 14 15 9 10 11</DataArray>\n\
         <DataArray type='Int64' Name='offsets' format='ascii'>8 12 15</DataArray>\n\
         <DataArray type='UInt8' Name='types' format='ascii'>12 9 5</DataArray></Cells></Piece>\n\
         </UnstructuredGrid></VTKFile>"
    )
}

#[test]
fn welded_vertices_have_their_least_id() {
    let folder = Folder::new();
    folder.write("start.obj", seam(1.0));
    folder.write("end.obj", seam(-1.0));
    let run = folder.run(&["step", "start.obj", "end.obj", "--json", "--weld"]);
    let contact = &json_of(&run)["contact"];
    assert_eq!(
        json!([contact["kind"], contact["ids"], contact["vertices"]]),
        json!(["vf", [6, 0], [[6], [0, 1, 2]]])
    );
    let run = folder.run(&["audit", "start.obj", "end.obj", "--weld"]);
    assert!(
        run.stdout
            .contains("at t = 0.5: vertex 6 and face 0 (vertices 0, 1, 2)"),
        "{run:?}"
    );
}

#[test]
fn vertices_around_solids_have_the_ids_of_the_file() {
    let folder = Folder::new();
    folder.write("start.vtu", solids(3.0));
    folder.write("end.vtu", solids(-1.0));
    let command = ["step", "start.vtu", "end.vtu"];
    // The tip is vertex 9, and the top of the cube has the vertices 5 to 8 and no id of its own.
    let vertices = [[9].as_slice(), &[5, 6, 7]];
    let run = folder.run(&[&command[..], &["--json"]].concat());
    let contact = &json_of(&run)["contact"];
    assert_eq!(
        json!([contact["ids"], contact["vertices"]]),
        json!([[9, null], vertices])
    );
    let run = folder.run(
        &[
            &command[..],
            &["--paraview", "out", "--all", "all.csv", "--view", "page.html"],
        ]
        .concat(),
    );
    assert!(
        run.stdout
            .contains("contact at t = 0.5: vertex 9 and face (vertices 5, 6, 7)\n"),
        "{run:?}"
    );
    let list = folder.read("all.csv");
    let first = list.lines().nth(1).unwrap();
    assert!(first.starts_with("0,vf,9,,9,5,6,7,,0.5,0.5,"), "{first}");
    // In the page, the primitives have their vertices in the mesh, without vertex 0, and their ids.
    let page = folder.read("page.html");
    let shown = "{\"kind\":\"face\",\"id\":null,\"vertices\":[4,5,6],\"labels\":[5,6,7]}";
    assert!(page.contains(shown));
    let impact = folder.read("out/impact.vtu");
    assert!(impact.contains(" Name=\"id\" "), "{impact}");
}

#[test]
fn vertices_of_a_scene_follow_those_of_the_files_before() {
    let folder = Folder::new();
    folder.write("start.vtu", solids(3.0));
    folder.write("end.vtu", solids(-1.0));
    // A tip that falls on the cube, in a file of its own.
    let tip = |height: f64| format!("v 0.5 0.75 {height}\nv 0.5 0.875 8\nv 0.25 0.875 8\nf 1 2 3\n");
    folder.write("tip.obj", tip(1.5));
    folder.write("tip-end.obj", tip(-6.0));
    let run = folder.run(&["step", "start.vtu", "end.vtu", "tip.obj", "tip-end.obj", "--json"]);
    let report = json_of(&run);
    assert_eq!(
        report["parts"],
        json!([
            {"name": "start", "first_vertex": 0, "vertex_count": 16, "is_obstacle": false},
            {"name": "tip", "first_vertex": 16, "vertex_count": 3, "is_obstacle": false},
        ])
    );
    assert_eq!(report["contact"]["vertices"][0], json!([16]));
}
