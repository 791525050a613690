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
//! - [`Options`] have the distance at which primitives touch, and the last time that counts. [`CONTACT`] is
//!   the distance 0 and the whole step, and a [`MinDistance`] is one for all or a thickness of each vertex.
//!   [`Pair`] has the kinds of pairs, and which distances they cover.
//! - [`CanCollide`] restricts all of this to the pairs that can collide.
//! - A [`HalfSpace`] is a ground or a wall: the first time at which a vertex reaches it is exact, too.
//! - [`intersections`] finds the places where a mesh at rest meets itself, [`enclosed`] the components inside
//!   of closed ones, and an [`Audit`] certifies a sequence of frames.
//! - [`Bodies`] are rigid bodies that turn and translate, on curves that are decided exactly.
//! - A [`CurveDetector`] finds contact of meshes whose vertices move on Bézier curves.
//! - A [`RigidFit`] is the rotation of a body from one frame to another.
//!
//! # Which one finds contacts
//!
//! Three find the contacts of a step, and their answers are the same:
//!
//! | | for | cost |
//! |---|---|---|
//! | [`step`], [`StepReport`] | a report on one step: the numbers of candidates, of pairs in contact and of pairs that touch at the start | every candidate is tested |
//! | [`Detector`] | a solver: step after step of one mesh, one answer of each | its memory stays from step to step; the earliest contact found so far bounds what is tested |
//! | [`Candidates`] | several questions about the same pairs: shorter steps of a line search, another method, a barrier | one broad phase for all of them; every pair is tested for each |
//!
//! No result depends on the number of threads, and no input causes a panic.

mod at_rest;
mod audit;
mod bodies;
mod broad_phase;
mod curves;
mod gathered;
mod half_space;
mod line_search;
mod mesh;
mod overlaps;
mod pairs;
mod search;
mod steps;
pub mod vector;

pub use at_rest::{
    Enclosed, Intersection, IntersectionOptions, IntersectionsError, Meeting, enclosed, has_intersections,
    intersections,
};
pub use audit::{Audit, Violation};
pub use bodies::{
    Bodies, BodiesAudit, BodiesError, BodiesReport, BodiesViolation, BodyContact, BodyDistance, FreePoses,
};
pub use broad_phase::{
    Aabb, AllPairs, BoxPairs, Boxes, BroadPhase, Bvh, PairCollector, PairSink, Sweep, TooManyPrimitives,
};
pub use curves::{CurveDetector, CurvesError};
pub use exact_ccd::{CONTACT, InvalidSeparation, Options, Point, Separation};
pub use half_space::{HalfSpace, HalfSpaceError};
pub use line_search::{
    FreeStep, FreeStepOptions, FreeSteps, LineSearchError, Precision, Tolerance, advance, bisect,
};
pub use mesh::{
    Frame, FrameError, MeshError, PositionsError, TetFaces, TetMesh, TetMeshError, TriangleMesh,
    check_positions,
};
pub use overlaps::{BoxKind, CandidateError, CandidateOptions};
pub use pairs::{
    CanCollide, GroupError, GroupMatrix, MinDistance, Pair, PairCounts, PairKind, ThicknessCount,
};
pub use search::{Candidates, Contact, Detector, FirstContacts, StepReport, Worlds, contact_points, step};
pub use steps::{Motion, MotionError, RigidFit, Step, StepError, Welding};

/// The examples in the README of this crate, as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
