//! The placement of meshes by rotation matrices.

use exact_ccd_mesh::{Aabb, Point};
use nalgebra::{Rotation3, Unit, Vector3};

use crate::description::BodyDescription;
use crate::placement::{Rotation, Scale};

/// A scaling, then a rotation, both about the origin, then a translation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pose {
    pub(super) scale: Vector3<f64>,
    /// `None` for no rotation.
    pub(super) rotation: Option<Rotation>,
    pub(super) translation: Vector3<f64>,
}

impl Pose {
    pub(super) const IDENTITY: Self = Self {
        scale: Vector3::new(1.0, 1.0, 1.0),
        rotation: None,
        translation: Vector3::new(0.0, 0.0, 0.0),
    };

    /// The pose after a scaling of the scene about the origin, then a translation.
    pub(super) fn then(self, factor: f64, translation: Vector3<f64>) -> Self {
        Self {
            scale: self.scale * factor,
            rotation: self.rotation,
            translation: self.translation * factor + translation,
        }
    }

    /// Places a body.
    pub(super) fn apply(self, body: &mut BodyDescription) {
        let [x, y, z] = self.scale.into();
        body.scale = if x == y && y == z {
            Scale::Uniform(x)
        } else {
            Scale::Axes([x, y, z])
        };
        body.rotate = self.rotation;
        body.translate = self.translation.into();
    }
}

/// The rotation about the axes in this order, each fixed in space, by angles in degrees. The first is applied
/// last.
pub(super) fn about_axes(rotations: &[(Vector3<f64>, f64)]) -> Option<Rotation> {
    let mut turned = rotations.iter().filter(|(_, degrees)| *degrees != 0.0);
    match (turned.next(), turned.next()) {
        (None, _) => None,
        (Some((axis, degrees)), None) => Some(Rotation {
            axis: (*axis).into(),
            degrees: *degrees,
        }),
        _ => of_matrix(
            &rotations
                .iter()
                .fold(Rotation3::identity(), |matrix, (axis, degrees)| {
                    matrix * Rotation3::new(axis * degrees.to_radians())
                }),
        ),
    }
}

/// A rotation matrix as an axis and an angle.
pub(super) fn of_matrix(matrix: &Rotation3<f64>) -> Option<Rotation> {
    let (axis, angle): (Unit<Vector3<f64>>, f64) = matrix.axis_angle()?;
    Some(Rotation {
        axis: axis.into_inner().into(),
        degrees: angle.to_degrees(),
    })
}

/// The center of the bounding box of some points.
pub(super) fn box_center(points: impl IntoIterator<Item = Point>) -> Point {
    let Aabb { lower, upper } = points.into_iter().collect();
    core::array::from_fn(|axis| 0.5 * (lower[axis] + upper[axis]))
}
