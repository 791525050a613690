//! Brochu's root parity, as published and in rational numbers.

use exact_ccd::{CONTACT, Ccd, Decide, EdgeEdge, Point, Query, VertexFace};
use exact_ccd_methods::parity::{BrochuRootParity, Parity, RationalRootParity};
use proptest::array::{uniform3, uniform4};
use proptest::prelude::*;

use exact_ccd_testing::kinds::query;
use exact_ccd_testing::parity::expected;
use exact_ccd_testing::primitives::Points;
use exact_ccd_testing::runner::for_all;

const CASES: u32 = 2000;

/// Eight points with coordinates from few numbers, so that points coincide, and faces are flat or
/// in one plane with the origin, or with coordinates of 53 bits close to these, on axes of
/// different magnitudes.
fn points(exponents: std::ops::Range<i32>) -> impl Strategy<Value = Points> {
    let coordinate = (
        -2..=2i8,
        prop_oneof![8 => Just(0.0), 1 => -1e-15..1e-15, 1 => -1.0..1.0],
    )
        .prop_map(|(x, error)| f64::from(x) + error);
    let frame = uniform4(uniform3(coordinate));
    (frame.clone(), frame, uniform3(exponents)).prop_map(|(start, end, exponents)| {
        let scale = exponents.map(|exponent| 2f64.powi(exponent));
        [start, end].map(|frame| frame.map(|point| [0, 1, 2].map(|axis: usize| scale[axis] * point[axis])))
    })
}

fn both(method: &impl Ccd, points: &Points) -> [bool; 2] {
    [
        method.collides(&query::<VertexFace>(points)),
        method.collides(&query::<EdgeEdge>(points)),
    ]
}

/// The rational method reports the parity by the definition of contact. The published method misses no
/// odd one.
fn agree(points: &Points) {
    let expected = [
        expected(&query::<VertexFace>(points)),
        expected(&query::<EdgeEdge>(points)),
    ];
    let collisions = expected.map(Parity::is_collision);
    assert_eq!(both(&RationalRootParity, points), collisions, "{points:?}");
    for (published, collides) in both(&BrochuRootParity::default(), points)
        .into_iter()
        .zip(collisions)
    {
        assert!(published || !collides, "{points:?}");
    }
}

#[test]
fn reports_each_odd_parity() {
    for_all(CASES, points(0..1), |points| agree(&points));
}

/// Expansions would overflow or underflow, or lose the last bits.
#[test]
fn reports_each_odd_parity_at_any_magnitude() {
    for_all(CASES, points(-1060..1021), |points| agree(&points));
}

#[test]
fn rational_numbers_give_no_false_positives() {
    for_all(CASES, points(0..1), |points| {
        let [vertex_face, edge_edge] = both(&RationalRootParity, &points);
        assert!(!vertex_face || query::<VertexFace>(&points).collides(CONTACT));
        assert!(!edge_edge || query::<EdgeEdge>(&points).collides(CONTACT));
    });
}

/// The decisions of the published method, the rational one and the kernel.
fn contacts(query: &Query<VertexFace>) -> [bool; 3] {
    let published = BrochuRootParity::default().collides(query);
    let rational = RationalRootParity.collides(query);
    [published, rational, query.collides(CONTACT)]
}

/// Edge b slides along edge a, which rotates about its midpoint: they meet where (2t − 1)² = −height.
fn see_saw(height: f64) -> Query<EdgeEdge> {
    let b = |x: f64| [[x, -1.0, height], [x, 1.0, height]];
    let a = |z: f64| [[-1.0, 0.0, z], [1.0, 0.0, -z]];
    query(&[[a(-1.0), b(-1.0)], [a(1.0), b(1.0)]].map(|frame| frame.as_flattened().try_into().unwrap()))
}

#[test]
fn two_contacts_and_a_double_one_are_missed() {
    for height in [-0.25, 0.0] {
        let query = see_saw(height);
        assert!(query.collides(CONTACT));
        assert!(!BrochuRootParity::default().collides(&query));
        assert!(!RationalRootParity.collides(&query));
    }
}

/// A vertex comes near to a face without touching it. The published method rounds the small distance.
#[test]
fn a_distance_below_the_roundoff_of_a_long_ray_is_lost() {
    let face = [[2.0, -1.0, -1.0], [-2.0, 1.0, -1.0], [0.0, 0.0, 1.0]];
    let falls_to = |distance: f64| {
        let frame = |p: f64| [[p, 2.0 * p, 0.0], face[0], face[1], face[2]];
        query(&[frame(1.0), frame(distance)])
    };
    assert_eq!(contacts(&falls_to(1e-17)), [true, false, false]);
    assert_eq!(contacts(&falls_to(1e-14)), [false, false, false]);
    assert_eq!(contacts(&falls_to(0.0)), [true; 3]);
}

/// An edge of the face sweeps an arrowhead in the plane of the vertex, which is in the notch.
#[test]
fn the_hull_of_a_flat_face_is_more_than_it_covers() {
    let frame =
        |v1: [f64; 2], v2: [f64; 2], p: Point| [p, [v1[0], v1[1], 0.0], [v2[0], v2[1], 0.0], [0.0, 0.0, 5.0]];
    let with = |p: Point| {
        query(&[
            frame([-3.0, -1.0], [0.0, 1.0], p),
            frame([0.0, 3.0], [3.0, -1.0], p),
        ])
    };
    assert_eq!(contacts(&with([0.0, 0.0, 0.0])), [true, false, false]);
    assert_eq!(contacts(&with([0.0, 2.0, 0.0])), [true; 3]);
}

/// The vertex has the height of the corners of the face that surround it. All other points are above.
#[test]
fn level_edges_around_the_vertex_stop_all_rays() {
    let top = [0.0, 0.0, 1.0];
    let with = |p: Point| {
        query(&[
            [p, [-2.0, -2.0, 0.0], top, [-2.0, 2.0, 0.0]],
            [p, top, [2.0, -2.0, 0.0], [2.0, 2.0, 0.0]],
        ])
    };
    assert_eq!(contacts(&with([0.0, 0.0, 0.0])), [true, false, false]);
    assert_eq!(contacts(&with([0.0, 0.0, -1.0])), [false, false, false]);
}

/// No point moves, or all points have the same displacement.
#[test]
fn contact_at_rest_is_found() {
    let frame = |z: f64| [[1.0, 1.0, z], [0.0, 0.0, z], [4.0, 0.0, z], [0.0, 4.0, z]];
    assert_eq!(contacts(&query(&[frame(0.0), frame(0.0)])), [true; 3]);
    assert_eq!(contacts(&query(&[frame(0.0), frame(1.0)])), [true; 3]);
}
