//! The time of a simple contact, rounded, in twice the precision.

use alloc::vec::Vec;
use core::cmp::Ordering;

use arrayvec::ArrayVec;

use super::corners::Curves;
use super::counted::Counted;
use super::displacement::{Displacement, Turning};
use super::guess::Bracket;
use super::motion::difference;
use super::polynomial::MOST;
use super::twice::{Twice, on_curve};
use crate::numbers::double_double::{DoubleDouble, ROUNDOFF};
use crate::numbers::number::Number;
use crate::numbers::roundoff::{LARGEST, UNDERFLOW, certain_sign, margin};
use crate::numbers::vector::{cross, dot, minus};
use crate::tables::{Point, Tables};
use crate::values::ContactTime;

/// The most evaluations: a bisection of all f64 of an octave needs 53 from both ends.
const STEPS: u32 = 120;

/// The paths of the points of a query, at any time.
pub(super) trait Paths {
    /// The first three corners at a time, times a positive factor.
    fn corners<K: Tables>(&self, time: [Twice; 2]) -> [[Twice; 3]; 3];

    /// The largest magnitude of a coordinate.
    fn largest(&self) -> f64;
}

/// The time at which the volume of the first three corners changes its sign, given that it does so once
/// between two times, and its sign before that; and given the corners in f64. `None` if the time is an f64,
/// or so near to one that no sign is certain.
pub(super) fn of_root<K: Tables>(
    paths: &impl Paths,
    curves: &Curves,
    times: [f64; 2],
    before: Ordering,
) -> Option<ContactTime> {
    let largest = paths.largest();
    if largest > LARGEST {
        return None;
    }
    let mut bracket = Bracket::new(curves, times);
    let evaluate = |bracket: &mut Bracket, time: f64| {
        let value = volume::<K>(paths, time);
        bracket.add(time, value.value.high, sign(value, largest)? == before);
        Some(value.value.high)
    };
    // Of the root in f64, some last bits may be wrong. One step of Newton's method settles them.
    let guess = bracket.guess(curves);
    let value = evaluate(&mut bracket, guess)?;
    let below = bracket.newton(curves, guess, value);
    for time in [below, below.next_up()] {
        if bracket.contains(time) {
            evaluate(&mut bracket, time)?;
        }
    }
    for step in 0..STEPS {
        if let Some(low) = bracket.settled() {
            return Some(ContactTime::just_above(low));
        }
        let time = bracket.next(step);
        evaluate(&mut bracket, time)?;
    }
    None
}

/// c₀ · (c₁ × c₂) of the corners at a time.
fn volume<K: Tables>(paths: &impl Paths, t: f64) -> Twice {
    let s = Counted {
        value: DoubleDouble::difference(1.0, t),
        ..Counted::exactly(1.0 - t)
    };
    let [a, b, c] = paths.corners::<K>([s, Counted::exactly(t)]);
    dot(a, cross(b, c))
}

/// The sign of a volume, if it is certain.
///
/// Coordinates are at most 2²⁰⁰ and quaternions below 2: what underflows in a corner stays below 2⁻⁸⁰⁰, and
/// is multiplied by two other corners, each at most 2¹⁰ times the largest coordinate.
fn sign(volume: Twice, largest: f64) -> Option<Ordering> {
    const OF_CORNER: f64 = f64::from_bits((1023 - 770) << 52);
    let error = margin(volume.roundings) * ROUNDOFF * volume.magnitude;
    certain_sign(
        volume.value.high,
        error + largest * largest * OF_CORNER + UNDERFLOW,
    )
}

/// Points on Bézier curves, by their control points in order.
pub(super) struct OnCurves<'a>(pub(super) &'a [[Point; 4]]);

impl Paths for OnCurves<'_> {
    fn corners<K: Tables>(&self, time: [Twice; 2]) -> [[Twice; 3]; 3] {
        let points = [0, 1, 2, 3].map(|point: usize| {
            let control: ArrayVec<Point, MOST> = self.0.iter().map(|points| points[point]).collect();
            on_curve(&control, time)
        });
        core::array::from_fn(|corner| {
            let (i, j) = K::CORNERS[corner];
            minus(points[i], points[j])
        })
    }

    fn largest(&self) -> f64 {
        largest(self.0.as_flattened())
    }
}

/// Points of two bodies, in the coordinates of the second one.
pub(super) struct OfBodies<'a> {
    pub(super) points: &'a [Point; 4],
    pub(super) chains: &'a [Vec<Turning<f64>>; 2],
}

impl Paths for OfBodies<'_> {
    fn corners<K: Tables>(&self, time: [Twice; 2]) -> [[Twice; 3]; 3] {
        let [first, second] = self
            .chains
            .each_ref()
            .map(|chain| chain.iter().map(|motion| Displacement::at(motion, time)));
        let motion = Displacement::between(first, second).map(|displacement| displacement.motion());
        let points = self.points.map(|point| point.map(Counted::exactly));
        core::array::from_fn(|corner| {
            let (i, j) = K::CORNERS[corner];
            motion
                .as_ref()
                .map_or(points[i], |motion| difference(motion, points[i], points[j]))
        })
    }

    fn largest(&self) -> f64 {
        let places = self.chains.iter().flatten().map(|motion| largest(&motion.places));
        places.fold(largest(self.points), f64::max)
    }
}

fn largest(points: &[Point]) -> f64 {
    let coordinates = points.as_flattened().iter();
    coordinates.fold(0.0, |most, x| most.max(x.abs()))
}
