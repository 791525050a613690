//! The output of `exact-ccd audit`.

use std::fmt;

use exact_ccd_mesh::{TriangleMesh, Violation};
use serde::Serialize;

use super::frames::Frames;
use crate::distances::Distances;
use crate::shortest::shortest;
use crate::step_report::ReportedPair;

/// The answer, in the shape of the JSON object.
#[derive(Serialize)]
pub(super) struct Report {
    #[serde(flatten)]
    pub(super) distances: Distances,
    pub(super) collision_free: bool,
    /// The number of frames.
    pub(super) frames: usize,
    /// The number of frames examined until the first violation.
    pub(super) examined: usize,
    pub(super) violation: Option<ReportedViolation>,
    pub(super) seconds: Seconds,
}

/// The first violation, and the files of the frames to which it belongs.
#[derive(Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub(super) enum ReportedViolation {
    Intersection {
        frame: usize,
        file: String,
        edge: u32,
        face: u32,
        /// The vertices of the edge, then those of the face, for the text.
        #[serde(skip)]
        vertices: [u32; 5],
    },
    Contact {
        frame: usize,
        file: String,
        /// The file of the next frame, unless the contact is at rest.
        next: Option<String>,
        toi: f64,
        pair: ReportedPair,
    },
}

/// The durations.
#[derive(Serialize)]
pub(super) struct Seconds {
    pub(super) read: f64,
    pub(super) examine: f64,
    pub(super) total: f64,
}

impl Report {
    pub(super) fn to_json(&self) -> String {
        serde_json::to_string(self).expect("numbers and names only")
    }
}

impl ReportedViolation {
    /// The violation found in the examination of frame `index`.
    pub(super) fn new(frames: &Frames, index: usize, mesh: &TriangleMesh, violation: Violation) -> Self {
        let file = |frame: usize| frames.file(frame).display().to_string();
        match violation {
            Violation::Intersection { frame, intersection } => {
                let (edge, face) = (intersection.edge, intersection.face);
                let ([a, b], [c, d, e]) = (mesh.edges()[edge as usize], mesh.faces()[face as usize]);
                Self::Intersection {
                    frame,
                    file: file(frame),
                    edge,
                    face,
                    vertices: [a, b, c, d, e],
                }
            }
            Violation::Contact { frame, contact } => Self::Contact {
                frame,
                file: file(frame),
                next: (index > frame).then(|| file(index)),
                toi: contact.impact.time.lower(),
                pair: ReportedPair::new(mesh, &contact),
            },
        }
    }
}

/// The text on a terminal.
impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.distances.are_zero() {
            writeln!(f, "{}", self.distances)?;
        }
        match &self.violation {
            None => writeln!(f, "free of contact")?,
            Some(violation) => writeln!(f, "{violation}")?,
        }
        let Seconds { read, examine, total } = self.seconds;
        writeln!(f, "frames: {} of {} examined", self.examined, self.frames)?;
        write!(
            f,
            "seconds: {read:.3} reading, {examine:.3} examining, {total:.3} in total"
        )
    }
}

impl fmt::Display for ReportedViolation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Intersection {
                frame,
                file,
                edge,
                face,
                vertices: [a, b, c, d, e],
            } => write!(
                f,
                "intersection in frame {frame} ({file}): edge {edge} (vertices {a}, {b}) and face {face} (vertices {c}, {d}, {e})"
            ),
            Self::Contact {
                frame,
                file,
                next: None,
                pair,
                ..
            } => write!(f, "contact in frame {frame} ({file}): {pair}"),
            Self::Contact {
                frame,
                file,
                next: Some(next),
                toi,
                pair,
            } => {
                let (after, t) = (frame + 1, shortest(*toi));
                write!(
                    f,
                    "contact between frame {frame} ({file}) and frame {after} ({next}) at t = {t}: {pair}"
                )
            }
        }
    }
}
