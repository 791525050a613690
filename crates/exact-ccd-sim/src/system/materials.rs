//! The material of each tetrahedron of a solid.

use super::body_error::BodyError;
use crate::body::{Region, SolidProperties};
use crate::range::{OutOfRange, check_positive};

/// The material of each tetrahedron of a solid: its last region's, or the solid's if it is in no region.
pub(super) fn materials<'a>(
    count: usize,
    material: &'a SolidProperties,
    regions: &'a [Region],
) -> Result<Vec<&'a SolidProperties>, BodyError> {
    check(material)?;
    let mut materials = vec![material; count];
    for (region, Region { tetrahedra, material }) in regions.iter().enumerate() {
        check(material).map_err(|source| BodyError::Material { region, source })?;
        for &element in tetrahedra {
            let slot = materials.get_mut(element as usize);
            *slot.ok_or(BodyError::Region {
                region,
                element,
                count,
            })? = material;
        }
    }
    Ok(materials)
}

fn check(material: &SolidProperties) -> Result<(), OutOfRange> {
    check_positive("density", material.density)?;
    material.moduli().check()
}
