//! Batches of queries that have no vertices in common.

use alloc::vec::Vec;

use super::collisions::with_queries;
use crate::collision::Collision;
use crate::kind::Kind;
use crate::query::NonFinite;
use crate::values::Options;
use crate::vectors::{Batch, CHUNK, Instructions, Passed, Row};

/// A coordinate of a query in an array is infinite or not a number.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("query {query}: {source}")]
pub struct NonFiniteQuery {
    /// The index of the query.
    pub query: usize,
    /// The coordinate.
    pub source: NonFinite,
}

/// Queries that are given by their points, and have no vertices in common.
///
/// The arguments of [`Query::new`](crate::Query::new) make one query: its points at both ends of the step.
/// If the queries belong to a mesh, with vertices in common, [`Trajectories`](super::Trajectories) read less
/// memory.
///
/// ```
/// use exact_ccd::{CONTACT, VertexFace, batch};
///
/// let at = |z: f64| [[0.25, 0.25, z], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
/// let queries = [[at(1.0), at(0.5)], [at(1.0), at(-1.0)]];
/// let mut times = Vec::new();
/// batch::Queries::<VertexFace>::new(&queries).collisions(CONTACT, |index, collision| {
///     times.push((index, collision.time_of_impact()));
/// })?;
/// assert_eq!(times, [(1, 0.5)]);
/// # Ok::<(), batch::NonFiniteQuery>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Queries<'a, K: Kind> {
    points: &'a [[K::Points; 2]],
    instructions: Instructions,
}

impl<'a, K: Kind> Queries<'a, K> {
    /// The queries with these points at the start and at the end.
    #[must_use]
    pub fn new(points: &'a [[K::Points; 2]]) -> Self {
        Self {
            points,
            instructions: Instructions::best(),
        }
    }

    /// The same queries, for other vector instructions than the widest.
    #[must_use]
    pub fn with_instructions(self, instructions: Instructions) -> Self {
        Self { instructions, ..self }
    }

    /// Calls `found` with the index and the collision of each query that
    /// [collides](crate::Query::collides), in order.
    ///
    /// # Errors
    /// [`NonFiniteQuery`] names the first coordinate that is infinite or not a number. All collisions
    /// before that query have been found then, and none after it.
    pub fn collisions(
        &self,
        options: impl Into<Options>,
        mut found: impl FnMut(usize, Collision<'_, K>),
    ) -> Result<(), NonFiniteQuery> {
        let Options { separation, until } = options.into();
        // The tables of a whole chunk would take longer than a few queries.
        let most = CHUNK.min(self.points.len());
        let indices = consecutive::<K>(most);
        let mut rows = Vec::with_capacity(4 * most);
        for (chunk, points) in self.points.chunks(CHUNK).enumerate() {
            rows.clear();
            for [start, end] in points {
                let ends = start.as_ref().iter().zip(end.as_ref());
                rows.extend(ends.map(|(&start, &end)| Row::new(start, end)));
            }
            // Without a branch for each coordinate.
            let finite = rows.iter().fold(true, |all, row| all & row.is_finite());
            let first = CHUNK * chunk;
            let error = if finite {
                None
            } else {
                first_error::<K>(first, points)
            };
            let sound = &indices[..error.map_or(points.len(), |error| error.query - first)];
            let mut found = with_queries::<K>(|index, collision| found(first + index, collision));
            let batch = Batch {
                rows: &rows,
                queries: sound,
                separations: separation.into(),
                until,
                passed: Passed::Colliding(&mut found),
            };
            K::run(batch, self.instructions);
            if let Some(error) = error {
                return Err(error);
            }
        }
        Ok(())
    }
}

/// The vertices of some queries without common ones.
fn consecutive<K: Kind>(count: usize) -> Vec<K::Vertices> {
    let mut next = 0..;
    let vertices = || {
        let mut vertices = K::Vertices::default();
        vertices
            .as_mut()
            .iter_mut()
            .zip(&mut next)
            .for_each(|(vertex, index)| *vertex = index);
        vertices
    };
    core::iter::repeat_with(vertices).take(count).collect()
}

#[cold]
fn first_error<K: Kind>(first: usize, points: &[[K::Points; 2]]) -> Option<NonFiniteQuery> {
    points.iter().enumerate().find_map(|(index, [start, end])| {
        let source = NonFinite::check(&[start.as_ref(), end.as_ref()]).err()?;
        Some(NonFiniteQuery {
            query: first + index,
            source,
        })
    })
}
