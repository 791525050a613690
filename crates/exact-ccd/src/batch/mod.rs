//! Many queries over the vertices of one mesh: the filters on several at a time.
//!
//! [`collides`] for a million candidates, at a fraction of its price: the positions are read once
//! ([`Trajectories`]), the first filters work on vectors, whichever the processor has ([`Instructions`]), each passes on
//! only those that it does not settle, and the rare rest goes the way of a single query. The answers are those of
//! [`collides`], on any processor: the same operations in the same order, each rounded as IEEE 754 says.
//!
//! [`collides`]: crate::Query::collides
//!
//! ```
//! use exact_ccd::VertexFace;
//! use exact_ccd::batch::Trajectories;
//!
//! // Two vertices fall, one of them through a resting triangle.
//! let x0 = [[0.25, 0.25, 1.0], [3.0, 3.0, 1.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
//! let mut x1 = x0;
//! (x1[0][2], x1[1][2]) = (-1.0, -1.0);
//!
//! let trajectories = Trajectories::new(&x0, &x1)?;
//! let mut colliding = Vec::new();
//! trajectories.collisions::<VertexFace>(&[[0, 2, 3, 4], [1, 2, 3, 4]], |index, query| {
//!     colliding.push((index, query.time_of_impact()));
//! })?;
//! assert_eq!(colliding, [(0, Some(0.5))]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod eight;
mod instructions;
mod planes;
mod row;
mod rows;
mod trajectories;

pub use instructions::Instructions;
pub use trajectories::{Trajectories, TrajectoriesError, VertexOutOfRange};
