//! Meshes whose vertices move on Bézier curves, decided exactly.

mod error;
mod step;

use std::sync::atomic::{AtomicU64, Ordering};

use exact_ccd::{Options, Point};
use rayon::prelude::*;

use crate::mesh::TriangleMesh;
use crate::pairs::{CanCollide, Pair};
use crate::search::{Contact, StepReport};
use step::CurvedStep;

pub use error::CurvesError;

/// The contacts of a mesh whose vertices move on Bézier curves of one degree, 1 to 8: free fall has degree 2,
/// and splines of animations degree 3.
///
/// A step is given by p + 1 sets of positions: those at t = 0, the control points in between, and those at
/// t = 1. They are taken exactly. The answers are exact, as a [`Detector`](crate::Detector) has them for
/// straight motion, which is degree 1: no contact is missed, none is invented, and times are rounded down.
/// [`Options`] have one distance for all pairs, and the last time that counts. No answer depends on the
/// number of threads.
///
/// ```
/// use exact_ccd::CONTACT;
/// use exact_ccd_mesh::{CurveDetector, Pair, TriangleMesh};
///
/// // A point is thrown upward against a triangle: at the time t, it is at z = 8 t (1 − t).
/// let mesh = TriangleMesh::new(4, vec![[0, 1, 2]])?;
/// let floor = [[0.0, 0.0, 1.5], [4.0, 0.0, 1.5], [0.0, 4.0, 1.5]];
/// let at = |z: f64| [&floor[..], &[[1.0, 1.0, z]]].concat();
///
/// let detector = CurveDetector::new(mesh);
/// let contact = detector.collision(&[&at(0.0), &at(4.0), &at(0.0)], CONTACT)?.unwrap();
/// assert_eq!(contact.pair, Pair::VertexFace { vertex: 3, face: 0 });
/// // 8 t (1 − t) = 3/2
/// assert_eq!(contact.impact.time.lower(), 0.25);
/// // In straight motion between both ends, it rests.
/// assert!(!detector.collides(&[&at(0.0), &at(0.0)], CONTACT)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct CurveDetector {
    mesh: TriangleMesh,
    can_collide: CanCollide,
}

impl CurveDetector {
    /// The detector of a mesh.
    #[must_use]
    pub fn new(mesh: TriangleMesh) -> Self {
        Self {
            mesh,
            can_collide: CanCollide::default(),
        }
    }

    /// The same detector, restricted to pairs that can collide.
    #[must_use]
    pub fn with_can_collide(self, can_collide: CanCollide) -> Self {
        Self { can_collide, ..self }
    }

    /// The mesh.
    #[must_use]
    pub fn mesh(&self) -> &TriangleMesh {
        &self.mesh
    }

    /// Returns true if any two primitives touch in the step. There are p + 1 sets of control points, with one
    /// position for each vertex in each set.
    ///
    /// # Errors
    /// [`CurvesError`] names the set whose positions are too many, too few or not finite, the number of sets,
    /// or a last time that is not in [0, 1].
    pub fn collides(&self, control: &[&[Point]], options: impl Into<Options>) -> Result<bool, CurvesError> {
        let (step, pairs) = self.begin(control, options.into())?;
        Ok(pairs.par_iter().any(|&pair| step.collides(pair)))
    }

    /// The earliest contact of the step, or `None` if there is none. Of several at one time, it is the one of
    /// the least [`Pair`].
    ///
    /// # Errors
    /// As [`collides`](Self::collides).
    pub fn collision(
        &self,
        control: &[&[Point]],
        options: impl Into<Options>,
    ) -> Result<Option<Contact>, CurvesError> {
        let (step, pairs) = self.begin(control, options.into())?;
        // The bits of f64 that are not negative are in the order of the numbers.
        let until = AtomicU64::new(step.options.until.abs().to_bits());
        let first_time = |&pair: &Pair| {
            let time = step.first_time(pair, f64::from_bits(until.load(Ordering::Relaxed)))?;
            until.fetch_min(time.upper().to_bits(), Ordering::Relaxed);
            Some((time, pair))
        };
        let first = pairs.par_iter().filter_map(first_time).min();
        Ok(first.and_then(|(_, pair)| step.contact(pair)))
    }

    /// All contacts of the step, the earliest first.
    ///
    /// # Errors
    /// As [`collides`](Self::collides).
    pub fn collisions(
        &self,
        control: &[&[Point]],
        options: impl Into<Options>,
    ) -> Result<Vec<Contact>, CurvesError> {
        let (step, pairs) = self.begin(control, options.into())?;
        Ok(contacts(&step, &pairs))
    }

    /// Finds and counts the contacts of the step.
    ///
    /// # Errors
    /// As [`collides`](Self::collides).
    pub fn step(&self, control: &[&[Point]], options: impl Into<Options>) -> Result<StepReport, CurvesError> {
        let (step, pairs) = self.begin(control, options.into())?;
        let contacts = contacts(&step, &pairs);
        let touching = contacts.iter().filter(|contact| contact.impact.time.is_start());
        Ok(StepReport {
            candidates: pairs.into_iter().collect(),
            colliding: contacts.iter().map(|contact| contact.pair).collect(),
            touching: touching.map(|contact| contact.pair).collect(),
            earliest: contacts.first().copied(),
        })
    }

    /// The step, and the pairs that come near each other in it.
    fn begin<'a>(
        &'a self,
        control: &'a [&'a [Point]],
        options: Options,
    ) -> Result<(CurvedStep<'a>, Vec<Pair>), CurvesError> {
        let step = CurvedStep::new(&self.mesh, control, options)?;
        let pairs = step.candidates(&self.can_collide).pairs().collect();
        Ok((step, pairs))
    }
}

fn contacts(step: &CurvedStep<'_>, pairs: &[Pair]) -> Vec<Contact> {
    let contacts = pairs.par_iter().filter_map(|&pair| step.contact(pair));
    let mut contacts: Vec<_> = contacts.collect();
    contacts.par_sort_unstable_by_key(Contact::key);
    contacts
}
