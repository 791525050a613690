//! The vertices of a mesh over a time step, and the queries about them.

use alloc::vec::Vec;

use fearless_simd::{Simd, dispatch};

use super::instructions::Instructions;
use super::planes::{self, LANES};
use super::row::Row;
use super::rows;
use crate::kind::Kind;
use crate::query::{Point, Query};
use crate::{exact, filter};

/// Points that move in straight lines, at constant speed, from t = 0 to t = 1: the vertices of a mesh, laid out for
/// many queries.
#[derive(Clone, Debug)]
pub struct Trajectories {
    rows: Vec<Row>,
    instructions: Instructions,
}

/// What keeps positions from being trajectories.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum TrajectoriesError {
    /// There are not as many positions at the end as at the start.
    #[error("{end} positions at t = 1, expected as many as at t = 0: {start}")]
    Count {
        /// How many there are at t = 0.
        start: usize,
        /// How many there are at t = 1.
        end: usize,
    },
    /// A coordinate is infinite or not a number.
    #[error("vertex {vertex} has a coordinate that is not a finite number")]
    NonFinite {
        /// The index of the first such vertex.
        vertex: usize,
    },
}

/// A query names a vertex that does not exist.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("query {query} names vertex {vertex}, but there are only {vertex_count} vertices")]
pub struct VertexOutOfRange {
    /// The index of the query.
    pub query: usize,
    /// The vertex, from 0.
    pub vertex: u32,
    /// How many vertices there are.
    pub vertex_count: usize,
}

/// How many queries go through one filter before the next filter.
const CHUNK: usize = 256;

impl Trajectories {
    /// The trajectories from positions `x0` at t = 0 to positions `x1` at t = 1.
    ///
    /// # Errors
    /// [`TrajectoriesError`], if the counts differ or a coordinate is not finite.
    pub fn new(x0: &[Point], x1: &[Point]) -> Result<Self, TrajectoriesError> {
        let mut trajectories = Self {
            rows: Vec::new(),
            instructions: Instructions::best(),
        };
        trajectories.set(x0, x1)?;
        Ok(trajectories)
    }

    /// Takes other trajectories, of any number of points, into the memory of the old ones.
    ///
    /// # Errors
    /// [`TrajectoriesError`], if the counts differ or a coordinate is not finite; there are no points then.
    pub fn set(&mut self, x0: &[Point], x1: &[Point]) -> Result<(), TrajectoriesError> {
        self.rows.clear();
        if x0.len() != x1.len() {
            return Err(TrajectoriesError::Count {
                start: x0.len(),
                end: x1.len(),
            });
        }
        self.rows.extend(x0.iter().zip(x1).map(|(&a, &b)| Row::new(a, b)));
        match self.rows.iter().position(|row| !row.is_finite()) {
            None => Ok(()),
            Some(vertex) => {
                self.rows.clear();
                Err(TrajectoriesError::NonFinite { vertex })
            }
        }
    }

    /// The same, for other vector instructions than the widest.
    #[must_use]
    pub fn with_instructions(self, instructions: Instructions) -> Self {
        Self { instructions, ..self }
    }

    /// How many vertices there are.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.rows.len()
    }

    /// The query of four vertices, in the order of [`VertexFace`](crate::VertexFace) or
    /// [`EdgeEdge`](crate::EdgeEdge); `None` if one of them does not exist.
    #[must_use]
    pub fn query<K: Kind>(&self, vertices: [u32; 4]) -> Option<Query<K>> {
        let row = |vertex: u32| self.rows.get(vertex as usize);
        let [a, b, c, d] = vertices;
        Some(query([row(a)?, row(b)?, row(c)?, row(d)?]))
    }

    /// Calls `found` with each query of four vertices that [collides](Query::collides), and its index, in order.
    ///
    /// # Errors
    /// [`VertexOutOfRange`] names the first vertex that does not exist; nothing is found then.
    pub fn collisions<K: Kind>(
        &self,
        queries: &[[u32; 4]],
        mut found: impl FnMut(usize, &Query<K>),
    ) -> Result<(), VertexOutOfRange> {
        self.check(queries)?;
        // Behind a pointer: contacts are few, and the vectors need to be compiled only once for all of whom they are shown to.
        let found: &mut dyn FnMut(usize, &Query<K>) = &mut found;
        dispatch!(self.instructions.level(), simd => collisions(simd, &self.rows, queries, found));
        Ok(())
    }

    pub(crate) fn check(&self, queries: &[[u32; 4]]) -> Result<(), VertexOutOfRange> {
        let vertex_count = self.rows.len();
        let largest = queries
            .as_flattened()
            .iter()
            .fold(0, |largest, &v| largest.max(v));
        if queries.is_empty() || (largest as usize) < vertex_count {
            return Ok(());
        }
        let vertices = queries.as_flattened();
        let index = vertices
            .iter()
            .position(|&vertex| vertex as usize >= vertex_count);
        index.map_or(Ok(()), |index| {
            Err(VertexOutOfRange {
                query: index / 4,
                vertex: vertices[index],
                vertex_count,
            })
        })
    }
}

#[inline(always)]
fn collisions<S: Simd, K: Kind>(
    simd: S,
    rows: &[Row],
    queries: &[[u32; 4]],
    found: &mut dyn FnMut(usize, &Query<K>),
) {
    let rows_of = |query: &[u32; 4]| query.map(|vertex| &rows[vertex as usize]);
    let mut near = [0; CHUNK + LANES];
    for (chunk, queries) in queries.chunks(CHUNK).enumerate() {
        let mut count = 0;
        for (index, query) in queries.iter().enumerate() {
            // Without a branch: which ones are left is hard to predict.
            near[count] = index;
            count += usize::from(!rows::are_separated::<S, K>(simd, rows_of(query)));
        }
        // The last vector is filled up with a query that is there already.
        let filled = count.next_multiple_of(LANES);
        let last = near[count.saturating_sub(1)];
        near[count..filled].fill(last);
        for (eight, indices) in near[..filled].chunks_exact(LANES).enumerate() {
            let mut lanes = [rows_of(&queries[indices[0]]); LANES];
            for (lane, &index) in lanes.iter_mut().zip(indices) {
                *lane = rows_of(&queries[index]);
            }
            let rest = planes::screen::<S, K>(simd, &lanes);
            for lane in 0..LANES.min(count - LANES * eight) {
                if rest.lanes >> lane & 1 != 0 {
                    let query = query(lanes[lane]);
                    let filtered = if rest.out_of_range >> lane & 1 == 0 {
                        filter::collides_near_plane(&query, &rest.cubic(lane))
                    } else {
                        None
                    };
                    if filtered.map_or_else(|| exact::collides(&query), |(collides, _)| collides) {
                        found(CHUNK * chunk + indices[lane], &query);
                    }
                }
            }
        }
    }
}

fn query<K: Kind>(rows: [&Row; 4]) -> Query<K> {
    let [[a0, a1], [b0, b1], [c0, c1], [d0, d1]] = rows.map(Row::points);
    Query::from_finite([[a0, b0, c0, d0], [a1, b1, c1, d1]])
}
