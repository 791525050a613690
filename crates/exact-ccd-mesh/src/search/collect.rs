//! Collectors of the contacts among candidates.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use exact_ccd::{Collision, Kind};

use super::contact::Contact;
use super::narrow_phase::NarrowPhase;
use crate::gathered::Gathered;
use crate::mesh::TriangleMesh;
use crate::pairs::{ByKind, Pair, PairCounts, Searched};

/// A collector of contacts: receives batches of candidates in any order, on any thread.
pub(crate) trait Collect: Sync {
    /// True if contacts that are found early shorten the search, and if a pair may be examined
    /// twice.
    const PROFITS_FROM_SAMPLE: bool;

    /// The time after which contacts are irrelevant.
    fn until(&self) -> f64;

    /// Examines candidates of one kind, of two primitives of one set the smaller index first. `Break` ends
    /// the search.
    fn examine<K: Searched>(
        &self,
        narrow_phase: &NarrowPhase,
        mesh: &TriangleMesh,
        pairs: &[[u32; 2]],
    ) -> ControlFlow<()>;

    /// Forgets the numbers of one kind, after a sample: its pairs are examined again.
    fn forget_sample<K: Searched>(&self) {}
}

/// The existence of a contact that counts.
pub(crate) struct AnyContact<'a> {
    until: f64,
    is_found: AtomicBool,
    /// Evaluated for pairs in contact only.
    counts: &'a (dyn Fn(Pair) -> bool + Sync),
}

impl<'a> AnyContact<'a> {
    pub(crate) fn new(until: f64, counts: &'a (dyn Fn(Pair) -> bool + Sync)) -> Self {
        Self {
            until,
            is_found: AtomicBool::new(false),
            counts,
        }
    }

    pub(crate) fn is_found(&self) -> bool {
        self.is_found.load(Ordering::Relaxed)
    }
}

impl Collect for AnyContact<'_> {
    const PROFITS_FROM_SAMPLE: bool = false;

    fn until(&self) -> f64 {
        self.until
    }

    fn examine<K: Searched>(
        &self,
        narrow_phase: &NarrowPhase,
        mesh: &TriangleMesh,
        pairs: &[[u32; 2]],
    ) -> ControlFlow<()> {
        narrow_phase.collisions::<K>(mesh, pairs, self.until(), |ids, pair| {
            if !self.is_found() && pair.contact().is_some() && (self.counts)(Pair::new(K::KIND, ids)) {
                self.is_found.store(true, Ordering::Relaxed);
            }
        });
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
    contact: Mutex<Option<Contact>>,
    /// The numbers of pairs that start within their distance, if they are to be counted. Their boxes meet at
    /// t = 0, so that a search until any time examines all of them.
    touching: Option<ByKind<AtomicUsize>>,
}

impl Earliest {
    /// The earliest contact until a time.
    pub(crate) fn new(until: f64) -> Self {
        Self {
            limit: AtomicU64::new(until.to_bits()),
            contact: Mutex::new(None),
            touching: None,
        }
    }

    /// The earliest contact of the step, with the pairs that start within their distance.
    pub(crate) fn with_touching() -> Self {
        Self {
            touching: Some(ByKind::default()),
            ..Self::new(1.0)
        }
    }

    /// The earliest contact so far.
    pub(crate) fn contact(&self) -> Option<Contact> {
        *self.contact.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The numbers of pairs that start within their distance.
    pub(crate) fn touching(self) -> PairCounts {
        self.touching.unwrap_or_default().map(AtomicUsize::into_inner)
    }

    fn add<K: Kind>(&self, pair: Pair, collision: &Collision<'_, K>) {
        let time = collision.time();
        let is_earliest = |found: &Option<Contact>| found.is_none_or(|found| (time, pair) < found.key());
        if !is_earliest(&self.contact()) {
            return;
        }
        // Before the lock: the normal may take long.
        let new = Contact::new(pair, collision);
        let mut contact = self.contact.lock().unwrap_or_else(PoisonError::into_inner);
        if is_earliest(&contact) {
            *contact = Some(new);
            self.limit.store(time.upper().to_bits(), Ordering::Relaxed);
        }
    }
}

impl Collect for Earliest {
    const PROFITS_FROM_SAMPLE: bool = true;

    fn until(&self) -> f64 {
        f64::from_bits(self.limit.load(Ordering::Relaxed))
    }

    fn examine<K: Searched>(
        &self,
        narrow_phase: &NarrowPhase,
        mesh: &TriangleMesh,
        pairs: &[[u32; 2]],
    ) -> ControlFlow<()> {
        let mut touching = 0;
        let mut lesser = Vec::new();
        // At the same time, a lesser pair comes first. The kinds are examined in the order of pairs.
        let is_later = |first| Pair::new(K::KIND, [0; 2]) > first;
        let (pairs, until) = match self.contact().map(|contact| contact.key()) {
            Some((time, first)) if time.is_start() && self.touching.is_none() => {
                if is_later(first) {
                    return ControlFlow::Break(());
                }
                lesser.extend(
                    pairs
                        .iter()
                        .copied()
                        .filter(|&ids| Pair::new(K::KIND, ids) < first),
                );
                (lesser.as_slice(), 0.0)
            }
            Some((time, first)) if is_later(first) => (pairs, time.lower()),
            _ => (pairs, self.until()),
        };
        narrow_phase.collisions::<K>(mesh, pairs, until, |ids, pair| {
            touching += usize::from(pair.starts_within());
            // Equal times count, for a lesser pair.
            if let Some(collision) = pair.contact()
                && collision.time().lower() <= self.until()
            {
                self.add(Pair::new(K::KIND, ids), &collision);
            }
        });
        if let Some(all) = &self.touching {
            all[K::KIND].fetch_add(touching, Ordering::Relaxed);
        }
        ControlFlow::Continue(())
    }

    fn forget_sample<K: Searched>(&self) {
        if let Some(all) = &self.touching {
            all[K::KIND].store(0, Ordering::Relaxed);
        }
    }
}

/// All contacts until a time.
pub(crate) struct AllContacts {
    until: f64,
    contacts: Gathered<Contact>,
}

impl AllContacts {
    pub(crate) fn new(until: f64) -> Self {
        Self {
            until,
            contacts: Gathered::default(),
        }
    }

    /// The contacts in their order.
    pub(crate) fn sorted(self) -> Vec<Contact> {
        let mut contacts = self.contacts.into_list();
        contacts.sort_unstable_by_key(Contact::key);
        contacts
    }
}

impl Collect for AllContacts {
    const PROFITS_FROM_SAMPLE: bool = false;

    fn until(&self) -> f64 {
        self.until
    }

    fn examine<K: Searched>(
        &self,
        narrow_phase: &NarrowPhase,
        mesh: &TriangleMesh,
        pairs: &[[u32; 2]],
    ) -> ControlFlow<()> {
        let mut found = Vec::new();
        narrow_phase.collisions::<K>(mesh, pairs, self.until(), |ids, pair| {
            let contact = pair.contact();
            found.extend(contact.map(|collision| Contact::new(Pair::new(K::KIND, ids), &collision)));
        });
        self.contacts.append(found);
        ControlFlow::Continue(())
    }
}
