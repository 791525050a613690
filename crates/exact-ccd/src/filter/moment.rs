//! Moments of a step, and the signs of quadratics there, from exact coefficients.

use core::cmp::Ordering;

use super::cubic::Root;
use super::roundoff::{UNIT, certain_sign};
use super::wide::Wide;

/// q₀ (1−t)² + m (1−t) t + q₁ t², as [q₀, m, q₁].
pub(super) type Quadratic<const N: usize> = [Wide<N>; 3];

/// A time or an interval of times.
#[derive(Clone, Debug)]
pub(crate) enum Moment {
    /// t = 0.
    Start,
    /// All times after 0 up to some time: as many as needed.
    Soon,
    /// All times after 0.
    Later,
    /// The root in a bracket.
    Root(Root),
    /// t = 1.
    End,
}

impl Moment {
    /// The sign of a quadratic, if it is certain and the same for all times of the moment.
    ///
    /// Soon after t = 0, (1−t)², (1−t) t and t² are positive, and each of them is as much larger than the
    /// next as needed: the first coefficient that is not zero has the sign. Later, all three remain
    /// positive but for the first two at t = 1: coefficients without two opposite signs have one sign in
    /// all of (0, 1], if the last is not zero.
    pub(super) fn sign<const N: usize>(&self, quadratic: &Quadratic<N>) -> Option<Ordering> {
        let [first, _, last] = quadratic;
        match self {
            Self::Start => Some(first.sign()),
            Self::End => Some(last.sign()),
            Self::Root(root) => near(quadratic, root),
            Self::Soon => Some(leading(quadratic)),
            Self::Later => {
                let leading = leading(quadratic);
                let opposite = leading.reverse();
                let is_constant = quadratic.iter().all(|q| leading.is_eq() || q.sign() != opposite);
                (is_constant && (leading.is_eq() || !last.is_zero())).then_some(leading)
            }
        }
    }
}

/// The sign of the first coefficient that is not zero.
fn leading<const N: usize>(coefficients: &[Wide<N>]) -> Ordering {
    let mut signs = coefficients.iter().map(Wide::sign);
    signs.find(|sign| sign.is_ne()).unwrap_or(Ordering::Equal)
}

/// The sign of a quadratic in a bracket, if it is certain.
///
/// With M = |q₀| + |m| + |q₁|, which bounds its values in [0, 1], the quadratic changes by at most 4 M
/// times the distance from `near`. The value there results from at most 10 roundings: that of the
/// coefficient, 1 − t twice, two products twice, two sums; n = 10. The integers are at least 1, so that
/// what underflows is far below the bound.
fn near<const N: usize>(quadratic: &Quadratic<N>, root: &Root) -> Option<Ordering> {
    if quadratic.iter().all(Wide::is_zero) {
        return Some(Ordering::Equal);
    }
    let [q0, m, q1] = quadratic.map(|q| q.approximate().high);
    let (t, s) = (root.near, 1.0 - root.near);
    let value = (q0 * s + m * t) * s + q1 * t * t;
    let radius = (root.high - root.near).max(root.near - root.low);
    certain_sign(
        value,
        (q0.abs() + m.abs() + q1.abs()) * (5.0 * radius + 16.0 * UNIT),
    )
}
