//! Meshes that pass through themselves, or are folded flat, at the start of a step.

use exact_ccd_mesh::{Bvh, Frame, IntersectionOptions, Meeting, intersections};
use serde_json::{Value, json};

use crate::folder::Folder;
use crate::meshes::{fall, ply};
use crate::step::answer;
use crate::view::data;

/// A box of twelve faces, and a rod of two faces that passes through two sides of it. Both move by `shift`.
fn rod_through_box(shift: f64) -> Frame {
    let corner =
        |index: u8| [0, 1, 2].map(|axis| f64::from(index >> axis & 1) + if axis == 0 { shift } else { 0.0 });
    let mut positions: Vec<_> = (0..8).map(corner).collect();
    let rod = [
        [-1.0, 0.375, 0.125],
        [2.0, 0.375, 0.125],
        [-1.0, 0.5, 0.125],
        [2.0, 0.5, 0.125],
    ];
    positions.extend(rod.map(|[x, y, z]| [x + shift, y, z]));
    let sides = [
        [0, 1, 3, 2],
        [4, 6, 7, 5],
        [0, 4, 5, 1],
        [2, 3, 7, 6],
        [0, 2, 6, 4],
        [1, 5, 7, 3],
    ];
    let mut faces: Vec<_> = sides
        .into_iter()
        .flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]])
        .collect();
    faces.extend([[8, 9, 10], [9, 11, 10]]);
    Frame::new(positions, faces).unwrap()
}

pub(crate) fn moving_rod_through_box() -> Folder {
    let folder = Folder::new();
    folder.write("start.ply", ply(&rod_through_box(0.0)));
    folder.write("end.ply", ply(&rod_through_box(1.0)));
    folder
}

fn crossing() -> IntersectionOptions {
    IntersectionOptions::default().with_meeting(Meeting::Crossing)
}

#[test]
fn a_rod_through_a_box_is_reported_with_its_first_edge_and_face() {
    let folder = moving_rod_through_box();
    let (mesh, found) = {
        let Frame { mesh, positions } = rod_through_box(0.0);
        let found = intersections(&mesh, &positions, &Bvh, &crossing()).unwrap();
        (mesh, found)
    };
    assert!(found.len() > 1);
    let (edge, face) = (found[0].edge, found[0].face);
    let ([a, b], [c, d, e]) = (mesh.edges()[edge as usize], mesh.faces()[face as usize]);
    let first = format!(
        "intersection at t = 0: edge {edge} (vertices {a}, {b}) and face {face} (vertices {c}, {d}, {e})\n"
    );
    let count = format!("pairs that intersect at t = 0: {}\n", found.len());
    for (options, rest) in [
        (
            &["--toi"][..],
            "no contact of a vertex and a face, or of two edges, in the step\n",
        ),
        (
            &["--any"],
            "no contact of a vertex and a face, or of two edges, in the step\n",
        ),
    ] {
        let run = folder.run(&[&["step", "start.ply", "end.ply"], options].concat());
        assert_eq!((run.status, answer(&run)), (1, format!("{first}{rest}{count}")));
    }
    let run = folder.run(&["step", "start.ply", "end.ply", "--json"]);
    let report: Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!((run.status, &report["collision_free"]), (1, &json!(false)));
    assert_eq!((&report["toi"], &report["contact"]), (&Value::Null, &Value::Null));
    assert_eq!(report["intersections"], found.len());
    let reported = &report["intersection"];
    assert_eq!(
        json!([reported["kind"], reported["ids"], reported["vertices"]]),
        json!(["ef", [edge, face], [[a, b], [c, d, e]]])
    );
}

#[test]
fn the_page_of_the_step_has_the_intersections() {
    let folder = moving_rod_through_box();
    folder.run(&["step", "start.ply", "end.ply", "--view", "page.html"]);
    let page = data(&folder, "page.html");
    let Frame { mesh, positions } = rod_through_box(0.0);
    let found = intersections(&mesh, &positions, &Bvh, &crossing()).unwrap();
    assert_eq!(page["contactCount"], found.len());
    let first = &page["contacts"][0];
    assert_eq!((&first["frame"], &first["time"]), (&json!(0), &json!(0.0)));
    let ids = [&first["primitives"][0]["id"], &first["primitives"][1]["id"]];
    assert_eq!(json!(ids), json!([found[0].edge, found[0].face]));
}

#[test]
fn the_check_can_be_left_out() {
    let folder = moving_rod_through_box();
    let run = folder.run(&["step", "start.ply", "end.ply", "--no-start-check", "--toi"]);
    assert_eq!((run.status, answer(&run).as_str()), (0, "free of contact\n"));
    let run = folder.run(&["step", "start.ply", "end.ply", "--no-start-check", "--json"]);
    let report: Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(
        (&report["intersections"], &report["collision_free"]),
        (&Value::Null, &json!(true))
    );
}

#[test]
fn a_closed_fold_and_faces_that_cross_at_a_common_vertex_are_found() {
    let folder = Folder::new();
    let write = |positions: [[f64; 3]; 5], faces: [[u32; 3]; 2]| {
        folder.write(
            "mesh.ply",
            ply(&Frame::new(positions.to_vec(), faces.to_vec()).unwrap()),
        );
        let step = folder.run(&["step", "mesh.ply", "mesh.ply"]);
        let audit = folder.run(&["audit", "mesh.ply"]);
        assert_eq!(step.status, audit.status, "{step:?} {audit:?}");
        (step.status, answer(&step))
    };
    let [p, q, far] = [[0.0; 3], [4.0, 0.0, 0.0], [9.0; 3]];
    // Two faces with the common edge p q: open by a little, closed, and flat but open.
    let fold = |b: [f64; 3]| write([p, q, [1.0, 2.0, 0.0], b, far], [[0, 1, 2], [1, 0, 3]]);
    assert_eq!(fold([2.0, 3.0, f64::MIN_POSITIVE]).0, 0);
    assert_eq!(fold([2.0, -3.0, 0.0]).0, 0);
    for b in [[2.0, 3.0, 0.0], [1.5, 1.0, 0.0], [3.0, 1.0, 0.0]] {
        let (status, text) = fold(b);
        assert_eq!(status, 1, "{b:?}");
        assert!(text.contains("contact at t = 0: "), "{text}");
    }
    // Two faces with the common vertex p: the second one beside the first, and through it.
    let cross = |y: f64| {
        let through = [[3.0, y, -1.0], [3.0, y, 1.0]];
        write(
            [p, q, [4.0, 4.0, 0.0], through[0], through[1]],
            [[0, 1, 2], [0, 3, 4]],
        )
    };
    assert_eq!(cross(-1.0).0, 0);
    let (status, text) = cross(1.0);
    assert_eq!(status, 1);
    assert!(text.starts_with("intersection at t = 0: "), "{text}");
}

#[test]
fn a_free_start_has_no_line() {
    let run = fall(1.0, 0.5).run(&["step", "start.ply", "end.ply", "--toi"]);
    assert_eq!(answer(&run), "free of contact\n");
}
