//! Simple fractions as contact times.

use std::cmp::Ordering;

use exact_ccd::{Interval, Intervals};
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

    /// Returns true if this is one of the times. Numbers between the same two f64 count as equal, which is
    /// right for small numbers.
    pub(crate) fn is_among(self, times: &Intervals) -> bool {
        let is_in = |&Interval { start, end, .. }: &Interval| {
            let (after, before) = (self.compare(start.lower()), self.compare(end.upper()));
            (after.is_gt() || after.is_eq() && start.is_exact())
                && (before.is_lt() || before.is_eq() && end.is_exact())
        };
        times.iter().any(is_in)
    }
}
