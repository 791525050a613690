//! Triangle meshes in motion: mesh files, the broad phase, and the collision-free step of a whole mesh.

mod bounds;
mod broad_phase;
mod bvh;
mod candidates;
mod contacts;
mod frame;
mod mesh;
mod motion;
mod pair;
mod read;
mod step;
mod weld;
mod write;

pub use bounds::Bounds;
pub use broad_phase::{AllPairs, BroadPhase};
pub use bvh::Bvh;
pub use candidates::Candidates;
pub use contacts::{EarliestContact, StepReport};
pub use exact_ccd::Point;
pub use frame::{Frame, FrameError};
pub use mesh::{IndexOutOfRange, TriangleMesh};
pub use motion::{Motion, MotionError, ReadMotionError};
pub use pair::{Pair, PairCounts};
pub use read::{Fault, Format, ParseError, Place, ReadError};
pub use step::{Step, StepError, step};
