//! The placement of meshes.

use nalgebra::Vector3;

use super::super::fault::{Fault, Place};
use super::super::pose::{Pose, about_axes};
use super::entry::{Entry, Rule};
use crate::placement::Rotation;

/// `transformation`, for a mesh with a box of this size.
pub(super) fn pose(
    entry: &Entry<'_>,
    size: &Vector3<f64>,
    notes: &mut Vec<(Place, String)>,
) -> Result<Pose, Fault> {
    let rules = [
        ("translation", Rule::Said),
        ("rotation", Rule::Said),
        ("rotation_mode", Rule::Said),
        ("scale", Rule::Said),
        ("dimensions", Rule::Said),
    ];
    entry.check(&rules, notes)?;
    let vector = |key: &str, default: Vector3<f64>| match entry.get(key) {
        None => Ok(default),
        Some(value) if value.value.as_array().is_some_and(Vec::is_empty) => Ok(default),
        Some(value) if key == "scale" && value.value.is_number() => {
            Ok(Vector3::from_element(value.number()?))
        }
        Some(value) => value.point().map(Vector3::from),
    };
    let scale = match entry
        .get("dimensions")
        .filter(|dimensions| dimensions.value.is_array())
    {
        // The factor of an axis along which the mesh is flat does not matter.
        Some(dimensions) => {
            let dimensions = Vector3::from(dimensions.point()?);
            dimensions.zip_map(size, |length, size| if size == 0.0 { 1.0 } else { length / size })
        }
        None => vector("scale", Vector3::from_element(1.0))?,
    };
    Ok(Pose {
        scale,
        rotation: rotation(entry)?,
        translation: vector("translation", Vector3::zeros())?,
    })
}

fn rotation(entry: &Entry<'_>) -> Result<Option<Rotation>, Fault> {
    let Some(angles) = entry
        .get("rotation")
        .filter(|angles| angles.value.as_array().is_none_or(|list| !list.is_empty()))
    else {
        return Ok(None);
    };
    let mode = entry.get("rotation_mode");
    let mode = mode.as_ref().map_or(Ok("xyz"), Entry::text)?.to_ascii_lowercase();
    let numbers: Result<Vec<f64>, Fault> = angles.list().iter().map(Entry::number).collect();
    match (mode.as_str(), &numbers?[..]) {
        ("axis_angle", &[degrees, x, y, z]) => Ok(Some(Rotation {
            axis: [x, y, z],
            degrees,
        })),
        ("rotation_vector", &[x, y, z]) => {
            let degrees = Vector3::new(x, y, z).norm();
            let axis = [x, y, z];
            Ok((degrees != 0.0).then_some(Rotation { axis, degrees }))
        }
        ("quaternion", &[x, y, z, w]) => {
            let degrees = 2.0 * Vector3::new(x, y, z).norm().atan2(w).to_degrees();
            let axis = [x, y, z];
            Ok((degrees != 0.0).then_some(Rotation { axis, degrees }))
        }
        (mode, angles) if mode.len() == angles.len() && mode.chars().all(|axis| "xyz".contains(axis)) => {
            let axis = |name| Vector3::ith("xyz".find(name).unwrap_or(0), 1.0);
            let mut turns: Vec<(Vector3<f64>, f64)> =
                mode.chars().map(axis).zip(angles.iter().copied()).collect();
            turns.reverse();
            Ok(about_axes(&turns))
        }
        _ => {
            Err(angles
                .invalid("the angles in degrees of the axes of `rotation_mode`, three if it is not given"))
        }
    }
}
