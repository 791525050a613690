//! The answers do not depend on the order of points, axes, units, the direction of time, or the
//! frame of reference.

use exact_ccd::{EdgeEdge, Point, Query, Separation, VertexFace};
use proptest::array::{uniform2, uniform3};
use proptest::prelude::*;

use crate::queries::each_kind::for_each_kind;
use crate::queries::families::{cases, ordinary, rule};
use exact_ccd_testing::families::*;
use exact_ccd_testing::kinds::{Renamed, query};
use exact_ccd_testing::laws::{assert_reversible, assert_same_times};
use exact_ccd_testing::primitives::{Points, Primitives, combine};
use exact_ccd_testing::runner::for_all;
use exact_ccd_testing::symmetry::{Symmetry, assert_symmetric};

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

fn names_axes_and_units<K: Primitives + Renamed>() {
    for_all(10_000, (mixed::<K>(), symmetry()), |(points, symmetry)| {
        assert_symmetric::<K>(&points, Separation::ZERO, &symmetry);
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

fn names_axes_and_the_unit<K: Renamed>() {
    for_all(
        cases(20_000),
        (ordinary(), rule(), symmetry()),
        |(points, rule, symmetry)| {
            assert_symmetric::<K>(&points, rule.separation::<K>(&points), &symmetry);
        },
    );
}

#[test]
fn time_can_run_backwards() {
    for_all(6_000, mixed::<VertexFace>(), |points| {
        assert_reversible(&query::<VertexFace>(&points), Separation::ZERO);
    });
    for_all(6_000, mixed::<EdgeEdge>(), |points| {
        assert_reversible(&query::<EdgeEdge>(&points), Separation::ZERO);
    });
}

fn reversible<K: Renamed>() {
    for_all(cases(20_000), (ordinary(), rule()), |(points, rule)| {
        assert_reversible(&query::<K>(&points), rule.separation::<K>(&points));
    });
}

for_each_kind! {
    names_axes_and_the_unit_do_not_matter_to_a_distance => names_axes_and_the_unit;
    time_can_run_backwards_within_a_distance => reversible;
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
        let [one, other] = [points, seen_from(frame, &points)].map(|points| query::<K>(&points));
        assert_same_times((&one, Separation::ZERO), (&other, Separation::ZERO));
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
        let face: Query<VertexFace> = query(&points.map(|[p, _, x, y]| [p, x, y, y]));
        let edge: Query<EdgeEdge> = query(&points.map(|[p, _, x, y]| [p, p, x, y]));
        assert_same_times((&face, Separation::ZERO), (&edge, Separation::ZERO));
    });
}
