//! Lists of all contacts, in each format.

use std::fs::File;

use exact_ccd::CONTACT;
use exact_ccd_mesh::{Bvh, Detector, Frame, IntersectionOptions, Meeting, intersections};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::{Field, Row};
use serde_json::{Value, json};

use crate::folder::Folder;
use crate::meshes::{fall, ply, tip_above_square};
use crate::reports::json_of;
use crate::schema::Schema;

/// A row of a Parquet file.
pub(crate) fn row_of(row: &Row) -> Value {
    let value = |field: &Field| match field {
        Field::Null => Value::Null,
        Field::Long(value) => json!(value),
        Field::Double(value) => json!(value),
        Field::Str(value) => json!(value),
        other => json!(other.to_string()),
    };
    let columns = row.get_column_iter();
    columns
        .map(|(name, field)| (name.clone(), value(field)))
        .collect()
}

/// The lines of a list of contacts.
pub(crate) fn lines(folder: &Folder, name: &str) -> Vec<Value> {
    let text = folder.read(name);
    text.lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect()
}

#[test]
fn all_contacts_of_a_step_are_listed_in_every_format() {
    let folder = fall(1.0, -2.0);
    let [start, end] = [1.0, -2.0].map(tip_above_square);
    let mut detector = Detector::new(start.mesh.clone());
    let contacts = detector
        .collisions(&start.positions, &end.positions, CONTACT)
        .unwrap();
    assert!(contacts.len() > 1);
    let list = |name: &str| {
        let run = folder.run(&["step", "start.ply", "end.ply", "--json", "--all", name]);
        assert_eq!(run.status, 1, "{run:?}");
        json_of(&run)
    };
    let report = list("all.jsonl");
    let found = lines(&folder, "all.jsonl");
    let mut contact = report["contact"].clone();
    contact.as_object_mut().unwrap().remove("files").unwrap();
    assert_eq!(found[0], contact);
    assert_eq!(found.len(), contacts.len());
    let schema = Schema::of_reports();
    for (record, contact) in found.iter().zip(&contacts) {
        schema.assert("contact", record);
        assert_eq!(record["ids"], json!(contact.pair.ids()));
        assert_eq!(record["time"]["lower"], json!(contact.impact.time.lower()));
    }

    list("all.csv");
    let csv = folder.read("all.csv");
    let mut csv = csv.lines();
    assert_eq!(
        csv.next(),
        Some(
            "frame,kind,id_a,id_b,v0,v1,v2,v3,v4,time_lower,time_upper,x,y,z,nx,ny,nz,u,v,\
             distance_lower,distance_upper,part_a,part_id_a,part_b,part_id_b"
        )
    );
    assert_eq!(
        csv.next(),
        Some(
            "0,vf,4,1,4,2,1,3,,0.3333333333333333,0.33333333333333337,0.75,0.5,1.1102230246251565e-16,0,0,1,0.5,0.25,0,0,,,,"
        )
    );
    assert_eq!(csv.count() + 1, contacts.len());

    list("all.parquet");
    let file = SerializedFileReader::new(File::open(folder.path("all.parquet")).unwrap()).unwrap();
    let rows: Vec<_> = file
        .get_row_iter(None)
        .unwrap()
        .map(|row| row_of(&row.unwrap()))
        .collect();
    assert_eq!(rows.len(), contacts.len());
    for (row, record) in rows.iter().zip(&found) {
        assert_eq!(json!([row["id_a"], row["id_b"]]), record["ids"]);
        assert_eq!(row["kind"], record["kind"]);
        assert_eq!(row["time_lower"], record["time"]["lower"]);
        assert_eq!(json!([row["x"], row["y"], row["z"]]), record["point"]);
        assert_eq!(row["v4"], Value::Null);
    }
}

#[test]
fn a_list_has_the_intersections_at_the_start() {
    let folder = fall(-1.0, 1.0);
    let run = folder.run(&["step", "start.ply", "end.ply", "--all", "all.jsonl"]);
    assert_eq!(run.status, 1);
    let Frame { mesh, positions } = tip_above_square(-1.0);
    let crossing = IntersectionOptions::default().with_meeting(Meeting::Crossing);
    let expected = intersections(&mesh, &positions, &Bvh, &crossing).unwrap();
    let found = lines(&folder, "all.jsonl");
    let (at_rest, moving): (Vec<&Value>, Vec<_>) = found.iter().partition(|record| record["kind"] == "ef");
    let ids: Vec<_> = expected
        .iter()
        .map(|pair| json!([pair.edge, pair.face]))
        .collect();
    assert_eq!(
        at_rest
            .iter()
            .map(|record| record["ids"].clone())
            .collect::<Vec<_>>(),
        ids
    );
    // The tip comes back through the square.
    assert!(!moving.is_empty());
}

/// An edge rises through the end of another one: the parameter there is 0. A vertex rises to the point
/// (0, 0, 0) of a face.
#[test]
fn zeros_of_places_and_parameters_have_no_sign() {
    let folder = Folder::new();
    let mesh = |name: &str, rise: f64| {
        let rising = [[219.0, 60.0, 2.0], [221.0, 60.0, -1.0], [220.00001, 60.0, 0.0]];
        let mut positions: Vec<_> = rising.map(|[x, y, z]| [x, y, z + rise]).to_vec();
        positions.extend([[221.0, 60.1, 1e-5], [220.1, 60.0, 0.1], [220.00001, 59.3, 0.0]]);
        positions.extend([[-1.0, -1.0, 0.0], [1.0, -1.0, -0.0], [-0.0, 1.0, 0.0]]);
        positions.extend([[-0.0, -0.0, 4.0 * rise - 0.5], [0.0, 1.0, -9.0], [1.0, 1.0, -9.0]]);
        let faces = vec![[0, 1, 2], [3, 4, 5], [6, 7, 8], [9, 10, 11]];
        folder.write(name, ply(&Frame::new(positions, faces).unwrap()));
    };
    mesh("start.ply", 0.0);
    mesh("end.ply", 0.25);
    let run = folder.run(&["step", "start.ply", "end.ply", "--all", "all.jsonl"]);
    assert_eq!(run.status, 1);
    let found = lines(&folder, "all.jsonl");
    let mut zeros = 0;
    for record in &found {
        for name in ["point", "normal", "parameters"] {
            for number in record[name].as_array().into_iter().flatten() {
                let number = number.as_f64().unwrap();
                zeros += usize::from(number == 0.0);
                assert!(number != 0.0 || number.is_sign_positive(), "{name} of {record}");
            }
        }
    }
    assert!(zeros >= 4, "{found:?}");
    assert!(
        found.iter().any(|record| record["ids"] == json!([2, 5])),
        "{found:?}"
    );
}

/// The point on the segment from a to b at height 0.
fn at_height_0(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    let s = a[2] / (a[2] - b[2]);
    [0, 1, 2].map(|axis| a[axis] + s * (b[axis] - a[axis]))
}

#[test]
fn an_intersection_has_the_point_where_the_edge_meets_the_face() {
    let folder = fall(-0.5, 1.0);
    let Frame { mesh, positions } = tip_above_square(-0.5);
    folder.run(&["step", "start.ply", "end.ply", "--all", "all.jsonl"]);
    folder.run(&["step", "start.ply", "end.ply", "--all", "all.csv"]);
    folder.run(&["audit", "start.ply", "--all", "audit.jsonl"]);
    for list in ["all.jsonl", "audit.jsonl"] {
        let found = lines(&folder, list);
        let at_rest: Vec<_> = found.iter().filter(|record| record["kind"] == "ef").collect();
        assert!(!at_rest.is_empty());
        for record in at_rest {
            let edge = mesh.edges()[record["ids"][0].as_u64().unwrap() as usize];
            let [a, b] = edge.map(|vertex| positions[vertex as usize]);
            // All numbers are dyadic: the point is not rounded.
            assert_eq!(record["point"], json!(at_height_0(a, b)));
        }
    }
    let csv = folder.read("all.csv");
    let row: Vec<&str> = csv.lines().nth(1).unwrap().split(',').collect();
    assert_eq!((row[1], &row[11..14]), ("ef", &["0.8125", "0.5", "0"][..]));
    let text = folder.run(&["step", "start.ply", "end.ply"]).stdout;
    assert!(
        text.contains("\n  at (0.8125, 0.5, 0); ids count from 0\n"),
        "{text}"
    );
}

/// Faces in one plane touch in vertices and edges, and no edge passes through one: the point is on both, up
/// to rounding.
#[test]
fn faces_in_one_plane_have_common_points() {
    let triangle = |x: f64, y: f64| [[x, y, 0.0], [x + 4.0, y + 0.25, 0.0], [x + 0.5, y + 3.0, 0.0]];
    for (x, y) in [(0.5, 0.75), (-1.0, 0.3), (1.0, -2.0), (0.1, 0.1)] {
        let folder = Folder::new();
        let positions = [triangle(0.0, 0.0), triangle(x, y)].concat();
        let frame = Frame::new(positions.clone(), vec![[0, 1, 2], [3, 4, 5]]).unwrap();
        folder.write("flat.ply", ply(&frame));
        folder.run(&["audit", "flat.ply", "--all", "all.jsonl"]);
        let found = lines(&folder, "all.jsonl");
        assert!(found.len() >= 2, "{found:?}");
        assert!(found.iter().all(|record| record["kind"] != "ef"), "{found:?}");
        let of_faces = found.iter().filter(|record| record["kind"] == "vf");
        for record in of_faces {
            let point: [f64; 3] = serde_json::from_value(record["point"].clone()).unwrap();
            let vertices: [Vec<usize>; 2] = serde_json::from_value(record["vertices"].clone()).unwrap();
            let [vertex, face] =
                vertices.map(|ids| ids.into_iter().map(|id| positions[id]).collect::<Vec<_>>());
            // Twice the area of the triangle a b point.
            let area = |a: [f64; 3], b: [f64; 3]| {
                (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0])
            };
            assert_eq!(vertex, [point]);
            for side in 0..3 {
                assert!(area(face[side], face[(side + 1) % 3]) > -1e-12, "{record}");
            }
        }
    }
}

#[test]
fn an_audit_lists_every_bad_frame_and_pair() {
    let folder = Folder::new();
    let heights = [1.0, -1.0, 1.0, 2.0, -1.0];
    for (frame, height) in heights.into_iter().enumerate() {
        folder.write(&format!("{frame}.ply"), ply(&tip_above_square(height)));
    }
    let run = folder.run(&[
        "audit",
        "0.ply",
        "1.ply",
        "2.ply",
        "3.ply",
        "4.ply",
        "--json",
        "--all",
        "all.jsonl",
    ]);
    assert_eq!(run.status, 1);
    let report = json_of(&run);
    assert_eq!(
        (&report["examined"], &report["contact"]["frame"]),
        (&json!(5), &json!(0))
    );
    let found = lines(&folder, "all.jsonl");
    assert_eq!(report["violations"], json!({"count": found.len(), "frames": 4}));
    let frames = |kind: &str| {
        let of_kind = found
            .iter()
            .filter(|record| (record["kind"] == "ef") == (kind == "ef"));
        let mut frames: Vec<_> = of_kind.map(|record| record["frame"].as_u64().unwrap()).collect();
        frames.dedup();
        frames
    };
    // The tip is below the square in frames 1 and 4, and passes it in the steps around them.
    assert_eq!(frames("ef"), [1, 4]);
    assert_eq!(frames("contact"), [0, 1, 3]);
    let order = |record: &Value| {
        (
            record["frame"].as_u64().unwrap(),
            record["time"]["lower"].as_f64().unwrap(),
        )
    };
    assert!(found.is_sorted_by(|a, b| order(a) <= order(b)), "{found:?}");
    // Those of one step are those of `step`.
    folder.run(&["step", "3.ply", "4.ply", "--all", "step.jsonl"]);
    let mut of_step = lines(&folder, "step.jsonl");
    of_step.iter_mut().for_each(|record| record["frame"] = json!(3));
    let of_frame: Vec<_> = found
        .iter()
        .filter(|record| record["frame"] == 3)
        .cloned()
        .collect();
    assert_eq!(of_frame, of_step);

    let run = folder.run(&["audit", "0.ply", "--all", "all.jsonl"]);
    assert_eq!(
        (run.status, folder.read("all.jsonl").as_str()),
        (0, ""),
        "{run:?}"
    );
    folder.write("touching.ply", ply(&tip_above_square(0.0)));
    let run = folder.run(&["audit", "touching.ply", "--all", "all.jsonl"]);
    let kinds: Vec<_> = lines(&folder, "all.jsonl")
        .iter()
        .map(|record| record["kind"].clone())
        .collect();
    assert_eq!(run.status, 1);
    assert_eq!(kinds, [json!("vf")]);
}
