//! Collectors of the contacts among candidates.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};

use exact_ccd::ContactTime;

use crate::contact::{Contact, earlier};
use crate::mesh::TriangleMesh;
use crate::narrow_phase::NarrowPhase;
use crate::pair::{Pair, PairKind};
use crate::step::Step;

/// A collector of contacts: receives batches of candidates in any order, on any thread.
pub(crate) trait Collect: Sync {
    /// True if contacts that are found early shorten the search, and if a pair may be examined
    /// twice.
    const PROFITS_FROM_SAMPLE: bool;

    /// The time after which contacts are irrelevant.
    fn until(&self) -> f64;

    /// Examines candidates of one kind. `Break` ends the search.
    fn examine<K: PairKind>(
        &self,
        narrow_phase: &NarrowPhase,
        mesh: &TriangleMesh,
        pairs: &[[u32; 2]],
    ) -> ControlFlow<()>;
}

/// The existence of a contact.
#[derive(Default)]
pub(crate) struct AnyContact(AtomicBool);

impl AnyContact {
    pub(crate) fn is_found(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

impl Collect for AnyContact {
    const PROFITS_FROM_SAMPLE: bool = true;

    fn until(&self) -> f64 {
        1.0
    }

    fn examine<K: PairKind>(
        &self,
        narrow_phase: &NarrowPhase,
        mesh: &TriangleMesh,
        pairs: &[[u32; 2]],
    ) -> ControlFlow<()> {
        narrow_phase.collisions::<K>(mesh, pairs, |_, _| self.0.store(true, Ordering::Relaxed));
        if self.is_found() {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }
}

/// The earliest contact that any thread has found.
pub(crate) struct Earliest {
    /// The bits of the least f64 that is not below its time. Written under the lock, so that it
    /// never increases.
    limit: AtomicU64,
    contact: Mutex<Option<(ContactTime, Pair)>>,
}

impl Earliest {
    pub(crate) fn new() -> Self {
        Self {
            limit: AtomicU64::new(1f64.to_bits()),
            contact: Mutex::new(None),
        }
    }

    /// The contact, with the details of its impact in the step.
    pub(crate) fn contact(self, step: &Step<'_>) -> Option<Contact> {
        let contact = self.contact.into_inner().unwrap_or_else(PoisonError::into_inner);
        contact.and_then(|(_, pair)| Contact::of(step, pair))
    }

    fn add(&self, time: ContactTime, pair: Pair) {
        let mut contact = self.contact.lock().unwrap_or_else(PoisonError::into_inner);
        *contact = earlier(*contact, Some((time, pair)));
        if let Some((time, _)) = *contact {
            self.limit.store(time.upper().to_bits(), Ordering::Relaxed);
        }
    }
}

impl Collect for Earliest {
    const PROFITS_FROM_SAMPLE: bool = true;

    fn until(&self) -> f64 {
        f64::from_bits(self.limit.load(Ordering::Relaxed))
    }

    fn examine<K: PairKind>(
        &self,
        narrow_phase: &NarrowPhase,
        mesh: &TriangleMesh,
        pairs: &[[u32; 2]],
    ) -> ControlFlow<()> {
        narrow_phase.collisions::<K>(mesh, pairs, |ids, collision| {
            let time = collision.first_contact_time();
            // Equal times count: then the lesser pair comes first.
            if time.lower() <= self.until() {
                self.add(time, K::pair(ids));
            }
        });
        ControlFlow::Continue(())
    }
}

/// All contacts until a time.
pub(crate) struct ContactsUntil {
    time: f64,
    contacts: Mutex<Vec<Contact>>,
}

impl ContactsUntil {
    /// The contacts until a time of the step; `None` if there is no contact until then, as for
    /// negative times and NaN.
    pub(crate) fn new(time: f64) -> Option<Self> {
        (time >= 0.0).then(|| Self {
            time: time.min(1.0),
            contacts: Mutex::default(),
        })
    }

    /// The contacts in their order.
    pub(crate) fn sorted(self) -> Vec<Contact> {
        let mut contacts = self.contacts.into_inner().unwrap_or_else(PoisonError::into_inner);
        contacts.sort_unstable_by(Contact::compare);
        contacts
    }
}

impl Collect for ContactsUntil {
    const PROFITS_FROM_SAMPLE: bool = false;

    fn until(&self) -> f64 {
        self.time
    }

    fn examine<K: PairKind>(
        &self,
        narrow_phase: &NarrowPhase,
        mesh: &TriangleMesh,
        pairs: &[[u32; 2]],
    ) -> ControlFlow<()> {
        let mut found = Vec::new();
        narrow_phase.collisions::<K>(mesh, pairs, |ids, collision| {
            let time = collision.first_contact_time();
            // A time that is not an f64 lies above its lower bound.
            if time.lower() < self.time || time.is_exact() && time.lower() <= self.time {
                let (pair, impact) = (K::pair(ids), collision.impact());
                found.push(Contact { pair, impact });
            }
        });
        if !found.is_empty() {
            let mut contacts = self.contacts.lock().unwrap_or_else(PoisonError::into_inner);
            contacts.append(&mut found);
        }
        ControlFlow::Continue(())
    }
}
