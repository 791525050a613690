//! The kinds of query, as index tables over four moving points.
//!
//! A query has four moving points x₀ … x₃. A vertex and a face, or two edges, meet only when the four
//! points are coplanar, and the sides of lines on which vertices lie decide contact then. Hence all
//! algorithms in this crate are written once, over these tables. A vertex against an edge or a vertex
//! is a query of two edges, of which one or both have length zero: a point is repeated.

mod features;
mod kinds;
mod points;

pub(crate) use features::{Difference, Side, Tables};
pub use kinds::*;
pub use points::Point;
pub(crate) use points::Points;
