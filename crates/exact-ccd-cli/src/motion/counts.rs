//! The counts in the report of a motion.

use std::fmt;

use exact_ccd::AnyKind;
use exact_ccd_mesh::{PairCounts, StepReport};
use serde::{Serialize, Serializer};

use super::body_pairs::BodyPairs;
use super::half_spaces::HalfSpaceCounts;
use crate::contacts::ContactList;
use crate::options::distances::Distances;

/// The numbers of intersections and contacts, as far as they are known.
#[derive(Default, Serialize)]
pub(crate) struct Counts {
    /// The intersections at t = 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) intersections: Option<usize>,
    #[serde(flatten)]
    pub(crate) pairs: Option<Pairs>,
    /// The vertices that touch half spaces, if there are half spaces.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) half_spaces: Option<HalfSpaceCounts>,
    /// The violations in the list of all.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) violations: Option<Violations>,
}

/// The pairs of a step whose candidates have all been examined.
#[derive(Clone, Copy, Serialize)]
pub(crate) struct Pairs {
    touching_at_start: usize,
    candidates: OfKinds,
    colliding: OfKinds,
}

/// A number for each kind of pair.
#[derive(Clone, Copy)]
struct OfKinds(PairCounts);

/// The number of intersections and contacts, and of the frames that have them or at which their steps begin.
#[derive(Serialize)]
pub(crate) struct Violations {
    count: usize,
    frames: usize,
    #[serde(skip_serializing_if = "BodyPairs::is_empty")]
    bodies: BodyPairs,
}

impl From<&StepReport> for Pairs {
    fn from(report: &StepReport) -> Self {
        Self {
            touching_at_start: report.touching.total(),
            candidates: OfKinds(report.candidates),
            colliding: OfKinds(report.colliding),
        }
    }
}

impl From<&ContactList> for Violations {
    fn from(list: &ContactList) -> Self {
        let ContactList(records) = list;
        Self {
            bodies: BodyPairs::of(list),
            count: records.len(),
            frames: records.chunk_by(|a, b| a.frame == b.frame).count(),
        }
    }
}

impl Counts {
    /// Writes a line of text for each count.
    pub(super) fn write(&self, f: &mut fmt::Formatter<'_>, distances: &Distances) -> fmt::Result {
        let touching = distances.touching();
        if let Some(count) = self.intersections.filter(|count| *count > 0) {
            writeln!(f, "pairs that intersect at t = 0: {count}")?;
        }
        if let Some(pairs) = &self.pairs {
            writeln!(f, "candidate pairs: {}", pairs.candidates)?;
            if pairs.colliding.0.total() > 0 {
                writeln!(f, "pairs in contact: {}", pairs.colliding)?;
            }
            writeln!(f, "pairs {touching} at t = 0: {}", pairs.touching_at_start)?;
        }
        if let Some(vertices) = &self.half_spaces {
            let (colliding, at_start) = (vertices.colliding, vertices.touching_at_start);
            writeln!(
                f,
                "vertices in contact with half spaces: {colliding}; those {touching} at t = 0: {at_start}"
            )?;
        }
        match &self.violations {
            Some(Violations {
                count,
                frames,
                bodies,
            }) if *count > 0 => write!(
                f,
                "violations: {count}, in {frames} of the frames or in the steps after them\n{bodies}"
            ),
            _ => Ok(()),
        }
    }
}

impl Serialize for OfKinds {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(kind, count)| (kind.short(), count)))
    }
}

impl fmt::Display for OfKinds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let is_of_faces = |kind| matches!(kind, AnyKind::VertexFace | AnyKind::EdgeEdge);
        // A mesh of faces alone has no others.
        let has_others = self
            .0
            .iter()
            .any(|(kind, &count)| count > 0 && !is_of_faces(kind));
        let shown = self.0.iter().filter(|&(kind, _)| has_others || is_of_faces(kind));
        let counts: Vec<String> = shown
            .map(|(kind, count)| format!("{count} {}", kind.name()))
            .collect();
        f.write_str(&counts.join(", "))
    }
}
