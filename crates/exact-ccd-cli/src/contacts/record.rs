//! One contact or intersection, as reports have it.

use std::fmt;

use exact_ccd::Point;
use exact_ccd_files::FileIds;
use exact_ccd_mesh::{Contact, Intersection, Pair, TriangleMesh, contact_points};
use serde::Serialize;

use crate::distances::Reached;
use crate::shortest::shortest;

/// Two primitives that touch, in the shape of the JSON object. All ids are those in the
/// files, counted from 0.
#[derive(Clone, Serialize)]
pub(crate) struct ContactRecord {
    /// The number of the frame at which the step begins, in a sequence of frames.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) frame: Option<usize>,
    pub(super) kind: RecordKind,
    /// The ids of the two primitives; none for a face that has no id in its file.
    pub(super) ids: [Option<u32>; 2],
    /// The ids of their vertices.
    pub(super) vertices: [Vec<u32>; 2],
    /// Their vertices in the mesh, which may have other ids in the file.
    #[serde(skip)]
    pub(super) mesh_vertices: [Vec<u32>; 2],
    /// Bounds of the first time of contact.
    pub(super) time: TimeBounds,
    /// The place on the first primitive; none for an intersection.
    pub(super) point: Option<Point>,
    pub(super) normal: Option<Point>,
    pub(super) parameters: Option<[f64; 2]>,
    /// The distance of the pair then.
    pub(super) distance: Reached,
}

/// The kinds of pairs, with those of an edge and a face, which intersect at rest, and of a vertex in a
/// half space at rest.
#[derive(Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum RecordKind {
    Vf,
    Ee,
    Ve,
    Vv,
    Ef,
    Vh,
}

/// The adjacent f64 between which a time lies, or the same one twice.
#[derive(Clone, Copy, Serialize)]
pub(crate) struct TimeBounds {
    pub(super) lower: f64,
    pub(super) upper: f64,
}

impl RecordKind {
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Vf => "vf",
            Self::Ee => "ee",
            Self::Ve => "ve",
            Self::Vv => "vv",
            Self::Ef => "ef",
            Self::Vh => "vh",
        }
    }

    /// The names of the two primitives.
    fn names(self) -> [&'static str; 2] {
        match self {
            Self::Vf => ["vertex", "face"],
            Self::Ee => ["edge", "edge"],
            Self::Ve => ["vertex", "edge"],
            Self::Vv => ["vertex", "vertex"],
            Self::Ef => ["edge", "face"],
            Self::Vh => ["vertex", "half space"],
        }
    }
}

impl ContactRecord {
    /// A contact in a step between positions.
    pub(crate) fn of_contact(mesh: &TriangleMesh, positions: [&[Point]; 2], contact: &Contact) -> Self {
        let vertices = contact.pair.vertices(mesh).expect("the pair is one of the mesh");
        let (first, second) = vertices.split_at(contact.pair.first_len());
        let impact = &contact.impact;
        let points = contact_points([first, second], positions, impact);
        Self {
            frame: None,
            kind: match contact.pair {
                Pair::VertexFace { .. } => RecordKind::Vf,
                Pair::EdgeEdge { .. } => RecordKind::Ee,
                Pair::VertexEdge { .. } => RecordKind::Ve,
                Pair::VertexVertex { .. } => RecordKind::Vv,
            },
            ids: contact.pair.ids().map(Some),
            time: TimeBounds {
                lower: impact.time.lower(),
                upper: impact.time.upper(),
            },
            point: points.map(|[point, _]| point),
            // Without the sign of a zero, which means nothing here.
            normal: impact.normal.map(|normal| normal.map(|x| x + 0.0)),
            parameters: Some(impact.parameters),
            distance: contact.distance.into(),
            vertices: [first.to_vec(), second.to_vec()],
            mesh_vertices: [first.to_vec(), second.to_vec()],
        }
    }

    /// An edge that meets a face at rest.
    pub(crate) fn of_intersection(mesh: &TriangleMesh, intersection: Intersection) -> Self {
        let Intersection { edge, face } = intersection;
        let vertices = [
            mesh.edges()[edge as usize].to_vec(),
            mesh.faces()[face as usize].to_vec(),
        ];
        Self {
            frame: None,
            kind: RecordKind::Ef,
            ids: [Some(edge), Some(face)],
            mesh_vertices: vertices.clone(),
            vertices,
            time: TimeBounds {
                lower: 0.0,
                upper: 0.0,
            },
            point: None,
            normal: None,
            parameters: None,
            distance: Reached::default(),
        }
    }

    /// A vertex at rest that is at most `d` outside of a half space.
    pub(crate) fn of_half_space(vertex: u32, position: Point, number: u32, normal: Point, d: f64) -> Self {
        let (lower, upper) = (0.0, 0.0);
        Self {
            frame: None,
            kind: RecordKind::Vh,
            ids: [Some(vertex), Some(number)],
            mesh_vertices: [vec![vertex], Vec::new()],
            vertices: [vec![vertex], Vec::new()],
            time: TimeBounds { lower, upper },
            point: Some(position),
            normal: Some(normal),
            parameters: None,
            distance: Reached { lower, upper: d },
        }
    }

    /// The same record with the ids of the file in place of those of the mesh. Edges have no ids in files.
    pub(crate) fn in_file(mut self, ids: &FileIds) -> Self {
        let vertex = |&vertex: &u32| ids.vertices.get(vertex as usize).copied().unwrap_or(vertex);
        self.vertices = self
            .mesh_vertices
            .each_ref()
            .map(|own| own.iter().map(vertex).collect());
        for ((id, name), vertices) in self.ids.iter_mut().zip(self.kind.names()).zip(&self.vertices) {
            *id = match name {
                "vertex" => vertices.first().copied(),
                "face" => id.and_then(|face| ids.faces.get(face as usize).copied().flatten()),
                _ => *id,
            };
        }
        self
    }

    /// The same record in a frame of a sequence.
    pub(crate) fn in_frame(self, frame: usize) -> Self {
        let frame = Some(frame);
        Self { frame, ..self }
    }

    pub(crate) fn frame(&self) -> Option<usize> {
        self.frame
    }

    /// The first time of contact, rounded down.
    pub(crate) fn toi(&self) -> f64 {
        self.time.lower
    }

    pub(crate) fn is_intersection(&self) -> bool {
        self.kind == RecordKind::Ef
    }

    /// The place of the contact, its normal and its parameters, as a line of text; empty for an
    /// intersection.
    pub(crate) fn place(&self) -> String {
        let [Some(point), normal] = [self.point, self.normal] else {
            return String::new();
        };
        let list = |numbers: &[f64]| {
            numbers
                .iter()
                .copied()
                .map(shortest)
                .collect::<Vec<_>>()
                .join(", ")
        };
        let mut text = format!("  at ({})", list(&point));
        if let Some(normal) = normal {
            text += &format!(", normal ({})", list(&normal));
        }
        if let Some(parameters) = self.parameters {
            text += &format!(", parameters {}", list(&parameters));
        }
        text + "; ids count from 0\n"
    }
}

/// The two primitives, with their vertices.
impl fmt::Display for ContactRecord {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (side, name) in self.kind.names().into_iter().enumerate() {
            let and = if side == 0 { "" } else { " and " };
            write!(f, "{and}{name}")?;
            if let Some(id) = self.ids[side] {
                write!(f, " {id}")?;
            }
            if let vertices @ [_, _, ..] = &self.vertices[side][..] {
                let vertices: Vec<_> = vertices.iter().map(ToString::to_string).collect();
                write!(f, " (vertices {})", vertices.join(", "))?;
            }
        }
        self.distance.fmt(f)
    }
}
