//! The layout of a vertex: one vector.

use crate::tables::Point;

/// The position of a vertex at both ends of the step, as x y z x | x y z x, in one cache line. A
/// rotation by one place aligns each coordinate with the next one of the same time.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(crate) struct Row(pub(super) [f64; 8]);

/// The places of the coordinates at t = 0 that are compared; the coordinates at t = 1 are four places above.
pub(super) const PLACES: u64 = 0b0111;

impl Row {
    pub(crate) fn new([x0, y0, z0]: Point, [x1, y1, z1]: Point) -> Self {
        Self([x0, y0, z0, x0, x1, y1, z1, x1])
    }

    pub(crate) fn points(&self) -> [Point; 2] {
        let [x0, y0, z0, _, x1, y1, z1, _] = self.0;
        [[x0, y0, z0], [x1, y1, z1]]
    }

    pub(crate) fn is_finite(&self) -> bool {
        self.0.iter().fold(true, |all, x| all & x.is_finite())
    }
}
