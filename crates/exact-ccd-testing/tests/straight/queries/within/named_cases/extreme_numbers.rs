//! Numbers at the ends of the range.

use exact_ccd::{DistanceBounds, Query, VertexVertex};

use super::{FACE, is_within, vertex_against};
use exact_ccd_testing::laws::checked;

const TINY: f64 = 5e-324;

#[test]
fn a_huge_distance_holds_always() {
    let query = vertex_against(FACE, [0.25, 0.25, 1e300], [0.25, 0.25, -1e300]);
    is_within(&query, f64::MAX, &[[0.0, 1.0]]);
    is_within(&query, 1e301, &[[0.0, 1.0]]);
}

#[test]
fn a_subnormal_distance_is_taken_exactly() {
    let query = vertex_against(FACE, [0.25, 0.25, 3.0 * TINY], [0.25, 0.25, TINY]);
    is_within(&query, 2.0 * TINY, &[[0.5, 1.0]]);
    is_within(&query, TINY, &[[1.0, 1.0]]);
    is_within(&query, 0.0, &[]);
}

#[test]
fn tiny_and_huge_numbers_meet() {
    let query = vertex_against(FACE, [1e-300, 0.25, 1e300], [0.25, 1e-300, -1e300]);
    assert_eq!(checked(&query, super::within(1e-300)).len(), 1);
    assert_eq!(checked(&query, super::within(1e-10)).len(), 1);
    let misses = vertex_against(FACE, [-1e-300, 0.25, 1e300], [-1e-300, 0.25, -1e300]);
    assert_eq!(checked(&misses, super::within(1e-301)).len(), 0);
    assert_eq!(checked(&misses, super::within(1e-300)).len(), 1);
}

#[test]
fn a_distance_can_be_too_large_for_an_f64() {
    let [p, q] = [[f64::MAX; 3], [-f64::MAX; 3]];
    let query = Query::<VertexVertex>::new([p, q], [p, q]).unwrap();
    let expected = DistanceBounds {
        lower: f64::MAX,
        upper: f64::INFINITY,
    };
    assert_eq!(query.distance_at(0.5).unwrap(), expected);
    is_within(&query, f64::MAX, &[]);

    let [p, q] = [[f64::MAX, 0.0, 0.0], [-f64::MAX, 0.0, 0.0]];
    let twice = Query::<VertexVertex>::new([p, q], [p, q]).unwrap();
    assert_eq!(twice.distance_at(0.5).unwrap(), expected);
    let once = Query::<VertexVertex>::new([p, [0.0; 3]], [p, [0.0; 3]]).unwrap();
    let expected = DistanceBounds {
        lower: f64::MAX,
        upper: f64::MAX,
    };
    assert_eq!(once.distance_at(0.5).unwrap(), expected);
}

/// The normal of the face is so short that its square underflows.
#[test]
fn a_tiny_face_is_not_passed_by() {
    for size in [1e-80, 1e-85, 1e-90, 1e-95, 1e-120, 1e-160, 1e-300] {
        let face = FACE.map(|corner| corner.map(|x| x * size));
        let p = |z: f64| [0.25 * size, 0.25 * size, z];
        is_within(&vertex_against(face, p(1.0), p(0.5)), 0.75, &[[0.5, 1.0]]);
        is_within(&vertex_against(face, p(-1.0), p(-0.5)), 0.75, &[[0.5, 1.0]]);
    }
}

/// The distance from the plane x = y is h / √2 with h = 5e-324.
#[test]
fn a_distance_can_be_below_all_f64() {
    let face = [[0.0; 3], [8.0 * TINY, 8.0 * TINY, 0.0], [0.0, 0.0, 8.0 * TINY]];
    let p = [2.0 * TINY, 3.0 * TINY, TINY];
    let query = vertex_against(face, p, p);
    let expected = DistanceBounds {
        lower: 0.0,
        upper: TINY,
    };
    assert_eq!(query.distance_at(1.0).unwrap(), expected);
    is_within(&query, TINY, &[[0.0, 1.0]]);
    is_within(&query, 0.0, &[]);
}
