//! Symbols in the place of numbers of twice the precision.

use core::ops::{Add, Mul, Neg, Sub};

use super::symbol::{Operation, Rules, Symbol};
use crate::numbers::number::Number;

/// A [`Symbol`] in the place of [`DoubleDouble`](crate::filter::double_double::DoubleDouble): differences of
/// coordinates are exact, and `roundings` counts operations. Or, if not `TWICE`, in the place of an f64.
#[derive(Clone, Copy, Debug)]
pub(in crate::filter) struct Precise<const TWICE: bool>(pub(in crate::filter) Symbol);

impl<const TWICE: bool> Precise<TWICE> {
    const RULES: Rules = if TWICE { Rules::Double } else { Rules::Single };
}

impl<const TWICE: bool> Number for Precise<TWICE> {
    type Real = f64;

    fn difference(a: f64, b: f64) -> Self {
        let exact = Symbol::input(a - b);
        Self(if TWICE { exact } else { exact.rounded() })
    }

    fn value(self) -> f64 {
        self.0.value
    }
}

impl<const TWICE: bool> Add for Precise<TWICE> {
    type Output = Self;

    fn add(self, Self(b): Self) -> Self {
        let Self(a) = self;
        Self(a.sum(
            b,
            a.value + b.value,
            Operation::Sum(a.place, b.place),
            Self::RULES,
        ))
    }
}

impl<const TWICE: bool> Sub for Precise<TWICE> {
    type Output = Self;

    fn sub(self, Self(b): Self) -> Self {
        let Self(a) = self;
        Self(a.sum(
            b,
            a.value - b.value,
            Operation::Difference(a.place, b.place),
            Self::RULES,
        ))
    }
}

impl<const TWICE: bool> Mul for Precise<TWICE> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self(self.0.product(other.0, Self::RULES))
    }
}

impl<const TWICE: bool> Mul<f64> for Precise<TWICE> {
    type Output = Self;

    fn mul(self, other: f64) -> Self {
        self * Self(Symbol::constant(other))
    }
}

impl<const TWICE: bool> Neg for Precise<TWICE> {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}
