//! Cubics in Bernstein form, with error bounds: their signs and their roots in [0, 1].

use core::cmp::Ordering;

use arrayvec::ArrayVec;

use super::number::Lanes;
use super::roundoff::{UNDERFLOW, UNIT, certain_sign, margin};
use super::vector::interpolate;
use crate::values::ContactTime;

/// c(t) = b₀ (1−t)³ + 3 b₁ (1−t)² t + 3 b₂ (1−t) t² + b₃ t³, each coefficient known to within an
/// error.
#[derive(Clone, Copy)]
pub(crate) struct Cubic<T> {
    pub(crate) bernstein: [T; 4],
    /// A bound for the magnitudes of the coefficients, and of everything that is added up on the
    /// way to them.
    pub(crate) magnitude: T,
}

/// A bracket of exactly one root of c, a simple one; c has opposite strict signs at its ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Root {
    pub(crate) low: f64,
    pub(crate) high: f64,
    /// An approximation of the root in the bracket.
    pub(crate) near: f64,
    /// An approximation of c′ there.
    pub(crate) slope: f64,
    /// The sign of c before the root; after it, c has the opposite one.
    pub(crate) before: Ordering,
}

impl Root {
    /// The root at a time, of a cubic with this sign before it.
    pub(crate) fn exactly(time: f64, before: Ordering) -> Self {
        Self {
            low: time,
            high: time,
            near: time,
            slope: 0.0,
            before,
        }
    }

    /// A bound of the distance of the root from `near`; both are exact, or rounded once.
    pub(crate) fn radius(&self) -> f64 {
        (self.high - self.near).max(self.near - self.low)
    }

    /// The root in the narrowest bracket, given its time.
    pub(crate) fn at(&self, time: ContactTime) -> Self {
        Self {
            low: time.lower(),
            high: time.upper(),
            near: time.lower(),
            ..*self
        }
    }
}

impl<T: Lanes> Cubic<T> {
    /// The cubic with the coefficients b₀, 3 b₁, 3 b₂, b₃, each reached in at most ten roundings of
    /// terms whose magnitudes add up to at most m, 3 m, 3 m and m for `magnitude` m.
    #[inline(always)]
    pub(crate) fn new([b0, three_b1, three_b2, b3]: [T; 4], magnitude: T) -> Self {
        Self {
            bernstein: [b0, three_b1 / 3.0, three_b2 / 3.0, b3],
            magnitude,
        }
    }

    /// The error of a Bernstein coefficient, n = 10 + 1.
    #[inline(always)]
    pub(crate) fn coefficient_error(&self) -> T {
        self.magnitude * (margin(11) * UNIT) + UNDERFLOW
    }

    /// True where c certainly has one strict sign in all of [0, 1], because all coefficients have it.
    #[inline(always)]
    pub(crate) fn has_constant_sign(&self) -> T::Mask {
        self.exceeds([self.coefficient_error(); 4])
    }

    /// True where each coefficient certainly exceeds a bound, or is below its negative.
    #[inline(always)]
    pub(crate) fn is_beyond(&self, [c0, c1, c2, c3]: [T; 4]) -> T::Mask {
        let error = self.coefficient_error();
        self.exceeds([c0 + error, c1 + error, c2 + error, c3 + error])
    }

    /// True where each computed coefficient exceeds a limit, or is below its negative.
    #[inline(always)]
    fn exceeds(&self, [c0, c1, c2, c3]: [T; 4]) -> T::Mask {
        let [b0, b1, b2, b3] = self.bernstein;
        (b0.gt(c0) & b1.gt(c1) & b2.gt(c2) & b3.gt(c3))
            | ((-b0).gt(c0) & (-b1).gt(c1) & (-b2).gt(c2) & (-b3).gt(c3))
    }

    /// The error of a blossom value: three interpolations, with three roundings of the first value and two
    /// of the second. b₀ has eight roundings, and is the first value each time: n = 8 + 9. The other
    /// coefficients have at most eleven, and are the second value at least once: n = 11 + 8.
    #[inline(always)]
    pub(crate) fn blossom_error(&self) -> T {
        self.magnitude * (margin(19) * UNIT) + UNDERFLOW
    }

    /// The blossom of c: symmetric, affine in each argument, and c(t) at (t, t, t). (Ramshaw,
    /// Blossoms are polar forms, 1989.)
    #[inline(always)]
    pub(crate) fn blossom(&self, r: T, s: T, t: T) -> T {
        let [b0, b1, b2, b3] = self.bernstein;
        let [b0, b1, b2] = [
            interpolate(b0, b1, r),
            interpolate(b1, b2, r),
            interpolate(b2, b3, r),
        ];
        let [b0, b1] = [interpolate(b0, b1, s), interpolate(b1, b2, s)];
        interpolate(b0, b1, t)
    }

    /// The Bernstein coefficients of c′ / 3 in [low, high].
    #[inline(always)]
    pub(crate) fn slopes(&self, low: T, high: T) -> [T; 3] {
        let [b0, b1, b2, b3] = self.bernstein;
        let [d0, d1, d2] = [b1 - b0, b2 - b1, b3 - b2];
        let blossom = |s: T, t: T| interpolate(interpolate(d0, d1, s), interpolate(d1, d2, s), t);
        [blossom(low, low), blossom(low, high), blossom(high, high)]
    }

    /// The error of a coefficient of [`slopes`](Self::slopes): a difference and two interpolations of
    /// coefficients, n = 11 + 7, on terms of at most twice the magnitude.
    #[inline(always)]
    pub(crate) fn slope_error(&self) -> T {
        self.magnitude * (2.0 * margin(18) * UNIT) + 4.0 * UNDERFLOW
    }
}

impl Cubic<f64> {
    /// Returns true if c is positive at t = 0. This is certain if [`roots`](Self::roots) are.
    pub(crate) fn starts_positive(&self) -> bool {
        self.bernstein[0] > 0.0
    }

    /// Returns true if c is certainly not zero at t = 0 (`end` 0) or at t = 1 (`end` 1).
    pub(crate) fn is_certain_at(&self, end: usize) -> bool {
        self.bernstein[3 * end].abs() > self.coefficient_error()
    }

    /// Returns true if c certainly is strictly monotone in [low, high].
    pub(crate) fn is_monotone(&self, low: f64, high: f64) -> bool {
        let (slopes, error) = (self.slopes(low, high), self.slope_error());
        slopes.iter().all(|&slope| slope > error) || slopes.iter().all(|&slope| slope < -error)
    }

    /// The sign of c in all of [0, 1], if it is certainly the same.
    #[inline]
    pub(crate) fn constant_sign(&self) -> Option<Ordering> {
        let sign = if self.starts_positive() {
            Ordering::Greater
        } else {
            Ordering::Less
        };
        self.has_constant_sign().then_some(sign)
    }

    /// Brackets of all roots of c in [0, 1], in increasing order, if all of them are certainly
    /// simple and inside.
    ///
    /// A piece has no root if its Bernstein coefficients have one sign, and exactly one if their
    /// signs change once (Descartes' rule). If neither is certain for [0, 1], c is cut into
    /// monotone pieces; if neither is certain for one of these, the roots are unknown.
    pub(crate) fn roots(&self) -> Option<ArrayVec<Root, 3>> {
        let mut roots = ArrayVec::new();
        if self.isolate(0.0, 1.0, self.bernstein, &mut roots).is_some() {
            return Some(roots);
        }
        let mut low = 0.0;
        for high in self.cuts().into_iter().chain([1.0]) {
            self.isolate(low, high, self.piece(low, high), &mut roots)?;
            low = high;
        }
        Some(roots)
    }

    /// The signs of the Bernstein coefficients in [0, end], as far as they are certain.
    pub(crate) fn signs_until(&self, end: f64) -> [Option<Ordering>; 4] {
        self.piece(0.0, end).map(|value| self.sign(value))
    }

    /// The Bernstein coefficients in [low, high].
    fn piece(&self, low: f64, high: f64) -> [f64; 4] {
        [
            self.blossom(low, low, low),
            self.blossom(low, low, high),
            self.blossom(low, high, high),
            self.blossom(high, high, high),
        ]
    }

    /// Appends the root in a piece with these Bernstein coefficients, if there certainly is one;
    /// `None` if the number of roots is not certain.
    fn isolate(
        &self,
        low: f64,
        high: f64,
        coefficients: [f64; 4],
        roots: &mut ArrayVec<Root, 3>,
    ) -> Option<()> {
        let [first, second, third, last] = coefficients.map(|value| self.sign(value));
        let (Some(at_low), Some(at_high)) = (first, last) else {
            return None;
        };
        if at_low == at_high {
            return (second == first && third == first).then_some(());
        }
        // If one of these agrees, the signs change only once, whichever sign an unknown one has.
        (second == first || third == last).then(|| {
            let [start, .., end] = coefficients;
            let secant = low + (high - low) * (start / (start - end));
            roots.push(self.refine(low, high, secant, at_low));
        })
    }

    /// A bracket of the root in [0, 1] of a cubic whose exact coefficients change their signs once.
    ///
    /// The first guess is the root of the control polygon.
    pub(crate) fn only_root(&self) -> Root {
        let before = 0.0_f64.total_cmp(&self.bernstein[3]);
        let is_before = |&b: &f64| (b > 0.0) == before.is_gt();
        let last = self.bernstein[..3].iter().rposition(is_before).unwrap_or(0);
        let [start, end] = [last, last + 1].map(|i| self.bernstein[i]);
        let guess = (last as f64 + start / (start - end)) / 3.0;
        self.refine(0.0, 1.0, guess, before)
    }

    /// The points that cut [0, 1] into pieces on which c is monotone, and so are its Bernstein coefficients:
    /// approximate zeros of c′; if it has none, the zero of c″. On either side of it, the coefficients of c′
    /// have one sign.
    pub(crate) fn cuts(&self) -> ArrayVec<f64, 2> {
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

    /// An approximate zero of c″; near an almost triple root, it is far more accurate than the zeros of c′.
    pub(crate) fn inflection(&self) -> f64 {
        let [b0, b1, b2, b3] = self.bernstein;
        let [d0, d1, d2] = [b1 - b0, b2 - b1, b3 - b2];
        (d0 - d1) / (d0 - 2.0 * d1 + d2)
    }

    /// A narrow bracket of the only root in a wider one.
    fn refine(&self, low: f64, high: f64, guess: f64, before: Ordering) -> Root {
        let (near, slope) = self.approximate(low, high, guess, before);
        // At this distance c is at least twice its error away from zero, if its slope is the same
        // there.
        let mut width = 4.0 * self.blossom_error() / slope.abs();
        let mut root = Root {
            low,
            high,
            near,
            slope,
            before,
        };
        for _ in 0..3 {
            let (left, right) = (near - width, near + width);
            if root.low == low && left > low && self.sign_at(left) == Some(before) {
                root.low = left;
            }
            if root.high == high && right < high && self.sign_at(right) == Some(before.reverse()) {
                root.high = right;
            }
            width *= 16.0;
        }
        root
    }

    /// Newton's iteration, kept in the bracket by bisection: an approximation of the root, and of
    /// c′ there.
    ///
    /// The result needs no error bound. Powers of t are faster to evaluate than the Bernstein form.
    fn approximate(&self, mut low: f64, mut high: f64, guess: f64, before: Ordering) -> (f64, f64) {
        const STEPS: usize = 60;
        let noise = self.blossom_error();
        let [b0, b1, b2, b3] = self.bernstein;
        let [a1, a2, a3] = [
            3.0 * (b1 - b0),
            3.0 * ((b2 - b1) - (b1 - b0)),
            (b3 - b0) - 3.0 * (b2 - b1),
        ];
        // A bound of |c″| / 2: after a step s, the value is at most this times s², up to roundings.
        let curvature = a2.abs() + 3.0 * a3.abs();
        let (mut t, mut slope) = (guess, 0.0);
        for _ in 0..STEPS {
            let value = ((a3 * t + a2) * t + a1) * t + b0;
            slope = (3.0 * a3 * t + 2.0 * a2) * t + a1;
            if (value < 0.0) == before.is_lt() {
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

    /// The sign of a blossom value, if it is certain.
    fn sign(&self, value: f64) -> Option<Ordering> {
        certain_sign(value, self.blossom_error())
    }

    fn sign_at(&self, t: f64) -> Option<Ordering> {
        self.sign(self.blossom(t, t, t))
    }
}

#[cfg(test)]
mod tests;
