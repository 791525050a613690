//! Positions and indices in the buffers of a file.

use exact_ccd_mesh::Point;
use gltf::Accessor;
use gltf::accessor::{DataType, Dimensions};

use super::super::compressed::Budget;
use super::buffers::Buffers;
use crate::error::Fault;

impl Buffers {
    /// The elements of an accessor as positions, exactly.
    pub(super) fn positions(&self, accessor: &Accessor, budget: &mut Budget) -> Result<Vec<Point>, Fault> {
        if (accessor.data_type(), accessor.dimensions()) != (DataType::F32, Dimensions::Vec3) {
            return Err(wrong(accessor, "three floats for each position"));
        }
        budget.take((accessor.count() as u64).saturating_mul(24))?;
        let number = |at: &[u8], k: usize| {
            let bytes = std::array::from_fn(|byte| at[4 * k + byte]);
            f64::from(f32::from_le_bytes(bytes))
        };
        let elements = self.elements(accessor)?.into_iter();
        Ok(elements
            .map(|at| [number(at, 0), number(at, 1), number(at, 2)])
            .collect())
    }

    /// The elements of an accessor as indices.
    pub(super) fn indices(&self, accessor: &Accessor, budget: &mut Budget) -> Result<Vec<u64>, Fault> {
        use DataType::{U8, U16, U32};
        if !matches!(accessor.data_type(), U8 | U16 | U32) || accessor.dimensions() != Dimensions::Scalar {
            return Err(wrong(accessor, "unsigned integers as indices"));
        }
        budget.take((accessor.count() as u64).saturating_mul(8))?;
        let number = |at: &[u8]| {
            at.iter()
                .rev()
                .fold(0, |number, &byte| number << 8 | u64::from(byte))
        };
        Ok(self.elements(accessor)?.into_iter().map(number).collect())
    }

    /// The bytes of each element.
    fn elements(&self, accessor: &Accessor) -> Result<Vec<&[u8]>, Fault> {
        if accessor.sparse().is_some() {
            return Err(wrong(accessor, "no sparse data"));
        }
        let view = accessor.view().ok_or_else(|| wrong(accessor, "a buffer view"))?;
        let (size, count) = (accessor.size(), accessor.count());
        let stride = view.stride().unwrap_or(size);
        let missing = || wrong(accessor, "data within its buffer view");
        let buffer = self.get(view.buffer().index()).ok_or_else(missing)?;
        let data = buffer
            .get(view.offset()..)
            .and_then(|data| data.get(..view.length()));
        let data = data
            .and_then(|data| data.get(accessor.offset()..))
            .ok_or_else(missing)?;
        if stride < size {
            return Err(missing());
        }
        let mut elements = Vec::new();
        for k in 0..count {
            let start = k.checked_mul(stride).ok_or_else(missing)?;
            let element = data.get(start..).and_then(|data| data.get(..size));
            elements.push(element.ok_or_else(missing)?);
        }
        Ok(elements)
    }
}

fn wrong(accessor: &Accessor, expected: &str) -> Fault {
    Fault::expected(
        format!("{expected} in accessor {}", accessor.index()),
        "something else",
    )
}
