//! The report of a repair.

use std::fmt;

use exact_ccd_mesh::{Point, TriangleMesh};
use exact_ccd_repair::{Change, Outcome};
use serde::Serialize;

use crate::assembly::{Assembly, Summary};
use crate::contacts::ContactRecord;
use crate::messages::notes::Notes;
use crate::options::distances::Distances;
use crate::text::json::to_json;
use crate::text::numbers::shortest;
use crate::text::seconds::Seconds;

/// The number of pairs that a text names.
const NAMED: usize = 5;

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
    /// The first edges that pass through faces after.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    crossings: Vec<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    change: Option<Figures>,
    /// The file that was written.
    pub(super) output: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) seconds: Option<Seconds>,
}

/// The numbers of pairs that are not free.
#[derive(Clone, Copy, Default, Serialize)]
struct Pairs {
    /// The edges that pass through faces.
    crossings: usize,
    /// The pairs that touch, or are within the minimum distance.
    contacts: usize,
}

/// The change of the mesh. Displacements are relative to the diagonal of its box.
#[derive(Serialize)]
struct Figures {
    moved: usize,
    vertices: usize,
    displacement: Displacement,
    stretch: Stretch,
}

#[derive(Serialize)]
struct Displacement {
    mean: f64,
    p95: f64,
    max: f64,
}

/// The lengths of edges, relative to those before.
#[derive(Serialize)]
struct Stretch {
    min: f64,
    p5: f64,
    p95: f64,
    max: f64,
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
            crossings: Vec::new(),
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
                self.reason = Some(unrepaired.reason.to_string());
                self.after = Pairs {
                    crossings: unrepaired.crossings.len(),
                    contacts: unrepaired.contacts.len(),
                };
                let named = unrepaired.crossings.iter().take(NAMED);
                let name = |&crossing| {
                    let record = ContactRecord::of_intersection(0, mesh, &unrepaired.positions, crossing);
                    scene.in_file(record).to_string()
                };
                self.crossings = named.map(name).collect();
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

impl Figures {
    fn new(change: &Change, vertices: usize) -> Self {
        Self {
            moved: change.moved,
            vertices,
            displacement: Displacement {
                mean: change.mean_displacement,
                p95: change.p95_displacement,
                max: change.max_displacement,
            },
            stretch: Stretch {
                min: change.min_stretch,
                p5: change.p5_stretch,
                p95: change.p95_stretch,
                max: change.max_stretch,
            },
        }
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

impl fmt::Display for Pairs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} of an edge that passes through a face, {} in contact",
            self.crossings, self.contacts
        )
    }
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
        for crossing in &self.crossings {
            writeln!(f, "  {crossing}")?;
        }
        if let Some(Figures {
            moved,
            vertices,
            displacement: Displacement { mean, p95, max },
            stretch,
        }) = &self.change
        {
            writeln!(
                f,
                "moved: {moved} of {vertices} vertices, by {mean:.5} of the diagonal in the mean, {p95:.5} in 95 % of them at \
                 most, {max:.5} at most"
            )?;
            let Stretch { min, p5, p95, max } = stretch;
            writeln!(
                f,
                "lengths of edges: {min:.3} to {max:.3} of those before, {p5:.3} to {p95:.3} in 90 % of them"
            )?;
        }
        if let Some(output) = &self.output {
            writeln!(f, "written: {output}")?;
        }
        self.seconds
            .iter()
            .try_for_each(|seconds| writeln!(f, "{seconds}"))
    }
}
