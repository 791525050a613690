//! Arguments from bytes.

use arbitrary::{Result, Unstructured};
use exact_ccd_c::Kind;

/// A small integer, so that contact is frequent; or any bits, so that all errors are, too.
pub(super) fn number(bytes: &mut Unstructured<'_>) -> Result<f64> {
    Ok(match bytes.arbitrary::<u8>()? {
        kind @ ..0xfe => f64::from(kind % 9) - 4.0,
        0xfe => [-0.0, 5e-324, 1e-300, 1e300, f64::INFINITY][bytes.choose_index(5)?],
        0xff => f64::from_bits(bytes.arbitrary()?),
    })
}

/// Coordinates of points, in memory of exactly their size.
pub(super) fn points(bytes: &mut Unstructured<'_>, count: usize) -> Result<Vec<f64>> {
    (0..3 * count).map(|_| number(bytes)).collect()
}

/// Indices of vertices. One in 64 is out of range.
pub(super) fn indices(bytes: &mut Unstructured<'_>, count: usize, vertices: usize) -> Result<Vec<u32>> {
    let index = |_| {
        let byte: u8 = bytes.arbitrary()?;
        let range = vertices + usize::from(byte < 4);
        Ok((usize::from(byte) % range.max(1)) as u32)
    };
    (0..count).map(index).collect()
}

/// A distance, which is 0 in half of all cases, and rarely no distance.
pub(super) fn distance(bytes: &mut Unstructured<'_>) -> Result<f64> {
    Ok(match bytes.arbitrary::<u8>()? {
        ..0x80 => 0.0,
        byte @ ..0xf8 => f64::from(byte % 16) / 8.0,
        _ => number(bytes)?,
    })
}

/// A kind, or the number after the last, and the number of its points.
pub(super) fn kind(bytes: &mut Unstructured<'_>) -> Result<(u32, usize)> {
    let points = [4, 4, 3, 2, 4];
    let kind = bytes.int_in_range(0..=Kind::VertexVertex as u8 + 1)?;
    Ok((kind.into(), points[usize::from(kind)]))
}

/// The pointer to an array, in rare cases null.
pub(super) fn pointer<T>(bytes: &mut Unstructured<'_>, array: &[T]) -> Result<*const T> {
    let is_null = bytes.ratio(1, 64)?;
    Ok(if is_null {
        core::ptr::null()
    } else {
        array.as_ptr()
    })
}
