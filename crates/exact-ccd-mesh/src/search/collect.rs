//! Collectors of the contacts among candidates.

use std::borrow::Cow;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use exact_ccd::{Collision, Kind};

use super::contact::Contact;
use super::pair_collision::PairCollision;
use crate::gathered::Gathered;
use crate::pairs::{ByKind, Pair, PairCounts, Searched};

/// A collector of contacts, which the narrow phase passes to it, in batches in any order, on any thread.
pub(crate) trait Collect: Sync {
    /// The contacts in one batch of pairs, before [`end`](Self::end) unites them with the others.
    type Batch: Default;

    /// True if contacts that are found early shorten the search, and if a pair may be examined
    /// twice.
    const PROFITS_FROM_SAMPLE: bool = false;

    /// The time after which contacts are irrelevant.
    fn until(&self) -> f64;

    /// The pairs among some of one kind whose contacts may be relevant, and the time after which they are
    /// not. `Break` ends the search.
    fn relevant<'a, K: Searched>(&self, pairs: &'a [[u32; 2]]) -> ControlFlow<(), Relevant<'a>> {
        ControlFlow::Continue((Cow::Borrowed(pairs), self.until()))
    }

    /// Takes a pair that comes within its distance.
    fn add<K: Searched>(&self, batch: &mut Self::Batch, ids: [u32; 2], found: PairCollision<'_, K>);

    /// Takes a batch after its last pair, and the number of all pairs of the batch, with the irrelevant ones.
    /// `Break` ends the search.
    fn end<K: Searched>(&self, batch: Self::Batch, pair_count: usize) -> ControlFlow<()>;

    /// Forgets the numbers of one kind, after a sample: its pairs are examined again.
    fn forget_sample<K: Searched>(&self) {}
}

/// Pairs, and the time after which their contacts are irrelevant.
pub(crate) type Relevant<'a> = (Cow<'a, [[u32; 2]]>, f64);

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
    type Batch = ();

    fn until(&self) -> f64 {
        self.until
    }

    fn add<K: Searched>(&self, (): &mut (), ids: [u32; 2], found: PairCollision<'_, K>) {
        if !self.is_found() && found.contact().is_some() && (self.counts)(Pair::new(K::KIND, ids)) {
            self.is_found.store(true, Ordering::Relaxed);
        }
    }

    fn end<K: Searched>(&self, (): (), _: usize) -> ControlFlow<()> {
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

    /// Takes a contact if it is earlier than all so far.
    pub(super) fn offer<K: Kind>(&self, pair: Pair, collision: &Collision<'_, K>) {
        // Equal times count, for a lesser pair. The normal may take long: it is computed before the lock.
        let time = collision.time();
        if time.lower() <= self.until() && self.contact().is_none_or(|first| (time, pair) < first.key()) {
            self.take(Contact::new(pair, collision));
        }
    }

    /// Takes a contact if it is still earlier than all others.
    pub(super) fn take(&self, new: Contact) {
        let mut contact = self.contact.lock().unwrap_or_else(PoisonError::into_inner);
        if contact.is_none_or(|first| new.key() < first.key()) {
            *contact = Some(new);
            self.limit
                .store(new.impact.time.upper().to_bits(), Ordering::Relaxed);
        }
    }
}

impl Collect for Earliest {
    /// The number of pairs that start within their distance.
    type Batch = usize;

    const PROFITS_FROM_SAMPLE: bool = true;

    fn until(&self) -> f64 {
        f64::from_bits(self.limit.load(Ordering::Relaxed))
    }

    fn relevant<'a, K: Searched>(&self, pairs: &'a [[u32; 2]]) -> ControlFlow<(), Relevant<'a>> {
        let all = Cow::Borrowed(pairs);
        let Some((time, first)) = self.contact().map(|contact| contact.key()) else {
            return ControlFlow::Continue((all, self.until()));
        };
        // At the same time, a lesser pair comes first. The kinds are examined in the order of pairs.
        let is_later = Pair::new(K::KIND, [0; 2]) > first;
        let starts = time.is_start() && self.touching.is_none();
        ControlFlow::Continue(match (starts, is_later) {
            (true, true) => return ControlFlow::Break(()),
            (true, false) => {
                let is_lesser = |ids: &[u32; 2]| Pair::new(K::KIND, *ids) < first;
                (pairs.iter().copied().filter(is_lesser).collect(), 0.0)
            }
            (false, true) => (all, time.lower()),
            (false, false) => (all, self.until()),
        })
    }

    fn add<K: Searched>(&self, touching: &mut usize, ids: [u32; 2], found: PairCollision<'_, K>) {
        *touching += usize::from(found.starts_within());
        if let Some(collision) = found.contact() {
            self.offer(Pair::new(K::KIND, ids), &collision);
        }
    }

    fn end<K: Searched>(&self, touching: usize, _: usize) -> ControlFlow<()> {
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

    /// Adds some contacts.
    pub(super) fn append(&self, some: Vec<Contact>) {
        self.contacts.append(some);
    }

    /// The contacts in their order.
    pub(crate) fn sorted(self) -> Vec<Contact> {
        let mut contacts = self.contacts.into_list();
        contacts.sort_unstable_by_key(Contact::key);
        contacts
    }
}

impl Collect for AllContacts {
    type Batch = Vec<Contact>;

    fn until(&self) -> f64 {
        self.until
    }

    fn add<K: Searched>(&self, batch: &mut Vec<Contact>, ids: [u32; 2], found: PairCollision<'_, K>) {
        let contact = found.contact();
        batch.extend(contact.map(|collision| Contact::new(Pair::new(K::KIND, ids), &collision)));
    }

    fn end<K: Searched>(&self, batch: Vec<Contact>, _: usize) -> ControlFlow<()> {
        self.append(batch);
        ControlFlow::Continue(())
    }
}
