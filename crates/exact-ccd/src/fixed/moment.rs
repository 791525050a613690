//! Moments of a step, and the signs of quadratics q₀ (1−t)² + q₁ (1−t) t + q₂ t² there, from their exact
//! coefficients.

use core::cmp::Ordering;

use super::fraction::Fraction;
use super::length::Area;
use super::quadratic_root::QuadraticRoot;
use super::window::{Window, quadratic_sign_at};
use crate::numbers::cubic::Root;
use crate::numbers::number::Lanes;
use crate::numbers::roundoff::{UNIT, certain_sign, margin};
use crate::numbers::vector::interpolate;

/// A time or an interval of times.
#[derive(Clone, Debug)]
pub(crate) enum Moment {
    /// A time.
    At(Fraction),
    /// All times after 0.
    Later,
    /// The root in a bracket of a window.
    Root(Window, Root),
    /// A root of a quadratic, where the cubic vanishes at all times.
    QuadraticRoot(QuadraticRoot),
}

impl Moment {
    /// The sign of the quadratic with these coefficients, if it is certain and the same for all times of the
    /// moment. Only the coefficients that matter are computed.
    ///
    /// In (0, 1], (1−t)², (1−t) t and t² are positive, except the first two at t = 1. So the quadratic has
    /// one sign in all of (0, 1] if no two coefficients have opposite signs and the last is not zero.
    #[inline(always)]
    pub(super) fn sign<A: Area>(&self, coefficient: impl Fn(usize) -> A) -> Option<Ordering> {
        match self {
            Self::At(time) => Some(match time.weights() {
                [_, 0] => coefficient(0).sign(),
                [0, _] => coefficient(2).sign(),
                _ => quadratic_sign_at([0, 1, 2].map(coefficient), *time),
            }),
            Self::Root(window, root) => near([0, 1, 2].map(coefficient), window, root),
            Self::QuadraticRoot(of) => near([0, 1, 2].map(coefficient), &of.window, &of.root),
            Self::Later => {
                let last = coefficient(2).sign();
                let are_certain = (0..2).all(|i| {
                    let sign = coefficient(i).sign();
                    sign.is_eq() || sign == last
                });
                are_certain.then_some(last)
            }
        }
    }

    /// The sign of d₀ (1−t) + d₁ t at a root, for coefficients rounded once, if it is certain and not zero.
    ///
    /// The value results from n = 7 roundings: one of the coefficient, three of t, which its place in the
    /// window determines, one of 1 − t, one product and one sum. The error of t counts in 1 − t too: terms
    /// are at most 2 (|d₀| + |d₁|). The slope is at most |d₀| + |d₁|. The radius in time is the radius in
    /// the window times its width, with a factor of two for roundings.
    pub(crate) fn sign_of_linear(&self, [start, end]: [f64; 2]) -> Option<Ordering> {
        let (window, root) = match self {
            Self::Root(window, root) => (window, root),
            Self::QuadraticRoot(of) => (&of.window, &of.root),
            Self::At(_) | Self::Later => return None,
        };
        let t = window.time_at(root.near);
        let radius = window.width() * root.radius();
        certain_sign(
            interpolate(start, end, t),
            (start.abs() + end.abs()) * (2.0 * radius + margin(7) * UNIT),
        )
    }
}

/// The sign of a quadratic in a bracket, if it is certain.
///
/// With its coefficients in the window, M = |q₀| + |q₁| + |q₂| bounds its values in [0, 1], and 2 M its
/// slope −2 q₀ (1−t) + q₁ (1−2t) + 2 q₂ t. The value at `near` results from n = 7 roundings: one of the
/// coefficient, 1 − t twice, two products and two sums. The integers are at least 1, so that underflow
/// is far below the bound.
fn near<A: Area>(quadratic: [A; 3], window: &Window, root: &Root) -> Option<Ordering> {
    if quadratic.iter().all(|q| q.sign().is_eq()) {
        return Some(Ordering::Equal);
    }
    let quadratic = window.quadratic(quadratic);
    certain_sign(
        value_at(quadratic, root.near),
        error_near(quadratic, root.radius()),
    )
}

/// q₀ (1−t)² + q₁ (1−t) t + q₂ t².
#[inline(always)]
pub(crate) fn value_at<T: Lanes>([q0, q1, q2]: [T; 3], t: T) -> T {
    let s = -t + 1.0;
    (q0 * s + q1 * t) * s + q2 * t * t
}

#[inline(always)]
pub(crate) fn error_near<T: Lanes>([q0, q1, q2]: [T; 3], radius: T) -> T {
    (q0.abs() + q1.abs() + q2.abs()) * (radius * 5.0 + margin(7) * UNIT)
}
