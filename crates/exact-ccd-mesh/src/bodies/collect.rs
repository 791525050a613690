//! Collectors of the contacts among candidates.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};

use exact_ccd::{ContactTime, Options};

use super::Bodies;
use super::candidate::{Candidate, Key};
use super::part::Part;
use crate::gathered::Gathered;

/// A collector of contacts: receives candidates in any order, on any thread. A pair may be a candidate of
/// several parts of the step, and is one of each part in which it touches.
pub(super) trait Collect: Sync {
    /// The time after which contacts are irrelevant.
    fn until(&self) -> f64;

    /// Decides about candidates of a part of the step.
    fn decide(&self, candidates: &[Candidate], part: Part);
}

/// The existence of a contact.
pub(super) struct AnyContact<'a> {
    bodies: &'a Bodies,
    options: Options,
    is_found: AtomicBool,
}

impl<'a> AnyContact<'a> {
    pub(super) fn new(bodies: &'a Bodies, options: Options) -> Self {
        Self {
            bodies,
            options,
            is_found: AtomicBool::new(false),
        }
    }

    pub(super) fn is_found(&self) -> bool {
        self.is_found.load(Ordering::Relaxed)
    }
}

impl Collect for AnyContact<'_> {
    fn until(&self) -> f64 {
        if self.is_found() {
            f64::NEG_INFINITY
        } else {
            self.options.until
        }
    }

    fn decide(&self, candidates: &[Candidate], part: Part) {
        let options = self.options.until(self.options.until.min(part.end));
        let mut candidates = candidates.iter();
        if candidates.any(|candidate| !self.is_found() && candidate.collides(self.bodies, options)) {
            self.is_found.store(true, Ordering::Relaxed);
        }
    }
}

/// The earliest contact, the least of several at its time.
pub(super) struct Earliest<'a> {
    bodies: &'a Bodies,
    options: Options,
    /// The bits of a time by which there is a contact: the bits of f64 that are not negative are in the order
    /// of the numbers.
    until: AtomicU64,
    first: Mutex<Option<(ContactTime, Key, Candidate)>>,
}

impl<'a> Earliest<'a> {
    pub(super) fn new(bodies: &'a Bodies, options: Options) -> Self {
        Self {
            bodies,
            options,
            until: AtomicU64::new(options.until.abs().to_bits()),
            first: Mutex::new(None),
        }
    }

    pub(super) fn candidate(self) -> Option<Candidate> {
        let first = self.first.into_inner().unwrap_or_else(PoisonError::into_inner);
        first.map(|(_, _, candidate)| candidate)
    }
}

impl Collect for Earliest<'_> {
    fn until(&self) -> f64 {
        f64::from_bits(self.until.load(Ordering::Relaxed))
    }

    /// The filters bracket the first time of each, in floating point. None that begins after the end of
    /// another bracket, or after a time that was found, is the earliest. So few times are computed to the
    /// last bit.
    fn decide(&self, candidates: &[Candidate], part: Part) {
        let mut open = Vec::new();
        for candidate in candidates {
            let until = self.until().min(part.end);
            if let Some([start, end]) = candidate.bracket(self.bodies, self.options.until(until)) {
                self.until.fetch_min(end.to_bits(), Ordering::Relaxed);
                open.push((start, candidate));
            }
        }
        open.sort_by(|(a, one), (b, other)| a.total_cmp(b).then_with(|| one.key().cmp(&other.key())));
        for (start, candidate) in open {
            let until = self.until().min(part.end);
            if start > until {
                break;
            }
            let Some(time) = candidate.first_time(self.bodies, self.options.until(until)) else {
                continue;
            };
            self.until.fetch_min(time.upper().to_bits(), Ordering::Relaxed);
            let key = candidate.key();
            let mut first = self.first.lock().unwrap_or_else(PoisonError::into_inner);
            if first
                .as_ref()
                .is_none_or(|(before, other, _)| (time, key) < (*before, *other))
            {
                *first = Some((time, key, candidate.clone()));
            }
        }
    }
}

/// The first time of every contact, in no order.
pub(super) struct AllContacts<'a> {
    bodies: &'a Bodies,
    options: Options,
    contacts: Gathered<(ContactTime, Candidate)>,
}

impl<'a> AllContacts<'a> {
    pub(super) fn new(bodies: &'a Bodies, options: Options) -> Self {
        Self {
            bodies,
            options,
            contacts: Gathered::default(),
        }
    }

    pub(super) fn list(self) -> Vec<(ContactTime, Candidate)> {
        self.contacts.into_list()
    }
}

impl Collect for AllContacts<'_> {
    fn until(&self) -> f64 {
        self.options.until
    }

    /// A contact belongs to the part in which its first time is: after the start, but in the first part.
    fn decide(&self, candidates: &[Candidate], part: Part) {
        let options = self.options.until(self.options.until.min(part.end));
        let is_new = |time: ContactTime| part.start <= 0.0 || !time.is_at_most(part.start);
        let found = candidates.iter().filter_map(|candidate| {
            let time = candidate.first_time(self.bodies, options)?;
            is_new(time).then(|| (time, candidate.clone()))
        });
        self.contacts.append(found.collect());
    }
}
