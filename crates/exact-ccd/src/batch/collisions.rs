//! The collisions that a batch finds, with their queries.

use crate::collision::Collision;
use crate::decided::Decided;
use crate::kind::Kind;
use crate::query::Query;
use crate::tables::Points;

/// A function of collisions as one of what was decided about the points of queries.
pub(super) fn with_queries<K: Kind>(
    mut found: impl FnMut(usize, Collision<'_, K>),
) -> impl FnMut(usize, &Points<f64>, Decided<K>) {
    move |index, points, decided| {
        let query = Query::from_finite(K::of_four(points));
        found(index, Collision::new(&query, decided));
    }
}
