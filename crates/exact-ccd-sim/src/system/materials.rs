//! The material of each tetrahedron of a solid.

use super::error::{SystemError, positive};
use crate::body::{Region, SolidProperties};

/// The material of each tetrahedron of a solid: that of its last region, otherwise that of the solid.
pub(super) fn materials<'a>(
    body: usize,
    count: usize,
    material: &'a SolidProperties,
    regions: &'a [Region],
) -> Result<Vec<&'a SolidProperties>, SystemError> {
    check(body, material)?;
    let mut materials = vec![material; count];
    for (region, Region { tetrahedra, material }) in regions.iter().enumerate() {
        check(body, material).map_err(|source| SystemError::InRegion {
            region,
            source: Box::new(source),
        })?;
        for &element in tetrahedra {
            let slot = materials.get_mut(element as usize);
            *slot.ok_or(SystemError::Region {
                body,
                region,
                element,
                count,
            })? = material;
        }
    }
    Ok(materials)
}

fn check(body: usize, material: &SolidProperties) -> Result<(), SystemError> {
    positive(body, "density", material.density)?;
    let moduli = material.moduli().check();
    moduli.map_err(|source| SystemError::Moduli { body, source })
}
