//! The parity agrees with the definition of contact, on all families of special queries.

use exact_ccd::{EdgeEdge, VertexFace};
use exact_ccd_methods::parity::Rounded;
use proptest::prelude::*;

use exact_ccd_testing::families::*;
use exact_ccd_testing::kinds::query;
use exact_ccd_testing::parity::Rim;
use exact_ccd_testing::parity::laws::assert_defined;
use exact_ccd_testing::primitives::{Points, Primitives};
use exact_ccd_testing::runner::for_all;

/// Small integers need no rounding.
fn as_they_are<K: Rim>(cases: u32, points: impl Strategy<Value = Points>) {
    for_all(cases, points, |points| {
        assert_defined(&Rounded::check(query::<K>(&points)).unwrap());
    });
}

fn on_integers<K: Rim + Primitives>() {
    as_they_are::<K>(20_000, small_integers(1));
    as_they_are::<K>(20_000, small_integers(2));
    as_they_are::<K>(20_000, degenerate(small_integers(1)));
    as_they_are::<K>(20_000, degenerate(small_integers(2)));
    as_they_are::<K>(10_000, exact_contacts::<K>(degenerate(small_integers(2))));
    as_they_are::<K>(10_000, exact_grazes::<K>(small_integers(2)));
}

#[test]
fn of_a_vertex_and_a_face_at_integers() {
    on_integers::<VertexFace>();
}

#[test]
fn of_edges_at_integers() {
    on_integers::<EdgeEdge>();
}

fn shifted<K: Rim>(cases: u32, points: impl Strategy<Value = Points>) {
    for_all(cases, points, |points| {
        assert_defined(&Rounded::shift(&query::<K>(&points)).unwrap());
    });
}

fn on_rounded_numbers<K: Rim + Primitives>() {
    shifted::<K>(5_000, degenerate(fractions()));
    shifted::<K>(5_000, rounded_contacts::<K>());
    shifted::<K>(2_000, rounded_grazes::<K>());
    shifted::<K>(5_000, narrow_misses::<K>(exact_contacts::<K>(small_integers(8))));
    shifted::<K>(2_000, planar_contacts::<K>());
}

#[test]
fn of_a_vertex_and_a_face_at_rounded_numbers() {
    on_rounded_numbers::<VertexFace>();
}

#[test]
fn of_edges_at_rounded_numbers() {
    on_rounded_numbers::<EdgeEdge>();
}
