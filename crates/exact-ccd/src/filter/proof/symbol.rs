//! Numbers that record how they are computed, and bound their errors.

use alloc::rc::Rc;
use core::cell::RefCell;
use std::thread_local;
use std::vec::Vec;

use crate::numbers::roundoff::LARGEST;

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
/// u; `permanent` is the sum of their magnitudes. So its error is at most γₙ times the permanent, apart
/// from underflow (Higham, Accuracy and Stability of Numerical Algorithms, chapter 3).
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
    pub(super) is_constant: bool,
    /// The place in the record.
    pub(in crate::filter) place: usize,
}

/// The rules of an arithmetic.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Rules {
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
    pub(super) fn constant(value: f64) -> Self {
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

    pub(super) fn sum(self, other: Self, value: f64, operation: Operation, rules: Rules) -> Self {
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

    pub(super) fn product(self, other: Self, rules: Rules) -> Self {
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

    pub(super) fn quotient(self, other: Self) -> Self {
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
    pub(super) fn either(self, other: Self) -> Self {
        Self {
            roundings: self.roundings.max(other.roundings),
            degree: self.degree.max(other.degree),
            largest: self.largest.max(other.largest),
            underflow: self.underflow.max(other.underflow),
            ..self
        }
    }

    pub(super) fn unchanged(self, value: f64, operation: Operation) -> Self {
        Self {
            value,
            place: Self::new(value, operation).place,
            ..self
        }
    }
}
