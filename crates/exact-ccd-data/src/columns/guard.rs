//! Checks of a file before the library allocates memory for its contents.
//!
//! A damaged or forged file of a few bytes can announce pages of gigabytes. The size of every page is
//! checked against the size of the file. Metadata and headers of pages are refused if the library may read
//! them otherwise than the check does.

use std::panic::{self, AssertUnwindSafe};

use bytes::Bytes;
use parquet::basic::Encoding;
use parquet::column::page::{Page, PageMetadata, PageReader};
use parquet::errors::{ParquetError, Result};
use parquet::file::metadata::{ParquetMetaData, RowGroupMetaData};
use parquet::file::reader::{ChunkReader, Length};

use super::counted_file::{CountedFile, too_large};
use super::header::HeaderReader;

/// Checks the numbers that the metadata announce.
///
/// # Errors
/// If the columns overlap, so that the same bytes are read several times, or the queries, which have this
/// number of coordinates, are far larger than the file.
pub(super) fn check_size(file: &CountedFile, metadata: &ParquetMetaData, coordinates: usize) -> Result<()> {
    let limit = file.budget().limit();
    let rows = metadata.file_metadata().num_rows().unsigned_abs();
    let bytes = rows.saturating_mul((coordinates * size_of::<f64>()) as u64);
    if bytes > limit {
        return Err(ParquetError::General(format!(
            "its {rows} queries take {bytes} bytes, and a file of its size has at most {limit}"
        )));
    }
    let columns = metadata.row_groups().iter().flat_map(RowGroupMetaData::columns);
    let sizes = columns.map(|column| column.compressed_size().unsigned_abs());
    if sizes.fold(0, u64::saturating_add) > file.len() {
        return Err(ParquetError::General("its columns overlap".to_owned()));
    }
    Ok(())
}

/// Calls the library. A panic becomes an error.
///
/// The hook of the process stays as it is: it belongs to the program, which may print or log the panic. The
/// checks before this call refuse the files that are known to cause a panic.
pub(super) fn catch<T>(call: impl FnOnce() -> Result<T>) -> Result<T> {
    let answer = panic::catch_unwind(AssertUnwindSafe(call));
    answer.unwrap_or_else(|_| Err(ParquetError::General("its metadata contradict each other".into())))
}

impl ChunkReader for CountedFile {
    type T = HeaderReader;

    /// The library reads the header of a page with this, and nothing else.
    fn get_read(&self, start: u64) -> Result<Self::T> {
        Ok(HeaderReader::new(self.clone(), start))
    }

    fn get_bytes(&self, start: u64, length: usize) -> Result<Bytes> {
        self.bytes(start, length)
    }
}

/// The pages of a column chunk. Their values are not more than announced, and a dictionary comes
/// before its use.
pub(super) struct GuardedPages<P> {
    pages: P,
    file: CountedFile,
    /// The largest number of values that can follow.
    left: usize,
    has_dictionary: bool,
}

impl<P: PageReader> GuardedPages<P> {
    pub(super) fn new(file: CountedFile, pages: P, values: usize) -> Self {
        Self {
            pages,
            file,
            left: values,
            has_dictionary: false,
        }
    }
}

impl<P: PageReader> PageReader for GuardedPages<P> {
    fn get_next_page(&mut self) -> Result<Option<Page>> {
        let page = self.pages.get_next_page()?;
        if let Some(page) = &page {
            let budget = self.file.budget();
            budget.take(page.buffer().len() as u64).map_err(too_large)?;
            budget.step(page.num_values().into());
        }
        let too_many = match &page {
            None => false,
            Some(Page::DictionaryPage { buf, num_values, .. }) => {
                self.has_dictionary = true;
                // A value in a dictionary has a byte at least.
                *num_values as usize > buf.len()
            }
            Some(page) => {
                let is_dictionary = matches!(
                    page.encoding(),
                    Encoding::RLE_DICTIONARY | Encoding::PLAIN_DICTIONARY
                );
                if is_dictionary && !self.has_dictionary {
                    return Err(ParquetError::General("a dictionary is missing".into()));
                }
                let left = self.left.checked_sub(page.num_values() as usize);
                self.left = left.unwrap_or(0);
                left.is_none()
            }
        };
        if too_many {
            Err(ParquetError::General(
                "a page has more values than there are rows for".into(),
            ))
        } else {
            Ok(page)
        }
    }

    fn peek_next_page(&mut self) -> Result<Option<PageMetadata>> {
        self.pages.peek_next_page()
    }

    fn skip_next_page(&mut self) -> Result<()> {
        self.pages.skip_next_page()
    }

    fn at_record_boundary(&mut self) -> Result<bool> {
        self.pages.at_record_boundary()
    }
}

impl<P: PageReader> Iterator for GuardedPages<P> {
    type Item = Result<Page>;

    fn next(&mut self) -> Option<Self::Item> {
        self.get_next_page().transpose()
    }
}
