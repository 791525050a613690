//! Errors of data that a format cannot hold.

use std::io;

use exact_ccd_mesh::Frame;

/// Checks that a frame has vertices, and that its positions fit its mesh, so that the written file
/// reads back as the same frame.
pub(super) fn check_frame(frame: &Frame) -> io::Result<()> {
    frame.check().map_err(invalid)?;
    match frame.positions.is_empty() {
        true => Err(invalid("no vertices, expected at least one")),
        false => Ok(()),
    }
}

/// The error [`InvalidInput`](io::ErrorKind::InvalidInput).
pub(super) fn invalid(error: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, error)
}
