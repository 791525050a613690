//! The displacement for all files.

use exact_ccd_mesh::Aabb;
use exact_ccd_methods::parity::{Displacement, RoundingError};

/// The displacement for all points in a box, which may be empty. None overflows, because rounding is
/// monotone and the corners do not.
pub(super) fn shared_displacement(bounds: &Aabb) -> Result<Displacement, RoundingError> {
    if *bounds == Aabb::EMPTY {
        return Ok(Displacement::default());
    }
    let displacement = Displacement::of_box(bounds.lower, bounds.upper);
    displacement.apply_to_all(&[bounds.lower, bounds.upper])?;
    Ok(displacement)
}
