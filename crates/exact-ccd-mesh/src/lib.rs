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
//!   other. They decide contact in the step, or in shorter ones, exactly or by any
//!   [`Ccd`](exact_ccd::Ccd).
//! - [`StepReport`] counts the contacts of a step and has the earliest one.
//! - [`Detector`] finds contact in step after step, without a test of every candidate, and
//!   [certifies the step](Detector::free_step) that a solver can take.
//! - [`MinDistance`] makes all of this about a distance that primitives keep: one for all, or a
//!   thickness of each vertex. [`Pair`] has the kinds of pairs, and which distances they cover.
//! - [`CanCollide`] restricts all of this to the pairs that can collide.
//! - A [`HalfSpace`] is a ground or a wall: the first time at which a vertex reaches it is exact, too.
//! - [`intersections`] finds the places where a mesh at rest passes through itself, and an [`Audit`]
//!   certifies a sequence of frames.
//! - [`step_size`] is the line search of an optimiser: the largest step along a direction without
//!   contact.
//!
//! No result depends on the number of threads, and no input causes a panic.

mod aabb;
mod approach;
mod audit;
mod boundary;
mod broad_phase;
mod by_kind;
mod can_collide;
mod candidate_options;
mod candidates;
mod collect;
mod contact;
mod contact_points;
mod culled_search;
mod detector;
mod disjoint_sets;
mod frame;
mod half_space;
mod intersections;
mod line_search;
mod margin;
mod mesh;
mod method;
mod min_distance;
mod motion;
mod narrow_phase;
mod other_ends;
mod overlaps;
mod pair;
mod pair_kind;
mod pair_vertices;
mod positions;
mod primitive_count;
mod report;
mod start_check;
mod step;
mod step_boxes;
mod tet_error;
mod tet_mesh;
pub mod vector;
mod weld;

pub use aabb::Aabb;
pub use audit::{Audit, Violation};
pub use boundary::TetFaces;
pub use broad_phase::{AllPairs, Boxes, BroadPhase, Bvh, PairCollector, PairSink, Sweep};
pub use by_kind::{ByKind, PairCounts};
pub use can_collide::CanCollide;
pub use candidate_options::{BoxKind, CandidateError, CandidateOptions};
pub use candidates::Candidates;
pub use contact::Contact;
pub use contact_points::contact_points;
pub use detector::Detector;
pub use exact_ccd::Point;
pub use frame::{Frame, FrameError};
pub use half_space::{HalfSpace, HalfSpaceError};
pub use intersections::{
    Intersection, IntersectionsError, crossings, crossings_by, intersections, intersections_among,
    intersections_by,
};
pub use line_search::{
    FreeStep, FreeStepOptions, LineSearch, LineSearchError, Tolerance, advance, bisect, step_size,
};
pub use mesh::{MeshError, TriangleMesh};
pub use min_distance::{MinDistance, ThicknessCount};
pub use motion::{Motion, MotionError};
pub use pair::Pair;
pub use pair_kind::PairKind;
pub use positions::{PositionsError, check_positions};
pub use primitive_count::TooManyPrimitives;
pub use report::{StepReport, step};
pub use step::{Step, StepError};
pub use tet_error::TetMeshError;
pub use tet_mesh::TetMesh;
pub use weld::Welding;

/// The examples in the README of this crate, as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
