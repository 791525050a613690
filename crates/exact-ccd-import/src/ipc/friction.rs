//! Friction of obstacles.

use super::file::File;
use crate::notes::Notes;
use exact_ccd_mesh::HalfSpace;
use exact_ccd_scene::description::BodyDescription;
use exact_ccd_sim::FrictionPair;

/// The name of all shapes of a file in which obstacles have other friction coefficients.
const SHAPES: &str = "shapes";

/// The friction coefficients that differ from the coefficient between shapes. Names the bodies and half
/// spaces to which they belong. `bodies` are the shapes of the file, then its obstacles.
///
/// IPC computes the friction between shapes and on half spaces (`computeEnergyVal` in `Optimizer.cpp`). The
/// coefficient of a mesh of `meshCO` has no effect there.
pub(super) fn pairs(
    file: &File,
    bodies: &mut [BodyDescription],
    half_spaces: &mut [HalfSpace],
    notes: &Notes,
) -> Vec<FrictionPair> {
    for obstacle in file.obstacles.iter().filter(|obstacle| obstacle.friction > 0.0) {
        let message = "contact with this mesh is frictionless, as in IPC, which does not use the coefficient";
        notes.add(obstacle.place.clone(), message);
    }
    let (shapes, obstacles) = bodies.split_at_mut(file.shapes.len().min(bodies.len()));
    if shapes.is_empty() {
        return Vec::new();
    }
    let meshes = obstacles.iter_mut().map(|obstacle| (&mut obstacle.name, 0.0));
    let meshes = (1..)
        .zip(meshes)
        .map(|(number, mesh)| (format!("mesh-{number}"), mesh));
    let planes = half_spaces.iter_mut().map(|plane| &mut plane.name);
    let planes = planes.zip(file.planes.iter().map(|(_, friction)| *friction));
    let planes = (1..)
        .zip(planes)
        .map(|(number, plane)| (format!("half-space-{number}"), plane));
    let different = meshes
        .chain(planes)
        .filter(|(_, (_, coefficient))| *coefficient != file.settings.friction.coefficient);
    let pairs: Vec<FrictionPair> = different
        .map(|(name, (named, coefficient))| {
            name.clone_into(named);
            FrictionPair {
                between: [SHAPES.to_owned(), name],
                coefficient,
            }
        })
        .collect();
    if !pairs.is_empty() {
        shapes
            .iter_mut()
            .for_each(|shape| SHAPES.clone_into(&mut shape.name));
    }
    pairs
}
