//! The closest points at the first time within a distance.

use exact_ccd::{EdgeEdge, Impact, Kind, Point, Query, VertexEdge, VertexVertex};

use super::{FACE, vertex_against, within};

#[track_caller]
fn comes_near<K: Kind>(query: &Query<K>, d: f64, time: f64, parameters: [f64; 2], normal: Option<Point>) {
    let Impact {
        time: first,
        parameters: found,
        normal: direction,
        ..
    } = query.impact(within(d)).unwrap();
    assert_eq!((first.lower(), first.is_exact()), (time, true));
    assert_eq!((found, direction), (parameters, normal));
}

#[test]
fn above_a_face_its_normal() {
    let query = vertex_against(FACE, [0.25, 0.5, 3.0], [0.25, 0.5, -1.0]);
    comes_near(&query, 1.0, 0.5, [0.25, 0.5], Some([0.0, 0.0, 1.0]));
    let query = vertex_against(FACE, [0.25, 0.5, -3.0], [0.25, 0.5, 1.0]);
    comes_near(&query, 1.0, 0.5, [0.25, 0.5], Some([0.0, 0.0, -1.0]));
}

#[test]
fn beside_a_face_across_its_edge() {
    let query = vertex_against(FACE, [0.5, -3.0, 0.0], [0.5, 1.0, 0.0]);
    comes_near(&query, 1.0, 0.5, [0.5, 0.0], Some([0.0, -1.0, 0.0]));
}

#[test]
fn near_a_corner_from_there() {
    let query = vertex_against(FACE, [5.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    comes_near(&query, 2.0, 0.5, [1.0, 0.0], Some([1.0, 0.0, 0.0]));
}

#[test]
fn between_crossing_edges_their_common_normal() {
    let at = |z: f64| [[-1.0, 0.0, z], [3.0, 0.0, z], [0.0, -1.0, 0.0], [0.0, 1.0, 0.0]];
    let query = Query::<EdgeEdge>::new(at(3.0), at(-1.0)).unwrap();
    comes_near(&query, 1.0, 0.5, [0.25, 0.5], Some([0.0, 0.0, 1.0]));
}

#[test]
fn from_an_edge_to_a_vertex() {
    let (a, b) = ([0.0, 0.0, 0.0], [4.0, 0.0, 0.0]);
    let query = Query::<VertexEdge>::new([[1.0, 5.0, 0.0], a, b], [[1.0, 1.0, 0.0], a, b]).unwrap();
    comes_near(&query, 3.0, 0.5, [0.0, 0.25], Some([0.0, 1.0, 0.0]));
}

#[test]
fn from_a_vertex_to_a_vertex() {
    let query = Query::<VertexVertex>::new([[0.0, 0.0, 6.0], [0.0; 3]], [[0.0, 0.0, 2.0], [0.0; 3]]).unwrap();
    comes_near(&query, 4.0, 0.5, [0.0, 0.0], Some([0.0, 0.0, 1.0]));
}

#[test]
fn within_the_distance_from_the_start_it_is_that_of_the_start() {
    let query = vertex_against(FACE, [0.25, 0.5, 0.5], [0.25, 0.5, -1.0]);
    comes_near(&query, 1.0, 0.0, [0.25, 0.5], Some([0.0, 0.0, 1.0]));
}

#[test]
fn a_contact_at_the_start_has_no_direction() {
    let query = vertex_against(FACE, [0.25, 0.5, 0.0], [0.25, 0.5, -1.0]);
    comes_near(&query, 1.0, 0.0, [0.25, 0.5], None);
}

#[test]
fn no_impact_out_of_reach() {
    let query = vertex_against(FACE, [0.25, 0.5, 3.0], [0.25, 0.5, 2.0]);
    assert_eq!(query.impact(within(1.0)), None);
}
