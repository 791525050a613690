//! Half spaces that a page draws.

use exact_ccd_mesh::Point;
use exact_ccd_mesh::vector::unit;
use serde::Serialize;

/// All x with n · (x − p) ≤ 0, in the shape of the JSON object.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct ShownHalfSpace {
    name: String,
    point: Point,
    /// The unit normal of the boundary, which points outward.
    pub(crate) normal: Point,
}

impl ShownHalfSpace {
    /// The half space, or `None` if its point or its normal is not finite, or the normal is zero.
    pub(crate) fn new(name: String, point: Point, normal: Point) -> Option<Self> {
        let normal = unit(normal)?;
        let is_finite = point.iter().all(|x| x.is_finite());
        is_finite.then_some(Self { name, point, normal })
    }

    /// The point of the boundary nearest to a point, for the eye.
    pub(crate) fn foot(&self, x: Point) -> Point {
        let height: f64 = (0..3)
            .map(|axis| self.normal[axis] * (x[axis] - self.point[axis]))
            .sum();
        let foot = [0, 1, 2].map(|axis| x[axis] - height * self.normal[axis]);
        if foot.iter().all(|x| x.is_finite()) {
            foot
        } else {
            x
        }
    }
}
