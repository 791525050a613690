//! Simple fractions as contact times.

use std::cmp::Ordering;

use exact_ccd::{ContactTime, ContactTimes};
use proptest::prelude::*;

/// m / n in [0, 1], with a small n.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rational {
    m: f64,
    n: f64,
}

impl Rational {
    /// All simple fractions, some in several forms, with denominators up to `most`.
    pub(crate) fn all_in_unit(most: u8) -> impl Iterator<Item = Self> {
        (1..=most).flat_map(|n| {
            (0..=n).map(move |m| Self {
                m: m.into(),
                n: n.into(),
            })
        })
    }

    /// A random simple fraction.
    pub(crate) fn in_unit(most: u8) -> impl Strategy<Value = Self> {
        prop::sample::select(Self::all_in_unit(most).collect::<Vec<_>>())
    }

    /// m and n.
    pub(crate) fn parts(self) -> (f64, f64) {
        (self.m, self.n)
    }

    /// The comparison with an f64 in [0, 1]. Exact: a fused multiply-add rounds once, which keeps
    /// the sign.
    fn compare(self, t: f64) -> Ordering {
        0.0.partial_cmp(&t.mul_add(self.n, -self.m)).unwrap()
    }

    /// Returns true if a contact time may be this number.
    fn may_be(self, time: ContactTime) -> bool {
        let above_lower = self.compare(time.lower());
        if time.is_exact() {
            above_lower.is_eq()
        } else {
            above_lower.is_gt() && self.compare(time.upper()).is_lt()
        }
    }

    /// Returns true if this is one of the contact times; `None` if an interval leaves that open.
    /// Numbers between the same two f64 count as equal, which is right for small numbers.
    pub(crate) fn is_among(self, times: &ContactTimes) -> Option<bool> {
        match times {
            ContactTimes::Finite(times) => Some(times.iter().any(|time| self.may_be(*time))),
            ContactTimes::Interval { first } if self.may_be(*first) => Some(true),
            ContactTimes::Interval { first } => self.compare(first.lower()).is_le().then_some(false),
        }
    }
}
