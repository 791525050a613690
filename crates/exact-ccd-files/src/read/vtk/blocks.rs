//! The header of an array, and its data in one piece or in compressed blocks.

use flate2::read::ZlibDecoder;

use super::super::budget::Budget;
use super::super::scalar::{ByteOrder, Scalar};
use super::stream::Stream;
use crate::error::Fault;

/// The compression of the arrays of a file.
#[derive(Clone, Copy)]
pub(super) enum Compression {
    Zlib,
    Lz4,
}

/// The layout of the headers of arrays.
#[derive(Clone, Copy)]
pub(super) struct Layout {
    pub(super) order: ByteOrder,
    /// The type of the numbers of a header.
    pub(super) word: Scalar,
    pub(super) compression: Option<Compression>,
}

/// The work for a compressed block besides its bytes, in steps: the decompressor has tables to set up. Usual
/// blocks have 32,768 bytes.
const BLOCK: u64 = 4096;

impl Layout {
    /// The data of the array at the beginning of a stream.
    pub(super) fn data(&self, stream: &mut Stream, budget: &Budget) -> Result<Vec<u8>, Fault> {
        let [first] = self.words(stream, budget)?;
        let Some(compression) = self.compression else {
            // Several arrays may be the same part of the appended data.
            budget.take(first)?;
            return stream.take(first, budget);
        };
        // The number of blocks (`first`), their size, and the size of the last one if it is shorter.
        let [size, last] = self.words(stream, budget)?;
        let header = stream.take(first.saturating_mul(self.word.size() as u64), budget)?;
        // Several arrays may have the same header.
        budget.work(header.len() as u64)?;
        let compressed = self.word.integers(&header, self.order);
        let mut data = Vec::new();
        for (block, &length) in compressed.iter().enumerate() {
            let is_short = last > 0 && block + 1 == compressed.len();
            let expanded = if is_short { last } else { size };
            let bytes = stream.take(length.unsigned_abs(), budget)?;
            budget.work(BLOCK + bytes.len() as u64)?;
            data.append(&mut compression.expand(&bytes, expanded, budget)?);
        }
        Ok(data)
    }

    /// The next numbers of a header.
    fn words<const N: usize>(&self, stream: &mut Stream, budget: &Budget) -> Result<[u64; N], Fault> {
        let bytes = stream.take((N * self.word.size()) as u64, budget)?;
        let words = self.word.integers(&bytes, self.order);
        Ok(std::array::from_fn(|k| words[k].unsigned_abs()))
    }
}

impl Compression {
    /// The data of a block, whose expanded size is known.
    fn expand(self, block: &[u8], size: u64, budget: &Budget) -> Result<Vec<u8>, Fault> {
        let wrong = |found: String| Fault::expected(format!("a block of {size} bytes"), found);
        let data = match self {
            Self::Zlib => budget.read_all(ZlibDecoder::new(block), "data compressed by zlib", size)?,
            Self::Lz4 => {
                budget.take(size)?;
                // The size is within the budget.
                let mut data = vec![0; size as usize];
                let length = lz4_flex::block::decompress_into(block, &mut data);
                let length = length.map_err(|error| wrong(format!("invalid LZ4 data ({error})")))?;
                data.truncate(length);
                data
            }
        };
        match data.len() as u64 == size {
            true => Ok(data),
            false => Err(wrong(data.len().to_string())),
        }
    }
}
