//! A sequence of frames, certified: does the mesh ever touch itself?

use exact_ccd::Point;

use crate::broad_phase::Bvh;
use crate::earliest::EarliestContact;
use crate::frame::Frame;
use crate::intersections::{Intersection, intersections};
use crate::mesh::TriangleMesh;
use crate::motion::MotionError;
use crate::step::{Step, StepError};

/// Examines frames of a mesh one after the other, between which vertices move in straight lines.
///
/// As long as there is no [`Violation`], no edge and face without a common vertex have a common point, nor do two such
/// edges or a vertex and a face, at any time up to the last frame. Only the first frame is examined at rest: a mesh that
/// does not pass through itself there can only come to do so by a vertex that reaches a face or an edge that reaches
/// another one, and that is a contact of the step. Parts that share a vertex are neighbours and may touch.
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
    last: Option<Frame>,
    frames: usize,
}

/// Where a mesh touches itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Violation {
    /// An edge meets a face at rest: the least such pair.
    Intersection {
        /// The frame, from 0.
        frame: usize,
        /// The edge and the face.
        intersection: Intersection,
    },
    /// A vertex and a face, or two edges, touch: the earliest such contact after a frame, or in it.
    Contact {
        /// The frame at which the step begins, from 0.
        frame: usize,
        /// What touches, and when, from 0 at that frame to 1 at the next.
        contact: EarliestContact,
    },
}

impl Audit {
    /// Examines the next frame, and the step that leads to it.
    ///
    /// # Errors
    /// [`MotionError`] names what differs between the mesh of this frame, which it calls the end, and that of the frames
    /// before; or the positions that are not finite. The frame counts as not examined.
    pub fn examine(&mut self, frame: Frame) -> Result<Option<Violation>, MotionError> {
        let violation = match &self.last {
            None => at_rest(&frame)?,
            Some(last) => {
                last.mesh.check_same(&frame.mesh)?;
                contact(self.frames - 1, &last.mesh, &last.positions, &frame.positions)?
            }
        };
        self.last = Some(frame);
        self.frames += 1;
        Ok(violation)
    }

    /// How many frames have been examined.
    #[must_use]
    pub fn frames(&self) -> usize {
        self.frames
    }

    /// The last frame that has been examined.
    #[must_use]
    pub fn last(&self) -> Option<&Frame> {
        self.last.as_ref()
    }
}

/// What is wrong with the first frame by itself: intersections, or what touches in a step that goes nowhere.
fn at_rest(Frame { mesh, positions }: &Frame) -> Result<Option<Violation>, StepError> {
    let found = intersections(mesh, positions).map_err(StepError::Start)?;
    match found.first() {
        Some(&intersection) => Ok(Some(Violation::Intersection {
            frame: 0,
            intersection,
        })),
        None => contact(0, mesh, positions, positions),
    }
}

/// The earliest contact of the step that begins at a frame.
fn contact(
    frame: usize,
    mesh: &TriangleMesh,
    x0: &[Point],
    x1: &[Point],
) -> Result<Option<Violation>, StepError> {
    let contact = Step::new(mesh, x0, x1)?.earliest_contact(&Bvh);
    Ok(contact.map(|contact| Violation::Contact { frame, contact }))
}
