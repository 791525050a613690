//! The reasons for which a motion is refused.

use crate::query::At;
use crate::values::Axis;

/// A pose or a motion is not one.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InvalidMotion {
    /// A component of a quaternion is infinite or not a number.
    #[error("component {component} of the quaternion{} is {value}, not a finite number", At(*.time))]
    Quaternion {
        /// The end of the step, 0 or 1; `None` for a pose.
        time: Option<usize>,
        /// The index of the component; 0 is the scalar.
        component: usize,
        /// The component.
        value: f64,
    },
    /// A quaternion is 0, which is no rotation.
    #[error("the quaternion{} is 0; a rotation is any other quaternion, of any length", At(*.time))]
    Zero {
        /// The end of the step, 0 or 1; `None` for a pose.
        time: Option<usize>,
    },
    /// The quaternion vanishes inside the step.
    #[error(
        "the quaternion vanishes in the step, because that at t = 1 is a negative multiple of that at t = 0; \
         take its opposite, which is the same rotation, or divide the step"
    )]
    Vanishes,
    /// A coordinate of a control point is infinite or not a number.
    #[error("coordinate {axis} of point {point} of control set {control} is {value}, not a finite number")]
    ControlPoint {
        /// The index of the set of control points, from 0.
        control: usize,
        /// The index of the point in it, from 0.
        point: usize,
        /// The axis of the coordinate.
        axis: Axis,
        /// The coordinate.
        value: f64,
    },
    /// A curve has a degree that is not supported.
    #[error("a curve with {count} control points; expected 2 to {most}, for degrees 1 to {}", .most - 1)]
    Degree {
        /// The number of control points.
        count: usize,
        /// The largest number.
        most: usize,
    },
    /// A chain has too many motions.
    #[error("a chain of {count} motions; expected at most {most}")]
    Length {
        /// The number of motions.
        count: usize,
        /// The largest number.
        most: usize,
    },
}
