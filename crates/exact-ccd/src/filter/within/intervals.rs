//! All times within d.

use core::cmp::Ordering;

use super::crossing::Crossings;
use super::leaving::Leaving;
use super::snapshot::{Headed, Snapshot};
use crate::numbers::double_double::DoubleDouble;
use crate::tables::Tables;
use crate::values::{ContactTime, Interval, Intervals};

/// The largest number of intervals that are followed.
const MOST: usize = 8;

impl Crossings {
    /// The intervals of times within d, given the first one; `None` if they are not certain.
    ///
    /// If that is not t = 0, it is the first time of a bracket. D falls there to its end, so that the times
    /// within d in the bracket are one interval, and D is below d at its end.
    pub(super) fn intervals<K: Tables>(&self, first: ContactTime) -> Option<Intervals> {
        let mut intervals = arrayvec::ArrayVec::<Interval, MOST>::new();
        let mut next = Some(first);
        while let Some(start) = next {
            let enters = || Some(!start.is_exact() && self.approach::<K>(start)?.sense()? == Ordering::Less);
            if !start.is_start() && !enters()? {
                return None;
            }
            let Leaving { time: end, next: now } = self.last_after::<K>(start.upper())?;
            let is_moment = false;
            intervals
                .try_push(Interval {
                    start,
                    end,
                    is_moment,
                })
                .ok()?;
            next = match now {
                Some(now) => self.first_after::<K>(end.upper(), &now)?,
                None => None,
            };
        }
        Some(intervals.into_iter().collect())
    }

    /// The next first time within d after one at which D is above d, given the corners then.
    ///
    /// D is so near to d there that the first stretch needs twice the precision.
    fn first_after<K: Tables>(&self, from: f64, now: &Snapshot<DoubleDouble>) -> Option<Option<ContactTime>> {
        // The shortest stretches are as short as in `Advancement::free_after`: their number is bounded.
        const ATTEMPTS: usize = 5;
        let now = Headed::new(now)?;
        let mut length = 1.0 - from;
        for _ in 0..ATTEMPTS {
            let free = from + length;
            if self.is_beyond_between::<K>(free, &now) {
                let free = self.advancement.free_until::<K>([free, 1.0], 0.25 * length);
                return if free == 1.0 {
                    Some(None)
                } else {
                    self.first_between::<K>([free, 1.0])
                };
            }
            length *= 0.125;
        }
        None
    }
}
