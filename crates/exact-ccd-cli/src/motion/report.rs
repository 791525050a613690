//! The report of a motion: one step, or a sequence of frames.

use std::fmt;

use serde::Serialize;

use super::counts::Counts;
use crate::assembly::{Assembly, Summary};
use crate::contacts::ContactRecord;
use crate::messages::notes::Notes;
use crate::options::distances::Distances;
use crate::text::json::to_json;
use crate::text::numbers::shortest;
use crate::text::seconds::Seconds;

/// The answer, the contents of the files, and the distances within which pairs touch, in the shape of the
/// JSON object.
#[derive(Serialize)]
pub(crate) struct Report {
    #[serde(skip)]
    form: ReportForm,
    #[serde(flatten)]
    summary: Summary,
    #[serde(skip_serializing_if = "Notes::is_empty")]
    pub(crate) notes: Notes,
    #[serde(flatten)]
    distances: Distances,
    pub(crate) collision_free: bool,
    /// True for a contact, also if the first one is not searched for.
    #[serde(skip)]
    touches: bool,
    /// The number of frames: 2 of a step.
    frames: usize,
    /// The number of frames examined, until the first intersection or contact unless all are searched for.
    pub(crate) examined: usize,
    /// The times of the first and of the last frame examined, if the files have times.
    #[serde(skip_serializing_if = "Option::is_none")]
    times: Option<[f64; 2]>,
    /// The first edge that meets a face in a frame at rest.
    intersection: Option<Finding>,
    /// The first time of the contact in its step, rounded down.
    toi: Option<f64>,
    /// The first contact; none also if the question is only whether there is a contact.
    contact: Option<Finding>,
    #[serde(flatten)]
    pub(crate) counts: Counts,
    /// The durations of the phases, unless they are left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) seconds: Option<Seconds>,
}

/// The form of a report.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum ReportForm {
    /// Of `step`: times from 0 to 1, and the answer also beside an intersection at the start.
    Step,
    /// Of `audit`: frames, and times between them.
    Frames,
}

/// An intersection or a contact, and the files of its frame, and of the next one unless it is at rest.
#[derive(Serialize)]
pub(crate) struct Finding {
    #[serde(flatten)]
    record: ContactRecord,
    files: Vec<String>,
}

impl Report {
    /// The report of a motion in which nothing has been found yet.
    pub(crate) fn new(form: ReportForm, scene: &Assembly, notes: Notes, distances: Distances) -> Self {
        Self {
            form,
            summary: scene.summary(),
            notes,
            distances,
            collision_free: true,
            touches: false,
            frames: scene.frame_count(),
            examined: scene.frame_count(),
            times: None,
            intersection: None,
            toi: None,
            contact: None,
            counts: Counts::default(),
            seconds: None,
        }
    }

    /// Adds an intersection or a contact, unless there is an earlier one. A contact in motion is in the step
    /// that leads to frame `index`.
    pub(crate) fn add(&mut self, scene: &Assembly, index: usize, record: &ContactRecord) {
        let is_at_rest = record.is_intersection();
        let first = if is_at_rest {
            &mut self.intersection
        } else {
            self.touches = true;
            &mut self.contact
        };
        if first.is_none() {
            let last = if is_at_rest { record.frame } else { index };
            let files = (record.frame..=last).map(|frame| scene.frame_name(frame));
            *first = Some(Finding {
                record: record.clone(),
                files: files.collect(),
            });
        }
        self.toi = self.contact.as_ref().map(|contact| contact.record.toi());
        self.collision_free = false;
    }

    /// Sets the times of the frames that were examined.
    pub(crate) fn set_times(&mut self, scene: &Assembly) {
        let last = self.examined.saturating_sub(1);
        self.times = scene
            .time(0)
            .zip(scene.time(last))
            .map(|(first, last)| [first, last]);
    }

    /// Adds a contact that is not known.
    pub(crate) fn touch(&mut self) {
        (self.collision_free, self.touches) = (false, true);
    }

    pub(crate) fn to_json(&self) -> String {
        let command = match self.form {
            ReportForm::Step => "step",
            ReportForm::Frames => "audit",
        };
        to_json(command, self)
    }

    /// The line of the text that has the answer.
    pub(crate) fn verdict(&self) -> String {
        let first = self.findings().first().map(|finding| self.headline(finding));
        first.unwrap_or_else(|| self.decision().to_owned())
    }

    /// The line of the text about a contact that is not known, or that is absent.
    fn decision(&self) -> &'static str {
        if self.collision_free && self.summary.is_of_points() {
            "free of contact of points alone"
        } else if self.collision_free && self.frames == 1 {
            "free of contact at rest: one frame has no motion"
        } else if self.collision_free {
            "free of contact"
        } else if self.touches {
            "contact"
        } else {
            "no contact of a vertex and a face, or of two edges, in the step"
        }
    }

    /// The intersection and the contact, in the order of their frames.
    fn findings(&self) -> Vec<&Finding> {
        let mut findings: Vec<_> = self.intersection.iter().chain(&self.contact).collect();
        findings.sort_by_key(|finding| finding.record.frame);
        findings
    }

    /// The kind, the frames of an audit, the time unless it is at rest there, and the pair.
    fn headline(&self, Finding { record, files }: &Finding) -> String {
        let kind = if record.is_intersection() {
            "intersection"
        } else {
            "contact"
        };
        let frame = record.frame;
        let at = match &files[..] {
            _ if self.form == ReportForm::Step => format!("at t = {}", shortest(record.toi())),
            [file, next] => {
                let (after, t) = (frame + 1, shortest(record.toi()));
                format!("between frame {frame} ({file}) and frame {after} ({next}) at t = {t}")
            }
            files => format!("in frame {frame} ({})", files.concat()),
        };
        format!("{kind} {at}: {record}")
    }
}

/// The text on a terminal.
impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.summary, self.distances)?;
        for finding in self.findings() {
            writeln!(f, "{}{}", self.headline(finding), finding.record.place())?;
        }
        if self.contact.is_none() && (self.collision_free || self.form == ReportForm::Step) {
            writeln!(f, "{}", self.decision())?;
        }
        self.counts.write(f, &self.distances)?;
        if self.form == ReportForm::Frames {
            write!(f, "frames: {} of {} examined", self.examined, self.frames)?;
            if let Some(times) = self.times {
                let [first, last] = times.map(shortest);
                write!(f, ", from time {first} to {last}")?;
            }
            writeln!(f)?;
        }
        self.seconds.iter().try_for_each(|seconds| seconds.fmt(f))
    }
}
