//! The output of `exact-ccd step`.

use std::fmt;
use std::time::Duration;

use exact_ccd_mesh::{Contact, Pair, PairCounts, StepReport, TriangleMesh};
use serde::Serialize;

use crate::distances::{Distances, Reached};
use crate::kind::Kind;
use crate::shortest::shortest;

/// The answer, and the distances within which pairs touch.
#[derive(Serialize)]
pub(crate) struct Output {
    #[serde(flatten)]
    pub(crate) distances: Distances,
    #[serde(flatten)]
    pub(crate) answer: Answer,
}

/// The answer to one of the questions of the command line.
#[derive(Serialize)]
#[serde(untagged)]
pub(crate) enum Answer {
    /// Only if there is contact.
    Free(Free),
    /// The earliest contact.
    Report(Report),
}

/// The presence of contact, in the shape of the JSON object.
#[derive(Serialize)]
pub(crate) struct Free {
    collision_free: bool,
    seconds: Seconds,
}

/// The earliest contact, in the shape of the JSON object.
#[derive(Serialize)]
pub(crate) struct Report {
    collision_free: bool,
    toi: Option<f64>,
    pair: Option<ReportedPair>,
    #[serde(flatten)]
    counts: Option<Counted>,
    seconds: Seconds,
}

/// The counts, if all candidates have been examined.
#[derive(Serialize)]
struct Counted {
    touching_at_start: usize,
    candidates: Counts,
}

/// The pair that touches first.
#[derive(Serialize)]
pub(crate) struct ReportedPair {
    kind: Kind,
    /// The indices of the two primitives.
    ids: [u32; 2],
    /// The distance of the pair then.
    distance: Reached,
    /// The vertices of the first primitive, then those of the second, for the text.
    #[serde(skip)]
    vertices: Vec<u32>,
}

#[derive(Serialize)]
struct Counts {
    vf: usize,
    ee: usize,
    ve: usize,
    vv: usize,
}

/// The durations of the phases.
#[derive(Serialize)]
pub(crate) struct Seconds {
    read: f64,
    broad: f64,
    narrow: f64,
    total: f64,
}

impl Seconds {
    /// The durations, from that of reading, that of all the rest, and the narrow phase's share of
    /// the rest.
    pub(crate) fn new(read: Duration, rest: Duration, narrow: Duration) -> Self {
        let [read, rest, narrow] = [read, rest, narrow].map(|time| time.as_secs_f64());
        Self {
            read,
            broad: (rest - narrow).max(0.0),
            narrow,
            total: read + rest,
        }
    }
}

impl Answer {
    pub(crate) fn is_free(&self) -> bool {
        match self {
            Self::Free(Free { collision_free, .. }) | Self::Report(Report { collision_free, .. }) => {
                *collision_free
            }
        }
    }

    /// The total duration, including reading.
    pub(crate) fn seconds(&self) -> f64 {
        match self {
            Self::Free(Free { seconds, .. }) | Self::Report(Report { seconds, .. }) => seconds.total,
        }
    }
}

impl Output {
    pub(crate) fn to_json(&self) -> String {
        serde_json::to_string(self).expect("numbers and names only")
    }
}

impl Free {
    pub(crate) fn new(collision_free: bool, seconds: Seconds) -> Self {
        Self {
            collision_free,
            seconds,
        }
    }
}

impl Report {
    /// The report of all contacts.
    pub(crate) fn new(mesh: &TriangleMesh, contacts: &StepReport, seconds: Seconds) -> Self {
        Self {
            counts: Some(Counted {
                touching_at_start: contacts.touching.total(),
                candidates: contacts.candidates.into(),
            }),
            ..Self::earliest(mesh, contacts.earliest, seconds)
        }
    }

    /// The report of the earliest contact only.
    pub(crate) fn earliest(mesh: &TriangleMesh, earliest: Option<Contact>, seconds: Seconds) -> Self {
        Self {
            collision_free: earliest.is_none(),
            toi: earliest.map(|contact| contact.impact.time.lower()),
            pair: earliest.map(|contact| ReportedPair::new(mesh, &contact)),
            counts: None,
            seconds,
        }
    }
}

impl ReportedPair {
    pub(crate) fn new(mesh: &TriangleMesh, contact: &Contact) -> Self {
        let (kind, ids) = match contact.pair {
            Pair::VertexFace { vertex, face } => (Kind::Vf, [vertex, face]),
            Pair::EdgeEdge { a, b } => (Kind::Ee, [a, b]),
            Pair::VertexEdge { vertex, edge } => (Kind::Ve, [vertex, edge]),
            Pair::VertexVertex { a, b } => (Kind::Vv, [a, b]),
        };
        Self {
            kind,
            ids,
            distance: contact.distance.into(),
            vertices: contact.pair.vertices(mesh).expect("the pair is one of the mesh"),
        }
    }
}

impl From<PairCounts> for Counts {
    fn from(counts: PairCounts) -> Self {
        Self {
            vf: counts.vertex_face,
            ee: counts.edge_edge,
            ve: counts.vertex_edge,
            vv: counts.vertex_vertex,
        }
    }
}

/// The text on a terminal.
impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.toi, &self.pair) {
            (Some(toi), Some(pair)) => writeln!(f, "contact at t = {}: {pair}", shortest(toi))?,
            _ => writeln!(f, "free of contact")?,
        }
        if let Some(Counted {
            candidates,
            touching_at_start,
        }) = &self.counts
        {
            write!(
                f,
                "candidates: {} vertex-face pairs, {} edge-edge pairs",
                candidates.vf, candidates.ee
            )?;
            // A mesh of faces alone has none of these.
            if candidates.ve + candidates.vv > 0 {
                write!(
                    f,
                    ", {} vertex-edge pairs, {} vertex-vertex pairs",
                    candidates.ve, candidates.vv
                )?;
            }
            writeln!(f)?;
            writeln!(f, "touching at t = 0: {touching_at_start} pairs")?;
        }
        self.seconds.fmt(f)
    }
}

impl fmt::Display for Free {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let answer = if self.collision_free {
            "free of contact"
        } else {
            "contact"
        };
        writeln!(f, "{answer}")?;
        self.seconds.fmt(f)
    }
}

impl fmt::Display for Output {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.distances.are_zero() {
            writeln!(f, "{}", self.distances)?;
        }
        match &self.answer {
            Answer::Free(free) => free.fmt(f),
            Answer::Report(report) => report.fmt(f),
        }
    }
}

impl fmt::Display for Seconds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "seconds: {:.3} reading, {:.3} broad phase, {:.3} narrow phase, {:.3} in total",
            self.read, self.broad, self.narrow, self.total
        )
    }
}

impl fmt::Display for ReportedPair {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ([i, j], v) = (self.ids, &self.vertices);
        match self.kind {
            Kind::Vf => write!(
                f,
                "vertex {i} and face {j} (vertices {}, {}, {})",
                v[1], v[2], v[3]
            )?,
            Kind::Ee => write!(
                f,
                "edge {i} (vertices {}, {}) and edge {j} (vertices {}, {})",
                v[0], v[1], v[2], v[3]
            )?,
            Kind::Ve => write!(f, "vertex {i} and edge {j} (vertices {}, {})", v[1], v[2])?,
            Kind::Vv => write!(f, "vertex {i} and vertex {j}")?,
        }
        self.distance.fmt(f)
    }
}
