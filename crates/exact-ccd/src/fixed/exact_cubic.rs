//! The coplanarity cubic in integers, for the times of its roots.

use core::cell::OnceCell;

use super::fraction::Fraction;
use super::lattice::Integers;
use super::length::Volume;
use super::moment::Moment;
use super::wide::Wide;
use super::window::{Window, sign_at};
use super::zeros::largest;
use crate::numbers::cubic::Root;
use crate::numbers::precise_cubic::PreciseCubic;
use crate::tables::{Points, Tables};
use crate::values::ContactTime;

/// c₀ (1−t)³ + c₁ (1−t)² t + c₂ (1−t) t² + c₃ t³, exactly, and in twice the precision where that is needed.
pub(crate) struct ExactCubic {
    coefficients: [Volume; 4],
    approximate: OnceCell<Approximate>,
}

/// A cubic in twice the precision.
struct Approximate {
    cubic: PreciseCubic,
    /// The coefficients, rounded.
    rounded: [f64; 4],
}

impl ExactCubic {
    pub(super) fn new(coefficients: [Volume; 4]) -> Self {
        Self {
            coefficients,
            approximate: OnceCell::new(),
        }
    }

    /// The coplanarity cubic of a query, if its coordinates are short enough.
    pub(crate) fn of<K: Tables>(points: &Points<f64>) -> Option<Self> {
        Some(Self::new(Integers::<K>::new(points)?.cubic()))
    }

    /// The time of a moment at which the cubic vanishes, if it is certain.
    ///
    /// In flat worlds, many are multiples of 2⁻¹⁰. In the step as a window, twice the precision suffices for
    /// most others.
    pub(crate) fn time(&self, moment: &Moment) -> Option<ContactTime> {
        const DIGITS: u32 = 10;
        match moment {
            Moment::At(time) => Some(time.time()),
            Moment::Root(window, root) => {
                let shortest = window.shortest(root).filter(|time| time.digits() <= DIGITS);
                if let Some(time) = shortest.filter(|&time| sign_at(&self.coefficients, time).is_eq()) {
                    return Some(Fraction::from(time).time());
                }
                let is_step = *window == Window::STEP;
                let precise = is_step.then(|| self.between_adjacent(root)).flatten();
                precise.or_else(|| window.time(&self.coefficients, root))
            }
            // A root of another polynomial, and an interval of times.
            Moment::QuadraticRoot(_) | Moment::Later => None,
        }
    }

    /// The time of a root of the step.
    pub(crate) fn time_of_root(&self, root: &Root) -> Option<ContactTime> {
        self.time(&Moment::Root(Window::STEP, *root))
    }

    /// The time of a root of the step between two adjacent f64, if the signs at both are certain.
    fn between_adjacent(&self, root: &Root) -> Option<ContactTime> {
        let Approximate { cubic, rounded } = self.approximate();
        // The slope in the units of the integers.
        let [c0, c1, c2, c3] = *rounded;
        let [a1, a2, a3] = [c1 - 3.0 * c0, c2 - 2.0 * c1 + 3.0 * c0, c3 - c2 + c1 - c0];
        let slope = (3.0 * a3 * root.near + 2.0 * a2) * root.near + a1;
        cubic.round(&Root { slope, ..*root })
    }

    /// The cubic in twice the precision.
    ///
    /// The bound of [`PreciseCubic::new`] holds with the largest coefficient as magnitude. It allows for
    /// seven operations before a coefficient. A coefficient in twice the precision is off by 2⁻¹⁰⁴ of
    /// itself, which is less than one operation.
    fn approximate(&self) -> &Approximate {
        self.approximate.get_or_init(|| {
            let values = self.coefficients.map(Wide::approximate);
            let rounded = values.map(|value| value.high);
            Approximate {
                cubic: PreciseCubic::new(values, largest(rounded)),
                rounded,
            }
        })
    }

    /// The sign at a time, by twice the precision.
    #[cfg(test)]
    pub(crate) fn approximate_sign_at(&self, time: f64) -> Option<core::cmp::Ordering> {
        self.approximate().cubic.sign_at(time)
    }
}
