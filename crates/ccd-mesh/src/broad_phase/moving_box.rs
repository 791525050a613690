//! Boxes that move, in single precision.

use exact_ccd::Point;

use crate::bounds::Bounds;

/// A box at both ends of a step; in between, its sides move in straight lines at constant speed.
///
/// Coordinates are rounded to single precision, which takes half of the memory traffic. Rounding is monotone: what is not
/// greater before it is not greater after it. So boxes that meet still do, whichever way they were rounded.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(crate) struct MovingBox {
    /// The least coordinates at t = 0 and at t = 1, as x y z and an unused place each.
    pub(super) lower: [f32; 8],
    /// The greatest.
    pub(super) upper: [f32; 8],
}

impl MovingBox {
    pub(crate) const EMPTY: Self = Self {
        lower: [f32::INFINITY; 8],
        upper: [f32::NEG_INFINITY; 8],
    };

    /// The box from its places at t = 0 and at t = 1, seen from an origin.
    #[inline]
    pub(crate) fn new(ends: [Bounds; 2], origin: Point) -> Self {
        let round = |[x0, y0, z0]: Point, [x1, y1, z1]: Point| {
            let [x, y, z] = origin;
            [x0 - x, y0 - y, z0 - z, 0.0, x1 - x, y1 - y, z1 - z, 0.0].map(|x| x as f32)
        };
        let [start, end] = ends;
        Self {
            lower: round(start.lower, end.lower),
            upper: round(start.upper, end.upper),
        }
    }

    /// The smallest box around two boxes at all times.
    #[inline(always)]
    pub(crate) fn union(&self, other: &Self) -> Self {
        let mut union = *self;
        for place in 0..8 {
            // Not f32::min and max: their care for NaN costs, and there is none here.
            let (a, b) = (self.lower[place], other.lower[place]);
            union.lower[place] = if b < a { b } else { a };
            let (a, b) = (self.upper[place], other.upper[place]);
            union.upper[place] = if b > a { b } else { a };
        }
        union
    }

    /// Where the box is at t = 0 and at t = 1, rounded.
    pub(super) fn ends(&self) -> [Bounds; 2] {
        let at = |row: &[f32; 8], time: usize| [0, 1, 2].map(|axis| f64::from(row[4 * time + axis]));
        [0, 1].map(|time| Bounds {
            lower: at(&self.lower, time),
            upper: at(&self.upper, time),
        })
    }
}
