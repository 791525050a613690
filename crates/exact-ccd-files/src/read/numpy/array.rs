//! Arrays of numbers of any shape.

use super::super::budget::Budget;
use super::super::scalar::{ByteOrder, Scalar};
use super::header::Header;
use crate::error::{Fault, ParseError, Place};

/// An array, of which the last index varies fastest.
#[derive(Clone, Debug)]
pub(super) struct Array {
    scalar: Scalar,
    order: ByteOrder,
    pub(super) shape: Vec<usize>,
    data: Vec<u8>,
}

impl Array {
    /// The array in the contents of a `.npy` file.
    pub(super) fn read(file: &[u8], budget: &Budget) -> Result<Self, ParseError> {
        let header = Header::read(file, budget)?;
        let data = &file[header.length..];
        let length = header.data_length().filter(|&length| length == data.len());
        if length.is_none() {
            let expected = format!("the numbers of an array {header}");
            let found = format!("{} bytes", data.len());
            return Err(Fault::expected(expected, found).at(Place::Byte(header.length)));
        }
        budget.hold::<u8>(data.len());
        let data = match header.is_fortran {
            true => {
                budget.step((data.len() * header.shape.len()) as u64);
                with_last_index_fastest(data, &header.shape, header.scalar.size())
            }
            false => data.to_vec(),
        };
        Ok(Self {
            scalar: header.scalar,
            order: header.order,
            shape: header.shape,
            data,
        })
    }

    pub(super) fn is_integer(&self) -> bool {
        self.scalar.is_integer()
    }

    /// Returns true for rows of integers, as those of faces.
    pub(super) fn is_table_of_integers(&self) -> bool {
        self.is_integer() && self.shape.len() == 2
    }

    /// The number of numbers.
    pub(super) fn count(&self) -> usize {
        self.data.len() / self.scalar.size()
    }

    /// All numbers, none for an array of floating-point numbers.
    pub(super) fn integers(&self) -> Vec<i64> {
        self.scalar.integers(&self.data, self.order)
    }

    /// The numbers with these indices in the order of the file, as many as there are.
    pub(super) fn reals(&self, start: usize, count: usize) -> Vec<f64> {
        let size = self.scalar.size();
        let from = start.saturating_mul(size).min(self.data.len());
        let to = from
            .saturating_add(count.saturating_mul(size))
            .min(self.data.len());
        self.scalar.reals(&self.data[from..to], self.order)
    }
}

/// The same numbers in an order in which the last index varies fastest, not the first one.
fn with_last_index_fastest(data: &[u8], shape: &[usize], size: usize) -> Vec<u8> {
    let mut moved = Vec::with_capacity(data.len());
    let mut index = vec![0; shape.len()];
    for _ in 0..data.len() / size {
        let at = index
            .iter()
            .zip(shape)
            .rev()
            .fold(0, |at, (i, count)| at * count + i);
        moved.extend_from_slice(&data[at * size..][..size]);
        for (i, &count) in index.iter_mut().zip(shape).rev() {
            *i += 1;
            if *i < count {
                break;
            }
            *i = 0;
        }
    }
    moved
}
