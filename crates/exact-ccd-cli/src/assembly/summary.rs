//! The contents of a scene, at the beginning of reports.

use std::fmt;

use exact_ccd_files::{Contents, Group};
use serde::Serialize;

use super::part::Part;
use super::rules::{PartPair, Rules};
use super::shape::LeftOut;
use crate::messages::failure::listed;

/// The contents of a scene, as a part of a JSON object.
#[derive(Serialize)]
pub(crate) struct Summary {
    read: Contents,
    /// True if there is neither a face nor an edge.
    #[serde(skip_serializing_if = "is_false")]
    points_only: bool,
    /// The edges and points that are left out, if there are some.
    #[serde(skip_serializing_if = "Option::is_none")]
    left_out: Option<LeftOut>,
    /// The parts, if there are several.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    parts: Vec<PartSummary>,
    /// The named groups, if there are several.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    groups: Vec<GroupSummary>,
    /// The pairs of `--only`.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    only: Vec<String>,
    /// The pairs of `--ignore`.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    ignore: Vec<String>,
    /// For each part from arrays: the arrays that were read, and the arrays that were not.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    arrays: Vec<String>,
}

/// A named group: the part that has it, and the number of its vertices.
#[derive(Serialize)]
struct GroupSummary {
    part: String,
    name: String,
    vertex_count: usize,
}

/// A part of the scene: its name and its vertices.
#[derive(Serialize)]
struct PartSummary {
    name: String,
    first_vertex: usize,
    vertex_count: usize,
    is_obstacle: bool,
}

impl Summary {
    /// Returns true if there is neither a face nor an edge.
    pub(crate) fn is_of_points(&self) -> bool {
        self.points_only
    }

    pub(super) fn new(contents: Contents, parts: &[Part], rules: &Rules) -> Self {
        let of_part = |part: &Part| {
            let group = |group: &Group| GroupSummary {
                part: part.name.clone(),
                name: group.name.clone(),
                vertex_count: group.vertices.len(),
            };
            part.groups.iter().map(group).collect::<Vec<_>>()
        };
        let groups: Vec<GroupSummary> = parts.iter().flat_map(of_part).collect();
        let several = if parts.len() > 1 { parts } else { &[] };
        let mut first = 0;
        let part = |part: &Part| {
            let vertex_count = part.ids.vertex_count;
            first += vertex_count;
            PartSummary {
                name: part.name.clone(),
                first_vertex: first - vertex_count,
                vertex_count,
                is_obstacle: part.is_obstacle,
            }
        };
        let left_out = LeftOut {
            loose_edges: parts.iter().map(|part| part.left_out.loose_edges).sum(),
            points: parts.iter().map(|part| part.left_out.points).sum(),
        };
        let with_arrays = |part: &Part| Some(format!("{}: {}", part.name, part.arrays.as_ref()?));
        Self {
            read: contents,
            points_only: parts.iter().all(Part::is_of_points),
            left_out: Some(left_out).filter(|left_out| *left_out != LeftOut::default()),
            parts: several.iter().map(part).collect(),
            groups: if groups.len() > 1 { groups } else { Vec::new() },
            only: rules.only.iter().map(PartPair::to_string).collect(),
            ignore: rules.ignore.iter().map(PartPair::to_string).collect(),
            arrays: parts.iter().filter_map(with_arrays).collect(),
        }
    }
}

fn is_false(value: &bool) -> bool {
    !value
}

/// The first lines of a text.
impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.points_only {
            writeln!(
                f,
                "points alone: there is neither a face nor an edge, so the answer is about points"
            )?;
        }
        writeln!(f, "read: {}", self.read)?;
        if let Some(LeftOut { loose_edges, points }) = self.left_out {
            writeln!(
                f,
                "left out by --faces-only: loose edges: {loose_edges}, points: {points}"
            )?;
        }
        for arrays in &self.arrays {
            writeln!(f, "read of {arrays}")?;
        }
        for part in &self.parts {
            let kind = if part.is_obstacle { "obstacle" } else { "part" };
            write!(f, "{kind} {}: ", part.name)?;
            match part.vertex_count {
                1 => writeln!(f, "vertex {}", part.first_vertex)?,
                count => {
                    let last = part.first_vertex + count - 1;
                    writeln!(f, "vertices {} to {last}", part.first_vertex)?;
                }
            }
        }
        if !self.groups.is_empty() {
            let names = self.groups.iter().map(|group| group.name.clone());
            writeln!(f, "groups: {}", listed(names, 20))?;
        }
        for (rule, pairs) in [("only", &self.only), ("ignored", &self.ignore)] {
            if !pairs.is_empty() {
                writeln!(f, "{rule}: {}", pairs.join(", "))?;
            }
        }
        Ok(())
    }
}
