//! Triangle meshes in motion, with rods and points: the broad phase and the collision-free step of
//! a whole mesh.
//!
//! ```
//! use exact_ccd_mesh::{TriangleMesh, step};
//!
//! let mesh = TriangleMesh::new(4, vec![[0, 1, 2]])?; // vertex 3 is a point
//! let x0 = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.25, 0.25, 1.0]];
//! let x1 = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.25, 0.25, -1.0]];
//! let report = step(&mesh, &x0, &x1)?;
//! // Free of contact on [0, 0.5).
//! assert_eq!(report.time_of_impact(), Some(0.5));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! From a mesh to the answer:
//!
//! - [`TriangleMesh`] is the connectivity: faces, loose edges (rods) and loose vertices (points).
//! - [`Frame`] is a mesh at one time; two frames of the same mesh are a [`Motion`]. The crate
//!   `exact-ccd-files` reads and writes mesh files.
//! - [`TetMesh`] is a body of tetrahedra at one time, whose surface is a frame.
//! - [`Step`] is a motion whose positions have been checked. It borrows them.
//! - [`Candidates`] are the pairs of primitives of a step that a [`BroadPhase`] has found near each
//!   other.
//! - [`StepReport`] has the pairs in contact and the earliest contact. Each pair is an exact query of
//!   [`exact_ccd`].
//! - [`Detector`] finds the first contact of step after step, or only whether there is one, and
//!   skips most pairs.
//! - [`intersections`] finds the places where a mesh at rest passes through itself, and an [`Audit`]
//!   certifies a sequence of frames.
//! - [`Motion::shifted`] rounds a motion as [`exact_ccd::parity`] requires.
//! - [`step_size`] is the line search of an optimiser: the largest step along a direction without contact.
//!
//! No result depends on the number of threads, and no input causes a panic.

mod audit;
mod boundary;
mod bounds;
mod broad_phase;
mod candidates;
mod contacts;
mod detector;
mod earliest;
mod frame;
mod intersections;
mod kind;
mod line_search;
mod mesh;
mod motion;
mod narrow_phase;
mod pair;
mod positions;
mod shift;
mod step;
mod step_boxes;
mod tet_error;
mod tet_mesh;
mod weld;

pub use audit::{Audit, Violation};
pub use boundary::TetFaces;
pub use bounds::Bounds;
pub use broad_phase::{AllPairs, Boxes, BroadPhase, Bvh, Found, Sweep, Visit};
pub use candidates::Candidates;
pub use contacts::StepReport;
pub use detector::Detector;
pub use earliest::EarliestContact;
pub use exact_ccd::Point;
pub use frame::{Frame, FrameError};
pub use intersections::{Intersection, intersections};
pub use line_search::{
    Decision, ExactDecision, LineSearch, LineSearchError, ParityDecision, advance, step_size,
};
pub use mesh::{MeshError, TriangleMesh};
pub use motion::{Motion, MotionError};
pub use pair::{Pair, PairCounts};
pub use positions::{PositionsError, check_positions};
pub use step::{Step, StepError, step};
pub use tet_error::TetMeshError;
pub use tet_mesh::TetMesh;
pub use weld::Welding;

/// The examples in the README of this crate, as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
