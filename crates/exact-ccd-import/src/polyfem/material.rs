//! Materials.

use super::entry::{Entry, NOTHING, Rule};
use super::surface::Ids;
use crate::fault::{Fault, Problem};
use exact_ccd_sim::{SolidMaterial, SolidProperties};

/// The material of the bodies with an id.
pub(super) struct Material {
    ids: Ids,
    properties: SolidProperties,
}

/// The materials of the file.
pub(super) fn materials(root: &Entry<'_>) -> Result<Vec<Material>, Fault> {
    let entry = root.need("materials")?;
    let is_list = entry.value.is_array();
    entry
        .list()
        .iter()
        .map(|entry| material(entry, is_list))
        .collect()
}

fn material(entry: &Entry<'_>, is_listed: bool) -> Result<Material, Fault> {
    let name = entry.need("type")?;
    let energy = match name.text()? {
        "NeoHookean" => SolidMaterial::NeoHookean,
        "SaintVenant" => SolidMaterial::SaintVenantKirchhoff,
        "FixedCorotational" => SolidMaterial::FixedCorotated,
        _ => {
            let instead = "write \"NeoHookean\", \"SaintVenant\" or \"FixedCorotational\"";
            return Err(name.unsupported("this material", instead));
        }
    };
    entry.check(&[("type id E nu lambda mu rho", Rule::Said), ("phi psi", NOTHING)])?;
    let number = |key| entry.need(key)?.number();
    let (young, poisson) = if entry.get("E").is_some() {
        (number("E")?, number("nu")?)
    } else {
        let (lambda, mu) = (number("lambda")?, number("mu")?);
        (
            mu * (3.0 * lambda + 2.0 * mu) / (lambda + mu),
            lambda / (2.0 * (lambda + mu)),
        )
    };
    let ids = match entry.get("id") {
        None => vec![0],
        Some(ids) => ids.list().iter().map(Entry::integer).collect::<Result<_, _>>()?,
    };
    Ok(Material {
        ids: Ids(is_listed.then_some(ids)),
        properties: SolidProperties {
            density: entry.number_or("rho", 1.0)?,
            young,
            poisson,
            energy,
        },
    })
}

/// The material of the tetrahedra with an id. Of several materials with an id, PolyFEM takes the last one.
pub(super) fn of_id(id: i64, materials: &[Material], geometry: &Entry<'_>) -> Result<SolidProperties, Fault> {
    let mut latest = materials.iter().rev();
    let material = latest.find(|material| material.ids.contain(Some(id)));
    let missing = || {
        let ids = materials.iter().flat_map(|material| &material.ids.0).flatten();
        let known: Vec<String> = ids.map(i64::to_string).collect();
        let found = format!("tetrahedra with the id {id}, which no material has");
        let expected = format!(
            "one of the ids of materials ({}): set it by `volume_selection`, or by physical groups of the mesh",
            known.join(", ")
        );
        Problem::invalid(found, expected).at(&geometry.place())
    };
    material.map(|material| material.properties).ok_or_else(missing)
}
