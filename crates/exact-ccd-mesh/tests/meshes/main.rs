//! Broad phases, candidates, steps, line searches and intersections of meshes, against loops over all pairs.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod bodies;
mod broad_phase;
mod contacts;
mod coverage;
mod curves;
mod enclosed;
mod intersections;
mod line_search;
mod loose;
mod motion;
mod odd;
mod rods;
mod step;
mod tet_surface;
mod weld_edges;
