//! Coordinates from 5e-324 to the end of the range in one query: the parity agrees with the parity in
//! integers also where products underflow or overflow.

use exact_ccd::{EdgeEdge, Kind, Point, VertexFace};
use exact_ccd_methods::parity::{Parity, Rounded};
use proptest::array::{uniform2, uniform3, uniform4};
use proptest::prelude::*;

use exact_ccd_testing::families::*;
use exact_ccd_testing::kinds::query;
use exact_ccd_testing::parity::laws::checked_parity;
use exact_ccd_testing::primitives::Points;
use exact_ccd_testing::runner::for_all;

/// Few powers of two, such that products cancel at every magnitude.
fn powers() -> impl Strategy<Value = Points> {
    let signs = prop::sample::select(vec![-1.0, 0.0, 1.0]);
    let exponents = prop::sample::select(vec![-1000, -600, -300, 0, 300, 1000]);
    let coordinate = (signs, exponents).prop_map(|(sign, exponent): (f64, _)| sign * 2f64.powi(exponent));
    uniform2(uniform4(uniform3(coordinate)))
}

/// Small integers, in a separate unit on each axis at each of the two times.
fn uneven() -> impl Strategy<Value = Points> {
    let exponents = uniform2(uniform3(-1000..=1000i32));
    (degenerate(small_integers(2)), exponents).prop_map(|(points, exponents)| {
        [0, 1].map(|time: usize| {
            points[time]
                .map(|point| [0, 1, 2].map(|axis: usize| point[axis] * 2f64.powi(exponents[time][axis])))
        })
    })
}

/// With the vertex at rest in the origin, the differences are exact for any face.
fn around_origin(cases: u32, faces: impl Strategy<Value = Points>) {
    for_all(cases, faces, |points| {
        let points = points.map(|[_, v1, v2, v3]| [[0.0; 3], v1, v2, v3]);
        checked_parity(&Rounded::check(query::<VertexFace>(&points)).unwrap());
    });
}

#[test]
fn of_a_vertex_and_a_face() {
    around_origin(40_000, powers());
    around_origin(10_000, extremes());
    around_origin(10_000, few_values());
    around_origin(10_000, stretched(degenerate(fractions())));
    around_origin(10_000, subnormal(degenerate(small_integers(2))));
    around_origin(5_000, scattered(degenerate(fractions())));
}

/// 2⁻⁶⁰⁰ squared underflows, but its product with 2¹⁰⁰⁰ would not.
const SMALL: f64 = f64::from_bits((1023 - 600) << 52);
const LARGE: f64 = f64::from_bits((1023 + 1000) << 52);

#[test]
fn of_a_falling_vertex_in_any_units() {
    for axes in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
        for units in [[LARGE, SMALL, SMALL], [SMALL, LARGE, LARGE]] {
            let place = |point: Point| [0, 1, 2].map(|axis: usize| point[axes[axis]] * units[axis]);
            let falls = |x: f64, y: f64| {
                let around =
                    |z: f64| [[x, y, z], [-1.0, -1.0, 0.0], [2.0, -1.0, 0.0], [-1.0, 2.0, 0.0]].map(place);
                checked_parity(&Rounded::check(query::<VertexFace>(&[around(1.0), around(-1.0)])).unwrap())
            };
            assert_eq!(falls(0.25, 0.25), Parity::Odd, "{axes:?} {units:?}");
            assert_eq!(falls(0.75, 0.25), Parity::Boundary, "{axes:?} {units:?}");
            assert_eq!(falls(0.75, 0.5), Parity::Even, "{axes:?} {units:?}");
        }
    }
}

/// Products of three coordinates are out of the range of f64. Without a check of the range, every ray would
/// be rejected.
#[test]
fn of_corners_on_axes_at_any_distance() {
    let start = [[0.0; 3], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0], [-SMALL, -LARGE, 0.0]];
    let end = [
        [0.0; 3],
        [SMALL, LARGE, 0.0],
        [0.0, -LARGE, 0.0],
        [0.0, 0.0, -SMALL],
    ];
    let rounded = Rounded::check(query::<VertexFace>(&[start, end])).unwrap();
    assert_eq!(checked_parity(&rounded), Parity::Even);
}

fn in_uneven_units<K: Kind<Points = [Point; 4]>>() {
    for_all(10_000, uneven(), |points| {
        checked_parity(&Rounded::check(query::<K>(&points)).unwrap());
    });
}

#[test]
fn of_a_vertex_and_a_face_in_uneven_units() {
    in_uneven_units::<VertexFace>();
}

#[test]
fn of_edges_in_uneven_units() {
    in_uneven_units::<EdgeEdge>();
}

/// Queries of mixed magnitudes after the shift, in which the largest coordinates displace the others.
fn after_a_shift<K: Kind<Points = [Point; 4]>>() {
    let points = prop_oneof![
        extremes(),
        few_values(),
        scattered(degenerate(fractions())),
        powers()
    ];
    for_all(20_000, points, |points| {
        if let Ok(rounded) = Rounded::shift(&query::<K>(&points)) {
            checked_parity(&rounded);
        }
    });
}

#[test]
fn of_a_vertex_and_a_face_after_a_shift() {
    after_a_shift::<VertexFace>();
}

#[test]
fn of_edges_after_a_shift() {
    after_a_shift::<EdgeEdge>();
}
