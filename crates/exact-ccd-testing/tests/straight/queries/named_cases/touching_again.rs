//! Contact that ends and begins again, in a plane.
//!
//! The edge from (s − 2, h − s/2) to (s + 2, h + s/2) crosses the axis x = 0 at the height h − s²/4.

use exact_ccd::{EdgeEdge, Query, VertexFace};

use super::{during, touches_at, touches_during};

/// The face from the edge up to (0, 8), against the origin. It contains the origin where the height is at
/// most 0.
fn face(h: f64) -> Query<VertexFace> {
    during(|s| {
        [
            [0.0, 0.0, 0.0],
            [s - 2.0, h - 0.5 * s, 0.0],
            [s + 2.0, h + 0.5 * s, 0.0],
            [0.0, 8.0, 0.0],
        ]
    })
}

/// That edge, and the one from the origin to (0, y).
fn edges(h: f64, y: f64) -> Query<EdgeEdge> {
    during(|s| {
        [
            [s - 2.0, h - 0.5 * s, 0.0],
            [s + 2.0, h + 0.5 * s, 0.0],
            [0.0, 0.0, 0.0],
            [0.0, y, 0.0],
        ]
    })
}

#[test]
fn two_intervals() {
    touches_during(&face(0.0625), &[[0.0, 0.25], [0.75, 1.0]]);
    touches_during(&edges(0.0625, -1.0), &[[0.0, 0.25], [0.75, 1.0]]);
    touches_during(&edges(0.0625, 1.0), &[[0.25, 0.75]]);
}

/// At t = 1/2, the edge only touches the origin.
#[test]
fn intervals_with_a_common_end_are_one() {
    touches_during(&face(0.0), &[[0.0, 1.0]]);
    touches_during(&edges(0.0, -1.0), &[[0.0, 1.0]]);
    touches_at(&edges(0.0, 1.0), &[0.5]);
}

/// At both ends of the step.
#[test]
fn two_moments() {
    touches_at(&face(0.25), &[0.0, 1.0]);
    touches_at(&edges(0.25, -1.0), &[0.0, 1.0]);
}

/// The edge at rest ends at the origin and at the height −3/16, below which the other one is but for |s| ≤ 1.
#[test]
fn beyond_both_ends_of_an_edge() {
    touches_during(&edges(0.0625, -0.1875), &[[0.0, 0.25], [0.75, 1.0]]);
    let above_its_end = 0.0625 - 0.140625;
    touches_during(&edges(0.0625, above_its_end), &[[0.125, 0.25], [0.75, 0.875]]);
}

/// In a plane at a slant, with the f64 around two irrational numbers.
#[test]
fn ends_that_are_no_f64() {
    let slanted: Query<EdgeEdge> = during(|s| {
        let height = |z: f64| [z, 3.0 * z];
        let point = |x: f64, z: f64| {
            let [y, z] = height(z);
            [x, y, z]
        };
        [
            point(s - 2.0, 0.125 - 0.5 * s),
            point(s + 2.0, 0.125 + 0.5 * s),
            [0.0; 3],
            point(0.0, -1.0),
        ]
    });
    let times = exact_ccd_testing::laws::checked(&slanted, exact_ccd::Separation::ZERO);
    // s² = 1/2, hence 2 (2 t − 1)² = 1.
    let [first, second] = times[..] else {
        panic!("not two intervals: {times:?}");
    };
    assert!(first.start.is_start() && !first.end.is_exact() && !first.is_moment);
    assert!(second.end.lower() == 1.0 && !second.start.is_exact() && !second.is_moment);
    let around = [first.end, second.start].map(|time| [time.lower(), time.upper()]);
    let root = 0.5 - 0.125f64.sqrt();
    assert!(
        around[0].contains(&root) && around[1].contains(&(1.0 - root)),
        "{times:?}"
    );
}
