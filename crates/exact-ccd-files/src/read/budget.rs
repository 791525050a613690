//! The work and the memory of one reading, and the limits on both.

use std::cell::Cell;
use std::io::Read;

use crate::error::Fault;

/// Short files may expand to this number of bytes in any case.
const ALLOWANCE: u64 = 1 << 20;

/// The account of one reading.
///
/// Work is counted in steps, about one for each byte that a reader looks at; memory in bytes that a reader
/// keeps until it is done. Both are proportional to the bytes of the file and of the data that the file
/// expands to, so these two are limited.
#[derive(Debug)]
pub struct Budget {
    /// The most bytes that the files may have, and that they may expand to.
    max_size: u64,
    /// The bytes of the files.
    size: Cell<u64>,
    /// The bytes that the files expand to: data that are compressed, or that a file names several times.
    expanded: Cell<u64>,
    /// The steps of work for bytes that are read several times.
    worked: Cell<u64>,
    steps: Cell<u64>,
    bytes: Cell<u64>,
}

impl Budget {
    /// The largest allowed ratio of the data that a file expands to and its size. Meshes compress by 2 to 20,
    /// and regular grids by up to 100; deflate reaches 1,032.
    pub const RATIO: u64 = 200;

    /// The account before the first file is read, for files of at most `max_size` bytes.
    #[must_use]
    pub fn new(max_size: u64) -> Self {
        Self {
            max_size,
            size: Cell::new(0),
            expanded: Cell::new(0),
            worked: Cell::new(0),
            steps: Cell::new(0),
            bytes: Cell::new(0),
        }
    }

    /// The most bytes that a further file may have.
    pub(super) fn size_left(&self) -> u64 {
        self.max_size - self.size.get()
    }

    /// Adds the size of a further file.
    ///
    /// # Errors
    /// If all files together are larger than allowed.
    pub fn add_file(&self, size: u64) -> Result<(), Fault> {
        let limit = self.max_size;
        if size > self.size_left() {
            return Err(Fault::Size { limit });
        }
        self.size.set(self.size.get() + size);
        Ok(())
    }

    /// Takes bytes that the files expand to.
    ///
    /// # Errors
    /// If they are more than the limits allow.
    pub fn take(&self, bytes: u64) -> Result<(), Fault> {
        let expanded = self.expanded.get().saturating_add(bytes);
        let limit = self.limit();
        if expanded > limit {
            return Err(if limit == self.max_size {
                Fault::Size { limit }
            } else {
                Fault::Expansion { limit }
            });
        }
        self.expanded.set(expanded);
        self.step(bytes);
        Ok(())
    }

    /// Takes steps of work that a file may demand again and again for the same bytes.
    ///
    /// # Errors
    /// If they are more than the size of the files allows.
    pub(super) fn work(&self, steps: u64) -> Result<(), Fault> {
        let worked = self.worked.get().saturating_add(steps);
        let limit = self.limit_by_size();
        if worked > limit {
            return Err(Fault::Expansion { limit });
        }
        self.worked.set(worked);
        self.step(steps);
        Ok(())
    }

    /// Counts steps of work.
    pub fn step(&self, steps: u64) {
        self.steps.set(self.steps.get().saturating_add(steps));
    }

    /// Counts the memory of a number of elements of a type.
    pub(super) fn hold<T>(&self, count: usize) {
        let bytes = (count as u64).saturating_mul(size_of::<T>() as u64);
        self.bytes.set(self.bytes.get().saturating_add(bytes));
    }

    /// Reads all data of a decompressor.
    ///
    /// # Errors
    /// If the data are not valid, with `expected` as their description, or more than the limits allow, or
    /// than `most`.
    pub(super) fn read_all(&self, reader: impl Read, expected: &str, most: u64) -> Result<Vec<u8>, Fault> {
        let mut data = Vec::new();
        let left = self.limit().saturating_sub(self.expanded.get());
        let read = reader
            .take(left.min(most).saturating_add(1))
            .read_to_end(&mut data);
        read.map_err(|error| Fault::of_io(expected, &error))?;
        self.take(data.len() as u64)?;
        Ok(data)
    }

    /// The most bytes that the files may expand to: 200 times their size and a mebibyte.
    #[must_use]
    pub fn limit(&self) -> u64 {
        self.limit_by_size().min(self.max_size)
    }

    fn limit_by_size(&self) -> u64 {
        self.size
            .get()
            .saturating_mul(Self::RATIO)
            .saturating_add(ALLOWANCE)
    }

    /// The steps of work, and the bytes of memory.
    #[must_use]
    pub fn spent(&self) -> [u64; 2] {
        [self.steps.get(), self.bytes.get()]
    }
}
