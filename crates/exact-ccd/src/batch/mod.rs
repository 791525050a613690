//! Batches of queries: the filters on several at a time.
//!
//! Most queries of a batch cost a fraction of [`collides`]. The first filters work on vectors, with the
//! widest [`Instructions`] of the processor, and each passes on only those queries that it does not settle.
//! The rest is decided like single queries. The answers equal the answers of [`collides`], on any processor,
//! because each filter proves its answers. With any [`Instructions`], the operations are the same in the
//! same order, each rounded as IEEE 754 defines. On a processor without vectors, all queries are decided
//! like single ones.
//!
//! Queries of a mesh are given by vertices ([`Trajectories`]), others by their points
//! ([`Queries`]). Each collision is handed on as a [`Collision`](crate::Collision), whose times and
//! impact continue from the decision. With options, a batch is also about a separation of each pair.
//!
//! [`collides`]: crate::Query::collides
//!
//! ```
//! use exact_ccd::{CONTACT, VertexFace};
//! use exact_ccd::batch::Trajectories;
//!
//! // Two vertices fall, one of them through a resting triangle.
//! let x0 = [[0.25, 0.25, 1.0], [3.0, 3.0, 1.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
//! let mut x1 = x0;
//! (x1[0][2], x1[1][2]) = (-1.0, -1.0);
//!
//! let trajectories = Trajectories::new(&x0, &x1)?;
//! let mut colliding = Vec::new();
//! let queries = [[0, 2, 3, 4], [1, 2, 3, 4]];
//! trajectories.collisions::<VertexFace>(&queries, CONTACT, |index, collision| {
//!     colliding.push((index, collision.time_of_impact()));
//! })?;
//! assert_eq!(colliding, [(0, 0.5)]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod array;
mod collisions;
mod trajectories;

pub use array::{NonFiniteQuery, Queries};
pub use trajectories::{Trajectories, TrajectoriesError, VertexOutOfRange};

pub use crate::vectors::Instructions;
