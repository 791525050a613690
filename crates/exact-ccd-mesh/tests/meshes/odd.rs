//! A method with false negatives.

use exact_ccd::{CONTACT, Ccd, Decide, Guarantees, Kind, Query, TimeGuarantee};

/// Decides that primitives collide if the number of their contact times is odd or infinite.
pub(crate) struct Odd;

impl<K: Kind> Decide<K> for Odd {
    fn collides(&self, query: &Query<K>) -> bool {
        query
            .intervals(CONTACT)
            .count()
            .is_none_or(|count| count % 2 == 1)
    }
}

impl Ccd for Odd {
    fn name(&self) -> &'static str {
        "odd"
    }

    fn guarantees(&self) -> Guarantees {
        Guarantees {
            false_negatives: true,
            false_positives: false,
            time: TimeGuarantee::Absent,
        }
    }
}
