//! Queries out of columns.

use std::fs::File;
use std::marker::PhantomData;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::vec;

use exact_ccd::Kind;
use parquet::errors::ParquetError;
use parquet::file::metadata::{ParquetMetaData, ParquetMetaDataReader};

use super::counted_file::CountedFile;
use super::group::{Group, Leaves};
use super::guard::{catch, check_size};
use super::problem::ColumnProblem;
use super::row::Row;
use super::{coordinates, footer};
use crate::error::DataError;
use crate::record::Record;

/// The number of queries that are read at once.
const BATCH: usize = 1024;

/// Reads the queries of a Parquet file one after the other, with all data that the file has about them. It
/// ends after the first error.
///
/// The columns of [`ColumnWriter`](crate::ColumnWriter) are found by name, in any order. Other software may
/// have written them. Further columns are skipped. Columns are plain or compressed with gzip or snappy.
pub struct ColumnReader<K: Kind> {
    path: PathBuf,
    file: Arc<CountedFile>,
    metadata: ParquetMetaData,
    leaves: Leaves,
    /// The number of the row group to be opened next.
    next_group: usize,
    group: Option<Group>,
    /// The records that are read next, and the reason why there are no others.
    batch: vec::IntoIter<Result<Record<K>, DataError>>,
    /// The number of queries that were read.
    queries: usize,
    done: bool,
    kind: PhantomData<K>,
}

impl<K: Kind> ColumnReader<K> {
    /// A reader of the queries in a file.
    ///
    /// # Errors
    /// If the file cannot be opened, is not a Parquet file, or lacks a column.
    pub fn open(path: &Path) -> Result<Self, DataError> {
        let file = File::open(path).map_err(|source| DataError::io(path, source))?;
        let wrong = |error: ParquetError| DataError::columns(path, ColumnProblem::from(error));
        let file = Arc::new(CountedFile::new(file).map_err(wrong)?);
        let metadata = footer::metadata(&file).map_err(wrong)?;
        let metadata = catch(|| ParquetMetaDataReader::decode_metadata(&metadata)).map_err(wrong)?;
        check_size(&file, &metadata, coordinates::<K>()).map_err(wrong)?;
        let leaves = Leaves::find(&metadata).map_err(|problem| DataError::columns(path, problem))?;
        Ok(Self {
            path: path.to_owned(),
            file,
            metadata,
            leaves,
            next_group: 0,
            group: None,
            batch: Vec::new().into_iter(),
            queries: 0,
            done: false,
            kind: PhantomData,
        })
    }

    /// The work and the memory so far.
    #[cfg(test)]
    pub(crate) fn spent(&self) -> [u64; 2] {
        self.file.budget().spent()
    }

    /// The next queries; none at the end of the file.
    fn read_batch(&mut self) -> Result<Vec<Result<Record<K>, DataError>>, DataError> {
        let wrong = |problem| DataError::columns(&self.path, problem);
        loop {
            let Some(group) = &mut self.group else {
                let Some(metadata) = self.metadata.row_groups().get(self.next_group) else {
                    return match usize::try_from(self.metadata.file_metadata().num_rows()) {
                        Ok(rows) if rows == self.queries => Ok(Vec::new()),
                        _ => Err(wrong(ColumnProblem::parquet(
                            "the number of rows is not that announced",
                        ))),
                    };
                };
                let group = Group::open(&self.file, metadata, &self.leaves, coordinates::<K>());
                self.group = Some(group.map_err(wrong)?);
                self.next_group += 1;
                continue;
            };
            if group.rows_left == 0 {
                group.end().map_err(wrong)?;
                self.group = None;
                continue;
            }
            let rows = group.rows_left.min(BATCH);
            group.rows_left -= rows;
            let rows = group.read(rows).map_err(wrong)?;
            let first = self.queries;
            self.queries += rows.len();
            let record = |(index, row): (usize, Row)| {
                row.record().map_err(|problem| DataError::Record {
                    file: self.path.clone(),
                    query: first + index,
                    problem,
                })
            };
            return Ok(rows.into_iter().enumerate().map(record).collect());
        }
    }
}

impl<K: Kind> Iterator for ColumnReader<K> {
    type Item = Result<Record<K>, DataError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.done {
            return None;
        }
        if self.batch.as_slice().is_empty() {
            self.batch = self
                .read_batch()
                .unwrap_or_else(|error| vec![Err(error)])
                .into_iter();
        }
        let next = self.batch.next();
        self.done = !matches!(next, Some(Ok(_)));
        next
    }
}
