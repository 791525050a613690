//! Contact in successive steps of one mesh.

use std::sync::Arc;

use exact_ccd::Point;

use super::collect::ContactsUntil;
use super::contact::Contact;
use super::culled_search::CulledSearch;
use crate::at_rest::{Intersection, IntersectionsError, StartCheck, intersections_by};
use crate::broad_phase::{BroadPhase, Bvh};
use crate::mesh::TriangleMesh;
use crate::pairs::{CanCollide, MinDistance, Pair, ThicknessCount};
use crate::steps::{Step, StepError};

/// Finds contact in successive steps of one mesh.
///
/// An edge that passes through a face at the start of a step is no contact of the step, which may be free:
/// see [`with_start_check`](Self::with_start_check). [`Pair`] says which pairs are compared, and which are
/// never a contact.
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
    start_check: Option<StartCheck>,
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
            start_check: None,
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

    /// The same detector, with or without the check of the start; without it by default.
    ///
    /// With it, an answer about a step from positions `x0` has the error [`StepError::Crossing`] if an edge
    /// passes through a face there, as [`crossings`](crate::crossings) defines it, among the pairs that can
    /// collide. Primitives that merely touch are contacts at t = 0, as always. The check is a pass over the
    /// mesh at rest. No pass is made if `x0` is, bit for bit, the start of the step before, or the end of the
    /// last step that [`is_free`](Self::is_free) or [`earliest_contact`](Self::earliest_contact) found free,
    /// such as the positions of a [`free_step`](Self::free_step). With a
    /// predicate of [`with_can_collide`](Self::with_can_collide), only the first holds: it may leave out the
    /// pairs through which an edge comes to cross a face.
    ///
    /// ```
    /// use exact_ccd_mesh::{Detector, StepError, TriangleMesh};
    ///
    /// // An edge of the second face passes through the first face.
    /// let mesh = TriangleMesh::new(6, vec![[0, 1, 2], [3, 4, 5]])?;
    /// let floor = [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0]];
    /// let x = [floor, [[1.0, 1.0, -1.0], [1.0, 1.0, 1.0], [9.0, 1.0, 1.0]]].concat();
    /// let mut detector = Detector::new(mesh);
    /// assert!(detector.is_free(&x, &x)?);
    /// let mut detector = detector.with_start_check(true);
    /// assert!(matches!(detector.is_free(&x, &x), Err(StepError::Crossing { edge: 3, face: 0, .. })));
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
    /// A mesh that is pierced at `x0`, by an edge that passes through a face, may be free of contact: without
    /// [`with_start_check`](Self::with_start_check), this is not found.
    ///
    /// # Errors
    /// [`StepError`] names the positions that are too many, too few or not finite, or, with the check of the
    /// start, the edge that passes through a face.
    pub fn earliest_contact(&mut self, x0: &[Point], x1: &[Point]) -> Result<Option<Contact>, StepError> {
        let mut begun = self.begin(x0, x1)?;
        let contact = begun.search.earliest_contact(&begun.step);
        if contact.is_none() {
            begun.found_free(x1);
        }
        Ok(contact)
    }

    /// Returns true if no two primitives touch in the step from positions `x0` to positions `x1`: no
    /// [`Pair`], which says what is never a contact. Ends soon after the first contact found.
    ///
    /// A mesh that is pierced at `x0`, by an edge that passes through a face, may be free of contact: without
    /// [`with_start_check`](Self::with_start_check), this is not found.
    ///
    /// # Errors
    /// [`StepError`] names the positions that are too many, too few or not finite, or, with the check of the
    /// start, the edge that passes through a face.
    pub fn is_free(&mut self, x0: &[Point], x1: &[Point]) -> Result<bool, StepError> {
        let mut begun = self.begin(x0, x1)?;
        let is_free = begun.search.is_free(&begun.step, |_| true);
        if is_free {
            begun.found_free(x1);
        }
        Ok(is_free)
    }

    /// Returns true if no pair that counts touches in the step from positions `x0` to positions `x1`.
    ///
    /// The predicate is evaluated for pairs in contact only, on many threads, and for some of them twice. So
    /// it may be slow. That of [`with_can_collide`](Self::with_can_collide) is evaluated for every candidate,
    /// and holds for all answers, and for the check of the start.
    ///
    /// A mesh that is pierced at `x0`, by an edge that passes through a face, may be free of contact: without
    /// [`with_start_check`](Self::with_start_check), this is not found.
    ///
    /// # Errors
    /// [`StepError`] names the positions that are too many, too few or not finite, or, with the check of the
    /// start, the edge that passes through a face.
    pub fn is_free_of(
        &mut self,
        x0: &[Point],
        x1: &[Point],
        counts: impl Fn(Pair) -> bool + Sync,
    ) -> Result<bool, StepError> {
        let begun = self.begin(x0, x1)?;
        Ok(begun.search.is_free(&begun.step, counts))
    }

    /// The contacts in the step from positions `x0` to positions `x1` whose first time is not after
    /// `until`, the earliest first. All contacts for `until` = 1.
    ///
    /// A mesh that is pierced at `x0`, by an edge that passes through a face, may be free of contact: without
    /// [`with_start_check`](Self::with_start_check), this is not found.
    ///
    /// # Errors
    /// [`StepError`] names the positions that are too many, too few or not finite, or a time `until` that
    /// is not in [0, 1], or, with the check of the start, the edge that passes through a face.
    pub fn contacts(&mut self, x0: &[Point], x1: &[Point], until: f64) -> Result<Vec<Contact>, StepError> {
        let contacts = ContactsUntil::new(until)?;
        let begun = self.begin(x0, x1)?;
        begun.search.run(&begun.step, &contacts);
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

    /// The step from positions `x0` to positions `x1`, after the check of its start.
    pub(crate) fn begin<'a>(
        &'a mut self,
        x0: &'a [Point],
        x1: &'a [Point],
    ) -> Result<Begun<'a, B>, StepError> {
        let step = Step::new(&self.mesh, x0, x1)?;
        if let Some(start_check) = &mut self.start_check {
            start_check.examine(self.search.broad_phase(), &step, self.search.can_collide())?;
        }
        Ok(Begun {
            step,
            search: &mut self.search,
            start_check: self.start_check.as_mut(),
        })
    }
}

/// A step after the check of its start, and the search in it.
pub(crate) struct Begun<'a, B> {
    pub(crate) step: Step<'a>,
    pub(crate) search: &'a mut CulledSearch<B>,
    start_check: Option<&'a mut StartCheck>,
}

impl<B: BroadPhase> Begun<'_, B> {
    /// Takes the positions to which no pair touches from the start of the step.
    pub(crate) fn found_free(&mut self, x1: &[Point]) {
        if let Some(start_check) = &mut self.start_check {
            start_check.add_end_of_free(x1, self.search.can_collide());
        }
    }
}
