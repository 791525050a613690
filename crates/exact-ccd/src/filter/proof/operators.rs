//! The operators of a [`Symbol`].

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::symbol::{Operation, Rules, Symbol};
use crate::numbers::number::Lanes;

impl Add for Symbol {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.sum(
            other,
            self.value + other.value,
            Operation::Sum(self.place, other.place),
            Rules::Single,
        )
    }
}

impl Sub for Symbol {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        let operation = Operation::Difference(self.place, other.place);
        self.sum(other, self.value - other.value, operation, Rules::Single)
    }
}

impl Mul for Symbol {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        self.product(other, Rules::Single)
    }
}

impl Div for Symbol {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        self.quotient(other)
    }
}

impl Neg for Symbol {
    type Output = Self;

    fn neg(self) -> Self {
        self.unchanged(-self.value, Operation::Negative(self.place))
    }
}

impl Add<f64> for Symbol {
    type Output = Self;

    fn add(self, other: f64) -> Self {
        self + Self::constant(other)
    }
}

impl Mul<f64> for Symbol {
    type Output = Self;

    fn mul(self, other: f64) -> Self {
        self * Self::constant(other)
    }
}

impl Div<f64> for Symbol {
    type Output = Self;

    fn div(self, other: f64) -> Self {
        self / Self::constant(other)
    }
}

impl Lanes for Symbol {
    type Mask = bool;

    fn splat(self, value: f64) -> Self {
        Self::constant(value)
    }

    fn gt(self, other: Self) -> bool {
        self.value > other.value
    }

    fn any(mask: bool) -> bool {
        mask
    }

    fn abs(self) -> Self {
        self.unchanged(self.value.abs(), Operation::Magnitude(self.place))
    }

    /// The root of a number of even degree. It has no more roundings than its square, and its own. What
    /// underflows in the square is below 2⁷⁵ units of 2⁻¹⁰⁷⁵, and its root below 2⁻⁵⁰⁰, which the code adds.
    fn sqrt(self) -> Self {
        assert_eq!(self.degree % 2, 0, "the root of an odd degree");
        assert!(
            self.largest.is_infinite() || self.underflow < 2.0_f64.powi(75),
            "{}",
            self.underflow
        );
        Self {
            roundings: self.roundings + 1,
            permanent: self.permanent.sqrt(),
            degree: self.degree / 2,
            largest: self.largest.sqrt(),
            underflow: 0.0,
            ..self.unchanged(self.value.sqrt(), Operation::Root(self.place))
        }
    }

    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes.either(no) } else { no.either(yes) }
    }

    fn min(self, other: Self) -> Self {
        Self::select(self.value < other.value, self, other)
    }

    fn max(self, other: Self) -> Self {
        Self::select(self.value > other.value, self, other)
    }
}
