//! The earliest contact of a query in integers, and the answers that follow from it.

use alloc::vec::Vec;

use super::instant::Instant;
use super::motion::Motion;
use super::roots::roots;
use super::split::Split;
use crate::impact::Impact;
use crate::kind::Kind;
use crate::query::Query;
use crate::time::{ContactTime, ContactTimes, Times};

/// The earliest instant at which the primitives touch.
#[derive(Clone, Debug)]
pub(crate) struct FirstContact<K> {
    motion: Motion<K>,
    /// All instants at which contact may begin or end, in increasing order.
    instants: Vec<Instant>,
    /// The index of the first one at which the primitives touch.
    first: usize,
}

impl<K: Kind> FirstContact<K> {
    /// The earliest contact of a query, if there is one.
    pub(crate) fn of(query: &Query<K>) -> Option<Self> {
        let motion = Motion::new(query);
        let instants = roots(motion.events());
        let first = instants.iter().position(|instant| motion.touches(instant))?;
        Some(Self {
            motion,
            instants,
            first,
        })
    }

    /// The time of the earliest contact.
    pub(crate) fn time(&self) -> ContactTime {
        self.instants[self.first].round()
    }

    /// All contact times.
    pub(crate) fn times(&self) -> ContactTimes {
        let (motion, instants) = (&self.motion, &self.instants);
        let mut times = Times::default();
        for (i, instant) in instants.iter().enumerate().skip(self.first) {
            if i > self.first && !motion.touches(instant) {
                continue;
            }
            times.push(instant.round());
            // Contact over an interval begins at an event and includes the next one, because the
            // primitives are closed.
            let lasts = |next| motion.touches(&Instant::At(instant.before(next)));
            if motion.is_always_coplanar() && instants.get(i + 1).is_some_and(lasts) {
                return ContactTimes::Interval { first: times[0] };
            }
        }
        ContactTimes::Finite(times)
    }

    /// The impact of a query whose primitives touch at t = 0.
    pub(crate) fn impact_at_start(query: &Query<K>) -> Impact {
        Motion::new(query).impact(&Instant::At(Split::START))
    }

    /// The earliest contact: time, parameters and normal.
    pub(crate) fn impact(&self) -> Impact {
        self.motion.impact(&self.instants[self.first])
    }
}
