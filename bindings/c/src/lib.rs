//! The C interface of `exact-ccd`: the functions of `exact_ccd.h`.
//!
//! A function that can fail returns a [`Status`], and writes its results through pointers. The functions are
//! documented here as C programmers read them; the header is made from the sources by cbindgen.
//!
//! Rules for all functions:
//!
//! - Coordinates are `double`, three for each point, one point after the other. They need the
//!   alignment of `double` only.
//! - A null pointer where a value is expected, an index out of range, a coordinate that is not
//!   finite: all are errors with a message, [`exact_ccd_last_error`]. Nothing is written then, unless
//!   the function says so.
//! - No panic and no exception leaves the library.
//! - Functions without a handle, and functions with different handles, can be called from several
//!   threads at the same time. Calls with the same handle must not overlap, unless all of them take
//!   it as `const`.
//! - The floating-point environment of the caller (flushed subnormal numbers, rounding) does not
//!   change any answer, and is the same after the call.

mod audit;
mod batch;
mod border;
mod callbacks;
mod certificates;
mod contact;
mod detector;
mod detector_answers;
mod detector_settings;
mod detector_steps;
mod detector_vertices;
mod environment;
mod error;
mod intersections;
mod kind;
mod lists;
mod mesh;
mod pair;
mod pointers;
mod query;
mod threads;
mod version;
mod worlds;

pub use audit::*;
pub use batch::*;
pub use callbacks::*;
pub use certificates::*;
pub use contact::*;
pub use detector::*;
pub use detector_answers::*;
pub use detector_settings::*;
pub use detector_steps::*;
pub use detector_vertices::*;
pub use error::*;
pub use intersections::*;
pub use kind::*;
pub use lists::*;
pub use mesh::*;
pub use pair::*;
pub use query::*;
pub use threads::*;
pub use version::*;
pub use worlds::*;
