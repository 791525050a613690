//! The corners with positive and with negative coordinates.

use exact_ccd::Point;

/// The corners with positive and with negative coordinates, as sets of bits by axis.
#[derive(Clone, Copy)]
pub(super) struct Signs {
    positive: [u8; 3],
    negative: [u8; 3],
}

impl Signs {
    /// The corners of these differences of two points. Comparisons are exact.
    #[inline]
    pub(super) fn new(pairs: &[[Point; 2]; 8]) -> Self {
        let mut signs = Self {
            positive: [0; 3],
            negative: [0; 3],
        };
        for (index, [minuend, subtrahend]) in pairs.iter().enumerate() {
            for axis in 0..3 {
                signs.positive[axis] |= u8::from(minuend[axis] > subtrahend[axis]) << index;
                signs.negative[axis] |= u8::from(minuend[axis] < subtrahend[axis]) << index;
            }
        }
        signs
    }

    /// Returns true if the bounding box of the corners that are listed excludes the origin.
    #[inline]
    pub(super) fn exclude_origin(&self, corners: &[usize]) -> bool {
        let mask = mask(corners);
        (0..3).fold(false, |excluded, axis| {
            excluded | (self.positive[axis] & mask == mask) | (self.negative[axis] & mask == mask)
        })
    }

    /// Returns true if that box excludes a ray whose coordinates are not negative or, if it is the x axis,
    /// all but x are zero.
    #[inline]
    pub(super) fn exclude_ray(&self, is_axis: bool, corners: &[usize]) -> bool {
        let mask = mask(corners);
        let is_behind = self.negative.map(|negative| negative & mask == mask) != [false; 3];
        let [_, y, z] = self.positive.map(|positive| positive & mask == mask);
        is_behind | (is_axis & (y | z))
    }
}

#[inline]
fn mask(corners: &[usize]) -> u8 {
    corners.iter().fold(0, |mask, corner| mask | 1 << corner)
}
