//! The instances of a mesh in one node: `EXT_mesh_gpu_instancing`.

use super::accessor::Accessors;
use super::document::InstanceAttributes;
use super::transform::Transform;
use crate::error::Fault;

/// The transform of each instance within its node.
pub(super) fn read(attributes: &InstanceAttributes, accessors: &Accessors) -> Result<Vec<Transform>, Fault> {
    const EXPECTED: &str = "numbers of instances";
    let translations = attributes
        .translation
        .map(|at| accessors.vectors(at, "VEC3", EXPECTED));
    let rotations = attributes
        .rotation
        .map(|at| accessors.vectors(at, "VEC4", EXPECTED));
    let scales = attributes.scale.map(|at| accessors.vectors(at, "VEC3", EXPECTED));
    let (translations, rotations, scales) = (
        translations.transpose()?,
        rotations.transpose()?,
        scales.transpose()?,
    );
    let counts = [
        translations.as_ref().map(Vec::len),
        rotations.as_ref().map(Vec::len),
        scales.as_ref().map(Vec::len),
    ];
    let mut counts = counts.into_iter().flatten();
    let count = counts.next().unwrap_or(0);
    if let Some(other) = counts.find(|other| *other != count) {
        let expected = format!("{count} instances in each attribute of EXT_mesh_gpu_instancing");
        return Err(Fault::expected(expected, other.to_string()));
    }
    let of = |k: usize| {
        let translation = translations.as_ref().map_or([0.0; 3], |all| all[k]);
        let rotation = rotations.as_ref().map_or([0.0, 0.0, 0.0, 1.0], |all| all[k]);
        Transform::of_parts(
            translation,
            rotation,
            scales.as_ref().map_or([1.0; 3], |all| all[k]),
        )
    };
    Ok((0..count).map(of).collect())
}
