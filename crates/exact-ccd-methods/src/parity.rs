//! The paper's method.

use exact_ccd::parity::Rounded;
use exact_ccd::{EdgeEdge, Kind, Query, VertexFace};

use crate::method::{Answer, Method, Promise, Time};

/// Root parity on rounded input, by [`exact_ccd::parity`].
///
/// B. Wang, Z. Ferguson, X. Jiang, M. Attene, D. Panozzo and T. Schneider, *Fast and Exact Root Parity for Continuous
/// Collision Detection*, Computer Graphics Forum 41(2), 2022.
///
/// A query is first shifted by its own displacement, which is zero on the axes on which its corner differences are exact.
///
/// # When it fails
/// It misses an even number of contacts. What it says is right for the rounded query; the one that was asked may be in
/// contact where the rounded one is not, and the other way round. A query too large to be rounded counts as a contact.
#[derive(Clone, Copy, Debug, Default)]
pub struct RootParity;

fn answer<K: Kind>(query: &Query<K>) -> Answer {
    Answer::from_decision(Rounded::shift(query).map_or(true, |rounded| rounded.parity().is_collision()))
}

impl Method for RootParity {
    fn name(&self) -> &str {
        "parity"
    }

    fn promise(&self) -> Promise {
        Promise {
            may_miss: true,
            may_invent: true,
            time: Time::Absent,
        }
    }

    fn vertex_face(&self, query: &Query<VertexFace>) -> Answer {
        answer(query)
    }

    fn edge_edge(&self, query: &Query<EdgeEdge>) -> Answer {
        answer(query)
    }
}
