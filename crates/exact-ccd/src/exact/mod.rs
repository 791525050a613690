//! The exact path.
use crate::kind::Kind;
use crate::query::Query;
use crate::time::{ContactTimes, Times};

/// Whether the primitives touch.
#[must_use]
pub fn collides<K: Kind>(query: &Query<K>) -> bool {
    contact_times(query).count() != Some(0)
}

/// All contact times.
#[must_use]
pub fn contact_times<K: Kind>(_query: &Query<K>) -> ContactTimes {
    ContactTimes::Finite(Times::default())
}
