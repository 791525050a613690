//! The oracle on motions whose times within a distance are known by hand. So a test that compares with it
//! does not depend on the oracle alone.

use exact_ccd::AnyKind::{self, EdgeEdge, VertexEdge, VertexFace, VertexVertex};
use exact_ccd::Point;
use exact_ccd_testing::definition;

/// Intervals by their ends. A time that is not an f64 is given by the one below it.
type Expected<'a> = &'a [[(f64, bool); 2]];

fn assert_within(kind: AnyKind, start: &[Point], end: &[Point], d: f64, expected: Expected<'_>) {
    let found = definition::intervals(kind, [start, end], d);
    let ends: Vec<_> = found.iter().map(|(ends, _)| *ends).collect();
    assert_eq!(ends, expected, "{kind:?} {d}");
}

const fn exactly(t: f64) -> (f64, bool) {
    (t, true)
}

const fn just_above(t: f64) -> (f64, bool) {
    (t, false)
}

/// A vertex passes another one along a line: |8 t − 4| ≤ d.
#[test]
fn a_vertex_passes_a_vertex() {
    let (start, end) = ([[-4.0, 0.0, 0.0], [0.0; 3]], [[4.0, 0.0, 0.0], [0.0; 3]]);
    assert_within(VertexVertex, &start, &end, 0.0, &[[exactly(0.5); 2]]);
    let quarters = [exactly(0.25), exactly(0.75)];
    assert_within(VertexVertex, &start, &end, 2.0, &[quarters]);
    assert_within(VertexVertex, &start, &end, 4.0, &[[exactly(0.0), exactly(1.0)]]);
}

/// At the height 1: 64 (t − 1/2)² + 1 ≤ d².
#[test]
fn a_vertex_passes_above_a_vertex() {
    let (start, end) = ([[-4.0, 1.0, 0.0], [0.0; 3]], [[4.0, 1.0, 0.0], [0.0; 3]]);
    assert_within(VertexVertex, &start, &end, 1.0f64.next_down(), &[]);
    assert_within(VertexVertex, &start, &end, 1.0, &[[exactly(0.5); 2]]);
    // t = 1/2 ± √3 / 8
    let ends = [
        just_above(0.283_493_649_053_890_3),
        just_above(0.716_506_350_946_109_6),
    ];
    assert_within(VertexVertex, &start, &end, 2.0, &[ends]);
}

/// A vertex at the distance √(x² + 9) from an edge that ends at x = 8.
#[test]
fn a_vertex_passes_the_end_of_an_edge() {
    let edge = [[8.0, 0.0, 0.0], [9.0, 0.0, 0.0]];
    let at = |x: f64| [[x, 3.0, 0.0], edge[0], edge[1]];
    assert_within(
        VertexEdge,
        &at(0.0),
        &at(16.0),
        5.0,
        &[[exactly(0.25), exactly(0.8125)]],
    );
    assert_within(
        VertexEdge,
        &at(0.0),
        &at(16.0),
        3.0,
        &[[exactly(0.5), exactly(0.5625)]],
    );
}

/// A vertex falls through the inside of a face, through its side, and beside it.
#[test]
fn a_vertex_falls_through_a_face() {
    let at = |x: f64, z: f64| [[x, 1.0, z], [0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
    let falls = |x: f64, expected: Expected<'_>| {
        assert_within(VertexFace, &at(x, 1.0), &at(x, -2.0), 0.0, expected);
    };
    falls(1.0, &[[just_above(1.0 / 3.0); 2]]);
    falls(3.0, &[[just_above(1.0 / 3.0); 2]]);
    falls(3.0f64.next_up(), &[]);
    falls(-5e-324, &[]);
    assert_within(
        VertexFace,
        &at(1.0, 2.0),
        &at(1.0, -2.0),
        1.0,
        &[[exactly(0.25), exactly(0.75)]],
    );
}

/// 1 / 3 is between two f64, and `1.0 / 3.0` is the lower one.
#[test]
fn a_third_is_rounded_down() {
    assert!((1.0f64 / 3.0).mul_add(3.0, -1.0) < 0.0);
}

/// A vertex slides over the face, in its plane: in contact while it is inside.
#[test]
fn a_vertex_slides_over_a_face() {
    let at = |x: f64| [[x, 1.0, 0.0], [0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
    let slides = [exactly(0.25), exactly(0.625)];
    assert_within(VertexFace, &at(-2.0), &at(6.0), 0.0, &[slides]);
}

/// Two edges at t = 0 and t = 1. The ends of the first one, at x = −1 and x = 1, have the heights z + 4 t − 2
/// and z + 2 − 4 t. The second one is at x = 2 t − 1. There, the first edge has the height z − 2 (2 t − 1)².
fn turning(z: f64) -> [[Point; 4]; 2] {
    [(z - 2.0, z + 2.0, -1.0), (z + 2.0, z - 2.0, 1.0)].map(|(left, right, x)| {
        [
            [-1.0, 0.0, left],
            [1.0, 0.0, right],
            [x, -1.0, 0.0],
            [x, 1.0, 0.0],
        ]
    })
}

/// The height 1 − 2 (2 t − 1)² is 0 at t = 1/2 ± √(1/8).
#[test]
fn edges_touch_twice() {
    let [start, end] = turning(1.0);
    let times = [0.146_446_609_406_726_2, 0.853_553_390_593_273_7].map(|t| [just_above(t); 2]);
    assert_within(EdgeEdge, &start, &end, 0.0, &times);
}

/// The points of the last test raised by 1: 2 − 2 (2 t − 1)² is zero at both ends of the step. With one more
/// half, it never is.
#[test]
fn edges_touch_at_the_ends_of_the_step() {
    let raised = |points: [Point; 4], z: f64| points.map(|p| [p[0], p[1], p[2] + z * (1.0 - p[1] * p[1])]);
    let [start, end] = turning(1.0);
    let ends = [[exactly(0.0); 2], [exactly(1.0); 2]];
    assert_within(EdgeEdge, &raised(start, 1.0), &raised(end, 1.0), 0.0, &ends);
    assert_within(EdgeEdge, &raised(start, 1.5), &raised(end, 1.5), 0.0, &[]);
    let lowered = [[exactly(0.5); 2]];
    assert_within(EdgeEdge, &raised(start, -1.0), &raised(end, -1.0), 0.0, &lowered);
}

/// Numbers of any magnitude: the contact is next to the end of the step, within less than any f64.
#[test]
fn contact_next_to_the_end() {
    let at = |z: f64| [[0.25, 0.25, z], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let nearly_one = [just_above(1.0f64.next_down()); 2];
    assert_within(VertexFace, &at(1e300), &at(-5e-324), 0.0, &[nearly_one]);
    assert_within(
        VertexFace,
        &at(-5e-324),
        &at(f64::MAX),
        0.0,
        &[[just_above(0.0); 2]],
    );
    assert_within(VertexFace, &at(1e300), &at(5e-324), 0.0, &[]);
}

/// Both times of contact are within one f64 of each other: t = 1/2 ± 2⁻⁵³⁷.
#[test]
fn two_contacts_between_adjacent_numbers() {
    let [start, end] = turning(0.0);
    // The height is −2 (2 t − 1)² + δ for b at the height −δ.
    let lowered = |points: [Point; 4], z: f64| {
        let [a, b, c, d] = points;
        [a, b, [c[0], c[1], z], [d[0], d[1], z]]
    };
    let intervals = |z: f64| {
        let (start, end) = (lowered(start, z), lowered(end, z));
        definition::intervals(EdgeEdge, [&start, &end], 0.0)
    };
    let count = |z: f64| intervals(z).len();
    assert_eq!([-5e-324, 0.0, 5e-324].map(count), [2, 1, 0]);
    let [first, second]: [_; 2] = intervals(-5e-324).try_into().unwrap();
    assert_eq!(first, ([just_above(0.5f64.next_down()); 2], true));
    assert_eq!(second, ([just_above(0.5); 2], true));
}

/// The vertex reaches the plane of the face and the line of a side at 1/4: a root of different polynomials.
#[test]
fn different_polynomials_have_a_common_root() {
    let at = |x: f64, z: f64| [[x, 1.0, z], [0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
    assert_within(
        VertexFace,
        &at(-1.0, 1.0),
        &at(3.0, -3.0),
        0.0,
        &[[exactly(0.25); 2]],
    );
    assert_within(VertexFace, &at(-1.0, 1.0), &at(-5.0, -3.0), 0.0, &[]);
}
