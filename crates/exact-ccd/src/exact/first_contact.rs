//! The earliest contact of a query in integers, and the answers that follow from it.

use alloc::vec::Vec;

use super::instant::Instant;
use super::intervals::{Event, Passage, intervals_of};
use super::motion::Motion;
use super::points::MovingPoints;
use super::roots::roots;
use super::split::Split;
use crate::tables::{Points, Tables};
use crate::values::{ContactTime, Impact, Intervals};

/// The earliest instant at which the primitives touch.
#[derive(Clone, Debug)]
pub(crate) struct FirstContact<K> {
    motion: Motion<K>,
    /// All instants at which contact may begin or end, in increasing order.
    instants: Vec<Instant>,
    /// The index of the first one at which the primitives touch.
    first: usize,
}

impl<K: Tables> FirstContact<K> {
    /// The earliest contact of a query, if there is one.
    #[cfg(test)]
    pub(crate) fn of(points: &Points<f64>) -> Option<Self> {
        Self::along(MovingPoints::along(points))
    }

    /// The earliest contact, if there is one.
    pub(crate) fn along(points: MovingPoints) -> Option<Self> {
        let motion = Motion::<K>::new(points);
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

    /// All intervals of contact.
    pub(crate) fn intervals(&self) -> Intervals {
        let motion = &self.motion;
        let (first, later) = (self.first, self.first + 1);
        let later = self.instants[later..].iter();
        let touching = later.filter(|instant| motion.touches(instant));
        let events = [&self.instants[first]].into_iter().chain(touching);
        let events = events.cloned().map(|time| Event {
            time,
            passage: Passage::Unknown,
        });
        // Primitives that are not always coplanar touch at isolated times only.
        intervals_of(events.collect(), |t| {
            motion.is_always_coplanar() && motion.touches(&Instant::At(t.clone()))
        })
    }

    /// The impact of a query whose primitives touch at t = 0.
    pub(crate) fn impact_at_start(points: &Points<f64>) -> Impact {
        Motion::<K>::new(MovingPoints::along(points)).impact(&Instant::At(Split::START))
    }

    /// The earliest contact: time, parameters and normal.
    pub(crate) fn impact(&self) -> Impact {
        self.motion.impact(&self.instants[self.first])
    }
}
