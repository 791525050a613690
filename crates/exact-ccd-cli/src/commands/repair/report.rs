//! The report of a repair.

use std::fmt;

use exact_ccd_mesh::{Point, TriangleMesh};
use exact_ccd_repair::{Outcome, Reason};
use serde::Serialize;

use super::figures::Figures;
use super::remaining::{Pairs, Remaining};
use crate::assembly::{Assembly, Summary};
use crate::messages::notes::Notes;
use crate::options::distances::Distances;
use crate::text::json::to_json;
use crate::text::numbers::shortest;
use crate::text::seconds::Seconds;

/// The answer, in the shape of the JSON object.
#[derive(Serialize)]
pub(super) struct Report {
    #[serde(flatten)]
    summary: Summary,
    #[serde(skip_serializing_if = "Notes::is_empty")]
    pub(super) notes: Notes,
    #[serde(flatten)]
    distances: Distances,
    pub(super) repaired: bool,
    /// The reason why it is not.
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
    /// The pairs before, unless it is not repaired.
    #[serde(skip_serializing_if = "Option::is_none")]
    before: Option<Pairs>,
    /// The pairs after.
    after: Pairs,
    #[serde(flatten)]
    remaining: Remaining,
    #[serde(skip_serializing_if = "Option::is_none")]
    change: Option<Figures>,
    /// The file that was written.
    pub(super) output: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) seconds: Option<Seconds>,
}

impl Report {
    /// The report of a mesh that is not repaired.
    pub(super) fn new(scene: &Assembly, notes: Notes, distances: Distances) -> Self {
        Self {
            summary: scene.summary(),
            notes,
            distances,
            repaired: false,
            reason: None,
            before: None,
            after: Pairs::default(),
            remaining: Remaining::default(),
            change: None,
            output: None,
            seconds: None,
        }
    }

    /// Adds the outcome for a mesh that had these positions. A displacement above the limit counts as not
    /// repaired.
    pub(super) fn add(
        &mut self,
        scene: &Assembly,
        mesh: &TriangleMesh,
        before: &[Point],
        limit: Option<f64>,
        outcome: &Outcome,
    ) {
        match outcome {
            Outcome::Repaired(repaired) => {
                let (vertex, largest) = largest_displacement(before, &repaired.positions);
                let beyond = limit.filter(|&limit| largest > limit);
                self.repaired = beyond.is_none();
                self.reason = beyond.map(|limit| {
                    let (largest, limit) = (shortest(largest), shortest(limit));
                    format!("vertex {vertex} would move by {largest}, more than --max-displacement {limit}")
                });
                self.before = Some(Pairs {
                    crossings: repaired.crossings,
                    contacts: repaired.contacts,
                });
                self.change = Some(Figures::new(&repaired.change, before.len()));
            }
            Outcome::Unrepaired(unrepaired) => {
                self.reason = Some(reason(scene, mesh, unrepaired.reason));
                let (crossings, contacts) = (&unrepaired.crossings, &unrepaired.contacts);
                self.after = Pairs::of(crossings, contacts);
                self.remaining = Remaining::new(scene, mesh, crossings, contacts);
            }
        }
    }

    pub(super) fn text(&self, is_json: bool) -> String {
        if is_json {
            to_json("repair", self)
        } else {
            self.to_string().trim_end().to_owned()
        }
    }

    /// The line of the text that has the answer.
    pub(super) fn verdict(&self) -> String {
        match &self.reason {
            Some(reason) => format!("not repaired: {reason}"),
            None if self.change.as_ref().is_some_and(|change| change.moved == 0) => {
                "free before: nothing moved".to_owned()
            }
            None => "repaired: free of contact at rest".to_owned(),
        }
    }
}

/// The reason why a mesh is not repaired, with the names of its bodies.
fn reason(scene: &Assembly, mesh: &TriangleMesh, reason: Reason) -> String {
    match reason {
        Reason::OneSided { face } => format!(
            "{} is part of a closed surface that has only one side, as a Klein bottle: such a surface has no positions \
             without intersections",
            scene.face_name(mesh, face)
        ),
        reason => reason.to_string(),
    }
}

/// The vertex that moves farthest, and an upper bound of its displacement.
///
/// A difference and each `hypot`, whose errors are at most an ulp, change the length by a factor of at most
/// 1 + 2⁻⁵¹ together; the bound is greater by 1 + 2⁻⁴⁹.
fn largest_displacement(before: &[Point], after: &[Point]) -> (usize, f64) {
    let length = |(a, b): (&Point, &Point)| (a[0] - b[0]).hypot(a[1] - b[1]).hypot(a[2] - b[2]);
    let lengths = before.iter().zip(after).map(length).enumerate();
    let (vertex, largest) = lengths.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or_default();
    (vertex, largest * (1.0 + 8.0 * f64::EPSILON))
}

/// The text on a terminal.
impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.summary, self.distances)?;
        writeln!(f, "{}", self.verdict())?;
        if let Some(before) = &self.before {
            writeln!(f, "pairs before: {before}")?;
        }
        if !self.repaired && self.change.is_none() {
            writeln!(f, "pairs that remain: {}", self.after)?;
        }
        write!(f, "{}", self.remaining)?;
        if let Some(change) = &self.change {
            write!(f, "{change}")?;
        }
        if let Some(output) = &self.output {
            writeln!(f, "written: {output}")?;
        }
        self.seconds
            .iter()
            .try_for_each(|seconds| writeln!(f, "{seconds}"))
    }
}
