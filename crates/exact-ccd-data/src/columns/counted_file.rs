//! The account of what is read from a file.

use std::fs::File;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use bytes::Bytes;
use exact_ccd_files::{Budget, Fault};
use parquet::errors::{ParquetError, Result};
use parquet::file::metadata::ColumnChunkMetaData;
use parquet::file::reader::{ChunkReader, Length};

/// A file that counts all bytes that are read, and the bytes of the pages that they expand to.
#[derive(Clone)]
pub(super) struct CountedFile {
    file: Arc<File>,
    budget: Arc<Mutex<Budget>>,
}

impl CountedFile {
    pub(super) fn new(file: File) -> Result<Self> {
        let budget = Budget::new(u64::MAX);
        budget.add_file(Length::len(&file)).map_err(too_large)?;
        Ok(Self {
            file: Arc::new(file),
            budget: Arc::new(Mutex::new(budget)),
        })
    }

    /// The account of the reading.
    pub(super) fn budget(&self) -> MutexGuard<'_, Budget> {
        self.budget.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Some bytes of the file.
    pub(super) fn bytes(&self, start: u64, length: usize) -> Result<Bytes> {
        if start
            .checked_add(length as u64)
            .is_none_or(|end| end > self.len())
        {
            return Err(ParquetError::EOF(
                "the file is too short for what it announces".into(),
            ));
        }
        self.budget().step(length as u64);
        self.file.get_bytes(start, length)
    }

    /// Returns true if a column chunk lies in the file.
    pub(super) fn holds(&self, chunk: &ColumnChunkMetaData) -> bool {
        let start = chunk.dictionary_page_offset().unwrap_or(chunk.data_page_offset());
        let [start, length] = [start, chunk.compressed_size()].map(u64::try_from);
        start.is_ok_and(|start| {
            length.is_ok_and(|length| start.checked_add(length).is_some_and(|end| end <= self.len()))
        })
    }
}

impl Length for CountedFile {
    fn len(&self) -> u64 {
        self.file.len()
    }
}

pub(super) fn too_large(fault: Fault) -> ParquetError {
    ParquetError::General(fault.to_string())
}
