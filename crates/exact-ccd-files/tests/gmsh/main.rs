//! Gmsh files: both versions, text and binary of both byte orders.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod errors;
mod groups;
mod hostile;
mod same_mesh;

mod writer;
