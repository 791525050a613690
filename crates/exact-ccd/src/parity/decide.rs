//! Root parity as a method of continuous collision detection.

use super::Rounded;
use crate::ccd::{Ccd, Decide, Guarantees, TimeGuarantee};
use crate::kind::Kind;
use crate::query::Query;

/// Root parity on rounded input: the decision of Algorithm 1 of the paper.
///
/// A query is first shifted by its own displacement, which is zero on the axes on which its corner
/// differences are exact.
///
/// # False negatives and false positives
/// An even number of contacts looks like none. The answer is right for the rounded query: the query itself may be in
/// contact where the rounded one is not, and the other way round. A query that is too large to be rounded counts as a
/// collision.
#[derive(Clone, Copy, Debug, Default)]
pub struct RootParity;

impl<K: Kind> Decide<K> for RootParity {
    fn collides(&self, query: &Query<K>) -> bool {
        Rounded::shift(query).map_or(true, |rounded| rounded.parity().is_collision())
    }
}

impl Ccd for RootParity {
    fn name(&self) -> &'static str {
        "parity"
    }

    fn guarantees(&self) -> Guarantees {
        Guarantees {
            false_negatives: true,
            false_positives: true,
            time: TimeGuarantee::Absent,
        }
    }
}
