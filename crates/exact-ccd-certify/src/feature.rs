//! Directions of closest features at one time, in integers.
//!
//! They are the directions of [`direction`](crate::direction), without rounding: where primitives
//! almost touch, no rounded direction separates them. Directions orthogonal to an edge and an axis are
//! for primitives that touch at rest.

use dashu_int::IBig;
use exact_ccd_check::Pair;
use exact_ccd_check::motion::{Motion, Point, Time};
use exact_ccd_check::separation::dot;

/// All candidates at a time. The same features have the same places in the list at all times. Some
/// candidates may be 0.
pub(crate) fn directions(motion: &Motion, pair: &Pair<'_>, time: &Time) -> Vec<Point> {
    let points: Vec<Point> = pair.vertices().map(|vertex| motion.at(vertex, time)).collect();
    let (first, second) = points.split_at(pair.first.len());
    let corners: Vec<Point> = first
        .iter()
        .flat_map(|a| second.iter().map(move |b| minus(a, b)))
        .collect();
    let mut directions = Vec::new();
    for (i, p) in corners.iter().enumerate() {
        directions.push(p.clone());
        for (j, q) in corners.iter().enumerate().skip(i + 1) {
            let edge = minus(q, p);
            let (along, square) = (dot(p, &edge), dot(&edge, &edge));
            directions.push([0, 1, 2].map(|axis: usize| &square * &p[axis] - &along * &edge[axis]));
            for r in &corners[j + 1..] {
                push_both(&mut directions, cross(&edge, &minus(r, p)));
            }
        }
    }
    for (p, q) in corners.iter().zip(corners.iter().skip(1)) {
        for axis in 0..3 {
            let unit = [0, 1, 2].map(|k| IBig::from(u8::from(k == axis)));
            push_both(&mut directions, cross(&minus(q, p), &unit));
        }
    }
    directions
}

fn push_both(directions: &mut Vec<Point>, normal: Point) {
    directions.push([0, 1, 2].map(|axis: usize| -&normal[axis]));
    directions.push(normal);
}

/// Directions without their common powers of two.
pub(crate) fn reduced<const N: usize>(directions: [&Point; N]) -> [Point; N] {
    let zeros = directions
        .iter()
        .copied()
        .flatten()
        .filter_map(IBig::trailing_zeros)
        .min()
        .unwrap_or(0);
    directions.map(|direction| [0, 1, 2].map(|axis: usize| &direction[axis] >> zeros))
}

fn minus(a: &Point, b: &Point) -> Point {
    [0, 1, 2].map(|axis: usize| &a[axis] - &b[axis])
}

fn cross(a: &Point, b: &Point) -> Point {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
}
