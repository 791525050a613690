//! F at the corners of its domain, scaled by a power of two.

use crate::filter::hull::Hull;
use crate::numbers::vector::scaled;
use crate::tables::Point;

/// Corners scaled so that the largest component is in [1/2, 1).
///
/// Scaling is exact, except that it may be off by 2⁻¹⁰⁷⁵ where the result is subnormal.
pub(super) struct Scaled {
    pub(super) factor: f64,
    /// F at t = 0 and at t = 1, each component rounded once.
    pub(super) at: [[Point; 4]; 2],
    /// The largest magnitude of a component on each axis.
    pub(super) reach: Point,
    /// d, scaled.
    pub(super) d: f64,
}

impl Scaled {
    /// The corners and d; `None` if they are out of range.
    pub(super) fn new(hull: &Hull<f64>, d: f64) -> Option<Self> {
        const RANGE: i64 = 1000;
        let reaches = hull.reaches();
        let reach = reaches
            .into_iter()
            .fold(0.0, |a: f64, b| if b > a { b } else { a });
        let exponent = (reach.to_bits() >> 52) as i64 - 1022;
        if !(-RANGE..=RANGE).contains(&exponent) {
            return None;
        }
        let factor = f64::from_bits(((1023 - exponent) as u64) << 52);
        Some(Self {
            factor,
            at: [0, 1].map(|time| hull.corners(time).map(|corner| scaled(corner, factor))),
            reach: scaled(reaches, factor),
            d: d * factor,
        })
    }
}
