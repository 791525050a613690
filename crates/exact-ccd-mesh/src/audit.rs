//! The certificate of a sequence of frames: the mesh never touches itself.

use exact_ccd::{Options, Point};

use crate::at_rest::{Intersection, IntersectionOptions, Meeting, intersections};
use crate::broad_phase::Bvh;
use crate::mesh::{Frame, TriangleMesh, check_positions};
use crate::pairs::{CanCollide, MinDistance};
use crate::search::{Contact, Detector};
use crate::steps::{MotionError, StepError};

/// Examines the frames of a mesh one after the other, between which vertices move in straight
/// lines.
///
/// As long as there is no [`Violation`], no two primitives without a common vertex have a common point at any
/// time up to the last frame. This holds for an edge and a face, two edges, a vertex and a face, and a vertex
/// and a loose edge. The first frame is examined at rest, for edges that pass through faces and for contacts.
/// A mesh that does not touch itself in this frame can touch itself later only after a vertex reaches a face,
/// or an edge another edge, and this is a contact of a step. Parts that share a vertex are neighbours and may
/// touch. Edges and vertices without a face are primitives as all others, compared as defined by
/// [`Pair`](crate::Pair), which lists the pairs that are never compared.
///
/// A predicate of [`with_can_collide`](Self::with_can_collide) may leave out the pair that comes into contact
/// first, but not the edge and the face that meet next. So with a predicate, every frame is examined at rest.
/// An edge that passes through a face between two frames only is then no violation. Nor is an edge that only
/// touches a face, if the predicate leaves out the pairs that touch there.
///
/// With a [minimum distance](Self::with_min_distance) d, no two primitives come within d either, but for a
/// vertex and an edge that another edge connects. In the first frame, primitives that do not intersect are
/// nearest at a vertex and a face, at two edges, or at a vertex and a loose edge or vertex, and all of these
/// pairs are examined at rest.
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
    /// An edge passes through a face at rest. [`Audit::examine`] returns the least such pair. One that only
    /// touches it is a [contact](Self::Contact) of a vertex and the face, or of two edges: see
    /// [`Meeting::Crossing`].
    Intersection {
        /// The frame, from 0.
        frame: usize,
        /// The edge and the face.
        intersection: Intersection,
    },
    /// Two primitives touch after a frame, or in it. [`Audit::examine`] returns the earliest contact.
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

    /// The same audit, restricted to the pairs that can collide. This holds for an edge and a face, too.
    #[must_use]
    pub fn with_can_collide(self, can_collide: CanCollide) -> Self {
        Self { can_collide, ..self }
    }

    /// Examines the next frame, and the step that leads to it, and returns the first violation.
    ///
    /// # Errors
    /// [`MotionError`] names the difference between the mesh of this frame, which it calls the end,
    /// and the mesh of the frames before; or the positions that are not finite; or the number of
    /// thicknesses, if it is not the number of vertices. The frame counts as not examined.
    pub fn examine(&mut self, frame: Frame) -> Result<Option<Violation>, MotionError> {
        Ok(self.add(frame, false)?.first().copied())
    }

    /// [`examine`](Self::examine) for positions of the mesh of the frames before, which is not copied. Before
    /// the first frame, it is the mesh without vertices.
    ///
    /// # Errors
    /// As [`examine`](Self::examine).
    pub fn examine_positions(&mut self, positions: Vec<Point>) -> Result<Option<Violation>, MotionError> {
        Ok(self.add_positions(positions, false)?.first().copied())
    }

    /// All violations of the next frame, which is examined at rest in any case, and of the step that leads to
    /// it, sorted by frame and time. The first violation of a sequence is the same as by
    /// [`examine`](Self::examine).
    ///
    /// A contact in the first frame is one at rest, and the step after it does not have it again. Any other
    /// contact that lasts is one of every step in which the pair touches.
    ///
    /// # Errors
    /// As [`examine`](Self::examine).
    pub fn examine_all(&mut self, frame: Frame) -> Result<Vec<Violation>, MotionError> {
        self.add(frame, true)
    }

    /// Takes a frame that was examined elsewhere, as the last of so many: the next one is examined with the
    /// step that leads to it from this frame. So the steps of a recording can be examined in several
    /// processes.
    ///
    /// # Errors
    /// [`MotionError`], as [`examine`](Self::examine).
    pub fn begin_after(&mut self, last: Frame, frames: usize) -> Result<(), MotionError> {
        check_positions(last.mesh.vertex_count(), &last.positions).map_err(StepError::Start)?;
        match &mut self.last {
            Some((before, _)) => {
                before.mesh.check_same(&last.mesh)?;
                before.positions = last.positions;
            }
            None => {
                self.min_distance.check(&last.mesh)?;
                let detector = self.detector(&last.mesh);
                self.last = Some((last, detector));
            }
        }
        self.frames = frames;
        Ok(())
    }

    /// The detector of a mesh.
    fn detector(&self, mesh: &TriangleMesh) -> Detector {
        Detector::new(mesh.clone()).with_can_collide(self.can_collide.clone())
    }

    /// Adds a frame, and returns its violations, sorted by frame and time: all, or the first ones.
    fn add(&mut self, frame: Frame, all: bool) -> Result<Vec<Violation>, MotionError> {
        if let Some((last, _)) = &self.last {
            last.mesh.check_same(&frame.mesh)?;
            return self.add_positions(frame.positions, all);
        }
        let mut detector = self.detector(&frame.mesh);
        self.min_distance.check(&frame.mesh)?;
        let mut found = intersections_in(&frame.mesh, &frame.positions, 0, &self.can_collide)?;
        if all || found.is_empty() {
            let contacts = contacts_in(&mut detector, [&frame.positions; 2], &self.min_distance, all)?;
            let violation = |contact| Violation::Contact { frame: 0, contact };
            found.extend(contacts.into_iter().map(violation));
        }
        self.last = Some((frame, detector));
        self.frames += 1;
        Ok(found)
    }

    fn add_positions(&mut self, positions: Vec<Point>, all: bool) -> Result<Vec<Violation>, MotionError> {
        let Some((last, detector)) = &mut self.last else {
            let mesh = TriangleMesh::default();
            return self.add(Frame { mesh, positions }, all);
        };
        let mut contacts = contacts_in(detector, [&last.positions, &positions], &self.min_distance, all)?;
        if all && self.frames == 1 {
            contacts.retain(|contact| !contact.impact.touching_at_start());
        }
        let frame = self.frames - 1;
        let violation = |contact| Violation::Contact { frame, contact };
        let mut found: Vec<_> = contacts.into_iter().map(violation).collect();
        if all || found.is_empty() && self.can_collide.has_predicate() {
            let at_rest = intersections_in(&last.mesh, &positions, self.frames, &self.can_collide)?;
            found.extend(at_rest);
        }
        last.positions = positions;
        self.frames += 1;
        Ok(found)
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

/// The edges that pass through faces in a frame of this number.
fn intersections_in(
    mesh: &TriangleMesh,
    positions: &[Point],
    frame: usize,
    can_collide: &CanCollide,
) -> Result<Vec<Violation>, StepError> {
    let options = IntersectionOptions::default().with_meeting(Meeting::Crossing);
    let options = options.with_can_collide(can_collide.clone());
    let found = intersections(mesh, positions, &Bvh, &options)?.into_iter();
    let violation = |intersection| Violation::Intersection { frame, intersection };
    Ok(found.map(violation).collect())
}

/// The contacts in a step, the earliest first: all, or only the earliest.
fn contacts_in(
    detector: &mut Detector,
    [x0, x1]: [&[Point]; 2],
    min_distance: &MinDistance,
    all: bool,
) -> Result<Vec<Contact>, StepError> {
    let options = Options::within(min_distance.clone());
    if all {
        return detector.collisions(x0, x1, options);
    }
    Ok(detector.collision(x0, x1, options)?.into_iter().collect())
}
