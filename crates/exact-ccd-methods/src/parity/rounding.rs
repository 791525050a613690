//! Input rounded so that the corner differences of F are exact (section 4.2 of the paper).
//!
//! By Sterbenz's lemma x − y is exact if y / 2 ≤ x ≤ 2 y. A pair a ≤ b that violates this condition
//! is moved to the right by e = RU(b − 2a), the difference rounded up: then b + e ≤ 2 (a + e), and
//! since rounding is monotone and commutes with doubling, the same holds for the rounded
//! coordinates fl(a + e) and fl(b + e). The shift is the only place where input is changed, by at
//! most half a unit in the last place of the shifted coordinate.

use exact_ccd::{Axis, Kind, NonFinite, Point, Query, environment};

use super::Parity;
use super::expansion::Expansion;
use super::floats::Floats;
use super::image::Domain;
use super::rational::rational;
use super::ray::parity;
use crate::vector::minus;

/// The shift of all points along each axis that makes their differences exact.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Displacement(Point);

/// Sterbenz's condition, for numbers of either sign.
#[inline]
fn is_near(a: f64, b: f64) -> bool {
    ((b <= 2.0 * a) & (a <= 2.0 * b)) | ((b >= 2.0 * a) & (a >= 2.0 * b))
}

/// b − 2a, rounded up; infinite if it overflows.
#[inline]
fn least_shift(a: f64, b: f64) -> f64 {
    let doubled = 2.0 * a;
    if doubled.is_finite() {
        round_up_difference(b, doubled)
    } else {
        // Unless b − 2a overflows too, b is so large that half of it is exact.
        2.0 * round_up_difference(0.5 * b, a)
    }
}

/// a − b, rounded up; infinite if it overflows.
#[inline]
fn round_up_difference(a: f64, b: f64) -> f64 {
    let (difference, error) = exact_sum(a, -b);
    if error > 0.0 {
        difference.next_up()
    } else {
        difference
    }
}

/// a + b as fl(a + b) and the rounding error (Dekker). Unless the sum overflows, no intermediate
/// result does.
#[inline]
fn exact_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let (large, small) = if a.abs() < b.abs() { (b, a) } else { (a, b) };
    (sum, small - (sum - large))
}

/// The displacement of pairs of coordinates. If one of them needs a shift, all are shifted, and by
/// enough for each.
#[inline(always)]
fn displacement(pairs: &[[f64; 2]]) -> f64 {
    if pairs.iter().fold(true, |all, &[a, b]| all & is_near(a, b)) {
        return 0.0;
    }
    let ordered = pairs.iter().map(|&[a, b]| if a < b { (a, b) } else { (b, a) });
    let greater = |a: f64, b: f64| if b > a { b } else { a };
    // Rounding is monotone: the largest shift rounded up is the largest one rounded to nearest or,
    // if that is too small for one of the pairs that attain it, the next f64.
    let shift = ordered
        .clone()
        .map(|(lower, upper)| upper - 2.0 * lower)
        .fold(f64::NEG_INFINITY, greater);
    if !shift.is_finite() {
        return largest_shift(ordered);
    }
    let is_short = ordered.fold(false, |short, (lower, upper)| {
        let (difference, error) = exact_sum(upper, -2.0 * lower);
        short | ((difference == shift) & (error > 0.0))
    });
    if is_short { shift.next_up() } else { shift }
}

/// The largest of the shifts, where some of them, or 2a on the way to them, are out of range.
#[cold]
fn largest_shift(ordered: impl Iterator<Item = (f64, f64)>) -> f64 {
    ordered
        .map(|(lower, upper)| least_shift(lower, upper))
        .fold(f64::NEG_INFINITY, f64::max)
}

impl Displacement {
    /// The displacement for pairs of finite points whose differences are to be exact.
    #[must_use]
    pub fn of_pairs(pairs: &[[Point; 2]]) -> Self {
        let along = |axis: usize| pairs.iter().map(move |pair| pair.map(|point| point[axis]));
        Self([0, 1, 2].map(|axis| displacement(&along(axis).collect::<Vec<_>>())))
    }

    /// The displacement for all pairs of points in the box between two finite corners, such as the box of a
    /// simulation.
    #[must_use]
    pub fn of_box(lower: Point, upper: Point) -> Self {
        Self::of_pairs(&[[lower, upper]])
    }

    /// The displacement for the corner differences of a query.
    #[must_use]
    #[inline]
    pub fn of_query<K: Kind<Points = [Point; 4]>>(query: &Query<K>) -> Self {
        let mut axes = [[[0.0; 2]; 8]; 3];
        for (corner, [a, b]) in Domain::of::<K>().pairs(query).iter().enumerate() {
            for (axis, pairs) in axes.iter_mut().enumerate() {
                pairs[corner] = [a[axis], b[axis]];
            }
        }
        let [x, y, z] = &axes;
        Self([displacement(x), displacement(y), displacement(z)])
    }

    /// The displacements along x, y and z. Infinite where the coordinates are too far apart to be shifted.
    #[must_use]
    pub fn along_axes(self) -> Point {
        self.0
    }

    /// The shifted and rounded point.
    #[must_use]
    #[inline]
    pub fn apply(self, point: Point) -> Point {
        [0, 1, 2].map(|axis: usize| point[axis] + self.0[axis])
    }

    /// The shifted and rounded query.
    #[inline]
    pub(super) fn shift<K: Kind<Points = [Point; 4]>>(
        self,
        query: &Query<K>,
    ) -> Result<Query<K>, RoundingError> {
        if self == Self::default() {
            return Ok(*query);
        }
        let [start, end] = query.points().map(|points| points.map(|point| self.apply(point)));
        let out_of_range = |NonFinite { axis, .. }| RoundingError::OutOfRange { axis };
        Query::new(start, end).map_err(out_of_range)
    }

    /// The shifted and rounded points.
    ///
    /// The displacement of the box around all frames of a simulation serves every one of them:
    ///
    /// ```
    /// use exact_ccd_methods::parity::Displacement;
    ///
    /// let frame = |x: f64| [[0.0, 1.0, 0.1], [x, 1.0, 0.1]];
    /// let frames = [frame(0.1), frame(0.2), frame(0.3)];
    /// let displacement = Displacement::of_box([0.0, 1.0, 0.1], [0.3, 1.0, 0.1]);
    /// assert_eq!(displacement.along_axes(), [0.3, 0.0, 0.0]);
    /// assert_eq!(displacement.apply_to_all(&frames[0])?, [[0.3, 1.0, 0.1], [0.4, 1.0, 0.1]]);
    /// # Ok::<(), exact_ccd_methods::parity::RoundingError>(())
    /// ```
    ///
    /// # Errors
    /// [`RoundingError::OutOfRange`] names the axis along which a shifted coordinate would not be finite.
    pub fn apply_to_all(self, points: &[Point]) -> Result<Vec<Point>, RoundingError> {
        let shift = |&point: &Point| {
            let shifted = self.apply(point);
            let overflows = |axis: &Axis| !shifted[axis.index()].is_finite();
            match Axis::ALL.iter().copied().find(overflows) {
                None => Ok(shifted),
                Some(axis) => Err(RoundingError::OutOfRange { axis }),
            }
        };
        points.iter().map(shift).collect()
    }

    /// The magnitude of the rounding error along each axis: |x + e − fl(x + e)|, exactly. Not
    /// finite where the shift overflows.
    #[must_use]
    pub fn error(self, point: Point) -> Point {
        [0, 1, 2].map(|axis: usize| exact_sum(point[axis], self.0[axis]).1.abs())
    }
}

/// A query whose corner differences, the values of F at the corners of its domain, are exactly f64.
///
/// The only constructors are a shift ([`Rounded::shift`]) and a check ([`Rounded::check`]).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rounded<K: Kind> {
    query: Query<K>,
    corners: [Point; 8],
}

/// A query is not [`Rounded`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RoundingError {
    /// The difference of two coordinates is not exactly an f64.
    #[error(
        "on the {axis} axis, points {} and {} at t = {time} have an inexact difference",
        .points[0],
        .points[1]
    )]
    Inexact {
        /// The end of the time step, 0 or 1.
        time: usize,
        /// The indices of the two points among the four, from 0.
        points: [usize; 2],
        /// The axis of the coordinates.
        axis: Axis,
    },
    /// The coordinates are too far apart to be shifted within the range of f64.
    #[error("on the {axis} axis, the coordinates are too large to be shifted")]
    OutOfRange {
        /// The axis of the coordinates.
        axis: Axis,
    },
}

impl<K: Kind<Points = [Point; 4]>> Rounded<K> {
    /// The query, shifted by its own displacement and rounded.
    ///
    /// # Errors
    /// [`RoundingError::OutOfRange`] if a shifted coordinate would overflow.
    #[inline]
    pub fn shift(query: &Query<K>) -> Result<Self, RoundingError> {
        let displacement = Displacement::of_query(query);
        Ok(Self::of(displacement.shift(query)?))
    }

    /// The query without a shift, if all corner differences are exact: as in a scene that was
    /// shifted as a whole, or with small integers.
    ///
    /// # Errors
    /// [`RoundingError::Inexact`] names the first difference that is not.
    pub fn check(query: Query<K>) -> Result<Self, RoundingError> {
        for (time, points) in query.points().iter().enumerate() {
            for (i, j) in Domain::of::<K>().corners {
                for &axis in Axis::ALL {
                    let [a, b] = [points[i], points[j]].map(|point| point[axis.index()]);
                    let (difference, error) = exact_sum(a, -b);
                    if !(difference.is_finite() && error == 0.0) {
                        let points = [i, j];
                        return Err(RoundingError::Inexact { time, points, axis });
                    }
                }
            }
        }
        Ok(Self::of(query))
    }

    /// A query whose corner differences are exact.
    #[inline]
    fn of(query: Query<K>) -> Self {
        let mut corners = [[0.0; 3]; 8];
        for (corner, [a, b]) in corners.iter_mut().zip(&Domain::of::<K>().pairs(&query)) {
            *corner = minus(a, b);
        }
        Self { query, corners }
    }

    /// The query, with rounded coordinates.
    #[must_use]
    pub fn query(&self) -> &Query<K> {
        &self.query
    }

    /// The parity of the number of contacts of the rounded query.
    #[must_use]
    pub fn parity(&self) -> Parity {
        let corners = &self.corners;
        if !environment::is_default() {
            return rational(&self.query);
        }
        if !Expansion::can_hold(corners) {
            return rational(&self.query);
        }
        if are_beyond_diagonal(corners) {
            return Parity::Even;
        }
        let mut pairs = [[[0.0; 3]; 2]; 8];
        for ([corner, _], exact) in pairs.iter_mut().zip(corners) {
            *corner = *exact;
        }
        parity(Domain::of::<K>(), &pairs, |ray| Floats::new(corners, ray))
    }
}

/// Returns true if all points are strictly on one side of a plane x = ±y, y = ±z or z = ±x. Comparisons are
/// exact.
#[inline]
fn are_beyond_diagonal(points: &[Point; 8]) -> bool {
    [[0, 1], [1, 2], [2, 0]].into_iter().any(|[i, j]| {
        let sides = points.iter().fold([true; 4], |[a, b, c, d], point| {
            let (x, y) = (point[i], point[j]);
            [a & (x > y), b & (x < y), c & (x > -y), d & (x < -y)]
        });
        sides != [false; 4]
    })
}
