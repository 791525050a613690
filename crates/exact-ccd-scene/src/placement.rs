//! The placement of a mesh in the scene.

use exact_ccd_mesh::Point;
use nalgebra::{Rotation3, Unit, Vector3};
use serde::{Deserialize, Serialize};

/// A scale factor for all axes, or one for each axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged, expecting = "expected a number or three")]
pub(super) enum Scale {
    /// One factor for all axes.
    Uniform(f64),
    /// The factors for x, y and z.
    Axes(Point),
}

impl Scale {
    pub(super) fn factors(self) -> Point {
        match self {
            Self::Uniform(factor) => [factor; 3],
            Self::Axes(factors) => factors,
        }
    }

    /// A scaled point.
    pub(super) fn apply(self, point: Point) -> Vector3<f64> {
        Vector3::from(point).component_mul(&Vector3::from(self.factors()))
    }

    /// True if every factor is a normal number.
    pub(super) fn is_valid(self) -> bool {
        self.factors().iter().all(|factor| factor.is_normal())
    }
}

impl Default for Scale {
    fn default() -> Self {
        Self::Uniform(1.0)
    }
}

/// A rotation about an axis through the origin.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(super) struct Rotation {
    /// The direction of the axis.
    pub(super) axis: Point,
    /// The angle. Positive angles are counterclockwise for a viewer at whom the axis points.
    pub(super) degrees: f64,
}

impl Rotation {
    /// A rotated point. Without an axis, it stays.
    pub(super) fn apply(&self, point: Vector3<f64>) -> Vector3<f64> {
        match Unit::try_new(Vector3::from(self.axis), 0.0) {
            None => point,
            Some(axis) => Rotation3::from_axis_angle(&axis, self.degrees.to_radians()) * point,
        }
    }

    /// True if the axis has a direction.
    pub(super) fn has_axis(&self) -> bool {
        Vector3::from(self.axis).norm().is_normal()
    }
}
