//! Signs in interval arithmetic, and exact signs where an interval leaves the sign open.

use std::cell::OnceCell;
use std::cmp::Ordering;

use dashu_int::IBig;

use super::expansion::Expansion;
use super::image::{Differences, Image, Predicate, Vectors, integers, vectors};
use crate::interval::Enclosure;

/// An image with signs in intervals, and exact signs where intervals leave them open.
pub(super) struct Intervals {
    differences: Differences,
    vectors: Vectors<Enclosure>,
    exact: OnceCell<Exact>,
}

enum Exact {
    Expansions(Box<Vectors<Expansion>>),
    /// Where expansions would overflow or underflow.
    Integers(Box<Vectors<IBig>>),
}

impl Exact {
    fn new(differences: &Differences) -> Self {
        if Expansion::can_hold(differences.as_flattened()) {
            Self::Expansions(Box::new(vectors(differences)))
        } else {
            Self::Integers(Box::new(integers(differences)))
        }
    }

    fn sign(&self, predicate: Predicate) -> Ordering {
        match self {
            Self::Expansions(vectors) => predicate
                .value(vectors.as_slice())
                .sign()
                .unwrap_or(Ordering::Equal),
            Self::Integers(vectors) => vectors.sign(predicate),
        }
    }
}

impl Intervals {
    pub(super) fn new(differences: &Differences) -> Self {
        Self {
            vectors: vectors(differences),
            differences: *differences,
            exact: OnceCell::new(),
        }
    }

    pub(super) fn vectors(&self) -> &Vectors<Enclosure> {
        &self.vectors
    }

    fn exact_sign(&self, predicate: Predicate) -> Ordering {
        if predicate.vanishes(&self.differences) {
            return Ordering::Equal;
        }
        self.exact
            .get_or_init(|| Exact::new(&self.differences))
            .sign(predicate)
    }
}

impl Image for Intervals {
    fn sign(&self, predicate: Predicate) -> Ordering {
        let sign = predicate.value(&self.vectors).sign();
        sign.unwrap_or_else(|| self.exact_sign(predicate))
    }
}
