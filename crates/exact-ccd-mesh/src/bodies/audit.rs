//! The certificate of a recording of poses: the bodies never touch.

use exact_ccd::motion::Pose;
use exact_ccd::{Options, Separation};
use rayon::prelude::*;

use super::Bodies;
use super::contact::BodyContact;
use super::encounter::Encounter;
use super::error::BodiesError;
use super::world::World;

/// Examines the poses of bodies, frame after frame, between which each moves by
/// [`RigidMotion::between`](exact_ccd::motion::RigidMotion::between) and turns the shorter way
/// ([`Pose::nearer_turn`]).
///
/// As long as there is no [`BodiesViolation`], no two bodies that can collide have a common point on their
/// surfaces, rods or points at any time up to the last frame; with a distance d, no two come within d. The
/// first frame is examined at rest, for edges that pass through faces, too: bodies that do not touch and do
/// not intersect there can intersect later only after contact. A body that starts inside another one stays
/// there, and is no violation.
///
/// ```
/// use exact_ccd::motion::Pose;
/// use exact_ccd_mesh::{Bodies, BodiesAudit, BodiesViolation, Frame};
///
/// // A rod turns by a right angle about the z axis, and swings into a post.
/// let rod = |ends: [[f64; 3]; 2]| Frame::with_edges(ends.to_vec(), Vec::new(), &[[0, 1]]);
/// let bar = rod([[1.0, 0.0, 0.0], [4.0, 0.0, 0.0]])?;
/// let post = rod([[2.0, 2.0, -1.0], [2.0, 2.0, 1.0]])?;
/// let rest = Pose::new([1.0, 0.0, 0.0, 0.0], [0.0; 3])?;
/// let turned = Pose::new([1.0, 0.0, 0.0, 1.0], [0.0; 3])?;
///
/// let mut audit = BodiesAudit::new(Bodies::new([bar, post])?);
/// assert_eq!(audit.examine(&[rest, rest])?, None);
/// match audit.examine(&[turned, rest])? {
///     Some(BodiesViolation::Contact { frame: 0, contact }) => assert_eq!(contact.bodies, [0, 1]),
///     other => panic!("{other:?}"),
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct BodiesAudit {
    bodies: Bodies,
    last: Option<Vec<Pose>>,
    frames: usize,
    separation: Separation,
}

/// A place where two bodies touch or intersect.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BodiesViolation {
    /// An edge of a body passes through a face of another one in the first frame, where no bodies touch.
    Intersection {
        /// The frame, from 0.
        frame: usize,
        /// The body of the edge, and the body of the face.
        bodies: [usize; 2],
        /// The index of the edge in its mesh.
        edge: u32,
        /// The index of the face in its mesh.
        face: u32,
    },
    /// Two primitives touch after a frame, or in it: the earliest contact.
    Contact {
        /// The frame at which the step begins, from 0.
        frame: usize,
        /// The contact. Its time is 0 at that frame and 1 at the next.
        contact: BodyContact,
    },
}

impl BodiesAudit {
    /// The audit of bodies, among the pairs that can collide.
    #[must_use]
    pub fn new(bodies: Bodies) -> Self {
        Self {
            bodies,
            last: None,
            frames: 0,
            separation: Separation::default(),
        }
    }

    /// The same audit with another distance at which bodies touch. The default is 0, which is contact.
    #[must_use]
    pub fn with_separation(self, separation: Separation) -> Self {
        Self { separation, ..self }
    }

    /// Examines the poses of the next frame, one for each body, and the step that leads there, and returns
    /// the first violation.
    ///
    /// # Errors
    /// As [`Bodies::motions`]. The frame counts as not examined.
    pub fn examine(&mut self, poses: &[Pose]) -> Result<Option<BodiesViolation>, BodiesError> {
        let options = Options::within(self.separation);
        let start = self.last.as_deref().unwrap_or(poses);
        let pairs = start.iter().zip(poses);
        let end: Vec<_> = pairs.map(|(start, end)| end.nearer_turn(start)).collect();
        // Others are reported with the given number.
        let end = if end.len() == poses.len() {
            end
        } else {
            poses.to_vec()
        };
        let motions = self.bodies.motions(start, &end)?;
        let frame = self.frames.saturating_sub(1);
        let contact = self.bodies.collision(&motions, options)?;
        let mut violation = contact.map(|contact| BodiesViolation::Contact { frame, contact });
        if self.last.is_none() && violation.is_none() {
            let world = World::new(&self.bodies, &motions, options);
            let encounters = self.bodies.encounters(&world, &motions, options)?;
            let crossing = |encounter: &Encounter<'_>| encounter.crossing(&self.bodies);
            let crossing = encounters.par_iter().find_map_first(crossing);
            violation = crossing.map(|crossing| BodiesViolation::Intersection {
                frame,
                bodies: crossing.bodies,
                edge: crossing.edge,
                face: crossing.face,
            });
        }
        self.last = Some(end);
        self.frames += 1;
        Ok(violation)
    }

    /// The number of frames that have been examined.
    #[must_use]
    pub fn frames(&self) -> usize {
        self.frames
    }

    /// The bodies.
    #[must_use]
    pub fn bodies(&self) -> &Bodies {
        &self.bodies
    }
}
