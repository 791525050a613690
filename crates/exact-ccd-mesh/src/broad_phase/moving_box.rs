//! Boxes that move, in single precision.

use exact_ccd::Point;

use crate::bounds::Bounds;

/// A box at both ends of a step (T = 2), where in between its sides move in straight lines at constant speed, or one that
/// rests (T = 1).
///
/// Coordinates are rounded to single precision, which takes half of the memory traffic. Rounding is monotone: what is not
/// greater before it is not greater after it. So boxes that meet still do, whichever way they were rounded.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub(crate) struct MovingBox<const T: usize> {
    /// The least coordinates at each time, as x y z and an unused place.
    pub(super) lower: [[f32; 4]; T],
    /// The greatest.
    pub(super) upper: [[f32; 4]; T],
}

impl<const T: usize> MovingBox<T> {
    pub(crate) const EMPTY: Self = Self {
        lower: [[f32::INFINITY; 4]; T],
        upper: [[f32::NEG_INFINITY; 4]; T],
    };

    /// The box from its places at each time, seen from an origin.
    #[inline]
    pub(crate) fn new(places: [Bounds; T], origin: Point) -> Self {
        let [x0, y0, z0] = origin;
        let round = |[x, y, z]: Point| [x - x0, y - y0, z - z0, 0.0].map(|x| x as f32);
        Self {
            lower: places.map(|place| round(place.lower)),
            upper: places.map(|place| round(place.upper)),
        }
    }

    /// The smallest box around two boxes at all times.
    #[inline(always)]
    pub(crate) fn union(&self, other: &Self) -> Self {
        let mut union = *self;
        for time in 0..T {
            for place in 0..4 {
                // Not f32::min and max: their care for NaN costs, and there is none here.
                let (a, b) = (self.lower[time][place], other.lower[time][place]);
                union.lower[time][place] = if b < a { b } else { a };
                let (a, b) = (self.upper[time][place], other.upper[time][place]);
                union.upper[time][place] = if b > a { b } else { a };
            }
        }
        union
    }

    /// Where the box is at each time, rounded.
    pub(super) fn places(&self) -> [Bounds; T] {
        let point = |[x, y, z, _]: [f32; 4]| [x, y, z].map(f64::from);
        core::array::from_fn(|time| Bounds {
            lower: point(self.lower[time]),
            upper: point(self.upper[time]),
        })
    }
}
