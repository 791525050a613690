//! Proof of proximity by the chords: a distance of at most d or d + ε, or contact.

use exact_ccd::Separation;

use crate::answer::{Proximity, Within};
use crate::crossing;
use crate::kind::CurvedKind;
use crate::straight::Straight;

impl<K: CurvedKind> Straight<K> {
    /// The earliest time by which the chords prove a distance of at most d or else d + ε, or contact.
    pub(crate) fn proximity(&self, d: Separation, tolerance: Separation) -> Option<Within> {
        let wider = Separation::new((d.get() + tolerance.get()).next_down()).unwrap_or(d);
        let is_zero = d == Separation::default();
        let crossing = || (is_zero && crossing::is_certain(self)).then_some(self.end);
        let contact = self.within_by(d).or_else(crossing);
        let near = || if wider > d { self.within_by(wider) } else { None };
        let within = |by, proximity| Within { by, proximity };
        contact
            .map(|by| within(by, Proximity::Contact))
            .or_else(|| near().map(|by| within(by, Proximity::Near)))
    }
}
