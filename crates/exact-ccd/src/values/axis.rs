//! The axes of space.

use core::fmt;

/// An axis of space.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[expect(missing_docs, reason = "the names are self-explanatory")]
pub enum Axis {
    X,
    Y,
    Z,
}

impl Axis {
    /// All axes, in the order of the coordinates.
    pub const ALL: &'static [Self] = &[Self::X, Self::Y, Self::Z];

    /// The index of the coordinate along this axis: 0, 1 or 2.
    #[must_use]
    pub fn index(self) -> usize {
        self as usize
    }
}

impl fmt::Display for Axis {
    /// Writes x, y or z.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
        })
    }
}
