//! The vertices of a mesh over a time step, and the queries about them.

use alloc::vec::Vec;

use super::collisions::with_queries;
use crate::collision::Collision;
use crate::kind::Kind;
use crate::query::{NonFinite, Query};
use crate::tables::Point;
use crate::values::{Axis, Options, Separations};
use crate::vectors::{Batch, Instructions, Passed, Row, points_of};

/// Points that move in straight lines, at constant speed, from t = 0 to t = 1: the vertices of a
/// mesh, laid out for many queries. The default has no points.
#[derive(Clone, Debug, Default)]
pub struct Trajectories {
    rows: Vec<Row>,
    instructions: Instructions,
}

/// Positions do not make trajectories.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TrajectoriesError {
    /// The numbers of positions at the start and at the end differ.
    #[error("{end} positions at t = 1, expected as many as at t = 0: {start}")]
    Count {
        /// The number of positions at t = 0.
        start: usize,
        /// The number of positions at t = 1.
        end: usize,
    },
    /// A coordinate is infinite or not a number.
    #[error("vertex {vertex} has {axis} = {value} at t = {time}, expected a finite number")]
    NonFinite {
        /// The end of the time step, 0 or 1.
        time: usize,
        /// The index of the vertex.
        vertex: usize,
        /// The axis of the coordinate.
        axis: Axis,
        /// The coordinate.
        value: f64,
    },
}

/// A query names a vertex that does not exist, or that has no thickness.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("query {query} names vertex {vertex}, expected one below {vertex_count}")]
pub struct VertexOutOfRange {
    /// The index of the query.
    pub query: usize,
    /// The index of the vertex.
    pub vertex: u32,
    /// The number of vertices, or of thicknesses if these are fewer.
    pub vertex_count: usize,
}

impl Trajectories {
    /// The trajectories from positions `x0` at t = 0 to positions `x1` at t = 1.
    ///
    /// # Errors
    /// [`TrajectoriesError`], if the counts differ or a coordinate is not finite.
    pub fn new(x0: &[Point], x1: &[Point]) -> Result<Self, TrajectoriesError> {
        let mut trajectories = Self::default();
        trajectories.set(x0, x1)?;
        Ok(trajectories)
    }

    /// Replaces the trajectories by others, of any number of points, and reuses their memory.
    ///
    /// # Errors
    /// [`TrajectoriesError`], if the counts differ or a coordinate is not finite; there are no
    /// points then.
    pub fn set(&mut self, x0: &[Point], x1: &[Point]) -> Result<(), TrajectoriesError> {
        self.rows.clear();
        if x0.len() != x1.len() {
            return Err(TrajectoriesError::Count {
                start: x0.len(),
                end: x1.len(),
            });
        }
        self.rows.extend(x0.iter().zip(x1).map(|(&a, &b)| Row::new(a, b)));
        for (vertex, row) in self.rows.iter().enumerate() {
            if !row.is_finite() {
                let error = first_error(vertex, &row.points());
                self.rows.clear();
                return error;
            }
        }
        Ok(())
    }

    /// The same trajectories, for other vector instructions than the widest.
    #[must_use]
    pub fn with_instructions(self, instructions: Instructions) -> Self {
        Self { instructions, ..self }
    }

    /// The number of vertices.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.rows.len()
    }

    /// The query of vertices, in the order of the kind; `None` if one of them does not exist.
    #[must_use]
    pub fn query<K: Kind>(&self, vertices: K::Vertices) -> Option<Query<K>> {
        let exist = vertices.as_ref().iter().all(|&v| (v as usize) < self.rows.len());
        exist.then(|| query_of(&self.rows, &vertices))
    }

    /// Calls `found` with the index and the collision of each query of vertices that
    /// [collides](Query::collides), in order.
    ///
    /// # Errors
    /// [`VertexOutOfRange`] names the first vertex that does not exist, or that has no thickness;
    /// nothing is found then.
    pub fn collisions<'d, K: Kind>(
        &self,
        queries: &[K::Vertices],
        options: impl Into<Options<Separations<'d>>>,
        found: impl FnMut(usize, Collision<'_, K>),
    ) -> Result<(), VertexOutOfRange> {
        let mut found = with_queries::<K>(found);
        self.run::<K>(queries, options.into(), Passed::Colliding(&mut found))
    }

    /// Calls `found` with the index of each query of vertices that may come within its separation, in order:
    /// all but some that the first filters prove to stay beyond it, from t = 0 to t = 1.
    ///
    /// Use it for many queries if most of them stay apart. It finds each query that comes within its
    /// separation; which others it finds depends on the processor.
    ///
    /// ```
    /// use exact_ccd::batch::Trajectories;
    /// use exact_ccd::{Separation, Separations, VertexVertex};
    ///
    /// // The second point comes near the first one, the third does not.
    /// let x0 = [[0.0; 3], [4.0, 0.0, 0.0], [9.0, 0.0, 0.0]];
    /// let x1 = [[0.0; 3], [1.0, 0.0, 0.0], [8.0, 0.0, 0.0]];
    /// let mut near = Vec::new();
    /// let within = Separations::Uniform(Separation::new(1.0)?);
    /// let trajectories = Trajectories::new(&x0, &x1)?;
    /// trajectories.may_collide::<VertexVertex>(&[[0, 1], [0, 2]], within, |index| near.push(index))?;
    /// assert!(near.contains(&0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`collisions`](Self::collisions).
    pub fn may_collide<'d, K: Kind>(
        &self,
        queries: &[K::Vertices],
        separations: impl Into<Separations<'d>>,
        mut found: impl FnMut(usize),
    ) -> Result<(), VertexOutOfRange> {
        let options = Options::within(separations.into());
        self.run::<K>(queries, options, Passed::Unsettled(&mut found))
    }

    fn run<'a, K: Kind>(
        &'a self,
        queries: &'a [K::Vertices],
        Options { separation, until }: Options<Separations<'a>>,
        passed: Passed<'a, K>,
    ) -> Result<(), VertexOutOfRange> {
        check::<K>(queries, self.vertex_count())?;
        if let Separations::Thickness(thickness) = separation {
            check::<K>(queries, thickness.vertex_count())?;
        }
        let batch = Batch {
            rows: &self.rows,
            queries,
            separations: separation,
            until,
            passed,
        };
        K::run(batch, self.instructions);
        Ok(())
    }

    /// The queries of vertices, if all of these exist.
    pub(crate) fn queries<K: Kind>(
        &self,
        queries: &[K::Vertices],
    ) -> Result<impl Iterator<Item = Query<K>>, VertexOutOfRange> {
        check::<K>(queries, self.vertex_count())?;
        Ok(queries.iter().map(|vertices| query_of(&self.rows, vertices)))
    }
}

/// Checks that all vertices of queries are below a number.
fn check<K: Kind>(queries: &[K::Vertices], vertex_count: usize) -> Result<(), VertexOutOfRange> {
    let largest = |vertices: &K::Vertices| vertices.as_ref().iter().fold(0, |most, &v| v.max(most));
    let largest = queries
        .iter()
        .fold(0, |most, vertices| largest(vertices).max(most));
    if queries.is_empty() || (largest as usize) < vertex_count {
        return Ok(());
    }
    let missing = |vertices: &K::Vertices| {
        let mut vertices = vertices.as_ref().iter().copied();
        vertices.find(|&vertex| vertex as usize >= vertex_count)
    };
    let mut queries = queries.iter().enumerate();
    let missing = queries.find_map(|(query, vertices)| Some((query, missing(vertices)?)));
    missing.map_or(Ok(()), |(query, vertex)| {
        Err(VertexOutOfRange {
            query,
            vertex,
            vertex_count,
        })
    })
}

/// The error that names the first coordinate of a vertex that is not finite.
#[cold]
fn first_error(vertex: usize, ends: &[Point; 2]) -> Result<(), TrajectoriesError> {
    NonFinite::check(&[ends]).map_err(
        |NonFinite {
             point, axis, value, ..
         }| TrajectoriesError::NonFinite {
            time: point,
            vertex,
            axis,
            value,
        },
    )
}

/// The query of vertices whose rows exist.
fn query_of<K: Kind>(rows: &[Row], vertices: &K::Vertices) -> Query<K> {
    Query::from_finite(K::of_four(&points_of::<K>(rows, vertices.as_ref())))
}
