//! The page of a single query.

use std::ops::Range;

use exact_ccd::{Kind, Point, Query, Separation, Stage};
use exact_ccd_mesh::TriangleMesh;
use serde::Serialize;

use crate::contact::Primitive;

/// The vertices of both primitives of a query, among the four points of a page.
fn primitives<K: Kind>() -> [Vec<u32>; 2] {
    let place = |point: usize| K::OF_FOUR.iter().position(|&of| of == point);
    let of_points = |points: Range<usize>| points.filter_map(place).map(|place| place as u32).collect();
    [0..K::FIRST, K::FIRST..K::KIND.point_names().len()].map(of_points)
}

/// The mesh of a query: its face and its edges, over its four points.
pub(crate) fn mesh_of<K: Kind>() -> TriangleMesh {
    let primitives = primitives::<K>();
    let faces = primitives
        .iter()
        .filter_map(|primitive| primitive[..].try_into().ok());
    let edges = primitives
        .iter()
        .filter_map(|primitive| primitive[..].try_into().ok());
    TriangleMesh::with_edges(4, faces.collect(), &edges.collect::<Vec<[u32; 2]>>()).unwrap_or_default()
}

/// The four points of a query at both ends of the step: in place of an edge, a vertex occurs twice.
pub(crate) fn points_of<K: Kind>(query: &Query<K>) -> [[Point; 4]; 2] {
    query
        .points()
        .map(|points| K::OF_FOUR.map(|i| points.as_ref()[i]))
}

pub(crate) fn primitives_of<K: Kind>() -> [Primitive; 2] {
    primitives::<K>().map(|vertices| Primitive::new(None, &vertices))
}

/// A query with its answers, in the shape of the JSON object.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct ShownQuery {
    kind: &'static str,
    points: [[Point; 4]; 2],
    primitives: [Primitive; 2],
    stage: String,
    /// The distance at which primitives count as touching.
    separation: f64,
    /// The intervals of contact, rounded down; both ends are the same for a moment.
    times: Vec<[f64; 2]>,
    /// At equidistant times from 0 to 1; none if it is above all f64.
    distances: Vec<Option<f64>>,
}

/// The number of intervals between the times of distances.
const INTERVALS: u32 = 120;

impl ShownQuery {
    pub(crate) fn new<K: Kind>(query: &Query<K>, separation: Separation) -> Self {
        let times = query.intervals(separation);
        let distance = |i: u32| {
            let bounds = query.distance_at(f64::from(i) / f64::from(INTERVALS)).ok()?;
            bounds.upper.is_finite().then_some(bounds.lower)
        };
        Self {
            kind: K::KIND.name(),
            points: points_of(query),
            primitives: primitives_of::<K>(),
            stage: stage_of(query, separation),
            separation: separation.get(),
            times: times
                .iter()
                .map(|time| [time.start.lower(), time.end.lower()])
                .collect(),
            distances: (0..=INTERVALS).map(distance).collect(),
        }
    }

    /// The line of the answer.
    pub(crate) fn verdict(&self) -> String {
        let touching = if self.separation > 0.0 {
            format!("within {}", self.separation)
        } else {
            "contact".to_owned()
        };
        let times: Vec<String> = self
            .times
            .iter()
            .map(|&[start, end]| interval(start, end))
            .collect();
        match &times[..] {
            [] if self.separation > 0.0 => format!("never {touching}"),
            [] => "free of contact".to_owned(),
            [time] => format!("{touching} at t = {time}"),
            _ => format!("{touching} at {} times: t = {}", times.len(), times.join(", ")),
        }
    }

    /// The line about the stage that decided.
    pub(crate) fn decided_by(&self) -> String {
        format!("decided by the stage {}", self.stage)
    }
}

fn interval(start: f64, end: f64) -> String {
    if start.to_bits() == end.to_bits() {
        start.to_string()
    } else {
        format!("{start} to {end}")
    }
}

/// The stage that decides, and its reason.
fn stage_of<K: Kind>(query: &Query<K>, separation: Separation) -> String {
    let stage = query.decide(separation).1;
    format!("{stage:?}: {}", meaning(stage))
}

/// The reasons of a stage.
fn meaning(stage: Stage) -> &'static str {
    match stage {
        Stage::BoundingBox => "an axis separates",
        Stage::Diagonals => "a diagonal of two axes separates",
        Stage::Normals => "the normal of the planes at t = 0 or t = 1 separates",
        Stage::Coplanarity => "the planes are apart at all times",
        Stage::Roots => "the roots of the cubic, and the position of the primitives at each",
        Stage::Coincident => "comparisons of coordinates",
        Stage::Direction => {
            "a plane through an edge and the velocity, or a direction found by iteration, separates"
        }
        Stage::Planar => "sides of lines in a plane across an axis",
        Stage::Start => "the primitives are within the distance at t = 0",
        Stage::Advancement => "directions separate, one stretch of time after the other",
        Stage::Crossing => "the distances just before and just after the first time",
        Stage::FixedWidth => "the signs of integers of fixed width",
        _ => "integers",
    }
}
