//! Trajectories by functions of the caller.

use crate::trajectory::{Position, Trajectory};

/// A trajectory by two functions of the caller: the position at a time, and the bound of the
/// deviation from the chord between two times; see [`Trajectory`].
///
/// ```
/// use exact_ccd_curved::{FromFunctions, Position, Trajectory};
///
/// // (t, t³, 0) for t as it is: |x″| ≤ 6 end, and the cube has two rounding errors.
/// let cubic = FromFunctions {
///     position: |t: f64| Position { point: [t, t * t * t, 0.0], error: 4.0 * f64::EPSILON },
///     deviation: |start: f64, end: f64| 6.0 * end * (end - start) * (end - start) / 7.0,
/// };
/// assert_eq!(cubic.at(0.5).point, [0.5, 0.125, 0.0]);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct FromFunctions<P, D> {
    /// x(t) with its error.
    pub position: P,
    /// The bound for the times from the first to the second argument.
    pub deviation: D,
}

impl<P: Fn(f64) -> Position, D: Fn(f64, f64) -> f64> Trajectory for FromFunctions<P, D> {
    fn at(&self, time: f64) -> Position {
        (self.position)(time)
    }

    fn deviation(&self, start: f64, end: f64) -> f64 {
        (self.deviation)(start, end)
    }
}
