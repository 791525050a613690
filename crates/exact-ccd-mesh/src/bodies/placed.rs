//! Bodies at both ends of a part of the step, and how far from straight motion they are in between.

use std::ops::{Add, Mul};

use arrayvec::ArrayVec;
use exact_ccd::Point;
use exact_ccd::motion::{Chain, RigidMotion};

use super::part::Part;
use super::sphere::length;
use super::turning::Turning;
use crate::vector::{dot, minus, product};

/// Squares of coordinates of this size do not overflow: 2⁴⁰⁰.
const LARGEST: f64 = f64::from_bits((1023 + 400) << 52);

const TWO_TO_MINUS_43: f64 = f64::from_bits((1023 - 43) << 52);

/// A body in the coordinates of the world, in a part of the step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed {
    ends: [Placement; 2],
    /// A bound of the distance of each point at each time from the point on the chord of its path at the same
    /// time, without the errors of the ends.
    pub(super) deviation: f64,
    /// A bound of the distance of all points at all times from the origin.
    pub(super) far: f64,
    /// A bound of the errors of the ends, and of distances that are computed from them (`approach.rs`).
    pub(super) error: f64,
}

/// The place of v is M v + c.
#[derive(Clone, Copy, Debug)]
struct Placement {
    turn: [Point; 3],
    shift: Point,
    /// The bound of the error of a place, in units of the reach.
    error: f64,
}

impl Placed {
    /// The body with a motion, whose points are within `reach` of its origin.
    pub(super) fn new(motion: &Chain, reach: f64, part: Part) -> Self {
        let motions = motion.motions();
        let far = motions.iter().map(|motion| farthest(motion.places()));
        let far = far.sum::<f64>() + reach;
        let ends = [part.start, part.end].map(|time| Placement::at(motions, time));
        let error = (ends[0].error.max(ends[1].error) + TWO_TO_MINUS_43) * far;
        Self {
            ends,
            deviation: 1.001 * deviation(motions, reach, part),
            far,
            // Also if it is not a number.
            error: if far <= LARGEST { error } else { f64::INFINITY },
        }
    }

    /// The places of a point at both ends.
    #[inline]
    pub(super) fn at_ends(&self, point: Point) -> [Point; 2] {
        [self.at(point, 0), self.at(point, 1)]
    }

    /// The place of a point at one end.
    #[inline]
    pub(super) fn at(&self, point: Point, end: usize) -> Point {
        self.ends[end].place(point)
    }

    /// A direction of the world at one end, in the coordinates of the body.
    pub(super) fn turned_back(&self, direction: Point, end: usize) -> Point {
        turned_back(self.ends[end].turn, direction)
    }
}

/// The product of a transposed matrix and a direction, in numbers of any kind.
pub(super) fn turned_back<T>(turn: [[T; 3]; 3], direction: [T; 3]) -> [T; 3]
where
    T: Copy + Add<Output = T> + Mul<Output = T>,
{
    [0, 1, 2].map(|k: usize| product(direction, turn.map(|row| row[k])))
}

impl Placement {
    /// The place at a time.
    ///
    /// The errors of rotations add up, each times the reach. The rest is a product of at most eight matrices
    /// with rows of length 1, and a sum of as many places: less than 32 roundings for each motion, on terms
    /// that sum up to the reach, and so below 8 · 32 · 2⁻⁵² = 2⁻⁴⁴ of it.
    fn at(motions: &[RigidMotion], time: f64) -> Self {
        let rest = Self {
            turn: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            shift: [0.0; 3],
            error: TWO_TO_MINUS_43,
        };
        motions.iter().fold(rest, |base, motion| {
            let rotation = Turning::new(motion.quaternions()).rotation(time);
            let column = |k: usize| [0, 1, 2].map(|i: usize| rotation.matrix[i][k]);
            Self {
                turn: base.turn.map(|row| [0, 1, 2].map(|k: usize| dot(row, column(k)))),
                shift: base.place(on_curve(motion.places(), time)),
                error: base.error + 1.1 * rotation.error,
            }
        })
    }

    #[inline]
    fn place(&self, point: Point) -> Point {
        [0, 1, 2].map(|axis: usize| dot(self.turn[axis], point) + self.shift[axis])
    }
}

/// The bound of the deviation from chords, for points within `reach` of the origin.
///
/// A path y deviates from its chord by at most max |y″| / 8, the unit of time being the part. From the last
/// motion of the chain to the first, y = o + R x for the path x before, |R| = 1, and with bounds ω and α of
/// the angular velocity and acceleration, |y| ≤ |o| + |x|, |y′| ≤ |o′| + ω |x| + |x′| and
/// |y″| ≤ |o″| + (ω² + α) |x| + 2 ω |x′| + |x″|. R x and its chord stay within |x| of 0 in any case: its
/// deviation is at most 2 |x|. The errors of differences of places, below 2⁻⁴⁸ of them, are in
/// [`Placed::error`].
fn deviation(motions: &[RigidMotion], reach: f64, part: Part) -> f64 {
    let (mut far, mut speed, mut acceleration, mut deviation) = (reach, 0.0, 0.0, 0.0);
    for motion in motions.iter().rev() {
        let turn = Turning::new(motion.quaternions()).speeds(part);
        let [omega, alpha] = turn.unwrap_or([f64::INFINITY; 2]);
        let [of_place, bend] = derivatives(motion.places(), part.length());
        let turned = (omega * omega + alpha) * far + 2.0 * omega * speed + acceleration;
        // The minimum with what is not a number is the other number.
        deviation = bend / 8.0 + (turned / 8.0).min(2.0 * far);
        acceleration = bend + turned;
        speed += of_place + omega * far;
        far += farthest(motion.places());
    }
    deviation
}

/// Bounds of the first and of the second derivative of a Bézier curve in a part of the step of this length.
fn derivatives(control: &[Point], duration: f64) -> [f64; 2] {
    let differences = |points: &[Point]| -> Vec<Point> {
        let pairs = points.windows(2);
        pairs.map(|pair| minus(pair[1], pair[0])).collect()
    };
    let degree = control.len() as f64 - 1.0;
    let first = differences(control);
    let second = differences(&first);
    [
        degree * duration * farthest(&first),
        degree * (degree - 1.0) * duration * duration * farthest(&second),
    ]
}

/// The point of a Bézier curve at a time.
fn on_curve(control: &[Point], time: f64) -> Point {
    let mut row: ArrayVec<Point, 4> = control.iter().copied().collect();
    while row.len() > 1 {
        for k in 1..row.len() {
            row[k - 1] = [0, 1, 2].map(|axis: usize| (1.0 - time) * row[k - 1][axis] + time * row[k][axis]);
        }
        row.pop();
    }
    row.first().copied().unwrap_or_default()
}

/// The largest distance of points from 0.
fn farthest(points: &[Point]) -> f64 {
    let lengths = points.iter().map(|&point| length(point));
    lengths.fold(0.0, |most: f64, x| if x <= most { most } else { x })
}
