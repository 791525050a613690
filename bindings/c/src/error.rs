//! The outcome of a call: a status, and a message for each thread.

use core::cell::RefCell;
use core::ffi::c_char;
use std::ffi::CString;

use exact_ccd::batch::{TrajectoriesError, VertexOutOfRange};
use exact_ccd::{InvalidSeparation, InvalidThickness, TimeOutOfStep};
use exact_ccd_mesh::{
    IntersectionsError, LineSearchError, MeshError, MotionError, StepError, ThicknessCount, TooManyPrimitives,
};

use crate::pair::EXACT_CCD_NONE;

/// The outcome of a call.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// The results have been written.
    Ok = 0,
    /// An argument is wrong: a null pointer, an unknown kind, a distance or a time out of range.
    InvalidArgument = 1,
    /// Positions are wrong: their number, or a coordinate that is infinite or not a number.
    InvalidPositions = 2,
    /// A mesh or a query names a vertex that does not exist, or a mesh is too large.
    InvalidMesh = 3,
    /// A defect of the library. The handle of the call may only be freed.
    Internal = 4,
    /// An edge passes through a face at the start of the step, and the detector has the check of the
    /// start: see `exact_ccd_detector_set_start_check`.
    Crossing = 5,
    /// Some pairs have no proof, or there is nothing to prove: there is no certificate.
    Uncertified = 6,
}

/// The reason why a call has no result.
#[derive(Debug, thiserror::Error)]
#[error("{message}")]
pub(crate) struct Error {
    pub(crate) status: Status,
    message: String,
    /// The query of a batch that is wrong.
    query: Option<usize>,
    /// The edge and the face that cross at the start.
    crossing: Option<[u32; 2]>,
}

/// A call that failed.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct LastError {
    /// The status that the call returned; `EXACT_CCD_STATUS_OK` if no call on this thread has failed.
    pub status: Status,
    /// The message, as from `exact_ccd_last_error`.
    pub message: *const c_char,
    /// True if `query` has a meaning.
    pub has_query: bool,
    /// The index, from 0, of the first query of a batch that is wrong; 0 if there is none.
    pub query: usize,
    /// The edge that passes through a face, for `EXACT_CCD_STATUS_CROSSING`; else `EXACT_CCD_NONE`.
    pub edge: u32,
    /// That face; else `EXACT_CCD_NONE`.
    pub face: u32,
}

impl Error {
    pub(crate) fn new(status: Status, message: impl ToString) -> Self {
        let message = message.to_string();
        Self {
            status,
            message,
            query: None,
            crossing: None,
        }
    }

    pub(crate) fn argument(message: impl ToString) -> Self {
        Self::new(Status::InvalidArgument, message)
    }

    /// The error of a part of a batch that begins with query `first`.
    pub(crate) fn of_batch(error: VertexOutOfRange, first: usize) -> Self {
        let query = first + error.query;
        let error = VertexOutOfRange { query, ..error };
        Self {
            query: Some(query),
            ..Self::new(Status::InvalidMesh, error)
        }
    }

    /// The error of one of many worlds.
    pub(crate) fn of_world(self, world: usize) -> Self {
        let message = format!("world {world}: {}", self.message);
        Self { message, ..self }
    }

    /// Keeps the message for `exact_ccd_last_error`, and returns the status.
    #[cold]
    pub(crate) fn record(self) -> Status {
        // A message has no zero bytes: numbers and names of this library.
        let message = CString::new(self.message).unwrap_or_default();
        let fields = LastError {
            status: self.status,
            message: message.as_ptr(),
            has_query: self.query.is_some(),
            query: self.query.unwrap_or(0),
            edge: self.crossing.map_or(EXACT_CCD_NONE, |[edge, _]| edge),
            face: self.crossing.map_or(EXACT_CCD_NONE, |[_, face]| face),
        };
        LAST.set(Some((message, fields)));
        self.status
    }
}

macro_rules! status_of {
    ($($error:ty => $status:ident),* $(,)?) => {$(
        impl From<$error> for Error {
            fn from(error: $error) -> Self {
                Self::new(Status::$status, error)
            }
        }
    )*};
}

status_of! {
    InvalidSeparation => InvalidArgument,
    InvalidThickness => InvalidArgument,
    ThicknessCount => InvalidArgument,
    TimeOutOfStep => InvalidArgument,
    exact_ccd::NonFinite => InvalidPositions,
    TrajectoriesError => InvalidPositions,
    MeshError => InvalidMesh,
    TooManyPrimitives => InvalidMesh,
}

impl From<StepError> for Error {
    fn from(error: StepError) -> Self {
        match error {
            StepError::TooManyPrimitives(error) => error.into(),
            StepError::Time(error) => error.into(),
            StepError::ThicknessCount(error) => error.into(),
            StepError::Crossing { edge, face, .. } => Self {
                crossing: Some([edge, face]),
                ..Self::new(Status::Crossing, error)
            },
            _ => Self::new(Status::InvalidPositions, error),
        }
    }
}

impl From<MotionError> for Error {
    fn from(error: MotionError) -> Self {
        match error {
            MotionError::Positions(error) => error.into(),
            MotionError::ThicknessCount(error) => error.into(),
            _ => Self::new(Status::InvalidMesh, error),
        }
    }
}

impl From<IntersectionsError> for Error {
    fn from(error: IntersectionsError) -> Self {
        match error {
            IntersectionsError::TooManyPrimitives(error) => error.into(),
            _ => Self::new(Status::InvalidPositions, error),
        }
    }
}

impl From<LineSearchError> for Error {
    fn from(error: LineSearchError) -> Self {
        match error {
            LineSearchError::Step(error) => error.into(),
            LineSearchError::Direction(_) => Self::new(Status::InvalidPositions, error),
            _ => Self::new(Status::InvalidArgument, error),
        }
    }
}

thread_local! {
    /// The last call that failed, and the message that its fields point to.
    static LAST: RefCell<Option<(CString, LastError)>> = const { RefCell::new(None) };
}

/// The message of the last call on this thread that failed; empty if none has. It names the argument,
/// the vertex or the query that is wrong. The string is valid until the next call that fails on this
/// thread.
#[unsafe(no_mangle)]
pub extern "C" fn exact_ccd_last_error() -> *const c_char {
    exact_ccd_last_error_fields().message
}

/// The last call on this thread that failed, with the query, the edge and the face that are wrong as
/// numbers. The message is valid as long as the one that `exact_ccd_last_error` returns.
#[unsafe(no_mangle)]
pub extern "C" fn exact_ccd_last_error_fields() -> LastError {
    LAST.with_borrow(|last| match last {
        Some((_, fields)) => *fields,
        None => LastError {
            status: Status::Ok,
            message: c"".as_ptr(),
            has_query: false,
            query: 0,
            edge: EXACT_CCD_NONE,
            face: EXACT_CCD_NONE,
        },
    })
}
