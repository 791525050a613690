//! One contact or intersection, as reports have it.

use std::cmp::Ordering;
use std::fmt;

use exact_ccd::{AnyKind, CONTACT, Point, Query, VertexFace};
use exact_ccd_files::FileIds;
use exact_ccd_mesh::{Contact, Intersection, TriangleMesh, contact_points};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::text::numbers::shortest;

/// Two primitives that touch, in the shape of the JSON object. All ids are the ids in the files, counted
/// from 0.
#[derive(Clone, Default, Serialize, Deserialize)]
pub(crate) struct ContactRecord {
    /// The number of the frame, or of the frame at which the step begins.
    pub(crate) frame: usize,
    pub(crate) kind: RecordKind,
    /// The ids of the two primitives; none for a face that has no id in its file.
    pub(crate) ids: [Option<u32>; 2],
    /// The ids of their vertices.
    pub(crate) vertices: [Vec<u32>; 2],
    /// Their vertices in the mesh, which may have other ids in the file.
    #[serde(skip)]
    pub(crate) mesh_vertices: [Vec<u32>; 2],
    /// The first time of contact.
    pub(crate) time: Bounds,
    /// The place on the first primitive.
    pub(crate) point: Option<Point>,
    pub(crate) normal: Option<Point>,
    pub(crate) parameters: Option<[f64; 2]>,
    /// The distance of the pair then.
    pub(crate) distance: Bounds,
    /// The bodies of the primitives, if there are several in the scene.
    #[serde(flatten)]
    pub(crate) owners: Option<Owners>,
}

/// The names of the bodies of two primitives, and their ids in the files of their parts.
#[derive(Clone, Serialize, Deserialize)]
pub(crate) struct Owners {
    /// None for a half space.
    pub(crate) parts: [Option<String>; 2],
    pub(crate) part_ids: [Option<u32>; 2],
    pub(crate) part_vertices: [Vec<u32>; 2],
}

/// The kinds of pairs; an edge and a face, which intersect at rest; a vertex and a half space.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
pub(crate) enum RecordKind {
    Pair(AnyKind),
    #[default]
    EdgeFace,
    HalfSpace,
}

/// Bounds of a time, adjacent f64, or of a distance; the same number twice if it is an f64.
#[derive(Clone, Copy, Default, Serialize, Deserialize)]
pub(crate) struct Bounds {
    pub(crate) lower: f64,
    pub(crate) upper: f64,
}

impl RecordKind {
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Pair(kind) => kind.short(),
            Self::EdgeFace => "ef",
            Self::HalfSpace => "vh",
        }
    }

    /// The number in files of points.
    pub(super) fn number(self) -> i64 {
        let pairs = AnyKind::ALL.len() as i64;
        match self {
            Self::Pair(kind) => kind as i64,
            Self::EdgeFace => pairs,
            Self::HalfSpace => pairs + 1,
        }
    }

    /// The names of the two primitives.
    fn names(self) -> [&'static str; 2] {
        match self {
            Self::Pair(kind) => kind.sizes().map(|size| ["vertex", "edge", "face"][size - 1]),
            Self::EdgeFace => ["edge", "face"],
            Self::HalfSpace => ["vertex", "half space"],
        }
    }
}

impl Serialize for RecordKind {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

impl<'de> Deserialize<'de> for RecordKind {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        let pairs = AnyKind::ALL.iter().map(|&kind| Self::Pair(kind));
        let mut all = pairs.chain([Self::EdgeFace, Self::HalfSpace]);
        let found = all.find(|kind| kind.name() == name);
        found.ok_or_else(|| D::Error::custom(format_args!("`{name}` is no kind of pairs")))
    }
}

impl ContactRecord {
    /// A contact in the step between positions that begins at a frame.
    pub(crate) fn of_contact(
        frame: usize,
        mesh: &TriangleMesh,
        positions: [&[Point]; 2],
        contact: &Contact,
    ) -> Self {
        let record = Self::of_pair(frame, mesh, contact.pair);
        let impact = &contact.impact;
        let [first, second] = &record.mesh_vertices;
        let points = contact_points([first, second], positions, impact);
        Self {
            time: Bounds {
                lower: impact.time.lower(),
                upper: impact.time.upper(),
            },
            point: points.map(|[point, _]| point.map(unsigned_zero)),
            normal: impact.normal.map(|normal| normal.map(unsigned_zero)),
            parameters: Some(impact.parameters.map(unsigned_zero)),
            distance: Bounds {
                lower: contact.distance.lower,
                upper: contact.distance.upper,
            },
            ..record
        }
    }

    /// An edge that meets a face at rest, in a frame.
    pub(crate) fn of_intersection(
        frame: usize,
        mesh: &TriangleMesh,
        positions: &[Point],
        intersection: Intersection,
    ) -> Self {
        let record = Self::of_crossing(frame, mesh, intersection);
        let ends = mesh.edges()[intersection.edge as usize].map(|vertex| positions[vertex as usize]);
        let corners = mesh.faces()[intersection.face as usize].map(|vertex| positions[vertex as usize]);
        Self {
            point: first_common_point(ends, corners).map(|point| point.map(unsigned_zero)),
            ..record
        }
    }

    /// The vertex in the mesh and the number of the half space, if it is one of these two.
    pub(crate) fn in_half_space(&self) -> Option<(u32, u32)> {
        let is_such = self.kind == RecordKind::HalfSpace;
        let vertex = self.mesh_vertices[0].first();
        vertex.copied().zip(self.ids[1]).filter(|_| is_such)
    }

    /// The order of the first times. Times between the same two adjacent f64 are equal.
    pub(crate) fn compare_times(&self, other: &Self) -> Ordering {
        let [a, b] = [self.time, other.time];
        let lower = a.lower.total_cmp(&b.lower);
        lower.then(a.upper.total_cmp(&b.upper))
    }

    /// The same record with ids of the file instead of the mesh. Edges have no ids in files.
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

    /// The first time of contact, rounded down.
    pub(crate) fn toi(&self) -> f64 {
        self.time.lower
    }

    /// The vertices of both primitives, one of each, that are in the same place in all of these frames.
    pub(crate) fn vertices_in_same_place(&self, frames: &[&[Point]]) -> impl Iterator<Item = [u32; 2]> {
        let [first, second] = &self.mesh_vertices;
        let pairs = first.iter().flat_map(|&v| second.iter().map(move |&w| [v, w]));
        pairs.filter(|&[v, w]| frames.iter().all(|frame| frame[v as usize] == frame[w as usize]))
    }

    pub(crate) fn is_intersection(&self) -> bool {
        self.kind == RecordKind::EdgeFace
    }

    /// The place of the contact, its normal and its parameters, as a further line of text.
    pub(crate) fn place(&self) -> String {
        let Some(point) = self.point else {
            return String::new();
        };
        let list = |numbers: &[f64]| {
            let numbers = numbers.iter().map(|&x| shortest(x));
            numbers.collect::<Vec<_>>().join(", ")
        };
        let mut text = format!("\n  at ({})", list(&point));
        if let Some(normal) = self.normal {
            text += &format!(", normal ({})", list(&normal));
        }
        if let Some(parameters) = self.parameters {
            text += &format!(", parameters {}", list(&parameters));
        }
        let of_parts = if self.owners.is_some() {
            ", in the file of each part"
        } else {
            ""
        };
        text + "; ids count from 0" + of_parts
    }
}

/// A number without the sign of a zero, which means nothing in a place, a direction or an energy.
pub(crate) fn unsigned_zero(x: f64) -> f64 {
    x + 0.0
}

/// The first point of an edge, from its first end on, that a face contains, rounded: the place of a vertex
/// that moves along the edge, at its time of impact. `None` if they do not meet.
fn first_common_point([start, end]: [Point; 2], [a, b, c]: [Point; 3]) -> Option<Point> {
    let [from, to] = [[start, a, b, c], [end, a, b, c]];
    let impact = Query::<VertexFace>::new(from, to).ok()?.impact(CONTACT)?;
    let points = contact_points([&[0], &[1, 2, 3]], [&from, &to], &impact);
    points.map(|[point, _]| point)
}

/// The two primitives with their bodies and vertices, and their distance if it is not 0.
impl fmt::Display for ContactRecord {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (side, name) in self.kind.names().into_iter().enumerate() {
            let and = if side == 0 { "" } else { " and " };
            let part = self
                .owners
                .as_ref()
                .and_then(|owners| owners.parts[side].as_ref());
            let part = part.map(|part| format!("{part}: ")).unwrap_or_default();
            write!(f, "{and}{part}{name}")?;
            let owned = |owners: &Owners| (owners.part_ids[side], owners.part_vertices[side].clone());
            let in_scene = || (self.ids[side], self.vertices[side].clone());
            let (id, vertices) = self.owners.as_ref().map_or_else(in_scene, owned);
            if let Some(id) = id {
                write!(f, " {id}")?;
            }
            if let vertices @ [_, _, ..] = &vertices[..] {
                let vertices: Vec<_> = vertices.iter().map(ToString::to_string).collect();
                write!(f, " (vertices {})", vertices.join(", "))?;
            }
        }
        let Bounds { lower, upper } = self.distance;
        let [least, most] = [lower, upper].map(shortest);
        if upper == 0.0 {
            Ok(())
        } else if lower == upper {
            write!(f, ", {least} apart")
        } else {
            write!(f, ", between {least} and {most} apart")
        }
    }
}
