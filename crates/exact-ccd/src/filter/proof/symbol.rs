//! Numbers that record how they are computed, and bound their errors.

use alloc::rc::Rc;
use core::cell::RefCell;
use core::ops::{Add, Div, Mul, Neg, Sub};
use std::thread_local;
use std::vec::Vec;

use crate::filter::number::{Lanes, Number};
use crate::filter::roundoff::LARGEST;

/// An operation of the code, on the places of its operands in the record.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::filter) enum Operation {
    Input,
    Rounded(usize),
    Constant(f64),
    Sum(usize, usize),
    Difference(usize, usize),
    Product(usize, usize),
    Quotient(usize, usize),
    Negative(usize),
    Magnitude(usize),
    Root(usize),
}

thread_local! {
    /// All operations of this thread, in order.
    static RECORD: RefCell<Vec<Operation>> = const { RefCell::new(Vec::new()) };
}

/// A copy of the operations so far.
pub(in crate::filter) fn record() -> Rc<[Operation]> {
    RECORD.with_borrow(|record| record.as_slice().into())
}

/// An f64, and a bound of its error.
///
/// The number is a sum of products of inputs, each term times at most `roundings` factors from 1 − u to 1 +
/// u;
/// `permanent` is the sum of their magnitudes. So its error is at most γₙ times the permanent, apart from
/// underflow (Higham, Accuracy and Stability of Numerical Algorithms, chapter 3).
#[derive(Clone, Copy, Debug)]
pub(in crate::filter) struct Symbol {
    pub(in crate::filter) value: f64,
    /// n.
    pub(in crate::filter) roundings: u32,
    pub(in crate::filter) permanent: f64,
    /// The largest degree of a term in the inputs.
    pub(in crate::filter) degree: i32,
    /// A bound of the magnitude, for differences of inputs of at most twice [`LARGEST`].
    pub(in crate::filter) largest: f64,
    /// A bound of the error by underflow for these, in units of 2⁻¹⁰⁷⁵.
    pub(in crate::filter) underflow: f64,
    is_constant: bool,
    /// The place in the record.
    pub(in crate::filter) place: usize,
}

/// The rules of an arithmetic.
#[derive(Clone, Copy, PartialEq)]
enum Rules {
    /// f64. A sum of exact numbers is off by u of itself; a product with a power of two is exact.
    Single,
    /// Twice the precision: each operation is off by its roundoff of the magnitudes of the operands.
    Double,
}

impl Symbol {
    fn new(value: f64, operation: Operation) -> Self {
        let place = RECORD.with_borrow_mut(|record| {
            record.push(operation);
            record.len() - 1
        });
        Self {
            value,
            roundings: 0,
            permanent: value.abs(),
            degree: 0,
            largest: value.abs(),
            underflow: 0.0,
            is_constant: false,
            place,
        }
    }

    /// A coordinate, or an exact difference of two.
    pub(in crate::filter) fn input(value: f64) -> Self {
        Self {
            degree: 1,
            largest: 2.0 * LARGEST,
            ..Self::new(value, Operation::Input)
        }
    }

    /// A number without unit that the code takes as it is, such as a parameter.
    pub(in crate::filter) fn exactly(value: f64) -> Self {
        Self::new(value, Operation::Input)
    }

    /// A number in the code.
    fn constant(value: f64) -> Self {
        Self {
            is_constant: true,
            ..Self::new(value, Operation::Constant(value))
        }
    }

    /// This number as one of some degree: a product of differences, or a vector of such.
    pub(in crate::filter) fn of_degree(self, degree: i32) -> Self {
        // The components of normals are sums of two products.
        let largest = 2.0 * (2.0 * LARGEST).powi(degree);
        Self {
            degree,
            largest,
            ..self
        }
    }

    /// This number as an exact one: the next bound is of errors from here on.
    pub(in crate::filter) fn afresh(self) -> Self {
        Self {
            roundings: 0,
            permanent: self.value.abs(),
            underflow: 0.0,
            ..self
        }
    }

    /// This number, rounded once.
    pub(in crate::filter) fn rounded(self) -> Self {
        Self {
            roundings: 1,
            ..self.unchanged(self.value, Operation::Rounded(self.place))
        }
    }

    fn is_exact(self) -> bool {
        self.roundings == 0
    }

    fn sum(self, other: Self, value: f64, operation: Operation, rules: Rules) -> Self {
        let is_relative = rules == Rules::Single && self.is_exact() && other.is_exact();
        let are_inputs = self.degree == 1 && other.degree == 1 && is_relative;
        Self {
            roundings: self.roundings.max(other.roundings) + 1,
            permanent: if is_relative {
                value.abs()
            } else {
                self.permanent + other.permanent
            },
            degree: self.degree.max(other.degree),
            largest: if are_inputs {
                self.largest
            } else {
                self.largest + other.largest
            },
            underflow: self.underflow + other.underflow,
            ..Self::new(value, operation)
        }
    }

    fn product(self, other: Self, rules: Rules) -> Self {
        let is_power = |x: Self| x.is_constant && x.value.to_bits() << 12 == 0;
        let is_exact = rules == Rules::Single && (is_power(self) || is_power(other));
        Self {
            roundings: self.roundings + other.roundings + u32::from(!is_exact),
            permanent: self.permanent * other.permanent,
            degree: self.degree + other.degree,
            largest: self.largest * other.largest,
            underflow: self.underflow * other.largest + other.underflow * self.largest + 1.0,
            ..Self::new(
                self.value * other.value,
                Operation::Product(self.place, other.place),
            )
        }
    }

    fn quotient(self, other: Self) -> Self {
        Self {
            roundings: self.roundings + other.roundings + 1,
            permanent: self.permanent / other.value.abs(),
            degree: self.degree - other.degree,
            // Of a quotient by a constant; another one has no bound.
            largest: if other.degree == 0 {
                self.largest / other.permanent
            } else {
                f64::INFINITY
            },
            underflow: self.underflow + 1.0,
            ..Self::new(
                self.value / other.value,
                Operation::Quotient(self.place, other.place),
            )
        }
    }

    /// One of two numbers, with the bounds of both.
    fn either(self, other: Self) -> Self {
        Self {
            roundings: self.roundings.max(other.roundings),
            degree: self.degree.max(other.degree),
            largest: self.largest.max(other.largest),
            underflow: self.underflow.max(other.underflow),
            ..self
        }
    }

    fn unchanged(self, value: f64, operation: Operation) -> Self {
        Self {
            value,
            place: Self::new(value, operation).place,
            ..self
        }
    }
}

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
