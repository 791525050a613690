//! F at the corners of the domain, along curves.

use super::motion::difference;
use super::polynomial::MOST;
use super::relative::Relative;
use crate::numbers::number::Lanes;
use crate::numbers::roundoff::{LARGEST, UNIT, margin};
use crate::tables::{Point, Tables};

/// F at the corners of the domain of (u, v), times a weight w that is positive in the step: Bézier curves,
/// whose first ones count.
#[derive(Clone, Copy)]
pub(super) struct Curves {
    /// The control points of each corner.
    pub(super) corners: [[Point; MOST]; 4],
    /// The control points of w.
    pub(super) weight: [f64; MOST],
    /// The number of control points.
    pub(super) points: usize,
    /// The number of corners.
    pub(super) count: usize,
}

/// Curves with the bounds of their errors, which also hold in each part of the step.
pub(super) struct Corners {
    pub(super) curves: Curves,
    /// A bound of the magnitudes that are added up to a control point, on each axis.
    pub(super) magnitude: Point,
    /// The same for w.
    pub(super) weight_magnitude: f64,
    /// The largest number of roundings of a control point.
    pub(super) roundings: u32,
}

/// A floor of magnitudes, 2⁻⁷⁰⁰: the error that it adds, 2⁻⁷⁵², is above all that underflows in a control
/// point, which is below 2⁻⁸⁰⁰ (`relative.rs`).
const FLOOR: f64 = f64::from_bits((1023 - 700) << 52);

impl Corners {
    /// The corners of points on Bézier curves, given their control points in order: each difference is
    /// rounded once.
    pub(super) fn along<K: Tables>(control: impl ExactSizeIterator<Item = [Point; 4]>) -> Option<Self> {
        let mut curves = Curves::new::<K>(control.len())?;
        curves.weight = [1.0; MOST];
        for (k, points) in control.enumerate() {
            for (curve, &((i, j), _)) in curves.corners.iter_mut().zip(K::FEATURES.vertices) {
                curve[k] = [0, 1, 2].map(|axis: usize| points[i][axis] - points[j][axis]);
            }
        }
        let magnitude = [0, 1, 2].map(|axis: usize| {
            let all = curves.corners[..curves.count]
                .iter()
                .flat_map(|curve| &curve[..curves.points]);
            all.fold(FLOOR, |most, point| most.max(point[axis].abs()))
        });
        Self {
            curves,
            magnitude,
            weight_magnitude: 1.0,
            roundings: 1,
        }
        .in_range()
    }

    /// The corners of points of two bodies, in the coordinates of the second one, where its points are at
    /// rest.
    pub(super) fn of_bodies<K: Tables>(points: &[Point; 4], relative: &Relative) -> Option<Self> {
        let mut curves = Curves::new::<K>(relative.coefficients.len())?;
        for (k, motion) in relative.coefficients.iter().enumerate() {
            curves.weight[k] = motion.weight;
            for (curve, &((i, j), _)) in curves.corners.iter_mut().zip(K::FEATURES.vertices) {
                curve[k] = difference(motion, points[i], points[j]);
            }
        }
        // |M v| + |c| + w |x|, on each axis.
        let second = K::CORNERS[0].1;
        let largest = |points: &[Point], axis: usize| {
            points
                .iter()
                .fold(0.0, |most: f64, point| most.max(point[axis].abs()))
        };
        let moving = &points[..second];
        let moving = largest(moving, 0) + largest(moving, 1) + largest(moving, 2);
        let magnitude = [0, 1, 2].map(|axis: usize| {
            let resting = largest(&points[second..], axis);
            (moving + resting) * relative.turn_magnitude + relative.shift_magnitude[axis] + FLOOR
        });
        Self {
            curves,
            magnitude,
            weight_magnitude: relative.turn_magnitude,
            roundings: relative.roundings,
        }
        .in_range()
    }

    /// The corners, if they are in the range of the filters. A magnitude may be far above the coordinates,
    /// but by no factor above 2¹⁰.
    fn in_range(self) -> Option<Self> {
        let is_in_range = self.magnitude.iter().all(|&x| x <= LARGEST);
        is_in_range.then_some(self)
    }

    /// The bound of the error of values with more roundings, in units of their magnitudes.
    pub(super) fn error(&self, more: u32) -> f64 {
        margin(self.roundings + more) * UNIT
    }
}

impl Curves {
    fn new<K: Tables>(points: usize) -> Option<Self> {
        (points <= MOST).then_some(Self {
            corners: [[[0.0; 3]; MOST]; 4],
            weight: [0.0; MOST],
            points,
            count: K::FEATURES.vertices.len(),
        })
    }

    /// The control points of a corner.
    pub(super) fn corner(&self, corner: usize) -> &[Point] {
        &self.corners[corner][..self.points]
    }

    /// The control points of all corners.
    pub(super) fn all(&self) -> impl Iterator<Item = &Point> {
        let corners = self.corners[..self.count].iter();
        corners.flat_map(|curve| &curve[..self.points])
    }

    /// The curves in both halves of the step, by de Casteljau's scheme. A control point of a half has one
    /// rounding for each degree more: halves are exact, but for what underflows.
    pub(super) fn halves(&self) -> [Self; 2] {
        let mut halves = [*self; 2];
        let [left, right] = &mut halves;
        for corner in 0..self.count {
            for axis in 0..3 {
                let row = self.corners[corner].map(|point| point[axis]);
                let split = halved(row, self.points);
                for (half, row) in [&mut *left, &mut *right].into_iter().zip(split) {
                    for (point, x) in half.corners[corner].iter_mut().zip(row) {
                        point[axis] = x;
                    }
                }
            }
        }
        [left.weight, right.weight] = halved(self.weight, self.points);
        halves
    }
}

/// The control points of both halves of a curve.
#[inline(always)]
pub(super) fn halved<T: Lanes>(mut row: [T; MOST], count: usize) -> [[T; MOST]; 2] {
    let mut left = row;
    // Row by row, the first points belong to the left half, and the last ones to the right half.
    for (level, first) in left.iter_mut().enumerate().take(count).skip(1) {
        for k in 0..count - level {
            row[k] = (row[k] + row[k + 1]) * 0.5;
        }
        *first = row[0];
    }
    [left, row]
}
