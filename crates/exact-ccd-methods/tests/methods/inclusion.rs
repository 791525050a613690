//! The methods without false negatives, and their false positives.

use exact_ccd::{CONTACT, Ccd, Decide, EdgeEdge, Point, Query, VertexFace};
use exact_ccd_methods::{IntervalRootFinder, Magnitude, TightInclusion, UnivariateIntervalRootFinder};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// The methods, with a limit of iterations, on which their guarantees do not depend.
fn methods(max_iterations: usize) -> [Box<dyn Ccd>; 4] {
    let tight_inclusion = TightInclusion {
        max_iterations,
        ..Default::default()
    };
    [
        Box::new(tight_inclusion),
        Box::new(TightInclusion {
            max_queue: Some(1000),
            magnitude: Magnitude::Scene([10.0; 3]),
            ..tight_inclusion
        }),
        Box::new(IntervalRootFinder {
            max_iterations,
            ..Default::default()
        }),
        Box::new(UnivariateIntervalRootFinder {
            max_iterations,
            ..Default::default()
        }),
    ]
}

/// True if a method neither misses a contact nor returns a time after the earliest.
fn is_conservative(time: Option<f64>, time_of_impact: Option<f64>) -> bool {
    match (time_of_impact, time) {
        (None, _) => true,
        (Some(earliest), Some(time)) => time <= earliest,
        (Some(_), None) => false,
    }
}

fn assert_conservative(points: [[Point; 4]; 2], max_iterations: usize) -> Result<(), TestCaseError> {
    let [start, end] = points;
    let vertex_face = Query::<VertexFace>::new(start, end).unwrap();
    let edge_edge = Query::<EdgeEdge>::new(start, end).unwrap();
    for method in methods(max_iterations) {
        let answers = [
            (
                method.time_of_impact(&vertex_face),
                vertex_face.time_of_impact(CONTACT),
            ),
            (
                method.time_of_impact(&edge_edge),
                edge_edge.time_of_impact(CONTACT),
            ),
        ];
        for (time, earliest) in answers {
            prop_assert!(
                is_conservative(time, earliest),
                "{}: {time:?} {earliest:?}",
                method.name()
            );
        }
    }
    Ok(())
}

fn points(coordinate: impl Strategy<Value = f64> + Clone) -> impl Strategy<Value = [[Point; 4]; 2]> {
    use prop::array::{uniform2, uniform3, uniform4};
    uniform2(uniform4(uniform3(coordinate)))
}

/// A small integer: points coincide, and are collinear or coplanar, often.
fn grid() -> impl Strategy<Value = f64> + Clone {
    (-2..=2i8).prop_map(f64::from)
}

/// A small integer, or a number close to one.
fn nudged() -> impl Strategy<Value = f64> + Clone {
    (grid(), -1..=1i8, 10..60i32).prop_map(|(x, sign, exponent)| x + f64::from(sign) * 2f64.powi(-exponent))
}

/// Finite numbers, from subnormal numbers to numbers whose products overflow.
fn finite() -> impl Strategy<Value = f64> + Clone {
    use prop::num::f64::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    prop_oneof![NORMAL | SUBNORMAL | ZERO | POSITIVE | NEGATIVE, grid()]
}

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        rng_seed: RngSeed::Fixed(0),
        failure_persistence: None,
        ..Default::default()
    }
}

proptest! {
    #![proptest_config(config(400))]

    #[test]
    fn degenerate_contacts_are_not_missed(points in points(grid())) {
        assert_conservative(points, 500)?;
    }

    #[test]
    fn almost_degenerate_contacts_are_not_missed(points in points(nudged())) {
        assert_conservative(points, 500)?;
    }
}

proptest! {
    // The exact times of such queries are numbers of thousands of digits.
    #![proptest_config(config(60))]

    #[test]
    fn contacts_of_any_size_are_not_missed(points in points(finite())) {
        assert_conservative(points, 100)?;
    }
}

const FACE: [Point; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

/// A vertex moves above a resting face.
fn above_a_face(from: Point, to: Point) -> Query<VertexFace> {
    let [v1, v2, v3] = FACE;
    Query::<VertexFace>::new([from, v1, v2, v3], [to, v1, v2, v3]).unwrap()
}

#[test]
fn times_are_early_by_no_more_than_the_tolerance() {
    let query = above_a_face([0.25, 0.25, 1.0], [0.25, 0.25, -2.0]);
    for method in methods(1_000_000) {
        let time = method.time_of_impact(&query).unwrap();
        assert!(
            time <= 1.0 / 3.0 && time > 1.0 / 3.0 - 1e-6,
            "{} {time}",
            method.name()
        );
    }
}

/// (0.3 − 1) + 1 > 0.3 in f64: when the vertex has reached the face, the computed point is above it.
#[test]
fn a_contact_that_rounding_would_open_is_not_missed() {
    let [v1, v2, v3] = FACE.map(|[x, y, _]| [x, y, 0.3]);
    let query =
        Query::<VertexFace>::new([[0.25, 0.25, 1.0], v1, v2, v3], [[0.25, 0.25, 0.3], v1, v2, v3]).unwrap();
    assert!(query.collides(CONTACT));
    for method in methods(1_000_000) {
        assert!(method.collides(&query), "{}", method.name());
    }
}

#[test]
fn separated_primitives_are_free() {
    let query = above_a_face([0.25, 0.25, 1.0], [0.25, 0.25, 1e-7]);
    for method in methods(1_000_000) {
        assert_eq!(method.time_of_impact(&query), None, "{}", method.name());
    }
}

/// The longest edge of the face runs across boxes of u and v, which end at the tolerance.
#[test]
fn a_pass_closer_than_the_tolerance_is_a_contact() {
    let query = above_a_face([0.5 + 1e-7, 0.5, 1.0], [0.5 + 1e-7, 0.5, -1.0]);
    assert!(!query.collides(CONTACT));
    assert!(TightInclusion::default().collides(&query));
    assert!(IntervalRootFinder::default().collides(&query));
}

/// u + v ≤ 1: a vertex that passes the face's longest edge is still in the square of u and v.
#[test]
fn the_domain_of_a_face_is_a_triangle() {
    let query = above_a_face([0.6, 0.6, 1.0], [0.6, 0.6, -1.0]);
    for method in methods(1_000_000) {
        assert_eq!(method.time_of_impact(&query), None, "{}", method.name());
    }
}

#[test]
fn tight_inclusion_keeps_a_separation() {
    let query = above_a_face([0.25, 0.25, 1.0], [0.25, 0.25, 0.5]);
    let with = |minimum_separation| TightInclusion {
        minimum_separation,
        ..Default::default()
    };
    assert_eq!(with(0.49).time_of_impact(&query), None);
    // The separation is reached at t = 1/2, over an area of (u, v) that has more boxes than its limit.
    let time = with(0.75).time_of_impact(&query).unwrap();
    assert!(time <= 0.5 && time > 0.4, "{time}");
}

/// Edges that slide along each other, oblique to the axes, where the boxes are not flat.
fn sliding_edges(distance: f64) -> Query<EdgeEdge> {
    let edges = |x: f64| {
        let on_diagonal = |x: f64| [x, x, x];
        let beside = |x: f64| [x + distance, x - distance, x];
        [beside(x), beside(x + 1.0), on_diagonal(0.0), on_diagonal(1.0)]
    };
    Query::<EdgeEdge>::new(edges(-0.5), edges(0.5)).unwrap()
}

#[test]
fn tight_inclusion_says_contact_when_its_queue_is_full() {
    let limited = TightInclusion {
        max_queue: Some(1000),
        ..Default::default()
    };
    assert_eq!(
        TightInclusion::default().time_of_impact(&sliding_edges(0.02)),
        None
    );
    assert!(limited.collides(&sliding_edges(0.02)));
}

#[test]
fn tight_inclusion_bounds_rounding_by_the_size_of_the_scene() {
    let query = above_a_face([0.25, 0.25, 1.0], [0.25, 0.25, 0.5]);
    let in_a_scene = |size| TightInclusion {
        magnitude: Magnitude::Scene([size; 3]),
        ..Default::default()
    };
    assert_eq!(in_a_scene(1e3).time_of_impact(&query), None);
    assert_eq!(in_a_scene(1e5).time_of_impact(&query), Some(0.0));
}

/// Collinear edges span no plane, so that every time counts as coplanar, and every position as inside.
#[test]
fn only_the_univariate_finder_takes_edges_in_line_for_edges_that_touch() {
    let edges = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [3.0, 0.0, 0.0]];
    let query = Query::<EdgeEdge>::new(edges, edges).unwrap();
    let time = UnivariateIntervalRootFinder::default().time_of_impact(&query);
    assert_eq!(time, Some(0.0));
    assert_eq!(IntervalRootFinder::default().time_of_impact(&query), None);
    assert_eq!(TightInclusion::default().time_of_impact(&query), None);
}
