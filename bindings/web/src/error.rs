//! Errors of the page.

use exact_ccd::{AnyKind, InvalidSeparation, NonFinite};
use exact_ccd_files::{Format, ParseError};
use exact_ccd_mesh::{CandidateError, MotionError, StepError};
use exact_ccd_view::PageError;

/// The reason why there is no answer.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Error {
    #[error("{0:?} is not a kind of query, expected one of {kinds}", kinds = kinds())]
    Kind(String),
    #[error("{found} coordinates, expected {expected}: three for each point at t = 0, then at t = 1")]
    Coordinates { found: usize, expected: usize },
    #[error(transparent)]
    NonFinite(#[from] NonFinite),
    #[error(transparent)]
    Distance(#[from] InvalidSeparation),
    #[error("{0}: not the name of a mesh file, expected {formats}", formats = Format::extensions())]
    Extension(String),
    #[error("{name}: {source}")]
    Parse { name: String, source: ParseError },
    #[error("{start} and {end}: {source}")]
    Motion {
        start: String,
        end: String,
        source: MotionError,
    },
    #[error(transparent)]
    Step(#[from] StepError),
    #[error(transparent)]
    Candidates(#[from] CandidateError),
    #[error(transparent)]
    Page(#[from] PageError),
    #[error("the mesh has no vertex {0}")]
    Vertex(u32),
}

/// The names of the kinds.
fn kinds() -> String {
    let names: Vec<&str> = AnyKind::ALL.iter().map(|kind| kind.name()).collect();
    names.join(", ")
}
