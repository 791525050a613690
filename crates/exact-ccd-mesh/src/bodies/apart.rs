//! Primitives that a plane separates in a part of the step.

use arrayvec::ArrayVec;
use exact_ccd::Point;

use super::sphere::length;
use crate::vector::{cross, dot, minus};

/// The places of the vertices of a primitive at both ends of a part of the step.
pub(super) type Places = ArrayVec<[Point; 2], 3>;

/// The places up to a part of the time, from 0 to 1, on the way from the first to the second end.
pub(super) fn until(places: &Places, time: f64) -> Places {
    let at = |[a, b]: [Point; 2]| {
        [
            a,
            [0, 1, 2].map(|axis: usize| a[axis] + time * (b[axis] - a[axis])),
        ]
    };
    places.iter().map(|&ends| at(ends)).collect()
}

/// Returns true if two primitives are certainly farther apart than a margin while their vertices move in
/// straight lines between their places.
///
/// If a plane has one primitive on one side and the other one beyond a slab of this thickness, at both ends,
/// then parallel planes have at all times, since distances along the normal are linear in time. Scalar
/// products have errors below 2⁻⁵⁰ of the magnitudes, which are in the margin.
pub(super) fn are_apart(first: &Places, second: &Places, margin: f64) -> bool {
    let middle = |[a, b]: &[Point; 2]| [0, 1, 2].map(|axis: usize| 0.5 * (a[axis] + b[axis]));
    let [one, other] = [first, second].map(|p| p.iter().map(middle).collect::<ArrayVec<Point, 3>>());
    let between = minus(mean(&other), mean(&one));
    let directions = [Some(between), normal(&one, &other)];
    directions.into_iter().flatten().any(|direction| {
        let slab = margin * length(direction) * (1.0 + 1e-12);
        // Otherwise, products may underflow.
        let is_sound = dot(direction, direction) > 1e-200;
        let along = |places: &Places, end: usize| {
            let values = places.iter().map(move |ends| dot(direction, ends[end]));
            values.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], x| {
                [least.min(x), most.max(x)]
            })
        };
        let gaps = [0, 1].map(|end| {
            let ([a, b], [c, d]) = (along(first, end), along(second, end));
            [c - b, a - d]
        });
        is_sound && (0..2).any(|side| gaps.iter().all(|gap| gap[side] > slab))
    })
}

/// The normal of the face of a vertex and a face, or of two edges.
fn normal(one: &[Point], other: &[Point]) -> Option<Point> {
    match (one, other) {
        ([a, b, c], _) | (_, [a, b, c]) => Some(cross(minus(*b, *a), minus(*c, *a))),
        ([a, b], [c, d]) => Some(cross(minus(*b, *a), minus(*d, *c))),
        _ => None,
    }
}

fn mean(points: &[Point]) -> Point {
    let part = 1.0 / points.len() as f64;
    [0, 1, 2].map(|axis: usize| points.iter().map(|point| part * point[axis]).sum())
}
