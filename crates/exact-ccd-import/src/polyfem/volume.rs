//! The ids of the tetrahedra of a body.

use exact_ccd_files::Group;
use exact_ccd_mesh::Point;

use super::boundary::Conditions;
use super::entry::Entry;
use super::material::{Material, of_id};
use crate::fault::Fault;
use exact_ccd_scene::Mesh;
use exact_ccd_scene::description::GroupKey;
use exact_ccd_scene::description::{BodyDescription, RegionDescription};

/// The ids of the tetrahedra of a body: one for each physical group of its mesh, and one for the rest.
pub(super) struct Volumes {
    /// The tags of the groups, and the ids of their tetrahedra.
    groups: Vec<(u32, i64)>,
    /// The id of the tetrahedra in no group; `None` if there are none.
    rest: Option<i64>,
}

impl Volumes {
    /// The ids that `volume_selection` of a geometry gives.
    pub(super) fn parse(geometry: &Entry<'_>, mesh: &Mesh) -> Result<Self, Fault> {
        let Some(selection) = geometry.get("volume_selection") else {
            return Self::of_mesh(geometry, mesh, 0);
        };
        let only = |key: &str| {
            let value = selection.get(key);
            value.filter(|_| selection.value.as_object().is_some_and(|keys| keys.len() == 1))
        };
        if let Some(offset) = only("id_offset") {
            return Self::of_mesh(geometry, mesh, offset.integer()?);
        }
        let id = only("id").unwrap_or_else(|| selection.clone()).value.as_i64();
        let Some(id) = id else {
            let instead = "write one number, or give physical groups to the mesh and remove the key";
            return Err(selection.unsupported("ids of cells by regions of space or by a file", instead));
        };
        Ok(Self {
            groups: Vec::new(),
            rest: Some(id),
        })
    }

    /// The physical tags of the tetrahedra plus an offset. Without a group, the tag is 0.
    fn of_mesh(geometry: &Entry<'_>, mesh: &Mesh, offset: i64) -> Result<Self, Fault> {
        let mut is_in_group = vec![false; mesh.tetrahedra.len()];
        let mut groups = Vec::new();
        let id = |tag: u32| i64::from(tag).saturating_add(offset);
        for Group { physical, cells, .. } in &mesh.groups {
            let Some(physical) = physical.filter(|_| !cells.is_empty()) else {
                continue;
            };
            for &cell in cells {
                if std::mem::replace(&mut is_in_group[cell as usize], true) {
                    let what = format!(
                        "a tetrahedron of several physical groups, as tetrahedron {cell} of the mesh"
                    );
                    return Err(geometry.unsupported(&what, "give each tetrahedron one physical group"));
                }
            }
            groups.push((physical.tag, id(physical.tag)));
        }
        let rest = is_in_group.contains(&false).then(|| id(0));
        Ok(Self { groups, rest })
    }

    fn ids(&self) -> impl Iterator<Item = i64> {
        let ids = self.groups.iter().map(|(_, id)| *id);
        self.rest.into_iter().chain(ids)
    }

    /// Gives a body the material of its first id, and a region for each group with another material.
    pub(super) fn add_materials(
        &self,
        materials: &[Material],
        geometry: &Entry<'_>,
        body: &mut BodyDescription,
    ) -> Result<(), Fault> {
        for id in self.ids().take(1) {
            body.solid = Some(of_id(id, materials, geometry)?);
        }
        for &(tag, id) in &self.groups {
            let solid = of_id(id, materials, geometry)?;
            if body.solid != Some(solid) {
                let group = GroupKey::Tag(tag);
                body.region.push(RegionDescription { group, solid });
            }
        }
        Ok(())
    }

    /// The initial velocity of the body.
    pub(super) fn velocity(&self, conditions: &Conditions<'_>, geometry: &Entry<'_>) -> Result<Point, Fault> {
        let mut velocities = self.ids().map(|id| conditions.velocity(id));
        let first = velocities.next().unwrap_or_default();
        if velocities.any(|velocity| velocity != first) {
            let instead = "give all its ids the same velocity";
            return Err(geometry.unsupported("a body of several initial velocities", instead));
        }
        Ok(first)
    }
}
