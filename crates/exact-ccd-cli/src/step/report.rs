//! The output of `exact-ccd step`, in the shape of the JSON object.

use exact_ccd_files::FileIds;
use exact_ccd_mesh::{Contact, Intersection, Motion, PairCounts, StepReport, TriangleMesh};
use serde::Serialize;

use super::seconds::Seconds;
use crate::contacts::ContactRecord;
use crate::distances::Distances;
use crate::notes::Notes;
use crate::scene::Summary;

/// The answer, what was read, and the distances within which pairs touch.
#[derive(Serialize)]
pub(super) struct Output {
    #[serde(flatten)]
    pub(super) summary: Summary,
    #[serde(skip_serializing_if = "Notes::is_empty")]
    pub(super) notes: Notes,
    #[serde(flatten)]
    pub(super) distances: Distances,
    pub(super) collision_free: bool,
    /// The mesh at rest at the start, if it was examined.
    pub(super) start: Option<Start>,
    #[serde(flatten)]
    pub(super) answer: Answer,
}

/// The places where the mesh passes through itself at the start.
#[derive(Serialize)]
pub(super) struct Start {
    pub(super) intersections: usize,
    pub(super) first: Option<ContactRecord>,
}

/// The answer to one of the questions of the command line.
#[derive(Serialize)]
#[serde(untagged)]
pub(super) enum Answer {
    /// Only if there is contact.
    Free {
        #[serde(skip)]
        is_free: bool,
        seconds: Seconds,
    },
    /// The earliest contact.
    Report(Box<Report>),
}

/// The earliest contact.
#[derive(Serialize)]
pub(super) struct Report {
    pub(super) toi: Option<f64>,
    pub(super) contact: Option<ContactRecord>,
    #[serde(flatten)]
    pub(super) counts: Option<Counted>,
    pub(super) seconds: Seconds,
}

/// The counts, if all candidates have been examined.
#[derive(Serialize)]
pub(super) struct Counted {
    pub(super) touching_at_start: usize,
    pub(super) candidates: Counts,
    pub(super) colliding: Counts,
}

#[derive(Serialize)]
pub(super) struct Counts {
    pub(super) vf: usize,
    pub(super) ee: usize,
    pub(super) ve: usize,
    pub(super) vv: usize,
}

impl Output {
    pub(super) fn to_json(&self) -> String {
        serde_json::to_string(self).expect("numbers and names only")
    }
}

impl Start {
    pub(super) fn new(mesh: &TriangleMesh, ids: &FileIds, found: &[Intersection]) -> Self {
        let first = found.first();
        Self {
            intersections: found.len(),
            first: first.map(|&first| ContactRecord::of_intersection(mesh, first).in_file(ids)),
        }
    }
}

impl Answer {
    pub(super) fn free(is_free: bool, seconds: Seconds) -> Self {
        Self::Free { is_free, seconds }
    }

    pub(super) fn is_free(&self) -> bool {
        match self {
            Self::Free { is_free, .. } => *is_free,
            Self::Report(report) => report.contact.is_none(),
        }
    }

    /// Returns false if there is no contact at the start for certain.
    pub(super) fn may_touch_at_start(&self) -> bool {
        match self {
            Self::Free { is_free, .. } => !is_free,
            Self::Report(report) => report.toi == Some(0.0),
        }
    }

    /// The total duration, including reading.
    pub(super) fn seconds(&self) -> f64 {
        match self {
            Self::Free { seconds, .. } => seconds.total,
            Self::Report(report) => report.seconds.total,
        }
    }
}

impl Report {
    /// The report of all contacts.
    pub(super) fn new(motion: &Motion, ids: &FileIds, contacts: &StepReport, seconds: Seconds) -> Self {
        Self {
            counts: Some(Counted {
                touching_at_start: contacts.touching.total(),
                candidates: contacts.candidates.into(),
                colliding: contacts.colliding.into(),
            }),
            ..Self::earliest(motion, ids, contacts.earliest, seconds)
        }
    }

    /// The report of the earliest contact only.
    pub(super) fn earliest(
        motion: &Motion,
        ids: &FileIds,
        earliest: Option<Contact>,
        seconds: Seconds,
    ) -> Self {
        let Motion { mesh, x0, x1 } = motion;
        let contact =
            earliest.map(|contact| ContactRecord::of_contact(mesh, [x0, x1], &contact).in_file(ids));
        Self {
            toi: contact.as_ref().map(ContactRecord::toi),
            contact,
            counts: None,
            seconds,
        }
    }
}

impl From<PairCounts> for Counts {
    fn from(counts: PairCounts) -> Self {
        Self {
            vf: counts.vertex_face,
            ee: counts.edge_edge,
            ve: counts.vertex_edge,
            vv: counts.vertex_vertex,
        }
    }
}
