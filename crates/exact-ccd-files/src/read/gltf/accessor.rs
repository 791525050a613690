//! Positions and indices in the buffers of a file.

use exact_ccd_mesh::Point;

use super::super::budget::Budget;
use super::buffers::Buffers;
use super::document::{Accessor, Document, at};
use crate::error::Fault;

/// The numbers of the types of components.
const U8: u32 = 5121;
const U16: u32 = 5123;
const U32: u32 = 5125;
const F32: u32 = 5126;

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

    /// The elements of an accessor as positions, exactly.
    pub(super) fn positions(&self, index: u32) -> Result<Vec<Point>, Fault> {
        let accessor = at(&self.document.accessors, index, "accessor")?;
        if (accessor.component_type, &*accessor.shape) != (F32, "VEC3") {
            return Err(wrong(index, "three floats for each position"));
        }
        self.budget.take(accessor.count.saturating_mul(24))?;
        let number = |at: &[u8], k: usize| {
            let bytes = std::array::from_fn(|byte| at[4 * k + byte]);
            f64::from(f32::from_le_bytes(bytes))
        };
        let elements = self.elements(accessor, index, 12)?;
        Ok(elements
            .map(|at| [number(at, 0), number(at, 1), number(at, 2)])
            .collect())
    }

    /// The elements of an accessor as indices.
    pub(super) fn indices(&self, index: u32) -> Result<Vec<u64>, Fault> {
        let accessor = at(&self.document.accessors, index, "accessor")?;
        let size = match (accessor.component_type, &*accessor.shape) {
            (U8, "SCALAR") => 1,
            (U16, "SCALAR") => 2,
            (U32, "SCALAR") => 4,
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
            return Err(wrong(index, "no sparse data"));
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
