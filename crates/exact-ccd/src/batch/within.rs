//! Queries within a distance, one at a time.

use super::chunks::{self, Found, query_of};
use super::instructions::Instructions;
use super::row::Row;
use crate::kind::Kind;
use crate::query::Query;
use crate::separation::Separations;

/// Calls `found` with each query of rows that comes within its separation, and its index, in order.
/// All indices of rows exist.
pub(super) fn collisions<K: Kind>(
    instructions: Instructions,
    rows: &[Row],
    queries: &[K::Vertices],
    separations: Separations<'_>,
    found: Found<'_, K>,
) {
    if separations.is_contact() {
        return chunks::collisions::<K>(instructions, rows, queries, found);
    }
    for (index, vertices) in queries.iter().enumerate() {
        let (a, b) = vertices.as_ref().split_at(K::FIRST);
        let query: Query<K> = query_of(rows, vertices);
        if let Some(collision) = query.collision_within(separations.between(a, b)) {
            found(index, collision);
        }
    }
}
