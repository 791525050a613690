//! Step after step of one mesh, without a look at every candidate.

use std::ops::ControlFlow;
use std::sync::atomic::{self, AtomicBool, AtomicU64};
use std::sync::{Mutex, PoisonError};

use exact_ccd::{ContactTime, EdgeEdge, Point, VertexFace};

use crate::broad_phase::{BroadPhase, Bvh};
use crate::earliest::{EarliestContact, earlier};
use crate::kind::PairKind;
use crate::mesh::TriangleMesh;
use crate::narrow_phase::NarrowPhase;
use crate::pair::Pair;
use crate::step::{Step, StepError};
use crate::step_boxes::StepBoxes;

/// Looks for contact in step after step of one mesh.
///
/// No answer depends on what was asked before. What stays from step to step is the memory of boxes and trajectories, and
/// the order of the primitives in space, as long as it is good.
///
/// ```
/// use exact_ccd_mesh::{Detector, TriangleMesh};
///
/// let mesh = TriangleMesh::new(6, vec![[0, 1, 2], [3, 4, 5]])?;
/// let at = |height: f64| {
///     let floor = [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0]];
///     let falling = [[1.0, 1.0, height], [1.0, 2.0, height + 4.0], [2.0, 1.0, height + 4.0]];
///     [floor, falling].concat()
/// };
///
/// let mut detector = Detector::new(&mesh);
/// assert!(detector.is_free(&at(3.0), &at(1.0))?);
/// let contact = detector.earliest_contact(&at(1.0), &at(-1.0))?;
/// assert_eq!(contact.map(|contact| contact.impact.time.lower()), Some(0.5));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Detector<'a, B = Bvh> {
    mesh: &'a TriangleMesh,
    broad_phase: B,
    narrow_phase: NarrowPhase<'a>,
    resting: StepBoxes<'a, 1>,
    moving: StepBoxes<'a, 2>,
}

/// One block of primitives in so many is looked at first: enough of them to find a contact that comes early among many.
const SAMPLE: usize = 64;

/// A way is short that is so much of an edge: a box around all of it is hardly larger than one that moves along it.
const SHORT: f64 = 0.25;

/// Boxes are made anew if the time until which they are wanted has shrunk to so much.
const SHRINKAGE: f64 = 0.5;

impl<'a> Detector<'a> {
    /// For steps of `mesh`.
    #[must_use]
    pub fn new(mesh: &'a TriangleMesh) -> Self {
        Self::with_broad_phase(mesh, Bvh)
    }
}

impl<'a, B: BroadPhase> Detector<'a, B> {
    /// For steps of `mesh`, with another broad phase.
    #[must_use]
    pub fn with_broad_phase(mesh: &'a TriangleMesh, broad_phase: B) -> Self {
        Self {
            mesh,
            broad_phase,
            narrow_phase: NarrowPhase::new(mesh),
            resting: StepBoxes::new(mesh),
            moving: StepBoxes::new(mesh),
        }
    }

    /// The earliest contact in the step from positions `x0` to positions `x1`, or `None` if it is free of contact.
    ///
    /// The contacts of some primitives come first. The earliest of these bounds the time until which all others are
    /// looked at, and each contact found there lowers the bound; so most candidates are never examined, nor counted as
    /// [`StepReport`](crate::StepReport) does. The answer is the same, on any number of threads.
    ///
    /// # Errors
    /// [`StepError`] says which positions are too many, too few or not finite.
    pub fn earliest_contact(
        &mut self,
        x0: &[Point],
        x1: &[Point],
    ) -> Result<Option<EarliestContact>, StepError> {
        Ok(self.earliest_contact_of(&Step::new(self.mesh, x0, x1)?))
    }

    /// Whether no two primitives touch in the step from positions `x0` to positions `x1`. Ends soon after the first contact
    /// that it comes across.
    ///
    /// # Errors
    /// [`StepError`] says which positions are too many, too few or not finite.
    pub fn is_free(&mut self, x0: &[Point], x1: &[Point]) -> Result<bool, StepError> {
        Ok(self.is_step_free(&Step::new(self.mesh, x0, x1)?))
    }

    /// The step is one of this mesh.
    pub(crate) fn earliest_contact_of(&mut self, step: &Step<'_>) -> Option<EarliestContact> {
        let first = First::new();
        self.show(step, &first);
        first.contact(step)
    }

    /// The step is one of this mesh.
    pub(crate) fn is_step_free(&mut self, step: &Step<'_>) -> bool {
        let is_free = IsFree(AtomicBool::new(true));
        self.show(step, &is_free);
        is_free.0.into_inner()
    }

    /// Shows all contacts until the wanted time, and perhaps others, or not all if it is told to break.
    fn show(&mut self, step: &Step<'_>, wanted: &impl Wanted) {
        let Self {
            mesh,
            broad_phase,
            narrow_phase,
            resting,
            moving,
        } = self;
        let broad_phase = &*broad_phase;
        // All of it on a thread of the pool: to come from outside costs a switch each time.
        let _ = rayon::scope(|_| {
            narrow_phase.begin(step);
            let short = short(mesh, step);
            let search = Search {
                step,
                broad_phase,
                narrow_phase,
                wanted,
            };
            let were_short = wanted.until() < short;
            if were_short {
                resting.begin(step);
                search.vertices_and_faces(resting)?;
            } else {
                moving.begin(step);
                search.vertices_and_faces(moving)?;
            }
            if wanted.until() >= short {
                return search.edges(moving);
            }
            if !were_short {
                resting.begin(step);
            }
            search.edges(resting)
        });
    }
}

/// Until when all ways are short, compared with the edges.
fn short(mesh: &TriangleMesh, step: &Step<'_>) -> f64 {
    let [x0, x1] = step.positions();
    let length = |a: Point, b: Point| (0..3).fold(0.0, |most: f64, axis| most.max((a[axis] - b[axis]).abs()));
    let longest = x0.iter().zip(x1).map(|(&a, &b)| length(a, b)).fold(0.0, f64::max);
    let edges = mesh.edges().iter().step_by(SAMPLE);
    let count = edges.len() as f64;
    let sum: f64 = edges
        .map(|edge| edge.map(|v| x0[v as usize]))
        .map(|[a, b]| length(a, b))
        .sum();
    SHORT * sum / count / longest
}

/// What a search needs, but for the boxes.
struct Search<'a, B, W> {
    step: &'a Step<'a>,
    broad_phase: &'a B,
    narrow_phase: &'a NarrowPhase<'a>,
    wanted: &'a W,
}

impl<B: BroadPhase, W: Wanted> Search<'_, B, W> {
    fn vertices_and_faces<const T: usize>(&self, boxes: &mut StepBoxes<'_, T>) -> ControlFlow<()> {
        let look = |pairs: &[_]| self.wanted.look::<VertexFace>(self.narrow_phase, pairs);
        let time = self.wanted.until();
        boxes.vertices_and_faces_until(self.step, time);
        let sample = boxes.vertices.sample(SAMPLE);
        self.broad_phase.between(&sample, &boxes.faces, &look)?;
        if self.wanted.until() < SHRINKAGE * time {
            boxes.vertices_and_faces_until(self.step, self.wanted.until());
        }
        self.broad_phase.between(&boxes.vertices, &boxes.faces, &look)
    }

    fn edges<const T: usize>(&self, boxes: &mut StepBoxes<'_, T>) -> ControlFlow<()> {
        let look = |pairs: &[_]| self.wanted.look::<EdgeEdge>(self.narrow_phase, pairs);
        let time = self.wanted.until();
        boxes.edges_until(self.step, time);
        let sample = boxes.edges.sample(SAMPLE);
        self.broad_phase.between(&sample, &boxes.edges, &look)?;
        if self.wanted.until() < SHRINKAGE * time {
            boxes.edges_until(self.step, self.wanted.until());
        }
        self.broad_phase.within(&boxes.edges, &look)
    }
}

/// What is asked about contacts.
trait Wanted: Sync {
    /// Contacts after this time make no difference.
    fn until(&self) -> f64;

    /// Looks at the contacts among some pairs.
    fn look<K: PairKind>(&self, narrow_phase: &NarrowPhase<'_>, pairs: &[[u32; 2]]) -> ControlFlow<()>;
}

/// Whether none has been found.
struct IsFree(AtomicBool);

impl Wanted for IsFree {
    fn until(&self) -> f64 {
        1.0
    }

    fn look<K: PairKind>(&self, narrow_phase: &NarrowPhase<'_>, pairs: &[[u32; 2]]) -> ControlFlow<()> {
        narrow_phase.collisions::<K>(pairs, |_, _| self.0.store(false, atomic::Ordering::Relaxed));
        if self.0.load(atomic::Ordering::Relaxed) {
            ControlFlow::Continue(())
        } else {
            ControlFlow::Break(())
        }
    }
}

/// The first contact that any thread has found.
struct First {
    /// The bits of the least f64 that is not below its time. Written under the lock, so that it only falls.
    limit: AtomicU64,
    contact: Mutex<Option<(ContactTime, Pair)>>,
}

impl First {
    fn new() -> Self {
        Self {
            limit: AtomicU64::new(1f64.to_bits()),
            contact: Mutex::new(None),
        }
    }

    fn add(&self, time: ContactTime, pair: Pair) {
        let mut contact = self.contact.lock().unwrap_or_else(PoisonError::into_inner);
        *contact = earlier(*contact, Some((time, pair)));
        if let Some((time, _)) = *contact {
            self.limit
                .store(time.upper().to_bits(), atomic::Ordering::Relaxed);
        }
    }

    fn contact(self, step: &Step<'_>) -> Option<EarliestContact> {
        let contact = self.contact.into_inner().unwrap_or_else(PoisonError::into_inner);
        contact.and_then(|(_, pair)| EarliestContact::of(step, pair))
    }
}

impl Wanted for First {
    fn until(&self) -> f64 {
        f64::from_bits(self.limit.load(atomic::Ordering::Relaxed))
    }

    fn look<K: PairKind>(&self, narrow_phase: &NarrowPhase<'_>, pairs: &[[u32; 2]]) -> ControlFlow<()> {
        narrow_phase.collisions::<K>(pairs, |ids, collision| {
            let time = collision.first_contact_time();
            // If they may be equal, the lesser pair comes first.
            if time.lower() <= self.until() {
                self.add(time, K::pair(ids));
            }
        });
        ControlFlow::Continue(())
    }
}
