//! Errors of data that a format cannot hold.

use std::io;

use exact_ccd_mesh::Frame;

/// Checks that the positions of a frame fit its mesh, so that the written file reads back as the
/// same frame.
pub(super) fn check_frame(frame: &Frame) -> io::Result<()> {
    frame.check().map_err(invalid)
}

/// The error [`InvalidInput`](io::ErrorKind::InvalidInput).
pub(super) fn invalid(error: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, error)
}
