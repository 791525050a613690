//! The headers of pages, checked before the library allocates memory for a page.

use std::io::{self, Read};

use bytes::Bytes;
use bytes::buf::{Buf, Reader};
use parquet::errors::{ParquetError, Result};
use parquet::file::reader::Length;

use super::counted_file::CountedFile;
use super::format::PAGE_HEADER;
use super::thrift::{STRUCT, Thrift};

/// The numbers of bytes in which a header is searched, one after the other, as powers of two. Usual headers
/// have less than a hundred bytes; the least and the greatest of long strings make them longer. Each attempt
/// has eight times as many bytes as the one before, so that the work stays linear.
const LENGTHS: [u32; 5] = [9, 12, 15, 18, 21];

/// The bytes of the header of a page.
///
/// The header is read and checked with its first byte: the library opens some headers that it never reads.
pub(super) struct HeaderReader {
    file: CountedFile,
    start: u64,
    header: Option<Reader<Bytes>>,
}

impl HeaderReader {
    pub(super) fn new(file: CountedFile, start: u64) -> Self {
        Self {
            file,
            start,
            header: None,
        }
    }

    /// The header, if it has the one allowed form and the page is not too large.
    fn checked(&self) -> Result<Bytes> {
        let left = self.file.len().saturating_sub(self.start);
        for power in LENGTHS {
            let length = left.min(1 << power);
            let bytes = self.file.bytes(self.start, length as usize)?;
            let Some((length, size)) = header(&bytes) else {
                continue;
            };
            if size > self.file.budget().limit() {
                return Err(ParquetError::General(format!("a page of {size} bytes")));
            }
            return Ok(bytes.slice(..length));
        }
        Err(ParquetError::General(
            "the header of a page is damaged".to_owned(),
        ))
    }
}

impl Read for HeaderReader {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let header = match &mut self.header {
            Some(header) => header,
            None => {
                let header = self.checked().map_err(|error| match error {
                    ParquetError::General(text) => io::Error::other(text),
                    error => io::Error::other(error),
                })?;
                self.header.insert(header.reader())
            }
        };
        header.read(buffer)
    }
}

/// The length of a header, and the size of its page without compression. `None` if it is not valid.
fn header(bytes: &[u8]) -> Option<(usize, u64)> {
    let mut thrift = Thrift { rest: bytes };
    let mut end = thrift.clone();
    end.known(&PAGE_HEADER, STRUCT)?;
    let mut size = None;
    thrift.fields(&mut |thrift, field, stated| {
        if field != 2 {
            return thrift.skip(stated);
        }
        size = Some(u64::try_from(thrift.i32()?).ok()?);
        Some(())
    })?;
    Some((bytes.len() - end.rest.len(), size?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_size_of_a_page_is_the_second_field_of_its_header() {
        // 0xd8 0x04 is 600 in groups of seven bits, which is 300 as a signed number.
        let bytes = [0x15, 0x04, 0x15, 0xd8, 0x04, 0x15, 0x02, 0x00, 0x15];
        assert_eq!(header(&bytes), Some((8, 300)));
        let bytes = [0x15, 0x04, 0x15, 0xfe, 0xff, 0xff, 0xff, 0x0f, 0x00];
        assert_eq!(header(&bytes), Some((9, (1 << 31) - 1)));
        for other in [
            &[][..],
            &[0x00],
            &[0x15],
            &[0x15, 0x04, 0x25, 0x00],
            &[0x15, 0x04, 0x15, 0x01, 0x00],
            &[0x15, 0x04, 0x15, 0x80],
            // 2³¹.
            &[0x15, 0x04, 0x15, 0x80, 0x80, 0x80, 0x80, 0x10, 0x00],
        ] {
            assert_eq!(header(other), None);
        }
    }
}
