//! From the description of a body to the body.

use std::path::Path;

use exact_ccd_files::Group;
use exact_ccd_sim::{Body, BodyKind, Region};

use super::description::{BodyDescription, RegionDescription};
use super::field_error::FieldError;
use super::mesh::Mesh;

/// A body, the groups of its mesh, and the facts about its file that could change an answer.
pub(super) struct Loaded {
    pub(super) body: Body,
    pub(super) groups: Vec<Group>,
    pub(super) notes: Vec<String>,
}

/// The described body.
pub(super) fn load(described: &BodyDescription, folder: &Path) -> Result<Loaded, FieldError> {
    let materials = described.materials();
    if let [first, second, ..] = materials[..] {
        let message = format!("the body has both `{first}` and `{second}`, expected at most one material");
        return Err(FieldError::new(second, message));
    }
    let Mesh {
        points,
        faces,
        edges,
        tetrahedra,
        groups,
        notes,
    } = mesh(described, folder)?;
    let regions = regions(&described.region, described.solid.is_some(), &groups)?;
    let cells = match (faces.is_empty(), edges.is_empty()) {
        (false, _) => "faces",
        (true, false) => "edges",
        (true, true) => "no edges",
    };
    let kind = if let Some(material) = described.solid {
        if tetrahedra.is_empty() {
            let message =
                "the mesh of the solid has no tetrahedra, expected a .msh file with tetrahedra or a box";
            return Err(FieldError::new("solid", message));
        }
        BodyKind::Solid {
            tetrahedra,
            material,
            regions,
        }
    } else if let Some(material) = described.rod {
        if cells != "edges" {
            let message = format!("the mesh of the rod has {cells}, expected edges only");
            return Err(FieldError::new("rod", message));
        }
        BodyKind::Rod { edges, material }
    } else if let Some(material) = described.particles {
        if cells != "no edges" {
            let message = "the mesh of the particles has faces or edges, expected points only";
            return Err(FieldError::new("particles", message));
        }
        BodyKind::Particles { material }
    } else if faces.is_empty() {
        let field = if described.shape.is_some() {
            "shape"
        } else {
            "mesh"
        };
        let message =
            "the mesh has no faces, expected some: edges alone need a `rod`, points alone `particles`";
        return Err(FieldError::new(field, message));
    } else if let Some(material) = described.shell {
        BodyKind::Shell { faces, material }
    } else if let Some(material) = described.affine {
        BodyKind::Affine { faces, material }
    } else {
        BodyKind::Obstacle { faces }
    };
    check_name(&described.name)?;
    let placement = described.placement();
    placement.check()?;
    let body = Body {
        name: described.name.clone(),
        points: placement.all(&points),
        kind,
        velocity: described.velocity,
        angular_velocity: described.angular_velocity,
        offset: described.offset,
    };
    Ok(Loaded { body, groups, notes })
}

/// Checks that a name has no control characters.
pub(super) fn check_name(name: &str) -> Result<(), FieldError> {
    if name.contains(char::is_control) {
        let message = format!("the name {name:?} has a control character, expected none");
        return Err(FieldError::new("name", message));
    }
    Ok(())
}

/// The described regions of a mesh with these groups.
fn regions(
    described: &[RegionDescription],
    is_solid: bool,
    groups: &[Group],
) -> Result<Vec<Region>, FieldError> {
    let region = |region: &RegionDescription| {
        if !is_solid {
            return Err(
                "only a solid has regions, expected `solid` with the material of the rest".to_owned(),
            );
        }
        let found = region.group.find(groups)?;
        let tetrahedra: Vec<u32> = found.iter().flat_map(|group| &group.cells).copied().collect();
        if tetrahedra.is_empty() {
            return Err("the group has no tetrahedra, expected a physical group of a volume".to_owned());
        }
        let material = region.solid;
        Ok(Region { tetrahedra, material })
    };
    let numbered = described.iter().enumerate();
    numbered
        .map(|(number, described)| {
            region(described).map_err(|message| FieldError::new(format!("region.{number}.group"), message))
        })
        .collect()
}

/// The mesh of a body, from its file or its shape.
fn mesh(described: &BodyDescription, folder: &Path) -> Result<Mesh, FieldError> {
    match (&described.mesh, described.shape) {
        (Some(path), None) => {
            let path = folder.join(path);
            let file = path.display();
            let mesh = if path.is_file() {
                Mesh::read(&path)
            } else if path.is_dir() {
                Err(format!("{file} is a folder, expected a mesh file"))
            } else {
                Err(format!(
                    "the file {file} does not exist: mesh files are read from the folder of the scene, \
                     or from that of `--meshes`"
                ))
            };
            mesh.map_err(|message| FieldError::new("mesh", message))
        }
        (None, Some(shape)) => Mesh::generate(shape).map_err(|message| FieldError::new("shape", message)),
        (Some(_), Some(_)) => {
            let message = "the body has both `mesh` and `shape`, expected one of them";
            Err(FieldError::new("shape", message))
        }
        (None, None) => {
            let message = "the body has no mesh, expected `mesh` with a file or `shape`";
            Err(FieldError::new("mesh", message))
        }
    }
}
