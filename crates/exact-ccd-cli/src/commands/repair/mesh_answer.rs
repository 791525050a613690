//! The answer of the repair of a mesh.

use std::fmt;

use exact_ccd_mesh::{Point, TriangleMesh};
use exact_ccd_repair::{Outcome, Reason};
use serde::Serialize;

use super::figures::Figures;
use super::remaining::{Pairs, Remaining};
use crate::assembly::Assembly;
use crate::text::numbers::shortest;

/// The answer, in the shape of the JSON object.
#[derive(Default, Serialize)]
pub(super) struct MeshAnswer {
    /// The reason why it is not repaired.
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
}

impl MeshAnswer {
    /// The answer for a mesh that had these positions. A displacement above the limit counts as not repaired.
    pub(super) fn new(
        scene: &Assembly,
        mesh: &TriangleMesh,
        before: &[Point],
        limit: Option<f64>,
        outcome: &Outcome,
    ) -> Self {
        match outcome {
            Outcome::Repaired(repaired) => {
                let (vertex, largest) = largest_displacement(before, &repaired.positions);
                let beyond = limit.filter(|&limit| largest > limit).map(|limit| {
                    let (largest, limit) = (shortest(largest), shortest(limit));
                    format!("vertex {vertex} would move by {largest}, more than --max-displacement {limit}")
                });
                Self {
                    reason: beyond,
                    before: Some(Pairs {
                        crossings: repaired.crossings,
                        contacts: repaired.contacts,
                    }),
                    change: Some(Figures::new(&repaired.change, before.len())),
                    ..Self::default()
                }
            }
            Outcome::Unrepaired(unrepaired) => {
                let (crossings, contacts) = (&unrepaired.crossings, &unrepaired.contacts);
                Self {
                    reason: Some(reason(scene, mesh, unrepaired.reason)),
                    after: Pairs::of(crossings, contacts),
                    remaining: Remaining::new(scene, mesh, crossings, contacts),
                    ..Self::default()
                }
            }
        }
    }

    pub(super) fn is_repaired(&self) -> bool {
        self.reason.is_none()
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
        Reason::Linked { face, .. } => format!(
            "a loop of edges that do not move passes through the surface with {}, whose border does not move: no \
             positions of the other vertices are free",
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
impl fmt::Display for MeshAnswer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.verdict())?;
        if let Some(before) = &self.before {
            writeln!(f, "pairs before: {before}")?;
        }
        if self.change.is_none() {
            writeln!(f, "pairs that remain: {}", self.after)?;
        }
        write!(f, "{}", self.remaining)?;
        self.change.iter().try_for_each(|change| write!(f, "{change}"))
    }
}
