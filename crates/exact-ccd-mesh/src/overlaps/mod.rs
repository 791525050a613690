//! The boxes of a mesh's primitives during a step, with their margins, and the stream of pairs whose boxes
//! overlap.

mod margin;
mod options;
mod path;
mod primitives;
mod step_boxes;
mod stream;

pub use options::{BoxKind, CandidateError, CandidateOptions};

pub(crate) use margin::Margin;
pub(crate) use primitives::Primitives;
pub(crate) use step_boxes::StepBoxes;
pub(crate) use stream::stream;
