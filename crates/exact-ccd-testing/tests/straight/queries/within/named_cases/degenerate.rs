//! Faces without area, edges without length, motion at a constant distance.

use exact_ccd::{EdgeEdge, Point, Query, Separation, VertexEdge};

use super::{FACE, is_within, vertex_against};

#[test]
fn a_face_that_is_a_segment() {
    let face = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]];
    let query = vertex_against(face, [1.5, 0.0, 4.0], [1.5, 0.0, 0.0]);
    is_within(&query, 1.0, &[[0.75, 1.0]]);
    // Beyond its end, at (2, 0, 0): distance 5 from (5, 0, 4).
    let query = vertex_against(face, [5.0, 0.0, 4.0], [5.0, 0.0, 4.0]);
    is_within(&query, 5.0, &[[0.0, 1.0]]);
    is_within(&query, 5.0f64.next_down(), &[]);
}

#[test]
fn a_face_that_is_a_point() {
    let query = vertex_against([[0.0; 3]; 3], [3.0, 4.0, 0.0], [3.0, 4.0, 12.0]);
    is_within(&query, 5.0, &[[0.0, 0.0]]);
    is_within(&query, 13.0, &[[0.0, 1.0]]);
}

/// The face has area but for t = 1/2, when all its corners are on the x-axis.
#[test]
fn a_face_that_is_flat_for_a_moment() {
    let at = |s: f64| [[0.5, 0.0, 1.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.5, s, 0.0]];
    let query = Query::<exact_ccd::VertexFace>::new(at(-1.0), at(1.0)).unwrap();
    is_within(&query, 1.0, &[[0.0, 1.0]]);
    is_within(&query, 1.0f64.next_down(), &[]);
}

#[test]
fn parallel_edges_at_a_constant_distance() {
    let at = |x: f64| -> [Point; 4] {
        [
            [x, 0.0, 1.0],
            [x + 1.0, 0.0, 1.0],
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
        ]
    };
    // They overlap while |x| ≤ 1.
    let query = Query::<EdgeEdge>::new(at(-2.0), at(2.0)).unwrap();
    is_within(&query, 1.0, &[[0.25, 0.75]]);
    is_within(&query, 1.0f64.next_down(), &[]);
}

#[test]
fn a_vertex_that_slides_over_a_face_at_the_distance() {
    let query = vertex_against(FACE, [-1.0, 0.25, 1.0], [3.0, 0.25, 1.0]);
    // Above the face for 0 ≤ x ≤ 3/4.
    is_within(&query, 1.0, &[[0.25, 0.4375]]);
    is_within(&query, 1.0f64.next_down(), &[]);
}

#[test]
fn edges_without_length() {
    let at = |x: f64| [[x, 3.0, 4.0], [x, 3.0, 4.0], [0.0; 3], [0.0; 3]];
    let query = Query::<EdgeEdge>::new(at(-12.0), at(12.0)).unwrap();
    is_within(&query, 5.0, &[[0.5, 0.5]]);
    is_within(&query, 13.0, &[[0.0, 1.0]]);
}

/// The edge is a point at one end of the step.
#[test]
fn an_edge_along_an_axis_that_grows_from_a_point() {
    let (p, a, b) = ([0.0, 0.0, 10.0], [0.0; 3], [1.0, 0.0, 0.0]);
    for [start, end] in [[a, b], [b, a]] {
        let query = Query::<VertexEdge>::new([p, a, start], [p, a, end]).unwrap();
        is_within(&query, 1.0, &[]);
    }
}

/// A vertex beside an edge on a diagonal, by about 0.73 · 2⁻⁵⁵: of the differences of coordinates, one is
/// rounded up and the other one down, so that the vertex seems to be 2⁻⁵³ / √2 away.
#[test]
fn a_vertex_beside_a_diagonal_edge_is_as_near_as_it_is() {
    let power = |exponent: i32| 2.0_f64.powi(exponent);
    for scale in [0, -10, -40, 30].map(power) {
        for (axes, sign) in [[0, 1], [1, 2], [2, 0]]
            .into_iter()
            .flat_map(|axes| [(axes, 1.0), (axes, -1.0)])
        {
            let place = |x: f64, y: f64| {
                let mut point = [0.0; 3];
                (point[axes[0]], point[axes[1]]) = (scale * x, scale * sign * y);
                point
            };
            let vertex = place(-power(-55), -power(-54) - power(-60));
            let points = [vertex, place(-1.0, -1.0), place(0.5, 0.5)];
            let query = Query::<VertexEdge>::new(points, points).unwrap();
            let within = |d: f64| query.collides(Separation::new(scale * d * power(-55)).unwrap());
            assert!(within(0.75) && !within(0.7), "{scale} {axes:?} {sign}");
        }
    }
}
