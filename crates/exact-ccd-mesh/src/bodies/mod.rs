//! Rigid bodies in motion on curves, decided exactly.

mod body;
mod candidate;
mod contact;
mod error;
mod near;
mod search;

use exact_ccd::motion::Chain;
use exact_ccd::{Options, TimeOutOfStep};
use rayon::prelude::*;

use crate::mesh::Frame;
use body::Body;
use candidate::Candidate;

pub use contact::BodyContact;
pub use error::BodiesError;

/// Rigid bodies, each a mesh in coordinates of its own, and the contacts between them in steps in which each
/// moves by a [`Chain`] of rigid motions.
///
/// The answers are exact, as those for straight motion: no contact is missed, none is invented, and times
/// are rounded down. The primitives of two bodies are compared like the primitives of one mesh (see
/// [`Pair`](crate::Pair)): vertices and faces, edges, and loose vertices and edges. Primitives of one body
/// are not, since a body keeps its shape. Bodies that intersect at the start, or one inside the other, may
/// be free of contact: see [`intersections`](crate::intersections) and [`enclosed`](crate::enclosed).
///
/// [`Options`] have the distance at which bodies touch, and the last time that counts. No answer depends on
/// the number of threads; whether bodies touch, and all times, do not depend on the order of the bodies.
///
/// Two bodies whose relative motion has a degree above 8 in the coordinates, such as more than four
/// turns together, have no boxes of their paths: all pairs of their primitives are decided one by one.
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
pub struct Bodies(Vec<Body>);

impl Bodies {
    /// The bodies with these meshes, each with the positions of its vertices in the coordinates of the body.
    ///
    /// # Errors
    /// [`BodiesError`] names the body whose positions do not fit its mesh, or that has too many primitives.
    pub fn new(frames: impl IntoIterator<Item = Frame>) -> Result<Self, BodiesError> {
        let bodies = frames.into_iter().enumerate();
        let bodies = bodies.map(|(index, frame)| Body::new(index, frame));
        bodies.collect::<Result<_, _>>().map(Self)
    }

    /// The meshes with the positions of their vertices.
    pub fn frames(&self) -> impl ExactSizeIterator<Item = &Frame> {
        self.0.iter().map(|body| &body.frame)
    }

    /// Returns true if two bodies touch at some time of the step. There is one motion for each body.
    ///
    /// # Errors
    /// [`BodiesError`], for another number of motions, or if the last time that counts is not in the step.
    pub fn collides(&self, motions: &[Chain], options: impl Into<Options>) -> Result<bool, BodiesError> {
        let options = options.into();
        let candidates = self.candidates(motions, options)?;
        Ok(candidates
            .par_iter()
            .any(|candidate| candidate.collides(self, options)))
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
        let candidates = self.candidates(motions, options)?;
        Ok(search::earliest(self, &candidates, options))
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
        let candidates = self.candidates(motions, options)?;
        let contacts = candidates.par_iter();
        let mut contacts: Vec<_> = contacts
            .filter_map(|candidate| candidate.contact(self, options))
            .collect();
        contacts.par_sort_unstable_by(BodyContact::compare);
        Ok(contacts)
    }

    /// The pairs of primitives that come near each other.
    fn candidates(&self, motions: &[Chain], options: Options) -> Result<Vec<Candidate>, BodiesError> {
        TimeOutOfStep::check(options.until)?;
        if motions.len() != self.0.len() {
            return Err(BodiesError::MotionCount {
                motions: motions.len(),
                bodies: self.0.len(),
            });
        }
        let count = self.0.len();
        let pairs: Vec<_> = (0..count)
            .flat_map(|a| (a + 1..count).map(move |b| [a, b]))
            .collect();
        let near = pairs
            .par_iter()
            .map(|&pair| near::candidates(self, pair, motions, options));
        let lists = near.collect::<Result<Vec<_>, _>>()?;
        Ok(lists.into_iter().flatten().collect())
    }
}
