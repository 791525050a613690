//! Vectors and indices in the buffers of a file.

use super::super::budget::Budget;
use super::super::scalar::{ByteOrder, Scalar};
use super::buffers::Buffers;
use super::document::{Accessor, Document, at};
use crate::error::Fault;

/// The type of components with this number.
fn scalar(component_type: u32) -> Option<Scalar> {
    Some(match component_type {
        5120 => Scalar::I8,
        5121 => Scalar::U8,
        5122 => Scalar::I16,
        5123 => Scalar::U16,
        5125 => Scalar::U32,
        5126 => Scalar::F32,
        _ => return None,
    })
}

/// The number that stands for 1 in normalised data.
fn greatest(scalar: Scalar) -> f64 {
    match scalar {
        Scalar::I8 => 127.0,
        Scalar::U8 => 255.0,
        Scalar::I16 => 32767.0,
        Scalar::U16 => 65535.0,
        _ => 1.0,
    }
}

/// The accessors of a file, and the data that they name.
pub(super) struct Accessors<'a> {
    pub(super) document: &'a Document,
    pub(super) buffers: Buffers,
    pub(super) budget: &'a Budget,
}

impl Accessors<'_> {
    /// The number of elements of an accessor.
    pub(super) fn count(&self, index: u32) -> Result<u64, Fault> {
        Ok(at(&self.document.accessors, index, "accessor")?.count)
    }

    /// The elements of an accessor as vectors of this type, `VEC3` or `VEC4`; `expected` describes one.
    ///
    /// Floats and integers are exact. Of integers that are normalised, c stands for c / m with the greatest
    /// number m of the type, and not below −1, rounded to nearest.
    pub(super) fn vectors<const N: usize>(
        &self,
        index: u32,
        shape: &str,
        expected: &str,
    ) -> Result<Vec<[f64; N]>, Fault> {
        let accessor = at(&self.document.accessors, index, "accessor")?;
        let scalar = scalar(accessor.component_type).filter(|_| accessor.shape == shape);
        let scalar = scalar.ok_or_else(|| wrong(index, expected))?;
        let size = scalar.size();
        self.budget.take(accessor.count.saturating_mul(8 * N as u64))?;
        let greatest = if accessor.normalized {
            greatest(scalar)
        } else {
            1.0
        };
        let number = |at: &[u8], k: usize| {
            let real = scalar.real(&at[k * size..][..size], ByteOrder::LittleEndian);
            if greatest == 1.0 {
                real
            } else {
                (real / greatest).max(-1.0)
            }
        };
        let elements = self.elements(accessor, index, N * size)?;
        Ok(elements
            .map(|at| std::array::from_fn(|k| number(at, k)))
            .collect())
    }

    /// The elements of an accessor as times, which increase.
    pub(super) fn times(&self, index: u32) -> Result<Vec<f64>, Fault> {
        const TIMES: &str = "floats that increase, the times of keys,";
        let times: Vec<[f64; 1]> = self.vectors(index, "SCALAR", TIMES)?;
        let times: Vec<f64> = times.into_iter().flatten().collect();
        let is_finite = times.iter().all(|time| time.is_finite());
        match is_finite && times.is_sorted_by(|a, b| a < b) {
            true => Ok(times),
            false => Err(wrong(index, TIMES)),
        }
    }

    /// The elements of an accessor as indices.
    pub(super) fn indices(&self, index: u32) -> Result<Vec<u64>, Fault> {
        let accessor = at(&self.document.accessors, index, "accessor")?;
        let size = match (scalar(accessor.component_type), &*accessor.shape) {
            (Some(scalar @ (Scalar::U8 | Scalar::U16 | Scalar::U32)), "SCALAR") => scalar.size(),
            _ => return Err(wrong(index, "unsigned integers as indices")),
        };
        self.budget.take(accessor.count.saturating_mul(8))?;
        let number = |at: &[u8]| {
            at.iter()
                .rev()
                .fold(0, |number, &byte| number << 8 | u64::from(byte))
        };
        Ok(self.elements(accessor, index, size)?.map(number).collect())
    }

    /// The bytes of each element, which has this size.
    fn elements(
        &self,
        accessor: &Accessor,
        index: u32,
        size: usize,
    ) -> Result<impl Iterator<Item = &[u8]>, Fault> {
        if accessor.sparse.is_some() {
            return Err(wrong(index, "no sparse data (export it again without)"));
        }
        let view = accessor
            .buffer_view
            .ok_or_else(|| wrong(index, "a buffer view"))?;
        let view = at(&self.document.buffer_views, view, "bufferView")?;
        let buffer = self.buffers.get(view.buffer)?;
        let missing = || wrong(index, "data within its buffer view");
        let part = |data, start: u64| <[u8]>::get(data, usize::try_from(start).ok()?..);
        let data = part(buffer, view.byte_offset)
            .and_then(|data| data.get(..usize::try_from(view.byte_length).ok()?))
            .and_then(|data| part(data, accessor.byte_offset))
            .ok_or_else(missing)?;
        let stride = view.byte_stride.map_or(Ok(size), usize::try_from);
        let stride = stride.ok().filter(|&stride| stride >= size).ok_or_else(missing)?;
        let count = usize::try_from(accessor.count).map_err(|_| missing())?;
        let end = match count.checked_sub(1) {
            None => Some(0),
            Some(last) => last.checked_mul(stride).and_then(|start| start.checked_add(size)),
        };
        let data = end.and_then(|end| data.get(..end)).ok_or_else(missing)?;
        // The last piece may be shorter than the others, and has one element, too.
        Ok(data.chunks(stride).map(move |piece| &piece[..size]))
    }
}

fn wrong(accessor: u32, expected: &str) -> Fault {
    Fault::expected(format!("{expected} in accessor {accessor}"), "something else")
}
