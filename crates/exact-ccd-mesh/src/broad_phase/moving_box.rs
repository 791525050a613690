//! Boxes that move, in single precision.

use exact_ccd::Point;

use crate::aabb::Aabb;

/// A box at both ends of a step, whose sides move at constant speed in between (T = 2), or a box at
/// rest (T = 1).
///
/// Coordinates are rounded to single precision, which halves the memory traffic. Rounding is
/// monotone: a number that is not greater than another before rounding is not greater after it. So
/// boxes that meet still meet, in any rounding mode.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub(crate) struct MovingBox<const T: usize> {
    /// The least coordinates at each time, as x, y, z and a place for alignment.
    pub(super) lower: [[f32; 4]; T],
    /// The greatest coordinates at each time.
    pub(super) upper: [[f32; 4]; T],
}

impl<const T: usize> MovingBox<T> {
    pub(crate) const EMPTY: Self = Self {
        lower: [[f32::INFINITY; 4]; T],
        upper: [[f32::NEG_INFINITY; 4]; T],
    };

    /// The box from its places at each time, relative to an origin.
    #[inline]
    pub(crate) fn new(places: [Aabb; T], origin: Point) -> Self {
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
                // Not f32::min and max: their handling of NaN costs time, and there is no NaN here.
                let (a, b) = (self.lower[time][place], other.lower[time][place]);
                union.lower[time][place] = if b < a { b } else { a };
                let (a, b) = (self.upper[time][place], other.upper[time][place]);
                union.upper[time][place] = if b > a { b } else { a };
            }
        }
        union
    }

    /// The rounded box at each time.
    pub(super) fn places(&self) -> [Aabb; T] {
        let point = |[x, y, z, _]: [f32; 4]| [x, y, z].map(f64::from);
        core::array::from_fn(|time| Aabb {
            lower: point(self.lower[time]),
            upper: point(self.upper[time]),
        })
    }
}
