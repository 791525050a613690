//! Primitives that reach the distance d and do not come closer.

use exact_ccd::{EdgeEdge, Point, Query, VertexEdge, VertexVertex};

use super::{FACE, is_within, vertex_against};

#[test]
fn a_vertex_that_stops_at_the_distance_above_a_face() {
    let query = vertex_against(FACE, [0.25, 0.25, 2.0], [0.25, 0.25, 0.5]);
    is_within(&query, 0.5, &[[1.0, 1.0]]);
    is_within(&query, 0.5f64.next_down(), &[]);
}

#[test]
fn a_vertex_that_leaves_from_the_distance() {
    let query = vertex_against(FACE, [0.25, 0.25, 0.5], [0.25, 0.25, 2.0]);
    is_within(&query, 0.5, &[[0.0, 0.0]]);
}

#[test]
fn a_vertex_that_passes_a_corner_at_the_distance() {
    let query = vertex_against(FACE, [-1.0, -1.0, 3.0], [-1.0, 1.0, -3.0]);
    // At t = 1/2 it is at (−1, 0, 0).
    is_within(&query, 1.0, &[[0.5, 0.5]]);
    is_within(&query, 1.0f64.next_down(), &[]);
}

#[test]
fn a_vertex_that_passes_an_edge_at_the_distance() {
    let [a, b]: [Point; 2] = [[-4.0, 0.0, 0.0], [4.0, 0.0, 0.0]];
    let query = Query::<VertexEdge>::new([[0.0, 2.0, -3.0], a, b], [[1.0, 2.0, 3.0], a, b]).unwrap();
    is_within(&query, 2.0, &[[0.5, 0.5]]);
    is_within(&query, 2.0f64.next_down(), &[]);
}

#[test]
fn vertices_that_pass_at_the_distance() {
    let origin = [0.0; 3];
    let query = Query::<VertexVertex>::new([[-5.0, 3.0, 4.0], origin], [[5.0, 3.0, 4.0], origin]).unwrap();
    is_within(&query, 5.0, &[[0.5, 0.5]]);
    is_within(&query, 13.0, &[[0.0, 1.0]]);
    is_within(&query, 5.0f64.next_down(), &[]);
}

#[test]
fn edges_that_stop_at_the_distance() {
    let rest: [Point; 2] = [[0.0, -1.0, 0.0], [0.0, 1.0, 0.0]];
    let at = |z: f64| [[-1.0, 0.0, z], [1.0, 0.0, z], rest[0], rest[1]];
    let query = Query::<EdgeEdge>::new(at(4.0), at(1.0)).unwrap();
    is_within(&query, 1.0, &[[1.0, 1.0]]);
    is_within(&query, 2.5, &[[0.5, 1.0]]);
    is_within(&query, 1.0f64.next_down(), &[]);
}

/// At t = 1/2 it is upright, above the middle of the other edge.
#[test]
fn an_upright_edge_that_passes_over_another() {
    let rest: [Point; 2] = [[0.0, -8.0, 0.0], [0.0, 8.0, 0.0]];
    let at = |x: f64| [[x, 0.0, 1.0], [x, 0.0, 9.0], rest[0], rest[1]];
    let query = Query::<EdgeEdge>::new(at(-2.0), at(2.0)).unwrap();
    is_within(&query, 1.0, &[[0.5, 0.5]]);
}

/// A vertex that stops at the distance above a feature touches it, and so does one that starts there and
/// leaves.
#[test]
fn a_vertex_that_stops_at_the_distance_of_an_edge_or_a_vertex() {
    let [a, b]: [Point; 2] = [[-4.0, 0.0, 0.0], [4.0, 0.0, 0.0]];
    let [far, near] = [[1.0, 6.0, 8.0], [1.0, 3.0, 4.0]];
    let edge = |from, to| Query::<VertexEdge>::new([from, a, b], [to, a, b]).unwrap();
    is_within(&edge(far, near), 5.0, &[[1.0, 1.0]]);
    is_within(&edge(near, far), 5.0, &[[0.0, 0.0]]);
    is_within(&edge(far, near), 5.0f64.next_down(), &[]);
    let origin = [0.0; 3];
    let [far, near] = [[2.0, 4.0, 4.0], [1.0, 2.0, 2.0]];
    let vertex = |from, to| Query::<VertexVertex>::new([from, origin], [to, origin]).unwrap();
    is_within(&vertex(far, near), 3.0, &[[1.0, 1.0]]);
    is_within(&vertex(near, far), 3.0, &[[0.0, 0.0]]);
    is_within(&vertex(far, near), 3.0f64.next_down(), &[]);
}
