//! The numbers to which the positions at the end of a free step are rounded.

use exact_ccd::Point;

/// The format of the positions that a free step returns. The certificate is about them, as they are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Precision {
    /// Double precision: every position is as it was computed.
    #[default]
    Double,
    /// Single precision: every coordinate is the `f32` nearest to the computed one, for solvers that store
    /// positions so. The positions at the start must be `f32`, too.
    ///
    /// Rounding moves a vertex by up to half a unit in its last place. Where this alone makes contact, the
    /// step is smaller, and its size 0 if no smaller one helps.
    Single,
}

impl Precision {
    /// A position in this format. A coordinate beyond the range of `f32` becomes the greatest or the least
    /// `f32`.
    #[must_use]
    pub fn round(self, position: Point) -> Point {
        let largest = f64::from(f32::MAX);
        match self {
            Self::Double => position,
            Self::Single => position.map(|x| f64::from(x.clamp(-largest, largest) as f32)),
        }
    }

    /// The first position that is not in this format.
    pub(super) fn first_other(self, positions: &[Point]) -> Option<usize> {
        let is_other = |&position: &Point| self.round(position) != position;
        match self {
            Self::Double => None,
            Self::Single => positions.iter().position(is_other),
        }
    }

    /// The positions in this format.
    pub(super) fn rounded(self, mut positions: Vec<Point>) -> Vec<Point> {
        if self == Self::Single {
            for position in &mut positions {
                *position = self.round(*position);
            }
        }
        positions
    }

    /// The number of places by which a size falls first, as `f64`: a part of the step that may change rounded
    /// positions.
    pub(super) fn first_retreat(self) -> u64 {
        match self {
            Self::Double => 1,
            Self::Single => 1 << (f64::MANTISSA_DIGITS - f32::MANTISSA_DIGITS),
        }
    }
}
