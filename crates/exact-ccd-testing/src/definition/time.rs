//! Dyadic times n / 2ˢ in [0, 1].

use std::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::BitTest;
use dashu_ratio::RBig;

#[derive(Clone, Debug)]
pub(crate) struct Time {
    numerator: IBig,
    shift: usize,
}

impl Time {
    pub(crate) fn zero() -> Self {
        Self::from_f64(0.0)
    }

    pub(crate) fn one() -> Self {
        Self::from_f64(1.0)
    }

    pub(crate) fn from_f64(t: f64) -> Self {
        let exact = RBig::try_from(t).expect("a finite number");
        Self {
            numerator: exact.numerator().clone(),
            shift: exact.denominator().bit_len() - 1,
        }
    }

    pub(crate) fn numerator(&self) -> &IBig {
        &self.numerator
    }

    pub(crate) fn shift(&self) -> usize {
        self.shift
    }

    /// Both times in units of 2⁻ˢ.
    fn aligned(a: &Self, b: &Self) -> ([IBig; 2], usize) {
        let shift = a.shift.max(b.shift);
        ([a, b].map(|t| &t.numerator << (shift - t.shift)), shift)
    }

    /// A time strictly between two: the middle, or, if these are much nearer to 0 or to 1 than to each
    /// other, a power of two from there with the mean exponent. So a few halvings reach a root at 2⁻³⁰⁰⁰.
    pub(crate) fn between(low: &Self, high: &Self) -> Self {
        let ([a, b], shift) = Self::aligned(low, high);
        let one = IBig::ONE << shift;
        let from_end = |near: &IBig, far: &IBig| -> Option<Self> {
            let digits = |n: &IBig| n.bit_len();
            // The exponents of both distances from the end of the step; 0 counts as the square of `far`.
            let far = shift + 1 - digits(far);
            let near = if *near == IBig::ZERO {
                2 * far + 8
            } else {
                shift + 1 - digits(near)
            };
            (near > far + 2).then(|| Self {
                numerator: IBig::ONE,
                shift: (near + far) / 2,
            })
        };
        if let Some(power) = from_end(&a, &b) {
            return power;
        }
        if let Some(power) = from_end(&(&one - &b), &(&one - &a)) {
            let numerator = (IBig::ONE << power.shift) - IBig::ONE;
            return Self { numerator, ..power };
        }
        Self {
            numerator: a + b,
            shift: shift + 1,
        }
    }
}

impl PartialEq for Time {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Time {}

impl PartialOrd for Time {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Time {
    fn cmp(&self, other: &Self) -> Ordering {
        let ([a, b], _) = Self::aligned(self, other);
        a.cmp(&b)
    }
}
