//! Triangle meshes in motion: mesh files, the broad phase, and the collision-free step of a whole
//! mesh.
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
//! From files to the answer:
//!
//! - [`Frame`] is a mesh at one time, and reads and writes mesh files; two frames of the same mesh
//!   are a [`Motion`].
//! - [`TetMesh`] is a body of tetrahedra at one time, whose surface is a frame.
//! - [`Step`] is a motion whose positions are known to be sound. It is borrowed, so that a
//!   simulator keeps its own.
//! - [`Candidates`] are the pairs of primitives of a step that a [`BroadPhase`] has found near each
//!   other. They decide contact in the step, or in shorter ones, exactly or by any
//!   [`Ccd`](exact_ccd::Ccd).
//! - [`StepReport`] counts the contacts of a step and has the earliest one.
//! - [`Detector`] finds contact in step after step, without a test of every candidate, and
//!   [certifies the step](Detector::free_step) that a solver can take.
//! - [`CanCollide`] restricts all of this to the pairs that can collide.
//! - [`intersections`] are where a mesh at rest passes through itself, and an [`Audit`] certifies a
//!   sequence of frames.
//! - [`Motion::shifted`] rounds a motion so that [`exact_ccd::parity`] can decide it.
//! - [`step_size`] is the line search of an optimiser: the part of a direction that is free of
//!   contact.
//!
//! No result depends on the number of threads, and no input makes anything here panic.

mod aabb;
mod audit;
mod boundary;
mod broad_phase;
mod can_collide;
mod candidate_options;
mod candidates;
mod collect;
mod contact;
mod culled_search;
mod detector;
mod frame;
mod intersections;
mod line_search;
mod mesh;
mod motion;
mod narrow_phase;
mod overlaps;
mod pair;
mod positions;
mod primitive_count;
mod pvd;
mod read;
mod report;
mod shift;
mod step;
mod step_boxes;
mod tet_mesh;
mod weld;
mod write;

pub use aabb::Aabb;
pub use audit::{Audit, Violation};
pub use broad_phase::{AllPairs, Boxes, BroadPhase, Bvh, PairCollector, PairSink, Sweep};
pub use can_collide::CanCollide;
pub use candidate_options::{BoxKind, CandidateOptions, DistanceError};
pub use candidates::Candidates;
pub use contact::Contact;
pub use detector::Detector;
pub use exact_ccd::Point;
pub use frame::{Frame, FrameError};
pub use intersections::{Intersection, IntersectionsError, intersections};
pub use line_search::{
    FreeStep, FreeStepOptions, LineSearch, LineSearchError, Tolerance, advance, bisect, step_size,
};
pub use mesh::{IndexOutOfRange, TriangleMesh};
pub use motion::{Motion, MotionError, ReadMotionError};
pub use pair::{Pair, PairCounts, PairKind};
pub use positions::PositionsError;
pub use primitive_count::TooManyPrimitives;
pub use pvd::read_pvd;
pub use read::{Fault, Format, ParseError, Place, ReadError};
pub use report::{StepReport, step};
pub use step::{Step, StepError};
pub use tet_mesh::{TetMesh, TetMeshError};
pub use weld::Welding;
pub use write::{UnstructuredGrid, write_pvd};

/// The examples in the README of the repository, as tests.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
