//! Decompression within a limit that follows from the size of the file.

use std::io::Read;

use flate2::read::MultiGzDecoder;

use crate::error::{Fault, ParseError, Place, quoted};

/// The largest allowed ratio of decompressed to compressed data. Meshes compress by 2 to 20, and
/// regular grids by up to 100; deflate reaches 1,032.
const RATIO: u64 = 200;
/// Short files may expand to this number of bytes in any case.
const ALLOWANCE: u64 = 1 << 20;

/// The number of bytes that data from a file may still expand to.
#[derive(Clone, Copy)]
pub(super) struct Budget {
    limit: u64,
    left: u64,
}

impl Budget {
    /// The budget of a file of this size in bytes.
    pub(super) fn of(file_size: usize) -> Self {
        let limit = (file_size as u64).saturating_mul(RATIO).saturating_add(ALLOWANCE);
        Self { limit, left: limit }
    }

    /// Takes a number of bytes from the budget.
    pub(super) fn take(&mut self, bytes: u64) -> Result<(), Fault> {
        let limit = self.limit;
        self.left = self.left.checked_sub(bytes).ok_or(Fault::Expansion { limit })?;
        Ok(())
    }

    /// Reads all data of a decompressor.
    ///
    /// # Errors
    /// If the data are not valid, with `name` as the compression, or exceed the budget.
    pub(super) fn read_all(&mut self, reader: impl Read, name: &str) -> Result<Vec<u8>, Fault> {
        let mut data = Vec::new();
        let most = self.left.saturating_add(1);
        let read = reader.take(most).read_to_end(&mut data);
        read.map_err(|error| {
            Fault::expected(
                format!("data compressed by {name}"),
                quoted(error.to_string().as_bytes()),
            )
        })?;
        self.take(data.len() as u64)?;
        Ok(data)
    }
}

/// The contents of a gzip file, which may have several members.
pub(super) fn gunzip(bytes: &[u8]) -> Result<Vec<u8>, ParseError> {
    if !bytes.starts_with(b"\x1f\x8b") {
        let fault = Fault::Contents {
            found: if bytes.is_empty() {
                "empty"
            } else {
                "not compressed"
            },
            expected: "data compressed by gzip",
            advice: "remove .gz from the name of the file, or compress it".to_owned(),
        };
        return Err(fault.at(Place::File));
    }
    let mut budget = Budget::of(bytes.len());
    let data = budget.read_all(MultiGzDecoder::new(bytes), "gzip");
    data.map_err(|fault| fault.at(Place::File))
}
