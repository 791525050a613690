//! Root parity as a method of continuous collision detection.

use super::Rounded;
use crate::ccd::{Ccd, Decide, Guarantees, TimeGuarantee};
use crate::kind::Kind;
use crate::query::Query;

/// The paper's method: the parity of the number of contacts, after each query is shifted and rounded by itself.
///
/// The shift is zero on the axes on which the corner differences are exact.
///
/// # Errors of the method
/// - An even number of contacts is a false negative.
/// - Rounding can open or close a contact.
/// - A query whose coordinates are too large to be shifted counts as a contact.
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
