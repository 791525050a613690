//! The output of `exact-ccd step`, in the shape of the JSON object.

use exact_ccd_files::FileIds;
use exact_ccd_mesh::{Intersection, Motion, PairCounts, StepReport};
use serde::Serialize;

use super::seconds::Seconds;
use crate::contacts::ContactRecord;
use crate::distances::Distances;
use crate::half_spaces::HalfSpaceCounts;
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
    /// The vertices that touch half spaces, if there are half spaces.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) half_spaces: Option<HalfSpaceCounts>,
    pub(super) seconds: Seconds,
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
    pub(super) fn new(motion: &Motion, ids: &FileIds, found: &[Intersection]) -> Self {
        let Motion { mesh, x0, .. } = motion;
        let first = found.first();
        Self {
            intersections: found.len(),
            first: first.map(|&first| ContactRecord::of_intersection(mesh, x0, first).in_file(ids)),
        }
    }
}

impl Answer {
    /// The earliest contact, if it has been searched for.
    pub(super) fn contact(&self) -> Option<&ContactRecord> {
        match self {
            Self::Free { .. } => None,
            Self::Report(report) => report.contact.as_ref(),
        }
    }

    pub(super) fn is_free(&self) -> bool {
        match self {
            Self::Free { is_free } => *is_free,
            Self::Report(report) => report.contact.is_none(),
        }
    }
}

impl Report {
    /// The report of the earliest contact, with the counts of all contacts if they are known.
    pub(super) fn new(earliest: Option<ContactRecord>, contacts: Option<&StepReport>) -> Self {
        Self {
            toi: earliest.as_ref().map(ContactRecord::toi),
            contact: earliest,
            counts: contacts.map(|contacts| Counted {
                touching_at_start: contacts.touching.total(),
                candidates: contacts.candidates.into(),
                colliding: contacts.colliding.into(),
            }),
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
