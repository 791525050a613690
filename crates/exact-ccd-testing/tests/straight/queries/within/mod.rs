//! Answers within a distance, beyond the laws that contact has too.

mod distance;
mod impact;
mod monotone;
mod named_cases;
mod shorter_edges;
mod thickness;
