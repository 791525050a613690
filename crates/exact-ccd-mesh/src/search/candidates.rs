//! The pairs of primitives that come near each other in a step.

use std::ops::ControlFlow;

use exact_ccd::{AnyKind, Ccd, Options, with_kind};
use rayon::prelude::*;

use super::collect::{AllContacts, AnyContact, Collect, Earliest};
use super::contact::Contact;
use super::method;
use super::narrow_phase::{Examiner, NarrowPhase};
use crate::broad_phase::{BroadPhase, PairCollector};
use crate::overlaps::{self, CandidateError, CandidateOptions};
use crate::pairs::{ByKind, MinDistance, Pair, PairCounts, Receive, Searched};
use crate::steps::Step;

/// Pairs of primitives that come near each other in a step, by their indices.
///
/// Pairs that share a vertex are never among them. The pairs of a step hold for every step of the
/// same mesh from the same start to positions in between, such as [`Step::at`] returns: so one
/// broad phase suffices for a whole line search.
///
/// [`Options`] have the distance at which primitives touch, and the last time that counts. Decisions are
/// about all pairs of the mesh if that distance is not above the [minimum
/// distance](CandidateOptions::min_distance) for which the candidates were found. A vertex without a
/// thickness has the thickness 0. Other methods decide contact. No pair collides until a time that is
/// negative or not a number; a [`Detector`](crate::Detector) refuses it.
///
/// [`FromIterator`] makes candidates of [`Pair`]s from another source. Each is kept once. Pairs that a mesh
/// does not have, or that share a vertex, are no contacts.
///
/// ```
/// use exact_ccd::{AnyKind, CONTACT, Exact};
/// use exact_ccd_mesh::{Bvh, Candidates, Step, TriangleMesh};
///
/// let mesh = TriangleMesh::new(4, vec![[0, 1, 2]])?;
/// let start = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.25, 0.25, 1.0]];
/// let mut end = start;
/// end[3][2] = -1.0;
///
/// let step = Step::new(&mesh, &start, &end)?;
/// let candidates = Candidates::new(step, &Bvh);
/// assert_eq!(candidates.of_kind(AnyKind::VertexFace), [[3, 0]]);
/// let contact = candidates.collision(step, CONTACT);
/// assert_eq!(contact.map(|contact| contact.impact.time.lower()), Some(0.5));
///
/// let shorter = step.at(0.25);
/// assert!(!candidates.collides(Step::new(&mesh, &start, &shorter)?, CONTACT));
/// assert!(candidates.collides_by(step, &Exact));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Candidates(ByKind<Vec<[u32; 2]>>);

/// The number of pairs that a thread examines exactly between two checks for the end of the search.
const GRAIN: usize = 2048;

impl Candidates {
    /// All pairs whose boxes meet in the step: all contacts of the step are among them.
    #[must_use]
    pub fn new(step: Step<'_>, broad_phase: &dyn BroadPhase) -> Self {
        let candidates = Self::with_options(step, broad_phase, &CandidateOptions::default());
        candidates.expect("the default distances are 0")
    }

    /// The candidates of a step, with options.
    ///
    /// # Errors
    /// [`CandidateError`], if the distance is negative or not a number, or if the number of thicknesses
    /// differs from the number of vertices.
    pub fn with_options(
        step: Step<'_>,
        broad_phase: &dyn BroadPhase,
        options: &CandidateOptions,
    ) -> Result<Self, CandidateError> {
        let collectors = ByKind::<PairCollector>::default();
        let _ = overlaps::stream(step, broad_phase, options, &collectors)?;
        Ok(Self(collectors.map(PairCollector::into_sorted)))
    }

    /// Passes the candidates of a step on as they are found, in batches, from any thread, without
    /// storing them.
    ///
    /// The order of batches and of pairs in them may differ from run to run. Returns `Break` if the
    /// sink did.
    ///
    /// # Errors
    /// As [`with_options`](Self::with_options).
    pub fn stream(
        step: Step<'_>,
        broad_phase: &dyn BroadPhase,
        options: &CandidateOptions,
        sink: &(dyn Fn(&[Pair]) -> ControlFlow<()> + Sync),
    ) -> Result<ControlFlow<()>, CandidateError> {
        overlaps::stream(step, broad_phase, options, &Sink(sink))
    }

    /// Lists of pairs without a common vertex, in any order.
    pub(super) fn from_lists(lists: ByKind<Vec<[u32; 2]>>) -> Self {
        Self(lists)
    }

    pub(super) fn into_lists(self) -> ByKind<Vec<[u32; 2]>> {
        self.0
    }

    /// The pairs of a kind, by the indices of both primitives, sorted. Of two edges or two vertices, the
    /// smaller index comes first. [`Pair`] says which pairs there are of each kind.
    #[must_use]
    pub fn of_kind(&self, kind: AnyKind) -> &[[u32; 2]] {
        &self.0[kind]
    }

    /// All pairs, in their order.
    pub fn pairs(&self) -> impl Iterator<Item = Pair> {
        let all = self.0.iter();
        all.flat_map(|(kind, pairs)| pairs.iter().map(move |&ids| Pair::new(kind, ids)))
    }

    /// The numbers of pairs of each kind.
    #[must_use]
    pub fn counts(&self) -> PairCounts {
        self.0.map_ref(Vec::len)
    }

    /// Returns true if there are no pairs.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.counts().total() == 0
    }

    /// Returns true if any of the pairs touches in the step, exactly. Ends soon after the first contact
    /// found.
    #[must_use]
    pub fn collides(&self, step: Step<'_>, options: Options<impl Into<MinDistance>>) -> bool {
        self.decision(step, options).any()
    }

    /// The earliest contact of the pairs in the step, exactly, or `None` if there is none.
    #[must_use]
    pub fn collision(&self, step: Step<'_>, options: Options<impl Into<MinDistance>>) -> Option<Contact> {
        self.decision(step, options).earliest()
    }

    /// All contacts of the pairs in the step, exactly, the earliest first.
    #[must_use]
    pub fn collisions(&self, step: Step<'_>, options: Options<impl Into<MinDistance>>) -> Vec<Contact> {
        self.decision(step, options).all()
    }

    /// Returns true if any of the pairs is in contact in the step, according to a method. A loose vertex is
    /// passed to the method as an edge of length zero.
    #[must_use]
    pub fn collides_by(&self, step: Step<'_>, method: &dyn Ccd) -> bool {
        method::collides(method, &self.0, &step)
    }

    /// The earliest time of impact of the pairs in the step, in \[0, 1\], according to a method, or `None` if
    /// there is no contact. A time of the method that is not a number counts as 0.
    #[must_use]
    pub fn time_of_impact_by(&self, step: Step<'_>, method: &dyn Ccd) -> Option<f64> {
        method::time_of_impact(method, &self.0, &step)
    }

    fn decision<'a>(&'a self, step: Step<'a>, options: Options<impl Into<MinDistance>>) -> Decision<'a> {
        Decision {
            candidates: self,
            step,
            min_distance: options.separation.into(),
            until: options.until,
        }
    }

    /// Passes all pairs on, in batches.
    pub(super) fn pass_to(&self, receiver: &impl Receive) -> ControlFlow<()> {
        let mut kinds = AnyKind::ALL.iter();
        kinds.try_for_each(|&kind| with_kind!(kind, K => self.pass_kind_to::<K>(receiver)))
    }

    fn pass_kind_to<K: Searched>(&self, receiver: &impl Receive) -> ControlFlow<()> {
        let pairs = self.0[K::KIND].par_chunks(GRAIN);
        pairs.try_for_each(|pairs| receiver.receive::<K>(pairs))
    }
}

/// An exact decision about candidates in a step: apart from their methods, which each crate compiles again
/// for its own types.
struct Decision<'a> {
    candidates: &'a Candidates,
    step: Step<'a>,
    min_distance: MinDistance,
    until: f64,
}

impl Decision<'_> {
    fn any(self) -> bool {
        let contact = AnyContact::new(self.until, &|_| true);
        self.examine(&contact);
        contact.is_found()
    }

    fn earliest(self) -> Option<Contact> {
        let earliest = Earliest::new(self.until);
        self.examine(&earliest);
        earliest.contact()
    }

    fn all(self) -> Vec<Contact> {
        let contacts = AllContacts::new(self.until);
        self.examine(&contacts);
        contacts.sorted()
    }

    /// Passes all pairs to a collector.
    fn examine(self, collector: &impl Collect) {
        // All on threads of the pool: entering it from outside costs a context switch each time.
        rayon::scope(|_| {
            let min_distance = self.min_distance.extended_to(self.step.mesh());
            let narrow_phase = NarrowPhase::of(&self.step, min_distance);
            let _ = self.candidates.pass_to(&Examiner {
                narrow_phase: &narrow_phase,
                mesh: self.step.mesh(),
                collector,
            });
        });
    }
}

impl FromIterator<Pair> for Candidates {
    fn from_iter<I: IntoIterator<Item = Pair>>(pairs: I) -> Self {
        let mut lists = ByKind::<Vec<[u32; 2]>>::default();
        for pair in pairs {
            // Of two primitives of one set, the smaller index first.
            lists[pair.kind()].push(Pair::new(pair.kind(), pair.ids()).ids());
        }
        let sorted = |mut pairs: Vec<[u32; 2]>| {
            pairs.par_sort_unstable();
            pairs.dedup();
            pairs
        };
        Self(lists.map(sorted))
    }
}

impl Receive for ByKind<PairCollector> {
    fn receive<K: Searched>(&self, pairs: &[[u32; 2]]) -> ControlFlow<()> {
        self[K::KIND].add(pairs.iter().copied())
    }
}

/// A sink of candidates of all kinds.
struct Sink<'a>(&'a (dyn Fn(&[Pair]) -> ControlFlow<()> + Sync));

impl Receive for Sink<'_> {
    fn receive<K: Searched>(&self, pairs: &[[u32; 2]]) -> ControlFlow<()> {
        let pairs: Vec<Pair> = pairs.iter().map(|&ids| Pair::new(K::KIND, ids)).collect();
        (self.0)(&pairs)
    }
}
