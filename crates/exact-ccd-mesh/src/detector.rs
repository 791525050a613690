//! Contact in successive steps of one mesh.

use std::sync::Arc;

use exact_ccd::Point;

use crate::broad_phase::{BroadPhase, Bvh};
use crate::can_collide::CanCollide;
use crate::collect::ContactsUntil;
use crate::contact::Contact;
use crate::culled_search::CulledSearch;
use crate::intersections::{Intersection, IntersectionsError, intersections_by};
use crate::mesh::TriangleMesh;
use crate::min_distance::{MinDistance, ThicknessCount};
use crate::pair::Pair;
use crate::step::{Step, StepError};

/// Finds contact in successive steps of one mesh.
///
/// The detector shares the mesh and borrows nothing, so that a simulator can own both. No answer
/// depends on earlier steps. The detector keeps the memory of boxes and trajectories from step to
/// step, and the order of the primitives in space until neighbours in it have moved apart.
///
/// ```
/// use std::sync::Arc;
///
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
/// assert!(simulator.detector.is_free(&at(3.0), &at(1.0))?);
/// let contact = simulator.detector.earliest_contact(&at(1.0), &at(-1.0))?;
/// assert_eq!(contact.map(|contact| contact.impact.time.lower()), Some(0.5));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Detector<B = Bvh> {
    mesh: Arc<TriangleMesh>,
    search: CulledSearch<B>,
}

impl Detector {
    /// The detector for steps of `mesh`.
    #[must_use]
    pub fn new(mesh: impl Into<Arc<TriangleMesh>>) -> Self {
        Self::with_broad_phase(mesh, Bvh)
    }
}

impl<B: BroadPhase> Detector<B> {
    /// The detector for steps of `mesh`, with another broad phase.
    #[must_use]
    pub fn with_broad_phase(mesh: impl Into<Arc<TriangleMesh>>, broad_phase: B) -> Self {
        Self {
            mesh: mesh.into(),
            search: CulledSearch::new(broad_phase, CanCollide::all(), MinDistance::default()),
        }
    }

    /// The same detector, restricted to the pairs that can collide.
    #[must_use]
    pub fn with_can_collide(mut self, can_collide: CanCollide) -> Self {
        self.set_can_collide(can_collide);
        self
    }

    /// The same detector for another minimum distance: pairs within it touch.
    ///
    /// # Errors
    /// [`ThicknessCount`], if there is not one thickness for each vertex.
    pub fn with_min_distance(mut self, min_distance: MinDistance) -> Result<Self, ThicknessCount> {
        self.set_min_distance(min_distance)?;
        Ok(self)
    }

    /// Replaces the pairs that can collide.
    pub fn set_can_collide(&mut self, can_collide: CanCollide) {
        self.search.set_can_collide(can_collide);
    }

    /// Replaces the minimum distance. In case of an error, the detector keeps the one it has.
    ///
    /// # Errors
    /// [`ThicknessCount`], if there is not one thickness for each vertex.
    pub fn set_min_distance(&mut self, min_distance: MinDistance) -> Result<(), ThicknessCount> {
        min_distance.check(&self.mesh)?;
        self.search.set_min_distance(min_distance);
        Ok(())
    }

    /// The mesh.
    #[must_use]
    pub fn mesh(&self) -> &Arc<TriangleMesh> {
        &self.mesh
    }

    /// The earliest contact in the step from positions `x0` to positions `x1`, or `None` if it is
    /// free of contact.
    ///
    /// A sample of the primitives is examined first. Each contact that is found bounds the time
    /// until which the others matter; so most candidates are never examined, nor counted as
    /// [`StepReport`](crate::StepReport) does. The answer is the same on any number of threads.
    ///
    /// # Errors
    /// [`StepError`] names the positions that are too many, too few or not finite.
    pub fn earliest_contact(&mut self, x0: &[Point], x1: &[Point]) -> Result<Option<Contact>, StepError> {
        let step = Step::new(&self.mesh, x0, x1)?;
        Ok(self.search.earliest_contact(&step))
    }

    /// Returns true if no two primitives touch in the step from positions `x0` to positions `x1`.
    /// Ends soon after the first contact found.
    ///
    /// # Errors
    /// [`StepError`] names the positions that are too many, too few or not finite.
    pub fn is_free(&mut self, x0: &[Point], x1: &[Point]) -> Result<bool, StepError> {
        self.is_free_of(x0, x1, |_| true)
    }

    /// Returns true if no pair that counts touches in the step from positions `x0` to positions `x1`.
    ///
    /// The predicate is evaluated for pairs in contact only, on many threads, and for some of them twice. So
    /// it may be slow. That of [`with_can_collide`](Self::with_can_collide) is evaluated for every candidate,
    /// and holds for all answers.
    ///
    /// # Errors
    /// [`StepError`] names the positions that are too many, too few or not finite.
    pub fn is_free_of(
        &mut self,
        x0: &[Point],
        x1: &[Point],
        counts: impl Fn(Pair) -> bool + Sync,
    ) -> Result<bool, StepError> {
        let step = Step::new(&self.mesh, x0, x1)?;
        Ok(self.search.is_free(&step, counts))
    }

    /// The contacts in the step from positions `x0` to positions `x1` whose first time is not after
    /// `until`, the earliest first. All contacts for `until` = 1.
    ///
    /// # Errors
    /// [`StepError`] names the positions that are too many, too few or not finite, or a time `until` that
    /// is not in [0, 1].
    pub fn contacts(&mut self, x0: &[Point], x1: &[Point], until: f64) -> Result<Vec<Contact>, StepError> {
        let step = Step::new(&self.mesh, x0, x1)?;
        let contacts = ContactsUntil::new(until)?;
        self.search.run(&step, &contacts);
        Ok(contacts.sorted())
    }

    /// The edges and faces that can collide and have a common point at rest, sorted.
    ///
    /// # Errors
    /// As [`intersections`](crate::intersections).
    pub fn intersections(&self, positions: &[Point]) -> Result<Vec<Intersection>, IntersectionsError> {
        let (broad_phase, can_collide) = (self.search.broad_phase(), self.search.can_collide());
        intersections_by(broad_phase, &self.mesh, positions, can_collide)
    }

    /// The mesh and the search, for longer computations with both.
    pub(crate) fn parts(&mut self) -> (&TriangleMesh, &mut CulledSearch<B>) {
        (&self.mesh, &mut self.search)
    }
}
