//! All contacts of a step, counted.

use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};

use exact_ccd::Point;

use super::contact::Contact;
use super::narrow_phase::NarrowPhase;
use crate::broad_phase::{BroadPhase, Bvh};
use crate::gathered::Gathered;
use crate::mesh::TriangleMesh;
use crate::overlaps::{self, CandidateError, CandidateOptions, Receive};
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
        let list = Gathered::default();
        let report = Self::tally(step, broad_phase, options, progress, Some(&list))?;
        let mut contacts = list.into_list();
        contacts.sort_unstable_by_key(Contact::key);
        Ok((report, contacts))
    }

    fn tally(
        step: Step<'_>,
        broad_phase: &dyn BroadPhase,
        options: &CandidateOptions,
        progress: &(dyn Fn(usize) + Sync),
        list: Option<&Gathered<Contact>>,
    ) -> Result<Self, CandidateError> {
        let tallies = Tallies {
            narrow_phase: NarrowPhase::of(&step, options.min_distance.clone()),
            mesh: step.mesh(),
            progress,
            tallies: ByKind::default(),
            list,
        };
        let _ = overlaps::stream(step, broad_phase, options, &tallies)?;
        let of_kind = |tally: Mutex<Tally>| tally.into_inner().unwrap_or_else(PoisonError::into_inner);
        let tallies = tallies.tallies.map(of_kind);
        let earliest = tallies.iter().filter_map(|(_, tally)| tally.earliest);
        Ok(Self {
            candidates: tallies.map(|tally| tally.candidates),
            colliding: tallies.map(|tally| tally.colliding),
            touching: tallies.map(|tally| tally.touching),
            earliest: earliest.min_by_key(Contact::key),
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

/// The counts of each kind of pairs.
struct Tallies<'a> {
    narrow_phase: NarrowPhase,
    mesh: &'a TriangleMesh,
    progress: &'a (dyn Fn(usize) + Sync),
    tallies: ByKind<Mutex<Tally>>,
    /// All contacts, if they are wanted.
    list: Option<&'a Gathered<Contact>>,
}

/// The counts of one kind of pairs.
#[derive(Clone, Copy, Default)]
struct Tally {
    candidates: usize,
    colliding: usize,
    touching: usize,
    earliest: Option<Contact>,
}

impl Receive for Tallies<'_> {
    fn receive<K: Searched>(&self, candidates: Vec<[u32; 2]>) -> ControlFlow<()> {
        if candidates.is_empty() {
            return ControlFlow::Continue(());
        }
        let tally = || {
            self.tallies[K::KIND]
                .lock()
                .unwrap_or_else(PoisonError::into_inner)
        };
        let (mut earliest, mut contacts) = (tally().earliest, Vec::new());
        let (mut colliding, mut touching) = (0, 0);
        self.narrow_phase
            .collisions::<K>(self.mesh, &candidates, 1.0, |ids, pair| {
                touching += usize::from(pair.starts_within());
                let Some(collision) = pair.contact() else {
                    return;
                };
                colliding += 1;
                let pair = Pair::new(K::KIND, ids);
                let is_earliest =
                    earliest.is_none_or(|first: Contact| (collision.time(), pair) < first.key());
                if !is_earliest && self.list.is_none() {
                    return;
                }
                let contact = Contact::new(pair, &collision);
                if is_earliest {
                    earliest = Some(contact);
                }
                contacts.push(contact);
            });
        if let Some(list) = self.list {
            list.append(contacts);
        }
        {
            let mut tally = tally();
            tally.candidates += candidates.len();
            tally.colliding += colliding;
            tally.touching += touching;
            tally.earliest = tally
                .earliest
                .into_iter()
                .chain(earliest)
                .min_by_key(Contact::key);
        }
        // After the lock is released: the callback may take long, or wait for other threads.
        (self.progress)(candidates.len());
        ControlFlow::Continue(())
    }
}
