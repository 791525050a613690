//! Triangle meshes in motion: mesh files, the broad phase, and the collision-free step of a whole mesh.
//!
//! ```no_run
//! use exact_ccd_mesh::{Motion, step};
//!
//! let motion = Motion::read("start.ply", "end.ply")?;
//! let report = step(&motion.mesh, &motion.x0, &motion.x1)?;
//! match report.time_of_impact() {
//!     None => println!("free of contact"),
//!     Some(toi) => println!("free of contact on [0, {toi})"),
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The way from files to the answer:
//!
//! - [`Frame`] is a mesh at one time, and reads and writes mesh files; two frames of the same mesh are a [`Motion`].
//! - [`TetMesh`] is a body of tetrahedra at one time, whose surface is a frame.
//! - [`Step`] is a motion whose positions are known to be sound. It is borrowed, so that a simulator keeps its own.
//! - [`Candidates`] are the pairs of primitives of a step that a [`BroadPhase`] has found near each other.
//! - [`StepReport`] says which of them are in contact, and which first: exactly, for each pair is a query of
//!   [`exact_ccd`].
//! - [`Detector`] finds the first contact in step after step, or tells only whether there is one, without a look at all.
//! - [`intersections`] are where a mesh at rest passes through itself, and an [`Audit`] certifies a sequence of frames.
//! - [`Motion::shifted`] rounds a motion so that [`exact_ccd::parity`] can be asked about it.
//! - [`step_size`] is the line search of an optimiser: how far along a direction is free of contact.
//!
//! No result depends on the number of threads, and no input makes anything here panic.

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
mod pvd;
mod read;
mod shift;
mod step;
mod step_boxes;
mod tet_mesh;
mod weld;
mod write;

pub use audit::{Audit, Violation};
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
pub use motion::{Motion, MotionError, ReadMotionError};
pub use pair::{Pair, PairCounts};
pub use positions::PositionsError;
pub use pvd::read_pvd;
pub use read::{Fault, Format, ParseError, Place, ReadError};
pub use step::{Step, StepError, step};
pub use tet_mesh::{TetMesh, TetMeshError};
pub use weld::Welding;
pub use write::{UnstructuredGrid, write_pvd};

/// The examples in the README of the repository, as tests.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
