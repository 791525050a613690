//! Contact in successive steps of one mesh.

use std::sync::Arc;

use exact_ccd::{Options, Point, TimeOutOfStep};

use super::collect::Collect;
use super::culled_search::CulledSearch;
use crate::at_rest::{Intersection, StartCheck};
use crate::broad_phase::{BroadPhase, Bvh};
use crate::mesh::TriangleMesh;
use crate::pairs::{CanCollide, MinDistance};
use crate::steps::{Step, StepError};

/// Finds contact in successive steps of one mesh.
///
/// [`Options`] have the distance at which primitives touch, a [`Separation`](exact_ccd::Separation) or a
/// [`MinDistance`], and the last time that counts. [`CONTACT`](exact_ccd::CONTACT) is the distance 0 and the
/// whole step. [`Pair`](crate::Pair) says which pairs are compared, and which are never a contact.
///
/// An edge that passes through a face at the start of a step is no contact of the step, which may be free:
/// [`with_start_check`](Self::with_start_check) finds such edges.
///
/// The detector shares the mesh and borrows nothing, so that a simulator can own both. No answer
/// depends on earlier steps. The detector keeps the memory of boxes and trajectories from step to
/// step, and the order of the primitives in space until neighbours in it have moved apart.
///
/// ```
/// use std::sync::Arc;
///
/// use exact_ccd::CONTACT;
/// use exact_ccd_mesh::{Detector, TriangleMesh};
///
/// struct Simulator {
///     mesh: Arc<TriangleMesh>,
///     detector: Detector,
/// }
///
/// let mesh = Arc::new(TriangleMesh::new(6, vec![[0, 1, 2], [3, 4, 5]])?);
/// let detector = Detector::new(mesh.clone());
/// let mut simulator = Simulator { mesh, detector };
/// let at = |height: f64| {
///     let floor = [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0]];
///     let falling = [[1.0, 1.0, height], [1.0, 2.0, height + 4.0], [2.0, 1.0, height + 4.0]];
///     [floor, falling].concat()
/// };
///
/// assert!(!simulator.detector.collides(&at(3.0), &at(1.0), CONTACT)?);
/// let contact = simulator.detector.collision(&at(1.0), &at(-1.0), CONTACT)?;
/// assert_eq!(contact.map(|contact| contact.impact.time.lower()), Some(0.5));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Detector {
    mesh: Arc<TriangleMesh>,
    search: CulledSearch,
    start_check: Option<StartCheck>,
}

impl Detector {
    /// The detector for steps of `mesh`.
    #[must_use]
    pub fn new(mesh: impl Into<Arc<TriangleMesh>>) -> Self {
        Self::with_broad_phase(mesh, Arc::new(Bvh))
    }

    /// The detector for steps of `mesh`, with another broad phase, which its clones share.
    #[must_use]
    pub fn with_broad_phase(mesh: impl Into<Arc<TriangleMesh>>, broad_phase: Arc<dyn BroadPhase>) -> Self {
        Self {
            mesh: mesh.into(),
            search: CulledSearch::new(broad_phase),
            start_check: None,
        }
    }

    /// The same detector, restricted to the pairs that can collide.
    #[must_use]
    pub fn with_can_collide(mut self, can_collide: CanCollide) -> Self {
        self.set_can_collide(can_collide);
        self
    }

    /// The same detector, with or without the check of the start; without it by default.
    ///
    /// With it, an answer about a step from positions `x0` has the error [`StepError::Crossing`] if an edge
    /// passes through a face there, as [`Meeting::Crossing`](crate::Meeting) defines it, among the pairs
    /// that can collide. Primitives that merely touch are contacts at t = 0, as always. The check is a pass
    /// over the mesh at rest. No pass is made if `x0` is, bit for bit, the start of the step before, or the
    /// end of the last step that [`collides`](Self::collides) or [`collision`](Self::collision) found free,
    /// such as the positions of a [`free_step`](Self::free_step). With a predicate of
    /// [`with_can_collide`](Self::with_can_collide), only the first holds: it may leave out the pairs
    /// through which an edge comes to cross a face.
    ///
    /// ```
    /// use exact_ccd::CONTACT;
    /// use exact_ccd_mesh::{Detector, StepError, TriangleMesh};
    ///
    /// // An edge of the second face passes through the first face.
    /// let mesh = TriangleMesh::new(6, vec![[0, 1, 2], [3, 4, 5]])?;
    /// let floor = [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0]];
    /// let x = [floor, [[1.0, 1.0, -1.0], [1.0, 1.0, 1.0], [9.0, 1.0, 1.0]]].concat();
    /// let mut detector = Detector::new(mesh);
    /// assert!(!detector.collides(&x, &x, CONTACT)?);
    /// let mut detector = detector.with_start_check(true);
    /// let crossing = detector.collides(&x, &x, CONTACT);
    /// assert!(matches!(crossing, Err(StepError::Crossing { edge: 3, face: 0, .. })));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn with_start_check(mut self, is_on: bool) -> Self {
        self.set_start_check(is_on);
        self
    }

    /// Turns the check of the start on or off: see [`with_start_check`](Self::with_start_check).
    pub fn set_start_check(&mut self, is_on: bool) {
        if is_on {
            self.start_check.get_or_insert_default();
        } else {
            self.start_check = None;
        }
    }

    /// The check of the start alone, if it is on, for the edges and faces that count. They are asked for in
    /// their order, until one counts, and only if they cross. Steps from the same positions need no further
    /// pass.
    ///
    /// # Errors
    /// [`StepError::Crossing`] has the first edge and face, and other errors are about the positions.
    pub fn check_start(
        &mut self,
        x0: &[Point],
        counts: impl Fn(Intersection) -> bool,
    ) -> Result<(), StepError> {
        let step = Step::new(&self.mesh, x0, x0)?;
        match &mut self.start_check {
            Some(start_check) => self.search.check_start(&step, start_check, &counts),
            None => Ok(()),
        }
    }

    /// The number of passes over the mesh at rest that the check of the start has made; 0 without it.
    #[must_use]
    pub fn start_passes(&self) -> usize {
        self.start_check.as_ref().map_or(0, StartCheck::passes)
    }

    /// Replaces the pairs that can collide.
    pub fn set_can_collide(&mut self, can_collide: CanCollide) {
        self.search.set_can_collide(can_collide);
        // Positions were checked for the pairs before.
        if let Some(start_check) = &mut self.start_check {
            start_check.forget();
        }
    }

    /// The mesh.
    #[must_use]
    pub fn mesh(&self) -> &Arc<TriangleMesh> {
        &self.mesh
    }

    /// The pairs that can collide.
    #[must_use]
    pub fn can_collide(&self) -> &CanCollide {
        self.search.can_collide()
    }

    /// The step from positions `x0` to positions `x1`, after the check of its start.
    pub(crate) fn begin<'a>(
        &'a mut self,
        x0: &'a [Point],
        x1: &'a [Point],
        options: Options<impl Into<MinDistance>>,
    ) -> Result<Begun<'a>, StepError> {
        self.begin_step(x0, x1, options.separation.into(), options.until)
    }

    /// Apart from [`begin`](Self::begin), which each crate compiles again for its own types.
    fn begin_step<'a>(
        &'a mut self,
        x0: &'a [Point],
        x1: &'a [Point],
        min_distance: MinDistance,
        until: f64,
    ) -> Result<Begun<'a>, StepError> {
        TimeOutOfStep::check(until)?;
        min_distance.check(&self.mesh)?;
        let step = Step::new(&self.mesh, x0, x1)?;
        if let Some(start_check) = &mut self.start_check {
            self.search.check_start(&step, start_check, &|_| true)?;
        }
        Ok(Begun {
            step,
            min_distance,
            until,
            search: &mut self.search,
            start_check: self.start_check.as_mut(),
        })
    }
}

/// A step after the check of its start, and the search in it.
pub(crate) struct Begun<'a> {
    pub(crate) step: Step<'a>,
    min_distance: MinDistance,
    pub(super) until: f64,
    pub(crate) search: &'a mut CulledSearch,
    start_check: Option<&'a mut StartCheck>,
}

impl Begun<'_> {
    /// The collector after the search.
    pub(super) fn run<C: Collect>(&mut self, collector: C) -> C {
        self.search.run(&self.step, &self.min_distance, &collector);
        collector
    }

    /// Takes the end of a step in which no pair touches.
    pub(crate) fn found_free(&mut self, x1: &[Point]) {
        if let Some(start_check) = &mut self.start_check
            && self.until >= 1.0
        {
            start_check.add_end_of_free(x1, self.search.can_collide());
        }
    }
}
