//! Pages of queries.

use exact_ccd::{EdgeEdge, Kind, Query, Separation, VertexFace, VertexVertex};
use exact_ccd_view::Page;
use serde_json::json;

use crate::html::Html;

const FACE: [[f64; 3]; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

fn page<K: Kind>(title: &str, query: &Query<K>) -> Page {
    Page::of_query(title, query, Separation::new(0.0).unwrap())
}

fn falling(from: f64, to: f64) -> Query<VertexFace> {
    let at = |z| [[0.25, 0.25, z], FACE[0], FACE[1], FACE[2]];
    Query::new(at(from), at(to)).unwrap()
}

#[test]
fn a_vertex_that_falls_through_a_face() {
    let json = Html::of(&page("falling", &falling(1.0, -3.0))).json();
    let query = &json["query"];
    assert_eq!(query["kind"], "vertex-face");
    assert_eq!(query["times"], json!([[0.25, 0.25]]));
    let distances = query["distances"].as_array().unwrap();
    assert_eq!(
        (&distances[0], &distances[30], &distances[120]),
        (&json!(1.0), &json!(0.0), &json!(3.0))
    );
    assert_eq!(query["points"][1][0], json!([0.25, 0.25, -3.0]));
    assert_eq!(
        (json["faces"].as_u64(), json["edges"].as_u64()),
        (Some(1), Some(0))
    );
    assert_eq!(json["contacts"][0]["closest"][0], json!([0.25, 0.25, 0.0]));
    assert_eq!(json["verdict"], "contact at t = 0.25");
}

#[test]
fn a_vertex_that_stays_above() {
    let json = Html::of(&page("above", &falling(1.0, 2.0))).json();
    assert_eq!(
        (&json["contacts"], &json["query"]["times"]),
        (&json!([]), &json!([]))
    );
    let stage = json["query"]["stage"].as_str().unwrap();
    assert!(stage.starts_with("BoundingBox: "), "{stage}");
    assert_eq!(json["verdict"], "free of contact");
}

#[test]
fn a_vertex_that_rests() {
    let json = Html::of(&page("rest", &falling(0.0, 0.0))).json();
    assert_eq!(json["query"]["times"], json!([[0.0, 1.0]]));
    assert_eq!(json["verdict"], "contact at t = 0 to 1");
}

#[test]
fn two_edges() {
    let at = |z| [[-1.0, 0.0, z], [1.0, 0.0, z], [0.0, -1.0, 0.0], [0.0, 1.0, 0.0]];
    let query = Query::<EdgeEdge>::new(at(2.0), at(-2.0)).unwrap();
    let html = Html::of(&page("edges", &query));
    let json = html.json();
    assert_eq!(
        (json["faces"].as_u64(), json["edges"].as_u64()),
        (Some(0), Some(2))
    );
    assert_eq!(json["query"]["primitives"][1]["vertices"], json!([2, 3]));
    assert_eq!(json["query"]["times"], json!([[0.5, 0.5]]));
}

/// The answers of a query of any size are shown: nothing is left out, and no number is infinite.
#[test]
fn extreme_coordinates() {
    let far = 1.7e308;
    let at = |z: f64| {
        [
            [0.0, 5e-324, z],
            [-far, -far, 0.0],
            [far, -far, 0.0],
            [0.0, far, 0.0],
        ]
    };
    let query = Query::<VertexFace>::new(at(far), at(-far)).unwrap();
    let json = Html::of(&page("far", &query)).json();
    assert_eq!(json["query"]["times"], json!([[0.5, 0.5]]));
    assert_eq!(json["contacts"][0]["closest"][0], json!([0.0, 5e-324, 0.0]));
}

/// Within a distance, the contact has two points, and lasts.
#[test]
fn two_vertices_within_a_distance() {
    let at = |x: f64| [[x, 0.0, 0.0], [4.0, 3.0, 0.0]];
    let query = Query::<VertexVertex>::new(at(0.0), at(16.0)).unwrap();
    let page = Page::of_query("vertices", &query, Separation::new(5.0).unwrap());
    let json = Html::of(&page).json();
    assert_eq!(json["query"]["times"], json!([[0.0, 0.5]]));
    assert_eq!(json["query"]["distances"][30].as_f64(), Some(3.0));
    assert_eq!(
        json["contacts"][0]["closest"],
        json!([[0.0, 0.0, 0.0], [4.0, 3.0, 0.0]])
    );
    assert_eq!(json["contacts"][0]["primitives"][1]["vertices"], json!([2]));
    assert_eq!(json["verdict"], "within 5 at t = 0 to 0.5");
}
