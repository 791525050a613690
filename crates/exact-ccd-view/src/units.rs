//! The units in which a page has positions.

use exact_ccd_mesh::{Aabb, Point};

/// Positions are center + scale · x, with x in single precision.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Units {
    pub(crate) center: Point,
    pub(crate) scale: f64,
}

/// The largest coordinate in these units: its square is a single-precision number.
const MOST: f64 = 1e18;

impl Units {
    /// The units in which the longest side of a box is 2. No operation overflows: halves are taken
    /// before sums and differences.
    pub(crate) fn of(bounds: &Aabb) -> Self {
        let half = |axis: usize| (0.5 * bounds.lower[axis], 0.5 * bounds.upper[axis]);
        let center = [0, 1, 2].map(|axis| half(axis).0 + half(axis).1);
        let radius = (0..3).map(|axis| half(axis).1 - half(axis).0).fold(0.0, f64::max);
        let is_box = radius.is_finite() && center.iter().all(|x| x.is_finite());
        Self {
            center: if is_box { center } else { [0.0; 3] },
            scale: if is_box && radius > 0.0 { radius } else { 1.0 },
        }
    }

    /// A length in these units.
    pub(crate) fn convert_length(&self, length: f64) -> f32 {
        (length / self.scale).clamp(0.0, MOST) as f32
    }

    /// A position in these units. Coordinates far outside of the box are moved to its surroundings.
    pub(crate) fn convert(&self, position: Point) -> [f32; 3] {
        [0, 1, 2].map(|axis| {
            let offset = position[axis] - self.center[axis];
            (offset / self.scale).clamp(-MOST, MOST) as f32
        })
    }
}
