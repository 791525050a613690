//! The placement of meshes.

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use super::entry::{Entry, Rule};
use crate::fault::Fault;
use exact_ccd_scene::description::{Placement, Rotation, Scale};

/// `transformation`, for a mesh with a box of these sides.
pub(super) fn placement(entry: &Entry<'_>, sides: Point) -> Result<Placement, Fault> {
    entry.check(&[("translation rotation rotation_mode scale dimensions", Rule::Said)])?;
    let dimensions = entry
        .get("dimensions")
        .filter(|dimensions| dimensions.value.is_array());
    let scale = match (dimensions, entry.get_filled("scale")) {
        (Some(dimensions), _) => {
            let lengths = dimensions.point()?;
            // The factor of an axis along which the mesh is flat does not matter.
            let factor = |axis: usize| {
                if sides[axis] == 0.0 {
                    1.0
                } else {
                    lengths[axis] / sides[axis]
                }
            };
            [0, 1, 2].map(factor)
        }
        (None, Some(scale)) if scale.value.is_number() => [scale.number()?; 3],
        (None, Some(scale)) => scale.point()?,
        (None, None) => [1.0; 3],
    };
    let translation = entry.get_filled("translation");
    Ok(Placement {
        scale: Scale(scale),
        rotate: rotation(entry)?,
        translate: translation.map_or(Ok([0.0; 3]), |translation| translation.point())?,
    })
}

fn rotation(entry: &Entry<'_>) -> Result<Option<Rotation>, Fault> {
    let Some(angles) = entry.get_filled("rotation") else {
        return Ok(None);
    };
    let mode = entry.get("rotation_mode");
    let mode = mode.as_ref().map_or(Ok("xyz"), Entry::text)?.to_ascii_lowercase();
    let numbers: Result<Vec<f64>, Fault> = angles.list().iter().map(Entry::number).collect();
    let turn = |axis, degrees| (degrees != 0.0).then_some(Rotation { axis, degrees });
    match (mode.as_str(), &numbers?[..]) {
        ("axis_angle", &[degrees, x, y, z]) => Ok(Some(Rotation {
            axis: [x, y, z],
            degrees,
        })),
        ("rotation_vector", &[x, y, z]) => Ok(turn([x, y, z], Vector3::new(x, y, z).norm())),
        ("quaternion", &[x, y, z, w]) => {
            let half = Vector3::new(x, y, z).norm().atan2(w);
            Ok(turn([x, y, z], (2.0 * half).to_degrees()))
        }
        (mode, angles) if mode.len() == angles.len() && mode.chars().all(|axis| "xyz".contains(axis)) => {
            let axis = |name| Vector3::ith("xyz".find(name).unwrap_or(0), 1.0);
            let mut turns: Vec<(Vector3<f64>, f64)> =
                mode.chars().map(axis).zip(angles.iter().copied()).collect();
            turns.reverse();
            Ok(Rotation::about_axes(&turns))
        }
        _ => {
            Err(angles
                .invalid("the angles in degrees of the axes of `rotation_mode`, three if it is not given"))
        }
    }
}
