//! The shift moves coordinates to the right by the smallest amount that makes their differences
//! exact, and returns the rounding errors.

use dashu_int::IBig;
use dashu_int::ops::Abs;
use exact_ccd::{Axis, EdgeEdge, Point, Query, VertexFace};
use exact_ccd_methods::parity::{Displacement, Rounded, RoundingError};
use proptest::prelude::*;

use crate::corners::Corners;
use exact_ccd_testing::families::*;
use exact_ccd_testing::kinds::query;
use exact_ccd_testing::parity::integers::exactly;
use exact_ccd_testing::primitives::Points;
use exact_ccd_testing::runner::for_all;

/// Pairs of all relations of magnitude.
fn points() -> impl Strategy<Value = Points> {
    prop_oneof![
        4 => fractions(),
        4 => degenerate(small_integers(8)),
        4 => few_values(),
        2 => stretched(fractions()),
        2 => subnormal(small_integers(8)),
        1 => extremes(),
        1 => scattered(fractions()),
    ]
}

/// Sterbenz's condition: each is at most twice the other.
fn are_near(x: f64, y: f64) -> bool {
    let (x, y) = (exactly(x), exactly(y));
    let twice = |x: &IBig| x + x;
    (x <= twice(&y) && y <= twice(&x)) || (x >= twice(&y) && y >= twice(&x))
}

/// b − 2 a for a ≤ b.
fn excess(x: f64, y: f64) -> IBig {
    exactly(x.max(y)) - exactly(x.min(y)) * 2
}

fn moves_by_the_least_shift<K: Corners>() {
    for_all(20_000, points(), |points| {
        let pairs = K::pairs(&points);
        let displacement = Displacement::of_query(&query::<K>(&points));
        assert_eq!(displacement, Displacement::of_pairs(&pairs), "{points:?}");
        for (axis, e) in displacement.along_axes().into_iter().enumerate() {
            let along = || pairs.iter().map(|[x, y]| (x[axis], y[axis]));
            if along().all(|(x, y)| are_near(x, y)) {
                assert_eq!(e, 0.0, "{points:?}");
                continue;
            }
            let most = along().map(|(x, y)| excess(x, y)).max().unwrap();
            assert!(e.is_infinite() || exactly(e) >= most, "{e}: {points:?}");
            assert!(exactly(e.next_down()) < most, "{e}: {points:?}");
        }
    });
}

#[test]
fn moves_a_vertex_and_a_face_by_the_least_shift() {
    moves_by_the_least_shift::<VertexFace>();
}

#[test]
fn moves_edges_by_the_least_shift() {
    moves_by_the_least_shift::<EdgeEdge>();
}

fn brings_points_near<K: Corners>() {
    for_all(20_000, points(), |points| {
        let query = query::<K>(&points);
        let displacement = Displacement::of_query(&query);
        let moved = points.map(|now| now.map(|point| displacement.apply(point)));
        match Rounded::shift(&query) {
            Ok(rounded) => {
                assert_eq!(*rounded.query().points(), moved);
                assert_eq!(Rounded::check(*rounded.query()), Ok(rounded));
                for [x, y] in K::pairs(&moved) {
                    assert!((0..3).all(|axis| are_near(x[axis], y[axis])), "{points:?}");
                }
            }
            Err(error) => {
                let overflows =
                    |axis: &Axis| moved.as_flattened().iter().any(|x| !x[axis.index()].is_finite());
                let named = |axis: Axis| error == RoundingError::OutOfRange { axis };
                assert!(
                    Axis::ALL.iter().copied().filter(overflows).any(named),
                    "{error}: {points:?}"
                );
            }
        }
    });
}

#[test]
fn brings_a_vertex_near_a_face() {
    brings_points_near::<VertexFace>();
}

#[test]
fn brings_edges_near() {
    brings_points_near::<EdgeEdge>();
}

/// One shift serves all queries in a box.
#[test]
fn of_a_box_brings_all_its_points_near() {
    let corners = points().prop_map(|[[a, b, _, _], _]| [a, b]);
    let boxes = (corners, prop::array::uniform8(prop::array::uniform3(0.0..=1.0)));
    for_all(20_000, boxes, |([a, b], places)| {
        let displacement = Displacement::of_box(a, b);
        let inside = places.map(|place: Point| {
            [0, 1, 2].map(|axis: usize| {
                let (lower, upper) = (a[axis].min(b[axis]), a[axis].max(b[axis]));
                (lower * (1.0 - place[axis]) + upper * place[axis]).clamp(lower, upper)
            })
        });
        let moved = inside.map(|point| displacement.apply(point));
        if !moved.as_flattened().iter().all(|x| x.is_finite()) {
            return;
        }
        let [p, q, r, s, t, u, v, w] = moved;
        for axis in 0..3 {
            assert!(
                moved
                    .iter()
                    .all(|x| moved.iter().all(|y| are_near(x[axis], y[axis]))),
                "{a:?}, {b:?}: {inside:?}"
            );
        }
        let query = Query::<EdgeEdge>::new([p, q, r, s], [t, u, v, w]).unwrap();
        assert!(Rounded::check(query).is_ok(), "{query:?}");
    });
}

/// |x + e − x′|.
#[test]
fn the_error_is_exact() {
    let pairs = points().prop_map(|[[a, b, c, _], _]| ([a, b], c));
    for_all(20_000, pairs, |(pair, point)| {
        let displacement = Displacement::of_pairs(&[pair]);
        let (moved, error) = (displacement.apply(point), displacement.error(point));
        for axis in 0..3 {
            let e = displacement.along_axes()[axis];
            if !moved[axis].is_finite() {
                assert!(!error[axis].is_finite(), "{pair:?}, {point:?}");
                continue;
            }
            let off: IBig = exactly(point[axis]) + exactly(e) - exactly(moved[axis]);
            assert_eq!(exactly(error[axis]), off.abs(), "{pair:?}, {point:?}");
        }
    });
}

/// The sum x + e and its rounding error are in range, though an intermediate x + e − x is not.
#[test]
fn the_error_is_exact_at_the_end_of_the_range() {
    let displacement = Displacement::of_pairs(&[[[-f64::MAX / 2.0; 3], [0.0; 3]]]);
    assert_eq!(displacement.along_axes(), [f64::MAX; 3]);
    let half_unit = 2f64.powi(970);
    assert_eq!(
        displacement.error([-half_unit, -3.0 * half_unit, -4.0 * half_unit]),
        [half_unit, half_unit, 0.0]
    );
}

/// Also if 2a is out of range, and if a + b is a tie with the end of the range.
#[test]
fn is_the_least_at_the_end_of_the_range() {
    let e = |a: f64, b: f64| Displacement::of_pairs(&[[[a; 3], [b; 3]]]).along_axes()[0];
    assert_eq!(e(-2f64.powi(1023), -2f64.powi(1021)), 7.0 * 2f64.powi(1021));
    assert_eq!(e(-f64::MAX, 0.0), f64::INFINITY);
    let unit = 2f64.powi(971);
    assert_eq!(e(-f64::MAX / 2.0, -1.5 * unit), f64::MAX - unit);
}

#[test]
fn a_point_that_leaves_the_range_names_its_axis() {
    for axis in 0..3 {
        let (mut lower, mut upper) = ([1.0; 3], [1.0; 3]);
        (lower[axis], upper[axis]) = (-1e308, 1.0);
        let displacement = Displacement::of_box(lower, upper);
        let expected = RoundingError::OutOfRange {
            axis: Axis::ALL[axis],
        };
        assert_eq!(displacement.apply_to_all(&[lower, upper]), Err(expected));
        upper[axis] = -9e307;
        let displacement = Displacement::of_box(lower, upper);
        let moved = [lower, upper].map(|point| displacement.apply(point));
        assert_eq!(displacement.apply_to_all(&[lower, upper]), Ok(moved.to_vec()));
    }
}
