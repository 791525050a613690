//! The regions of a solid.

use exact_ccd_files::Group;

use super::description::RegionDescription;
use exact_ccd_sim::{Body, BodyKind, Region};

/// Adds the described regions to a body with these groups. The error is the invalid region with a message.
pub(super) fn add(
    described: &[RegionDescription],
    groups: &[Group],
    body: &mut Body,
) -> Result<(), (usize, String)> {
    for (number, region) in described.iter().enumerate() {
        let error = |message: &str| (number, message.to_owned());
        let BodyKind::Solid { regions, .. } = &mut body.kind else {
            return Err(error(
                "only a solid has regions, expected `solid` with the material of the rest",
            ));
        };
        let found = region.group.find(groups).map_err(|message| error(&message))?;
        let cells = found.into_iter().flat_map(|group| &group.cells);
        let tetrahedra: Vec<u32> = cells.copied().collect();
        if tetrahedra.is_empty() {
            return Err(error(
                "the group has no tetrahedra, expected a physical group of a volume",
            ));
        }
        let material = region.solid;
        regions.push(Region { tetrahedra, material });
    }
    Ok(())
}
