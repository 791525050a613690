//! What `exact-ccd step` prints.

use std::fmt;

use ccd_mesh::{Pair, PairCounts, StepReport, TriangleMesh};
use serde::Serialize;

use crate::kind::Kind;
use crate::shortest::shortest;

/// The answer, in the shape of the JSON object.
#[derive(Serialize)]
pub(crate) struct Report {
    collision_free: bool,
    toi: Option<f64>,
    pair: Option<ReportedPair>,
    touching_at_start: usize,
    candidates: Counts,
    seconds: Seconds,
}

/// The pair that touches first.
#[derive(Serialize)]
pub(crate) struct ReportedPair {
    kind: Kind,
    /// The indices of the vertex and the face, or of the two edges.
    ids: [u32; 2],
    /// The vertices of the first primitive, then those of the second, for people.
    #[serde(skip)]
    vertices: [u32; 4],
}

#[derive(Serialize)]
struct Counts {
    vf: usize,
    ee: usize,
}

/// How long the phases took.
#[derive(Serialize)]
pub(crate) struct Seconds {
    pub(crate) read: f64,
    pub(crate) broad: f64,
    pub(crate) narrow: f64,
    pub(crate) total: f64,
}

impl Report {
    pub(crate) fn new(mesh: &TriangleMesh, contacts: &StepReport, seconds: Seconds) -> Self {
        Self {
            collision_free: contacts.is_free(),
            toi: contacts.time_of_impact(),
            pair: contacts
                .earliest
                .map(|earliest| ReportedPair::new(mesh, earliest.pair)),
            touching_at_start: contacts.touching.total(),
            candidates: contacts.candidates.into(),
            seconds,
        }
    }

    pub(crate) fn to_json(&self) -> String {
        serde_json::to_string(self).expect("numbers and names only")
    }
}

impl ReportedPair {
    pub(crate) fn new(mesh: &TriangleMesh, pair: Pair) -> Self {
        match pair {
            Pair::VertexFace { vertex, face } => {
                let [a, b, c] = mesh.faces()[face as usize];
                Self {
                    kind: Kind::Vf,
                    ids: [vertex, face],
                    vertices: [vertex, a, b, c],
                }
            }
            Pair::EdgeEdge { a, b } => {
                let [[a0, a1], [b0, b1]] = [a, b].map(|edge| mesh.edges()[edge as usize]);
                Self {
                    kind: Kind::Ee,
                    ids: [a, b],
                    vertices: [a0, a1, b0, b1],
                }
            }
        }
    }
}

impl From<PairCounts> for Counts {
    fn from(counts: PairCounts) -> Self {
        Self {
            vf: counts.vertex_face,
            ee: counts.edge_edge,
        }
    }
}

/// The answer for people.
impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.toi, &self.pair) {
            (Some(toi), Some(pair)) => writeln!(f, "contact at t = {}: {pair}", shortest(toi))?,
            _ => writeln!(f, "free of contact")?,
        }
        let Self {
            candidates,
            seconds,
            touching_at_start,
            ..
        } = self;
        writeln!(
            f,
            "candidates: {} vertex-face pairs, {} edge-edge pairs",
            candidates.vf, candidates.ee
        )?;
        writeln!(f, "touching at t = 0: {touching_at_start} pairs")?;
        write!(
            f,
            "seconds: {:.3} reading, {:.3} broad phase, {:.3} narrow phase, {:.3} in total",
            seconds.read, seconds.broad, seconds.narrow, seconds.total
        )
    }
}

impl fmt::Display for ReportedPair {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ([i, j], [a, b, c, d]) = (self.ids, self.vertices);
        match self.kind {
            Kind::Vf => write!(f, "vertex {i} and face {j} (vertices {b}, {c}, {d})"),
            Kind::Ee => write!(f, "edge {i} (vertices {a}, {b}) and edge {j} (vertices {c}, {d})"),
        }
    }
}
