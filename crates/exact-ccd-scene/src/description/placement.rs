//! The placement of a mesh in the scene.

use exact_ccd_mesh::Point;
use exact_ccd_mesh::vector::{DIRECTION, has_direction};
use nalgebra::{Rotation3, Unit, UnitQuaternion, Vector3};
use serde::{Deserialize, Serialize};

use crate::field_error::FieldError;

/// A scaling, then a rotation, both about the origin, then a translation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Placement {
    /// The scaling.
    pub scale: Scale,
    /// The rotation.
    pub rotate: Option<Rotation>,
    /// The translation, in m.
    pub translate: Point,
}

/// The scale factors for x, y and z; in a file one number if they are equal.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(from = "Factors", into = "Factors")]
pub struct Scale(pub Point);

#[derive(Serialize, Deserialize)]
#[serde(untagged, expecting = "expected a number or three")]
enum Factors {
    Uniform(f64),
    Axes(Point),
}

/// A rotation about an axis through the origin.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Rotation {
    /// The direction of the axis.
    pub axis: Point,
    /// The angle. Positive angles are counterclockwise for a viewer at whom the axis points.
    pub degrees: f64,
}

impl Placement {
    /// The position in the scene of a point of the mesh. Without an axis, it is not rotated.
    pub fn apply(&self, point: Point) -> Point {
        let Scale(factors) = self.scale;
        let scaled = Vector3::from(point).component_mul(&Vector3::from(factors));
        let turn = self.rotate.and_then(|Rotation { axis, degrees }| {
            let axis = Unit::try_new(Vector3::from(axis), 0.0)?;
            Some(Rotation3::from_axis_angle(&axis, degrees.to_radians()))
        });
        let rotated = turn.map_or(scaled, |turn| turn * scaled);
        (rotated + Vector3::from(self.translate)).into()
    }

    /// The positions in the scene of the points of a mesh.
    pub fn all(&self, points: &[Point]) -> Vec<Point> {
        points.iter().map(|&point| self.apply(point)).collect()
    }

    /// The placement after a scaling of the scene about the origin, then a translation.
    pub fn then(self, factor: f64, translate: Vector3<f64>) -> Self {
        Self {
            scale: Scale(self.scale.0.map(|scale| scale * factor)),
            rotate: self.rotate,
            translate: (Vector3::from(self.translate) * factor + translate).into(),
        }
    }

    /// Checks that all numbers are finite, that no factor is 0, and that the axis has a direction.
    pub(crate) fn check(&self) -> Result<(), FieldError> {
        let Scale(factors) = self.scale;
        if !factors.iter().all(|factor| factor.is_normal()) {
            let message = format!("the scale factors are {factors:?}, expected finite numbers other than 0");
            return Err(FieldError::new("scale", message));
        }
        if let Some(Rotation { axis, degrees }) = self.rotate {
            if !has_direction(axis) {
                let message = format!("the axis is {axis:?}, expected {DIRECTION}");
                return Err(FieldError::new("rotate", message));
            }
            if !degrees.is_finite() {
                let message = format!("the angle is {degrees} degrees, expected a finite number");
                return Err(FieldError::new("rotate", message));
            }
        }
        let translation = self.translate;
        if translation.iter().any(|x| !x.is_finite()) {
            let message = format!("the translation is {translation:?}, expected finite numbers");
            return Err(FieldError::new("translate", message));
        }
        Ok(())
    }
}

impl Default for Scale {
    fn default() -> Self {
        Self([1.0; 3])
    }
}

impl From<Factors> for Scale {
    fn from(factors: Factors) -> Self {
        match factors {
            Factors::Uniform(factor) => Self([factor; 3]),
            Factors::Axes(factors) => Self(factors),
        }
    }
}

impl From<Scale> for Factors {
    fn from(Scale(factors): Scale) -> Self {
        let [x, y, z] = factors;
        if x == y && y == z {
            Self::Uniform(x)
        } else {
            Self::Axes(factors)
        }
    }
}

impl Rotation {
    /// The rotation about the axes in this order, each fixed in space, by angles in degrees. The first is
    /// applied last.
    pub fn about_axes(rotations: &[(Vector3<f64>, f64)]) -> Option<Self> {
        let mut turned = rotations.iter().filter(|(_, degrees)| *degrees != 0.0);
        let (axis, degrees) = match (turned.next(), turned.next()) {
            (None, _) => return None,
            (Some((axis, degrees)), None) => (*axis, *degrees),
            _ => {
                // Not a matrix, from which the axis of a half turn cannot be read.
                let turn =
                    |(axis, degrees): &(Vector3<f64>, f64)| UnitQuaternion::new(axis * degrees.to_radians());
                let turns = rotations.iter().map(turn);
                let (axis, angle) = turns
                    .fold(UnitQuaternion::identity(), |product, turn| product * turn)
                    .axis_angle()?;
                (axis.into_inner(), angle.to_degrees())
            }
        };
        let axis = axis.into();
        Some(Self { axis, degrees })
    }
}
