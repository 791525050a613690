//! The direction upwards on a page, on the command line.

use exact_ccd_mesh::Point;
use exact_ccd_mesh::vector::{DIRECTION, has_direction};

use crate::text::numbers::numbers;

/// A direction: an axis, with or without a sign, or three numbers.
pub(super) fn parse(text: &str) -> Result<Point, String> {
    let (sign, axis) = match text.strip_prefix('-') {
        Some(axis) => (-1.0, axis),
        None => (1.0, text),
    };
    match axis {
        "x" => return Ok([sign, 0.0, 0.0]),
        "y" => return Ok([0.0, sign, 0.0]),
        "z" => return Ok([0.0, 0.0, sign]),
        _ => {}
    }
    let up = numbers(text).filter(|&up| has_direction(up));
    up.ok_or_else(|| format!("expected x, y, z, -x, -y, -z, or {DIRECTION}"))
}
