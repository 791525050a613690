//! Cubics in Bernstein form, with error bounds: their signs and their roots in [0, 1].

use core::cmp::Ordering;

use arrayvec::ArrayVec;

use super::number::Lanes;
use super::{UNDERFLOW, UNIT};
use crate::time::ContactTime;

/// c(t) = b₀ (1−t)³ + 3 b₁ (1−t)² t + 3 b₂ (1−t) t² + b₃ t³, each coefficient known to within an error.
#[derive(Clone, Copy)]
pub(crate) struct Cubic<T> {
    pub(crate) bernstein: [T; 4],
    /// A bound for the magnitudes of the coefficients, and of everything that is added up on the way to them.
    pub(crate) magnitude: T,
}

/// A bracket of exactly one root of c, a simple one; c has opposite strict signs at its ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Root {
    pub(super) low: f64,
    pub(super) high: f64,
    /// An approximation of the root in the bracket.
    pub(super) near: f64,
    /// An approximation of c′ there.
    pub(super) slope: f64,
    /// Whether c is negative below the root and positive above it.
    pub(super) rising: bool,
}

impl Root {
    /// The root in the narrowest bracket, once its time is known.
    pub(super) fn at(&self, time: ContactTime) -> Self {
        Self {
            low: time.lower(),
            high: time.upper(),
            near: time.lower(),
            ..*self
        }
    }
}

/// What is known of a number of which an approximation is known.
#[derive(Clone, Copy, PartialEq)]
enum Sign {
    Negative,
    Unknown,
    Positive,
}

impl<T: Lanes> Cubic<T> {
    /// The cubic with the coefficients b₀, 3 b₁, 3 b₂, b₃, each reached in at most ten roundings of terms whose
    /// magnitudes add up to at most m, 3 m, 3 m and m for `magnitude` m.
    #[inline(always)]
    pub(super) fn new([b0, three_b1, three_b2, b3]: [T; 4], magnitude: T) -> Self {
        Self {
            bernstein: [b0, three_b1 / 3.0, three_b2 / 3.0, b3],
            magnitude,
        }
    }

    /// The error of a Bernstein coefficient, n = 10 + 1.
    #[inline(always)]
    fn coefficient_error(&self) -> T {
        self.magnitude * (16.0 * UNIT) + UNDERFLOW
    }

    /// Whether c is certainly positive in all of [0, 1], as all coefficients are, and whether it is negative.
    #[inline(always)]
    pub(super) fn constant_signs(&self) -> [T::Mask; 2] {
        let error = self.coefficient_error();
        let [b0, b1, b2, b3] = self.bernstein;
        [
            b0.exceeds(error) & b1.exceeds(error) & b2.exceeds(error) & b3.exceeds(error),
            (-b0).exceeds(error) & (-b1).exceeds(error) & (-b2).exceeds(error) & (-b3).exceeds(error),
        ]
    }
}

impl Cubic<f64> {
    /// Whether c is positive at t = 0. Certain where the roots are.
    pub(super) fn starts_positive(&self) -> bool {
        self.bernstein[0] > 0.0
    }

    /// True if c is certainly not zero at t = 0, or at t = 1.
    pub(super) fn is_certain_at(&self, end: usize) -> bool {
        self.bernstein[3 * end].abs() > self.coefficient_error()
    }

    /// The error of a blossom value: three interpolations of coefficients, each (1 − t) x + t y with three roundings
    /// one after another, n = 11 + 9.
    fn blossom_error(&self) -> f64 {
        32.0 * UNIT * self.magnitude + UNDERFLOW
    }

    /// The sign of c in all of [0, 1], if it is certainly the same.
    #[inline]
    pub(super) fn constant_sign(&self) -> Option<Ordering> {
        match self.constant_signs() {
            [true, _] => Some(Ordering::Greater),
            [_, true] => Some(Ordering::Less),
            _ => None,
        }
    }

    /// Brackets of all roots of c in [0, 1], in increasing order, if all of them are certainly simple and inside.
    ///
    /// A piece has no root if its Bernstein coefficients have one sign, and exactly one if their signs change once
    /// (Descartes' rule). Where neither is certain for the whole, c is cut where that makes it monotone; if neither is
    /// certain for a piece then, nothing is.
    pub(super) fn roots(&self) -> Option<ArrayVec<Root, 3>> {
        let mut roots = ArrayVec::new();
        if self.isolate(0.0, 1.0, self.bernstein, &mut roots).is_some() {
            return Some(roots);
        }
        let mut low = 0.0;
        for high in self.cuts().into_iter().chain([1.0]) {
            let coefficients = [
                self.blossom(low, low, low),
                self.blossom(low, low, high),
                self.blossom(low, high, high),
                self.blossom(high, high, high),
            ];
            self.isolate(low, high, coefficients, &mut roots)?;
            low = high;
        }
        Some(roots)
    }

    /// Adds the root in a piece with these Bernstein coefficients, if there certainly is one; `None` if that is not certain.
    fn isolate(
        &self,
        low: f64,
        high: f64,
        coefficients: [f64; 4],
        roots: &mut ArrayVec<Root, 3>,
    ) -> Option<()> {
        match coefficients.map(|value| self.sign(value)) {
            [Sign::Unknown, ..] | [.., Sign::Unknown] => None,
            [first, second, third, last] if first == last => {
                (second == first && third == first).then_some(())
            }
            // Whatever the sign of an unknown one, the signs change only once if one of these agrees.
            [first, second, third, last] => (second == first || third == last).then(|| {
                let [start, .., end] = coefficients;
                let secant = low + (high - low) * (start / (start - end));
                roots.push(self.refine(low, high, secant, last == Sign::Positive));
            }),
        }
    }

    /// Where to cut [0, 1] so that c is monotone on each piece, and so are its Bernstein coefficients there: about at the
    /// zeros of c′; if there are none, at that of c″, on either side of which the coefficients of c′ have one sign.
    fn cuts(&self) -> ArrayVec<f64, 2> {
        let [b0, b1, b2, b3] = self.bernstein;
        // c′ / 3 = d₀ (1−t)² + 2 d₁ (1−t) t + d₂ t² = a t² + 2 h t + d₀.
        let [d0, d1, d2] = [b1 - b0, b2 - b1, b3 - b2];
        let (a, h) = (d0 - 2.0 * d1 + d2, d1 - d0);
        let discriminant = h * h - a * d0;
        let [first, second] = if discriminant > 0.0 {
            let q = -(h + libm::sqrt(discriminant).copysign(h));
            let [x, y] = [q / a, d0 / q];
            if x < y { [x, y] } else { [y, x] }
        } else {
            [-h / a, 1.0]
        };
        let inside = |&t: &f64| t > 0.0 && t < 1.0;
        [first, second].into_iter().filter(inside).collect()
    }

    /// A narrow bracket of the only root in a wider one.
    fn refine(&self, low: f64, high: f64, guess: f64, rising: bool) -> Root {
        let (near, slope) = self.approximate(low, high, guess, rising);
        // Where c is at least twice its error away from zero, if it is as steep as here.
        let mut width = 4.0 * self.blossom_error() / slope.abs();
        let mut root = Root {
            low,
            high,
            near,
            slope,
            rising,
        };
        let (below, above) = if rising {
            (Sign::Negative, Sign::Positive)
        } else {
            (Sign::Positive, Sign::Negative)
        };
        for _ in 0..3 {
            let (left, right) = (near - width, near + width);
            if root.low == low && left > low && self.sign_at(left) == below {
                root.low = left;
            }
            if root.high == high && right < high && self.sign_at(right) == above {
                root.high = right;
            }
            width *= 16.0;
        }
        root
    }

    /// Newton's iteration, kept in the bracket by bisection: an approximation of the root, and of c′ there.
    ///
    /// A guess, which needs no bound: in powers of t, which are faster to evaluate than the Bernstein form.
    fn approximate(&self, mut low: f64, mut high: f64, guess: f64, rising: bool) -> (f64, f64) {
        const STEPS: usize = 60;
        let noise = self.blossom_error();
        let [b0, b1, b2, b3] = self.bernstein;
        let [a1, a2, a3] = [
            3.0 * (b1 - b0),
            3.0 * ((b2 - b1) - (b1 - b0)),
            (b3 - b0) - 3.0 * (b2 - b1),
        ];
        // At least half of |c″|: after a step s, the value is no larger than this s², until roundings matter.
        let curvature = a2.abs() + 3.0 * a3.abs();
        let (mut t, mut slope) = (guess, 0.0);
        for _ in 0..STEPS {
            let value = ((a3 * t + a2) * t + a1) * t + b0;
            slope = (3.0 * a3 * t + 2.0 * a2) * t + a1;
            if (value < 0.0) == rising {
                low = t;
            } else {
                high = t;
            }
            let newton = t - value / slope;
            let is_inside = newton > low && newton < high;
            let next = if is_inside { newton } else { 0.5 * (low + high) };
            let step = (next - t).abs();
            t = next;
            if step * slope.abs() <= noise || (is_inside && curvature * step * step <= noise) {
                break;
            }
        }
        (t, slope)
    }

    /// The symmetric, in each argument affine function whose diagonal is c. (Ramshaw, Blossoms are polar forms, 1989.)
    fn blossom(&self, r: f64, s: f64, t: f64) -> f64 {
        let [b0, b1, b2, b3] = self.bernstein;
        let [b0, b1, b2] = [
            interpolate(b0, b1, r),
            interpolate(b1, b2, r),
            interpolate(b2, b3, r),
        ];
        let [b0, b1] = [interpolate(b0, b1, s), interpolate(b1, b2, s)];
        interpolate(b0, b1, t)
    }

    /// The sign of a blossom value.
    fn sign(&self, value: f64) -> Sign {
        let error = self.blossom_error();
        if value > error {
            Sign::Positive
        } else if value < -error {
            Sign::Negative
        } else {
            Sign::Unknown
        }
    }

    fn sign_at(&self, t: f64) -> Sign {
        self.sign(self.blossom(t, t, t))
    }
}

fn interpolate(start: f64, end: f64, t: f64) -> f64 {
    (1.0 - t) * start + t * end
}
