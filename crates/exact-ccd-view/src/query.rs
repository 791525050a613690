//! The page of a single query.

use exact_ccd::separation::Separation;
use exact_ccd::{ContactTime, ContactTimes, EdgeEdge, Kind, Point, Query, Stage, VertexFace};
use exact_ccd_mesh::{Contact, Pair};
use serde::Serialize;

use crate::contact::Primitive;

/// A kind of query that a page can show.
pub trait PageKind: Kind<Points = [Point; 4]> {
    /// The name of the kind on the page.
    const NAME: &'static str;
    /// The number of points of the first primitive.
    const FIRST: usize;
    /// The faces of the mesh of a query.
    const FACES: &'static [[u32; 3]];
    /// Its edges that are not edges of faces.
    const EDGES: &'static [[u32; 2]];
    /// The primitives of the query in this mesh.
    const PAIR: Pair;
}

impl PageKind for VertexFace {
    const NAME: &'static str = "vertex-face";
    const FIRST: usize = 1;
    const FACES: &'static [[u32; 3]] = &[[1, 2, 3]];
    const EDGES: &'static [[u32; 2]] = &[];
    const PAIR: Pair = Pair::VertexFace { vertex: 0, face: 0 };
}

impl PageKind for EdgeEdge {
    const NAME: &'static str = "edge-edge";
    const FIRST: usize = 2;
    const FACES: &'static [[u32; 3]] = &[];
    const EDGES: &'static [[u32; 2]] = &[[0, 1], [2, 3]];
    const PAIR: Pair = Pair::EdgeEdge { a: 0, b: 1 };
}

/// A query with its answers, in the shape of the JSON object.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct ShownQuery {
    kind: &'static str,
    points: [[Point; 4]; 2],
    primitives: [Primitive; 2],
    stage: String,
    /// The intervals of contact, rounded down; both ends are the same for a moment.
    times: Vec<[f64; 2]>,
    /// At equidistant times from 0 to 1; none if it is above all f64.
    distances: Vec<Option<f64>>,
}

/// The number of intervals between the times of distances.
const INTERVALS: u32 = 120;

impl ShownQuery {
    pub(crate) fn new<K: PageKind>(query: &Query<K>) -> Self {
        let (_, stage) = query.collides_with_stage();
        let intervals = Separation::new(0.0).map(|zero| query.intervals_within(zero));
        let times = intervals.unwrap_or_default();
        let distance = |i: u32| {
            let bounds = query.distance_at(f64::from(i) / f64::from(INTERVALS)).ok()?;
            bounds.upper.is_finite().then_some(bounds.lower)
        };
        let [first, second] = [&[0, 1, 2, 3][..K::FIRST], &[0, 1, 2, 3][K::FIRST..]];
        Self {
            kind: K::NAME,
            points: *query.points(),
            primitives: [Primitive::new(None, first), Primitive::new(None, second)],
            stage: format!("{stage:?}"),
            times: times
                .iter()
                .map(|time| [time.start.lower(), time.end.lower()])
                .collect(),
            distances: (0..=INTERVALS).map(distance).collect(),
        }
    }
}

/// The contact of a query in the mesh of its page.
pub(crate) fn contact_of<K: PageKind>(query: &Query<K>) -> Option<Contact> {
    let pair = K::PAIR;
    query.impact().map(|impact| Contact { pair, impact })
}

/// Lines about the answer.
pub(crate) fn summary<K: PageKind>(query: &Query<K>) -> Vec<String> {
    let (_, stage) = query.collides_with_stage();
    let answer = match query.contact_times() {
        ContactTimes::Interval { first } => {
            format!("contact for an interval of time, from t = {}", first.lower())
        }
        ContactTimes::Finite(times) => match times[..] {
            [] => "free of contact".to_owned(),
            [time] => format!("contact at t = {}", time.lower()),
            _ => {
                let list: Vec<String> = times
                    .iter()
                    .copied()
                    .map(ContactTime::lower)
                    .map(|t| t.to_string())
                    .collect();
                format!("contact at {} times: t = {}", times.len(), list.join(", "))
            }
        },
    };
    vec![
        answer,
        format!("decided by the stage {stage:?}: {}", meaning(stage)),
    ]
}

/// The reasons of a stage.
fn meaning(stage: Stage) -> &'static str {
    match stage {
        Stage::BoundingBox => "the box around the image of the domain does not contain the origin",
        Stage::Diagonals => "a plane across a diagonal of two axes separates",
        Stage::Normals => "the plane of the primitives at t = 0 or t = 1 separates",
        Stage::Coplanarity => "the cubic has no root",
        Stage::Roots => "the roots of the cubic, and the position of the primitives at each",
        Stage::Coincident => "comparisons of coordinates",
        Stage::Direction => "a direction found by iteration separates",
        Stage::Planar => "sides of lines in a plane across an axis",
        _ => "integers",
    }
}
