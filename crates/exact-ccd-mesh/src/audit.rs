//! The certificate of a sequence of frames: the mesh never touches itself.

use exact_ccd::{Options, Point};

use crate::at_rest::{Intersection, IntersectionOptions, intersections};
use crate::broad_phase::Bvh;
use crate::mesh::{Frame, TriangleMesh};
use crate::pairs::{CanCollide, MinDistance};
use crate::search::{Contact, Detector};
use crate::steps::{MotionError, StepError};

/// Examines the frames of a mesh one after the other, between which vertices move in straight
/// lines.
///
/// As long as there is no [`Violation`], no two primitives without a common vertex, an edge and a
/// face, two edges, or a vertex and a face, have a common point at any time up to the last frame, nor do a
/// vertex and a loose edge.
/// The first frame is examined at rest. A mesh that does not intersect itself there can come
/// to do so only by a vertex that reaches a face or an edge that reaches another edge, and that is
/// a contact of the step. A predicate of [`with_can_collide`](Self::with_can_collide) may leave out this
/// pair, but not the edge and the face that come to meet. With one, every frame is examined at rest; an edge
/// that passes through a face between two frames only is no violation then. Parts that share a vertex are
/// neighbours and may touch. Edges and vertices without a face are primitives as all others, compared as
/// defined by [`Pair`](crate::Pair), which lists what is never compared.
///
/// With a [minimum distance](Self::with_min_distance) d, no two of them come within d either, but for a
/// vertex and an edge that another edge connects. In the first frame, the least distance of primitives that
/// do not intersect is that of a vertex and a face, of two edges, or of a vertex and a loose edge or vertex,
/// and all of these pairs are examined at rest.
///
/// ```
/// use exact_ccd_mesh::{Audit, Frame, Violation};
///
/// let floor = [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0]];
/// let falling = |z: f64| [[1.0, 1.0, z], [1.0, 2.0, z + 9.0], [2.0, 1.0, z + 9.0]];
/// let frame = |z: f64| Frame::new([floor, falling(z)].concat(), vec![[0, 1, 2], [3, 4, 5]]);
///
/// let mut audit = Audit::default();
/// assert_eq!(audit.examine(frame(3.0)?)?, None);
/// assert_eq!(audit.examine(frame(1.0)?)?, None);
/// match audit.examine(frame(-3.0)?)? {
///     Some(Violation::Contact { frame, contact }) => {
///         assert_eq!((frame, contact.impact.time.lower()), (1, 0.25));
///     }
///     other => panic!("{other:?}"),
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Audit {
    /// The last frame, and the detector of its mesh.
    last: Option<(Frame, Detector)>,
    frames: usize,
    min_distance: MinDistance,
    can_collide: CanCollide,
}

/// A place where a mesh touches itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Violation {
    /// An edge meets a face at rest: the least such pair.
    Intersection {
        /// The frame, from 0.
        frame: usize,
        /// The edge and the face.
        intersection: Intersection,
    },
    /// Two primitives touch: the earliest such contact after a frame, or in it.
    Contact {
        /// The frame at which the step begins, from 0.
        frame: usize,
        /// The contact. Its time is 0 at that frame and 1 at the next.
        contact: Contact,
    },
}

impl Audit {
    /// The same audit with another minimum distance. The default is 0, which is contact.
    ///
    /// An [inner distance](MinDistance::with_inner) is for line searches that start within the minimum
    /// distance. An audit does not use it: such a start is a violation.
    #[must_use]
    pub fn with_min_distance(self, min_distance: impl Into<MinDistance>) -> Self {
        let min_distance = min_distance.into().without_inner();
        Self { min_distance, ..self }
    }

    /// The same audit, restricted to the pairs that can collide: those of an edge and a face, too.
    #[must_use]
    pub fn with_can_collide(self, can_collide: CanCollide) -> Self {
        Self { can_collide, ..self }
    }

    /// Examines the next frame, and the step that leads to it.
    ///
    /// # Errors
    /// [`MotionError`] names the difference between the mesh of this frame, which it calls the end,
    /// and the mesh of the frames before; or the positions that are not finite; or the number of
    /// thicknesses that is not that of vertices. The frame counts as not examined.
    pub fn examine(&mut self, frame: Frame) -> Result<Option<Violation>, MotionError> {
        if let Some((last, _)) = &self.last {
            last.mesh.check_same(&frame.mesh)?;
            return self.examine_positions(frame.positions);
        }
        let mut detector = Detector::new(frame.mesh.clone()).with_can_collide(self.can_collide.clone());
        self.min_distance.check(&frame.mesh)?;
        let violation = self.at_rest(&frame, &mut detector)?;
        self.last = Some((frame, detector));
        self.frames += 1;
        Ok(violation)
    }

    /// [`examine`](Self::examine) for positions of the mesh of the frames before, which is not copied. Before
    /// the first frame, it is the mesh without vertices.
    ///
    /// # Errors
    /// As [`examine`](Self::examine).
    pub fn examine_positions(&mut self, positions: Vec<Point>) -> Result<Option<Violation>, MotionError> {
        let Some((last, detector)) = &mut self.last else {
            let mesh = TriangleMesh::default();
            return self.examine(Frame { mesh, positions });
        };
        let options = Options::within(self.min_distance.clone());
        let contact = detector.collision(&last.positions, &positions, options)?;
        last.positions = positions;
        let frame = self.frames;
        self.frames += 1;
        if let Some(contact) = contact {
            let frame = frame - 1;
            return Ok(Some(Violation::Contact { frame, contact }));
        }
        if !self.can_collide.has_predicate() {
            return Ok(None);
        }
        let found = first_intersection(last, &self.can_collide)?;
        Ok(found.map(|intersection| Violation::Intersection { frame, intersection }))
    }

    /// The violation in the first frame at rest: an intersection, or a contact of a step without motion.
    fn at_rest(&self, frame: &Frame, detector: &mut Detector) -> Result<Option<Violation>, StepError> {
        if let Some(intersection) = first_intersection(frame, &self.can_collide)? {
            return Ok(Some(Violation::Intersection {
                frame: 0,
                intersection,
            }));
        }
        let options = Options::within(self.min_distance.clone());
        let contact = detector.collision(&frame.positions, &frame.positions, options)?;
        Ok(contact.map(|contact| Violation::Contact { frame: 0, contact }))
    }

    /// The number of frames that have been examined.
    #[must_use]
    pub fn frames(&self) -> usize {
        self.frames
    }

    /// The last frame that has been examined.
    #[must_use]
    pub fn last(&self) -> Option<&Frame> {
        self.last.as_ref().map(|(frame, _)| frame)
    }
}

/// The least pair of an edge and a face that meet in a frame.
fn first_intersection(frame: &Frame, can_collide: &CanCollide) -> Result<Option<Intersection>, StepError> {
    let options = IntersectionOptions::default().with_can_collide(can_collide.clone());
    let found = intersections(&frame.mesh, &frame.positions, &Bvh, &options)?;
    Ok(found.first().copied())
}
