//! All contacts of a step, counted.

use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};

use exact_ccd::Point;

use super::collect::{AllContacts, Collect, Earliest};
use super::contact::Contact;
use super::narrow_phase::{Examiner, NarrowPhase};
use super::pair_collision::PairCollision;
use crate::broad_phase::{BroadPhase, Bvh};
use crate::mesh::TriangleMesh;
use crate::overlaps::{self, CandidateError, CandidateOptions};
use crate::pairs::{ByKind, Pair, PairCounts, Searched};
use crate::steps::{Step, StepError};

/// The contacts of a step of a mesh, counted; with a minimum distance, as defined by
/// [`MinDistance`](crate::MinDistance).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepReport {
    /// The number of pairs of primitives that come near each other; see
    /// [`Candidates`](crate::Candidates).
    pub candidates: PairCounts,
    /// The number of candidates that are in contact at some time of the step.
    pub colliding: PairCounts,
    /// The number of candidates that touch at t = 0: pairs within their minimum distance, even if an
    /// [inner one](crate::MinDistance::with_inner) holds for them.
    pub touching: PairCounts,
    /// The earliest contact, or `None` if the step is free of contact.
    pub earliest: Option<Contact>,
}

/// Finds and counts the contacts of a mesh with itself in one time step.
///
/// `x0` and `x1` are the positions of the vertices at t = 0 and t = 1. Pairs of primitives that
/// share a vertex always touch and are left out. For progress, or for another broad phase, call
/// [`StepReport::new`], as this function does. If only the earliest contact, or only its
/// existence, matters, [`Detector`](crate::Detector) is faster.
///
/// A mesh that is pierced at the start, by an edge that passes through a face, may be free of contact:
/// [`intersections`](crate::intersections) finds such edges.
///
/// ```
/// use exact_ccd_mesh::{Pair, TriangleMesh, step};
///
/// // A vertex of one triangle falls through another triangle, which rests.
/// let mesh = TriangleMesh::new(6, vec![[0, 1, 2], [3, 4, 5]])?;
/// let floor = [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0]];
/// let falling = |height: f64| [[1.0, 1.0, height], [1.0, 2.0, height + 4.0], [2.0, 1.0, height + 4.0]];
/// let (x0, x1) = ([floor, falling(1.0)].concat(), [floor, falling(-1.0)].concat());
///
/// let report = step(&mesh, &x0, &x1)?;
/// assert_eq!(report.time_of_impact(), Some(0.5));
/// assert_eq!(report.earliest.map(|contact| contact.pair), Some(Pair::VertexFace { vertex: 3, face: 0 }));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`StepError`] names the positions that are too many, too few or not finite.
pub fn step(mesh: &TriangleMesh, x0: &[Point], x1: &[Point]) -> Result<StepReport, StepError> {
    let step = Step::new(mesh, x0, x1)?;
    Ok(StepReport::new(step, &Bvh, &|_| ()))
}

impl StepReport {
    /// Examines all candidates of a step, as the broad phase finds them, without storing them.
    ///
    /// Calls `progress` after each batch, from any thread, with the number of candidates in it.
    #[must_use]
    pub fn new(step: Step<'_>, broad_phase: &dyn BroadPhase, progress: &(dyn Fn(usize) + Sync)) -> Self {
        let report = Self::with_options(step, broad_phase, &CandidateOptions::default(), progress);
        report.expect("the default distances are 0")
    }

    /// The same among other candidates, and for another minimum distance.
    ///
    /// # Errors
    /// [`CandidateError`], if the distance is negative or not a number, or if the number of thicknesses
    /// differs from the number of vertices.
    pub fn with_options(
        step: Step<'_>,
        broad_phase: &dyn BroadPhase,
        options: &CandidateOptions,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<Self, CandidateError> {
        Self::tally(step, broad_phase, options, progress, None)
    }

    /// The same with all contacts, the earliest first.
    ///
    /// # Errors
    /// As [`with_options`](Self::with_options).
    pub fn with_contacts(
        step: Step<'_>,
        broad_phase: &dyn BroadPhase,
        options: &CandidateOptions,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<(Self, Vec<Contact>), CandidateError> {
        let all = AllContacts::new(1.0);
        let report = Self::tally(step, broad_phase, options, progress, Some(&all))?;
        Ok((report, all.sorted()))
    }

    fn tally(
        step: Step<'_>,
        broad_phase: &dyn BroadPhase,
        options: &CandidateOptions,
        progress: &(dyn Fn(usize) + Sync),
        all: Option<&AllContacts>,
    ) -> Result<Self, CandidateError> {
        let tallies = Tallies {
            progress,
            counts: ByKind::default(),
            earliest: Earliest::new(1.0),
            all,
        };
        let examiner = Examiner {
            narrow_phase: &NarrowPhase::of(&step, options.min_distance.clone()),
            mesh: step.mesh(),
            collector: &tallies,
        };
        let _ = overlaps::stream(step, broad_phase, options, &examiner)?;
        let of_kind = |counts: &Mutex<Counts>| *counts.lock().unwrap_or_else(PoisonError::into_inner);
        let counts = tallies.counts.map_ref(of_kind);
        Ok(Self {
            candidates: counts.map_ref(|counts| counts.candidates),
            colliding: counts.map_ref(|counts| counts.colliding),
            touching: counts.map_ref(|counts| counts.touching),
            earliest: tallies.earliest.contact(),
        })
    }

    /// Returns true if no two primitives touch during the step.
    #[must_use]
    pub fn is_free(&self) -> bool {
        self.earliest.is_none()
    }

    /// The largest f64 not above the earliest contact time, if there is contact.
    #[must_use]
    pub fn time_of_impact(&self) -> Option<f64> {
        self.earliest.map(|contact| contact.impact.time.lower())
    }
}

/// The counts of each kind of pairs, and the earliest contact.
struct Tallies<'a> {
    progress: &'a (dyn Fn(usize) + Sync),
    counts: ByKind<Mutex<Counts>>,
    earliest: Earliest,
    /// All contacts, if they are wanted.
    all: Option<&'a AllContacts>,
}

/// The counts of one kind of pairs.
#[derive(Clone, Copy, Default)]
struct Counts {
    candidates: usize,
    colliding: usize,
    touching: usize,
}

impl Collect for Tallies<'_> {
    type Batch = (Counts, Vec<Contact>);

    fn until(&self) -> f64 {
        1.0
    }

    fn add<K: Searched>(&self, batch: &mut Self::Batch, ids: [u32; 2], found: PairCollision<'_, K>) {
        let (counts, contacts) = batch;
        counts.touching += usize::from(found.starts_within());
        let Some(collision) = found.contact() else {
            return;
        };
        counts.colliding += 1;
        let pair = Pair::new(K::KIND, ids);
        if self.all.is_none() {
            self.earliest.offer(pair, &collision);
            return;
        }
        let contact = Contact::new(pair, &collision);
        self.earliest.take(contact);
        contacts.push(contact);
    }

    fn end<K: Searched>(&self, (counts, contacts): Self::Batch, pair_count: usize) -> ControlFlow<()> {
        if let Some(all) = self.all {
            all.append(contacts);
        }
        {
            let mut all = self.counts[K::KIND]
                .lock()
                .unwrap_or_else(PoisonError::into_inner);
            all.candidates += pair_count;
            all.colliding += counts.colliding;
            all.touching += counts.touching;
        }
        // After the lock is released: the callback may take long, or wait for other threads.
        (self.progress)(pair_count);
        ControlFlow::Continue(())
    }
}
