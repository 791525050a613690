//! The output of `exact-ccd audit`.

use std::fmt;
use std::time::Duration;

use serde::Serialize;

use crate::contacts::{ContactList, ContactRecord};
use crate::distances::Distances;
use crate::notes::Notes;
use crate::scene::{Scene, Summary};
use crate::shortest::shortest;

/// The answer, in the shape of the JSON object.
#[derive(Serialize)]
pub(super) struct Report {
    #[serde(flatten)]
    pub(super) summary: Summary,
    #[serde(skip_serializing_if = "Notes::is_empty")]
    pub(super) notes: Notes,
    #[serde(flatten)]
    pub(super) distances: Distances,
    pub(super) collision_free: bool,
    /// The number of frames.
    pub(super) frames: usize,
    /// The number of frames examined, until the first violation unless all are searched for.
    pub(super) examined: usize,
    /// The numbers of violations, if all were searched for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) violations: Option<Totals>,
    pub(super) violation: Option<ReportedViolation>,
    pub(super) seconds: Seconds,
}

/// The numbers of violations, and of frames that have them or at which steps with them begin.
#[derive(Serialize)]
pub(super) struct Totals {
    pub(super) count: usize,
    pub(super) frames: usize,
}

/// The first violation, and the files of the frames to which it belongs.
#[derive(Clone, Serialize)]
pub(super) struct ReportedViolation {
    frame: usize,
    file: String,
    /// The file of the next frame, unless the contact is at rest.
    next: Option<String>,
    contact: ContactRecord,
}

/// The durations of the phases, in s, and their sum. Without files to write, that of writing is absent.
#[derive(Default, Serialize)]
pub(super) struct Seconds {
    read: f64,
    examine: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    write: Option<f64>,
    total: f64,
}

impl Seconds {
    /// The examination is all that is neither reading nor writing.
    pub(super) fn new(read: Duration, write: Option<Duration>, total: Duration) -> Self {
        let examine = total.saturating_sub(read + write.unwrap_or_default());
        let seconds = |duration: Duration| duration.as_secs_f64();
        Self {
            read: seconds(read),
            examine: seconds(examine),
            write: write.map(seconds),
            total: seconds(total),
        }
    }
}

impl Report {
    pub(super) fn to_json(&self) -> String {
        serde_json::to_string(self).expect("numbers and names only")
    }

    /// The line of the text that has the answer.
    pub(super) fn verdict(&self) -> String {
        let line = match &self.violation {
            None => "free of contact".to_owned(),
            Some(violation) => violation.to_string(),
        };
        line.lines().next().unwrap_or_default().to_owned()
    }
}

impl Totals {
    pub(super) fn of(list: &ContactList) -> Self {
        let of_one_frame = list.0.chunk_by(|a, b| a.frame() == b.frame());
        Self {
            count: list.0.len(),
            frames: of_one_frame.count(),
        }
    }
}

impl ReportedViolation {
    /// The violation found in the examination of frame `index`, in `frame` or in the step after it.
    pub(super) fn new(scene: &Scene, index: usize, frame: usize, contact: ContactRecord) -> Self {
        Self {
            frame,
            file: scene.frame_name(frame),
            next: (index > frame).then(|| scene.frame_name(index)),
            contact,
        }
    }
}

/// The text on a terminal.
impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.summary.fmt(f)?;
        if !self.distances.are_zero() {
            writeln!(f, "{}", self.distances)?;
        }
        match &self.violation {
            None => writeln!(f, "free of contact")?,
            Some(violation) => writeln!(f, "{violation}")?,
        }
        if let Some(Totals { count, frames }) = self.violations.as_ref().filter(|totals| totals.count > 0) {
            writeln!(
                f,
                "violations: {count}, in {frames} of the frames or in the steps after them"
            )?;
        }
        let Seconds {
            read,
            examine,
            write,
            total,
        } = self.seconds;
        writeln!(f, "frames: {} of {} examined", self.examined, self.frames)?;
        write!(f, "seconds: {read:.3} reading, {examine:.3} examining, ")?;
        if let Some(write) = write {
            write!(f, "{write:.3} writing, ")?;
        }
        write!(f, "{total:.3} in total")
    }
}

impl fmt::Display for ReportedViolation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            frame,
            file,
            next,
            contact,
        } = self;
        match next {
            _ if contact.is_intersection() => {
                write!(f, "intersection in frame {frame} ({file}): {contact}")?;
            }
            None => write!(f, "contact in frame {frame} ({file}): {contact}")?,
            Some(next) => {
                let (after, t) = (frame + 1, shortest(contact.toi()));
                write!(
                    f,
                    "contact between frame {frame} ({file}) and frame {after} ({next}) at t = {t}: {contact}"
                )?;
            }
        }
        write!(f, "\n{}", contact.place().trim_end())
    }
}
