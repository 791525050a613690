//! The answers do not depend on the order of points, axes, units, the direction of time, or the
//! frame of reference.

use exact_ccd::{EdgeEdge, Point, Query, VertexFace};
use proptest::array::{uniform2, uniform3};
use proptest::prelude::*;

use crate::generators::*;
use crate::laws::{assert_reversible, assert_same_times, assert_symmetric, query};
use crate::primitives::{Points, Primitives, combine};
use crate::runner::for_all;
use crate::symmetry::Symmetry;

fn symmetry() -> impl Strategy<Value = Symmetry> {
    (
        0..8usize,
        Just([0, 1, 2]).prop_shuffle(),
        uniform3(any::<bool>()),
        uniform3(prop_oneof![Just(0), -3..=3, -1000..=1000]),
    )
        .prop_map(|(renaming, axes, mirrored, exponents)| Symmetry {
            renaming,
            axes,
            mirrored,
            exponents,
        })
}

fn names_axes_and_units<K: Primitives>() {
    for_all(10_000, (mixed::<K>(), symmetry()), |(points, symmetry)| {
        assert_symmetric::<K>(&points, &symmetry);
    });
}

#[test]
fn names_axes_and_units_do_not_matter_to_a_vertex_and_a_face() {
    names_axes_and_units::<VertexFace>();
}

#[test]
fn names_axes_and_units_do_not_matter_to_edges() {
    names_axes_and_units::<EdgeEdge>();
}

#[test]
fn time_can_run_backwards() {
    for_all(6_000, mixed::<VertexFace>(), |points| {
        assert_reversible::<VertexFace>(&points);
    });
    for_all(6_000, mixed::<EdgeEdge>(), |points| {
        assert_reversible::<EdgeEdge>(&points);
    });
}

/// A frame of reference: axes that are not orthogonal, and an origin that moves.
type Frame = ([Point; 3], [Point; 2]);

fn frame() -> impl Strategy<Value = Frame> {
    let integer = |radius: i64| (-radius..=radius).prop_map(|n| n as f64);
    let axes = uniform3(uniform3(integer(3))).prop_filter("independent axes", |[a, b, c]| {
        let cross = |i: usize, j: usize| a[i] * b[j] - a[j] * b[i];
        cross(1, 2) * c[0] + cross(2, 0) * c[1] + cross(0, 1) * c[2] != 0.0
    });
    let origin = prop_oneof![integer(8).boxed(), integer(1 << 40).boxed()];
    (axes, uniform2(uniform3(origin)))
}

/// Exact on small integers.
fn seen_from((axes, origins): Frame, points: &Points) -> Points {
    [0, 1].map(|time: usize| {
        points[time].map(|[x, y, z]| combine([x, y, z, 1.0], [axes[0], axes[1], axes[2], origins[time]]))
    })
}

fn frames_of_reference<K: Primitives>() {
    let points = prop_oneof![small_integers(2), degenerate(small_integers(2))];
    for_all(6_000, (points, frame()), |(points, frame)| {
        assert_same_times(&query::<K>(&points), &query::<K>(&seen_from(frame, &points)));
    });
}

#[test]
fn the_frame_of_reference_does_not_matter() {
    frames_of_reference::<VertexFace>();
    frames_of_reference::<EdgeEdge>();
}

/// A face with two coincident corners is an edge, and a vertex is an edge without length.
#[test]
fn a_collapsed_face_is_an_edge() {
    for_all(6_000, mixed::<EdgeEdge>(), |points| {
        let face = points.map(|[p, _, x, y]| [p, x, y, y]);
        let edge = points.map(|[p, _, x, y]| [p, p, x, y]);
        let (face, edge): (Query<VertexFace>, Query<EdgeEdge>) = (query(&face), query(&edge));
        assert_same_times(&face, &edge);
    });
}
