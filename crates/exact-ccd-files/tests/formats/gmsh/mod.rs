//! Gmsh files: both versions, text and binary of both byte orders.

mod errors;
mod groups;
mod hostile;
mod same_mesh;

mod writer;
