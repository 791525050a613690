//! Contact times: algebraic numbers, each given as an f64 or as the two adjacent f64 around it.

use core::ops::Deref;

use arrayvec::ArrayVec;

use crate::non_negative::NonNegative;

/// One time of contact in [0, 1]: either exactly an f64, or strictly between two adjacent ones.
///
/// Times are in their order, in every floating-point environment. Two different times between the
/// same two adjacent f64 compare equal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct ContactTime {
    lower: NonNegative,
    /// True if the time is above `lower`, hence after the one that is exactly `lower`.
    is_above: bool,
}

impl ContactTime {
    pub(crate) fn exactly(time: f64) -> Self {
        Self {
            lower: in_step(time),
            is_above: false,
        }
    }

    /// A time strictly between `lower` and the next larger f64.
    pub(crate) fn just_above(lower: f64) -> Self {
        Self {
            lower: in_step(lower),
            is_above: true,
        }
    }

    /// The largest f64 that is not above the time.
    #[must_use]
    pub fn lower(self) -> f64 {
        self.lower.get()
    }

    /// The smallest f64 that is not below the time.
    #[must_use]
    pub fn upper(self) -> f64 {
        if self.is_above {
            self.lower.next_up()
        } else {
            self.lower()
        }
    }

    /// Returns true if the time is exactly [`lower`](Self::lower).
    #[must_use]
    pub fn is_exact(self) -> bool {
        !self.is_above
    }

    /// Returns true for the start of the step, t = 0.
    #[must_use]
    pub fn is_start(self) -> bool {
        self == Self::exactly(0.0)
    }

    /// Returns true if the contact is not after a time t; false for NaN.
    #[must_use]
    pub fn is_at_most(self, t: f64) -> bool {
        t > 1.0 || NonNegative::new(t).is_some_and(|t| (self.lower, self.is_above) <= (t, false))
    }
}

/// A time of the step, which is neither negative nor NaN.
#[inline]
fn in_step(time: f64) -> NonNegative {
    let time = NonNegative::new(time);
    debug_assert!(time.is_some(), "a contact time is in [0, 1]");
    time.unwrap_or(NonNegative::ZERO)
}

/// The maximal number of isolated contact times of a query.
///
/// They are among the events of the exact path. If the four points are coplanar at some times only,
/// these are the roots of a cubic: at most 3. If they are always coplanar, these are t = 0 and t =
/// 1 and, for each of at most four pairs of a vertex and an edge, the common roots of three
/// quadratics or, if these vanish, of three linear functions for each end of the edge: at most 2 +
/// 4 · 2.
const MAX_TIMES: usize = 10;

/// Distinct contact times in increasing order; a slice of [`ContactTime`].
///
/// Two distinct times may lie between the same two adjacent f64.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Times(ArrayVec<ContactTime, MAX_TIMES>);

impl Times {
    pub(crate) const NONE: Self = Self(ArrayVec::new_const());

    /// Appends a time. There is room for it: see [`MAX_TIMES`].
    pub(crate) fn push(&mut self, time: ContactTime) {
        let pushed = self.0.try_push(time);
        debug_assert!(pushed.is_ok(), "more than {MAX_TIMES} isolated contact times");
    }
}

impl Deref for Times {
    type Target = [ContactTime];

    fn deref(&self) -> &[ContactTime] {
        &self.0
    }
}

/// All times of a step at which two primitives are in contact.
#[derive(Clone, Debug, PartialEq)]
pub enum ContactTimes {
    /// The primitives meet at finitely many times; at none if the list is empty.
    Finite(Times),
    /// The primitives stay in contact for an interval of time, sliding or resting.
    Interval {
        /// The earliest contact time of the step.
        first: ContactTime,
    },
}

impl ContactTimes {
    /// No contact.
    pub(crate) const NONE: Self = Self::Finite(Times::NONE);

    /// The earliest contact time.
    #[must_use]
    pub fn first(&self) -> Option<ContactTime> {
        match self {
            Self::Finite(times) => times.first().copied(),
            Self::Interval { first } => Some(*first),
        }
    }

    /// The number of distinct contact times, or `None` if there are infinitely many.
    #[must_use]
    pub fn count(&self) -> Option<usize> {
        match self {
            Self::Finite(times) => Some(times.len()),
            Self::Interval { .. } => None,
        }
    }
}
