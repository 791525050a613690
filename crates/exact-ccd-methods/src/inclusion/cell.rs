//! Boxes in the domain of F.

use crate::interval::Enclosure;

/// The box of the intervals `[lower, lower + width]` in [0, 1]ᴺ, whose first axis is time.
///
/// Widths are powers of two, not less than [`MIN_WIDTH`](Self::MIN_WIDTH), and lower ends are
/// multiples of them: both ends are exact, and a box shares them with its neighbours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Cell<const N: usize> {
    pub(crate) lower: [f64; N],
    pub(crate) width: [f64; N],
}

impl<const N: usize> Cell<N> {
    pub(crate) const WHOLE: Self = Self {
        lower: [0.0; N],
        width: [1.0; N],
    };

    /// Below one, f64 has all multiples of this.
    pub(crate) const MIN_WIDTH: f64 = f64::EPSILON;

    /// The time at which the box begins.
    pub(crate) fn time(&self) -> f64 {
        self.lower[0]
    }

    pub(crate) fn interval(&self, axis: usize) -> Enclosure {
        Enclosure::new(self.lower[axis], self.lower[axis] + self.width[axis])
    }

    /// The lower half, then the upper one. The box must be wider than
    /// [`MIN_WIDTH`](Self::MIN_WIDTH) on this axis.
    pub(crate) fn halves(mut self, axis: usize) -> [Self; 2] {
        self.width[axis] *= 0.5;
        let lower = self;
        self.lower[axis] += self.width[axis];
        [lower, self]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_of_the_smallest_boxes_are_exact() {
        let mut cell = Cell::<1>::WHOLE;
        while cell.width[0] > Cell::<1>::MIN_WIDTH {
            let [lower, upper] = cell.halves(0);
            assert_eq!(lower.interval(0).upper, upper.lower[0]);
            assert_eq!(upper.interval(0).upper, 1.0);
            cell = upper;
        }
        assert_eq!(cell.lower[0], 1.0 - f64::EPSILON);
    }
}
