//! Contact by subdivision: F is affine in each of t, u and v, so that its image of a box lies in
//! the hull of its values at the corners. Boxes whose image a plane separates from the origin are
//! free of contact, the others are cut down to a minimal size. On small integers, primitives that
//! do not touch are farther apart than that size.

use exact_ccd::{CONTACT, ContactTime, EdgeEdge, Point, VertexFace};
use proptest::prelude::*;

use exact_ccd_testing::families::*;
use exact_ccd_testing::kinds::query;
use exact_ccd_testing::primitives::{Points, Primitives, at, combine, dot};
use exact_ccd_testing::runner::for_all;

/// An upper bound of all rounding errors.
const MARGIN: f64 = 1e-12;

/// The distance to the origin below which the image of a box counts as contact.
const SIZE: f64 = 1e-7;

/// An interval of each of t, u and v.
type Cuboid = [[f64; 2]; 3];

fn corners<K: Primitives>(points: &Points, cuboid: &Cuboid) -> [Point; 8] {
    let [times, us, vs] = cuboid;
    let ends = times.map(|t| at(points, t));
    [0, 1, 2, 3, 4, 5, 6, 7].map(|i: usize| combine(K::weights(us[i / 2 % 2], vs[i % 2]), ends[i / 4]))
}

/// Returns true if all points are beyond a plane through the origin, across an axis or across the
/// direction of their center.
fn are_beyond_a_plane(points: &[Point; 8]) -> bool {
    let center = combine([0.125; 8], *points);
    let directions = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], center];
    directions.iter().any(|&direction| {
        let heights = points.map(|point| dot(point, direction));
        heights.iter().all(|&height| height > MARGIN) || heights.iter().all(|&height| height < -MARGIN)
    })
}

/// The extent of the image along each of t, u and v.
fn extents(corners: &[Point; 8]) -> [f64; 3] {
    let distance = |i: usize, j: usize| {
        let difference = combine([1.0, -1.0], [corners[i], corners[j]]);
        dot(difference, difference).sqrt()
    };
    [4, 2, 1].map(|stride: usize| {
        (0..8)
            .filter(|i| i & stride == 0)
            .map(|i| distance(i, i + stride))
            .fold(0.0, f64::max)
    })
}

/// Returns true if there is contact in a box, up to the minimal size.
fn touches<K: Primitives>(points: &Points, cuboid: Cuboid) -> bool {
    let [_, [u, _], [v, _]] = cuboid;
    // If the lower corner is outside of the domain, so is the box.
    if !K::contains([u, v], 1.0) {
        return false;
    }
    let corners = corners::<K>(points, &cuboid);
    if are_beyond_a_plane(&corners) {
        return false;
    }
    let extents = extents(&corners);
    let widest = (1..3).fold(0, |best, i| if extents[i] > extents[best] { i } else { best });
    if extents[widest] < SIZE {
        return true;
    }
    let [low, high] = cuboid[widest];
    let middle = 0.5 * (low + high);
    [[low, middle], [middle, high]].into_iter().any(|half| {
        let mut part = cuboid;
        part[widest] = half;
        touches::<K>(points, part)
    })
}

fn touches_between<K: Primitives>(points: &Points, low: f64, high: f64) -> bool {
    low <= high && touches::<K>(points, [[low, high], [0.0, 1.0], [0.0, 1.0]])
}

fn contacts_are_the_reported_ones<K: Primitives>(points: &Points) {
    /// The time before and after an interval of contact at which the primitives are clearly apart.
    const NEAR: f64 = 1.0 / 64.0;
    let times = query::<K>(points).intervals(CONTACT);
    let mut free_from = 0.0;
    for interval in &times {
        let [start, end] = [interval.start, interval.end].map(ContactTime::lower);
        assert!(
            !touches_between::<K>(points, free_from, start - NEAR),
            "before {start}: {times:?}, {points:?}"
        );
        for time in [start, start.midpoint(end), end] {
            let (low, high) = ((time - SIZE).max(0.0), (time + SIZE).min(1.0));
            assert!(
                touches_between::<K>(points, low, high),
                "at {time}: {times:?}, {points:?}"
            );
        }
        free_from = end + NEAR;
    }
    assert!(
        !touches_between::<K>(points, free_from, 1.0),
        "after all: {times:?}, {points:?}"
    );
}

fn checked<K: Primitives>() {
    let points = prop_oneof![
        4 => small_integers(2),
        2 => small_integers(8),
        2 => degenerate(small_integers(2)),
        1 => exact_contacts::<K>(small_integers(8)),
    ];
    for_all(10_000, points, |points| {
        contacts_are_the_reported_ones::<K>(&points);
    });
}

#[test]
fn finds_the_contacts_of_a_vertex_and_a_face() {
    checked::<VertexFace>();
}

#[test]
fn finds_the_contacts_of_edges() {
    checked::<EdgeEdge>();
}
