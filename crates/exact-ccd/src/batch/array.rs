//! Batches of queries that have no vertices in common.

use alloc::vec::Vec;

use super::chunks::{self, CHUNK};
use super::instructions::Instructions;
use super::row::Row;
use crate::collision::Collision;
use crate::kind::Kind;
use crate::point::Point;
use crate::query::NonFinite;

/// A coordinate of a query in an array is infinite or not a number.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("query {query}: {source}")]
pub struct NonFiniteQuery {
    /// The index of the query.
    pub query: usize,
    /// The coordinate.
    pub source: NonFinite,
}

/// Calls `found` with the index and the collision of each query that
/// [collides](crate::Query::collides), in order.
///
/// The arguments of [`Query::new`](crate::Query::new) make one query: four points at t = 0 and at t
/// = 1. If the queries are those of a mesh, with vertices in common,
/// [`Trajectories`](super::Trajectories) read less memory.
///
/// ```
/// use exact_ccd::{VertexFace, batch};
///
/// let at = |z: f64| [[0.25, 0.25, z], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
/// let queries = [[at(1.0), at(0.5)], [at(1.0), at(-1.0)]];
/// let mut times = Vec::new();
/// batch::collisions::<VertexFace>(&queries, |index, collision| {
///     times.push((index, collision.time_of_impact()));
/// })?;
/// assert_eq!(times, [(1, 0.5)]);
/// # Ok::<(), batch::NonFiniteQuery>(())
/// ```
///
/// # Errors
/// [`NonFiniteQuery`] names the first coordinate that is infinite or not a number. All collisions
/// before that query have been found then, and none after it.
pub fn collisions<K: Kind>(
    queries: &[[[Point; 4]; 2]],
    found: impl FnMut(usize, Collision<'_, K>),
) -> Result<(), NonFiniteQuery> {
    collisions_with(Instructions::best(), queries, found)
}

/// [`collisions`] by other vector instructions than the widest.
///
/// # Errors
/// The same.
pub fn collisions_with<K: Kind>(
    instructions: Instructions,
    queries: &[[[Point; 4]; 2]],
    mut found: impl FnMut(usize, Collision<'_, K>),
) -> Result<(), NonFiniteQuery> {
    let indices: [[u32; 4]; CHUNK] = core::array::from_fn(|i| [0, 1, 2, 3].map(|k| 4 * i as u32 + k));
    let mut rows = Vec::with_capacity(4 * CHUNK);
    for (chunk, queries) in queries.chunks(CHUNK).enumerate() {
        rows.clear();
        for [start, end] in queries {
            rows.extend([0, 1, 2, 3].map(|i: usize| Row::new(start[i], end[i])));
        }
        // Without a branch for each coordinate.
        let finite = rows.iter().fold(true, |all, row| all & row.is_finite());
        let first = CHUNK * chunk;
        let error = if finite { None } else { first_error(first, queries) };
        let sound = error.map_or(queries.len(), |error| error.query - first);
        let found: chunks::Found<'_, K> = &mut |index, collision| found(first + index, collision);
        chunks::collisions(instructions, &rows, &indices[..sound], found);
        if let Some(error) = error {
            return Err(error);
        }
    }
    Ok(())
}

#[cold]
fn first_error(first: usize, queries: &[[[Point; 4]; 2]]) -> Option<NonFiniteQuery> {
    queries.iter().enumerate().find_map(|(index, points)| {
        let source = NonFinite::check_moving(points).err()?;
        Some(NonFiniteQuery {
            query: first + index,
            source,
        })
    })
}
