//! The trajectory of a point, and its chords.

use exact_ccd::Point;
use exact_ccd_mesh::vector::minus;

use crate::error::SearchError;
use crate::rounding::{above, length};

/// A position, up to an error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Position {
    /// The computed position.
    pub point: Point,
    /// The exact position is at most this far from it.
    pub error: f64,
}

impl Position {
    /// A position without error.
    #[must_use]
    pub fn exactly(point: Point) -> Self {
        Self { point, error: 0.0 }
    }
}

/// The motion of one point on a curve x(t), for t from 0 to 1.
///
/// Every answer of this crate is about the exact curve and rests on these two bounds: if they hold,
/// it is certain. Both may be infinite where nothing better is known. In a [step of a
/// mesh](crate::curved_step), an interval of times with an infinite bound is an error. NaN or a negative
/// number is an error of every search.
pub trait Trajectory {
    /// x(t), for t in [0, 1].
    fn at(&self, time: f64) -> Position;

    /// A bound of the deviation of the curve from its chord over the times from `start` to `end`:
    /// of |x(start + τ (end − start)) − ((1 − τ) x(start) + τ x(end))| for all τ in [0, 1].
    ///
    /// Both points belong to the same relative time τ, so the bound covers a difference in speed. It
    /// is about exact positions, and the caller adds the errors of [`at`](Self::at).
    fn deviation(&self, start: f64, end: f64) -> f64;
}

impl<T: Trajectory + ?Sized> Trajectory for &T {
    fn at(&self, time: f64) -> Position {
        (**self).at(time)
    }

    fn deviation(&self, start: f64, end: f64) -> f64 {
        (**self).deviation(start, end)
    }
}

impl<T: Trajectory + ?Sized> Trajectory for Box<T> {
    fn at(&self, time: f64) -> Position {
        (**self).at(time)
    }

    fn deviation(&self, start: f64, end: f64) -> f64 {
        (**self).deviation(start, end)
    }
}

/// A straight motion between two points in f64, near a curve.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Chord {
    pub(crate) ends: [Point; 2],
    /// The curve is at most this far from the point on the chord, at the same relative time.
    pub(crate) deviation: f64,
}

impl Chord {
    /// The chord of a trajectory.
    ///
    /// Let the exact ends x(s), x(e) have the computed positions p, q with errors a, b. At relative
    /// time τ the exact chord and the chord from p to q differ by at most (1 − τ) a + τ b ≤ max(a,
    /// b). So the curve is within the deviation + max(a, b).
    ///
    /// # Errors
    /// [`SearchError::Environment`] of the thread that computes it.
    pub(crate) fn of(trajectory: &impl Trajectory, start: f64, end: f64) -> Result<Self, SearchError> {
        SearchError::check_environment()?;
        let ends = [trajectory.at(start), trajectory.at(end)];
        let [a, b] = ends.map(|position| position.error);
        let bounds = [trajectory.deviation(start, end), a, b];
        let deviation = if bounds.iter().any(|x| x.is_nan() || *x < 0.0) {
            f64::NAN
        } else if bounds == [0.0; 3] {
            0.0
        } else {
            above(bounds[0] + a.max(b))
        };
        let ends = ends.map(|position| position.point);
        Ok(Self { ends, deviation })
    }

    /// Checks the bounds of chords.
    ///
    /// # Errors
    /// [`SearchError::Bound`] of the first one whose deviation is NaN.
    pub(crate) fn check(chords: &[Self], start: f64, end: f64) -> Result<(), SearchError> {
        match chords.iter().position(|chord| chord.deviation.is_nan()) {
            Some(point) => Err(SearchError::Bound { point, start, end }),
            None => Ok(()),
        }
    }

    /// A bound of the length of the chord.
    pub(crate) fn length(&self) -> f64 {
        let [p, q] = self.ends;
        above(length(minus(q, p)))
    }
}

/// A bound of the deviation of a curve whose acceleration x″ has at most this length.
///
/// With h = end − start and relative time τ, the deviation from the chord is the integral of
/// −G(τ, σ) h² x″ over σ in [0, 1], where G(τ, σ) = min(τ, σ) (1 − max(τ, σ)) ≥ 0 is Green's function
/// of the second derivative. The integral of G is τ (1 − τ) / 2 ≤ 1/8. So the deviation is at most
/// h² |x″| / 8, for vectors as for numbers.
pub(crate) fn deviation_by_acceleration(acceleration: f64, start: f64, end: f64) -> f64 {
    if acceleration == 0.0 {
        return 0.0;
    }
    let duration = end - start;
    // In this order, no underflow is amplified.
    above(0.125 * duration * (duration * acceleration))
}
