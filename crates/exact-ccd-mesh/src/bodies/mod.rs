//! Rigid bodies in motion on curves, decided exactly.

mod apart;
mod approach;
mod audit;
mod body;
mod candidate;
mod collect;
mod contact;
mod crossing;
mod distance;
mod encounter;
mod error;
mod free_step;
mod near;
mod part;
mod placed;
mod plane;
mod predicate;
mod scene;
mod shape;
mod sphere;
mod step;
mod tree;
mod turning;
mod world;

use exact_ccd::Options;
use exact_ccd::motion::Chain;
use rayon::prelude::*;

use crate::mesh::Frame;
use body::Body;
use collect::{AllContacts, AnyContact, Earliest};
use predicate::BodyPredicate;

pub use audit::{BodiesAudit, BodiesViolation};
pub use contact::BodyContact;
pub use distance::BodyDistance;
pub use error::BodiesError;
pub use free_step::FreePoses;
pub use step::BodiesReport;

/// Rigid bodies, each a mesh in coordinates of its own, and the contacts between them in steps in which each
/// moves by a [`Chain`] of rigid motions.
///
/// The answers are exact, as those for straight motion: no contact is missed, none is invented, and times
/// are rounded down. The primitives of two bodies are compared like the primitives of one mesh (see
/// [`Pair`](crate::Pair)): vertices and faces, edges, and loose vertices and edges. Primitives of one body
/// are not, since a body keeps its shape. Bodies that intersect at the start, or one inside the other, may
/// be free of contact: see [`intersections`](crate::intersections) and [`enclosed`](crate::enclosed).
///
/// [`Options`] have the distance at which bodies touch, and the last time that counts.
/// [`with_can_collide`](Self::with_can_collide) restricts the pairs of bodies. No answer depends on
/// the number of threads; whether bodies touch, and all times, do not depend on the order of the bodies.
///
/// ```
/// use exact_ccd::CONTACT;
/// use exact_ccd::motion::{Chain, RigidMotion};
/// use exact_ccd_mesh::{Bodies, Frame};
///
/// // A bar turns by a right angle about the z axis, and swings into a post.
/// let rod = |ends: [[f64; 3]; 2]| {
///     Frame::with_edges(ends.to_vec(), Vec::new(), &[[0, 1]])
/// };
/// let bar = rod([[1.0, 0.0, 0.0], [4.0, 0.0, 0.0]])?;
/// let post = rod([[2.0, 2.0, -1.0], [2.0, 2.0, 1.0]])?;
/// let turn = RigidMotion::new([[1.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 1.0]], &[[0.0; 3]; 2])?;
///
/// let bodies = Bodies::new([bar, post])?;
/// let contact = bodies.collision(&[turn.into(), Chain::default()], CONTACT)?.unwrap();
/// assert_eq!(contact.bodies, [0, 1]);
/// // tan(π / 8) = √2 − 1
/// assert_eq!(contact.impact.time.lower(), 0.41421356237309503);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Bodies {
    bodies: Vec<Body>,
    can_collide: BodyPredicate,
}

impl Bodies {
    /// The bodies with these meshes, each with the positions of its vertices in the coordinates of the body.
    ///
    /// # Errors
    /// [`BodiesError`] names the body whose positions do not fit its mesh, or that has too many primitives.
    pub fn new(frames: impl IntoIterator<Item = Frame>) -> Result<Self, BodiesError> {
        let bodies = frames.into_iter().enumerate();
        let bodies = bodies.map(|(index, frame)| Body::new(index, frame));
        let bodies = bodies.collect::<Result<_, _>>()?;
        Ok(Self {
            bodies,
            can_collide: BodyPredicate::default(),
        })
    }

    /// The same bodies, restricted to pairs for which the predicate returns true: it is called with the
    /// indices of two bodies, the lesser first, if their boxes meet.
    ///
    /// A [`GroupMatrix`](crate::GroupMatrix) and the group of each body make a predicate:
    /// `move |a, b| matrix.allows(groups[a], groups[b])`.
    #[must_use]
    pub fn with_can_collide(
        self,
        can_collide: impl Fn(usize, usize) -> bool + Send + Sync + 'static,
    ) -> Self {
        Self {
            can_collide: BodyPredicate::new(can_collide),
            ..self
        }
    }

    /// The meshes with the positions of their vertices.
    pub fn frames(&self) -> impl ExactSizeIterator<Item = &Frame> {
        self.bodies.iter().map(|body| &body.frame)
    }

    /// Returns true if two bodies touch at some time of the step. There is one motion for each body.
    ///
    /// # Errors
    /// [`BodiesError`], for another number of motions, or if the last time that counts is not in the step.
    pub fn collides(&self, motions: &[Chain], options: impl Into<Options>) -> Result<bool, BodiesError> {
        let options = options.into();
        let collector = AnyContact::new(self, options);
        self.search(motions, options, &collector)?;
        Ok(collector.is_found())
    }

    /// The earliest contact of the step, if there is one; of several at that time, the least in the order of
    /// kinds, bodies and primitives.
    ///
    /// # Errors
    /// As [`collides`](Self::collides).
    pub fn collision(
        &self,
        motions: &[Chain],
        options: impl Into<Options>,
    ) -> Result<Option<BodyContact>, BodiesError> {
        let options = options.into();
        let collector = Earliest::new(self, options);
        self.search(motions, options, &collector)?;
        let first = collector.candidate();
        Ok(first.and_then(|candidate| candidate.contact(self, options)))
    }

    /// All contacts of the step, each with its first time, in the order of their times.
    ///
    /// # Errors
    /// As [`collides`](Self::collides).
    pub fn collisions(
        &self,
        motions: &[Chain],
        options: impl Into<Options>,
    ) -> Result<Vec<BodyContact>, BodiesError> {
        let options = options.into();
        let collector = AllContacts::new(self, options);
        self.search(motions, options, &collector)?;
        let contacts = collector.list().into_par_iter();
        let mut contacts: Vec<_> = contacts
            .filter_map(|(_, candidate)| candidate.contact(self, options))
            .collect();
        contacts.par_sort_unstable_by(BodyContact::compare);
        Ok(contacts)
    }
}
