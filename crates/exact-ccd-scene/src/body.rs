//! From the description of a body to the body.

use std::path::Path;

use exact_ccd_files::Group;

use super::description::BodyDescription;
use super::mesh::Mesh;
use exact_ccd_sim::{Body, BodyKind};

/// The described body, without its regions, and the groups of its mesh; or the invalid field with a message.
pub(super) fn load(
    described: &BodyDescription,
    folder: &Path,
) -> Result<(Body, Vec<Group>), (&'static str, String)> {
    if let [first, second, ..] = described.materials()[..] {
        return Err((
            second,
            format!("the body has both `{first}` and `{second}`, expected at most one material"),
        ));
    }
    let Mesh {
        points,
        faces,
        edges,
        tetrahedra,
        groups,
    } = mesh(described, folder)?;
    let kind = if let Some(material) = described.solid {
        if tetrahedra.is_empty() {
            let message =
                "the mesh of the solid has no tetrahedra, expected a .msh file with tetrahedra or a box";
            return Err(("solid", message.to_owned()));
        }
        BodyKind::Solid {
            tetrahedra,
            material,
            regions: Vec::new(),
        }
    } else if let Some(material) = described.rod {
        if let Some(cells) = other_than_edges(&faces, &edges) {
            let message = format!("the mesh of the rod has {cells}, expected edges only");
            return Err(("rod", message));
        }
        BodyKind::Rod { edges, material }
    } else if let Some(material) = described.particles {
        if !faces.is_empty() || !edges.is_empty() {
            let message = "the mesh of the particles has faces or edges, expected points only";
            return Err(("particles", message.to_owned()));
        }
        BodyKind::Particles { material }
    } else if let Some(material) = described.shell {
        BodyKind::Shell { faces, material }
    } else {
        BodyKind::Obstacle { faces }
    };
    check_placement(described)?;
    let points = points.into_iter().map(|point| described.place(point)).collect();
    let velocity = described.velocity;
    let body = Body {
        name: described.name.clone(),
        points,
        kind,
        velocity,
        angular_velocity: described.angular_velocity,
        offset: described.offset,
    };
    Ok((body, groups))
}

/// The cells of a mesh that a rod cannot have, in words.
fn other_than_edges(faces: &[[u32; 3]], edges: &[[u32; 2]]) -> Option<&'static str> {
    if !faces.is_empty() {
        Some("faces")
    } else if edges.is_empty() {
        Some("no edges")
    } else {
        None
    }
}

/// The mesh of a body, from its file or its shape.
fn mesh(described: &BodyDescription, folder: &Path) -> Result<Mesh, (&'static str, String)> {
    match (&described.mesh, described.shape) {
        (Some(path), None) => {
            let path = folder.join(path);
            if !path.is_file() {
                let file = path.display();
                let message = if path.is_dir() {
                    format!("{file} is a folder, expected a mesh file")
                } else {
                    format!(
                        "the file {file} does not exist: mesh files are read from the folder of the scene, \
                         or from that of `--meshes`"
                    )
                };
                return Err(("mesh", message));
            }
            Mesh::read(&path).map_err(|message| ("mesh", message))
        }
        (None, Some(shape)) => Mesh::generate(shape).map_err(|message| ("shape", message)),
        (Some(_), Some(_)) => Err((
            "shape",
            "the body has both `mesh` and `shape`, expected one of them".to_owned(),
        )),
        (None, None) => Err((
            "mesh",
            "the body has no mesh, expected `mesh` with a file or `shape`".to_owned(),
        )),
    }
}

/// Checks `scale`, `rotate` and `translate`.
fn check_placement(described: &BodyDescription) -> Result<(), (&'static str, String)> {
    if !described.scale.is_valid() {
        let factors = described.scale.factors();
        let message = format!("the scale factors are {factors:?}, expected finite numbers other than 0");
        return Err(("scale", message));
    }
    if let Some(rotation) = described.rotate {
        if !rotation.has_axis() {
            let axis = rotation.axis;
            let message = format!("the axis is {axis:?}, expected a vector of positive length");
            return Err(("rotate", message));
        }
        if !rotation.degrees.is_finite() {
            let degrees = rotation.degrees;
            return Err((
                "rotate",
                format!("the angle is {degrees} degrees, expected a finite number"),
            ));
        }
    }
    let translation = described.translate;
    if translation.iter().any(|x| !x.is_finite()) {
        let message = format!("the translation is {translation:?}, expected finite numbers");
        return Err(("translate", message));
    }
    Ok(())
}
