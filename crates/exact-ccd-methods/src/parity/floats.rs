//! Signs in f64, and exactly where their error bound leaves them open.

use std::cmp::Ordering;

use exact_ccd::Point;
use geometry_predicates::{orient2d, orient3d};

use super::approximate::Approximate;
use super::image::{Differences, Image, Predicate, Vectors, integers, vectors};
use super::number::Number;

/// An image whose vectors are exactly f64, in the range (`Expansion::can_hold`) of the
/// predicates.
pub(super) struct Floats {
    differences: Differences,
    vectors: Vectors<Approximate>,
}

impl Floats {
    /// The image of differences that are exact.
    #[inline]
    pub(super) fn new(differences: &Differences) -> Self {
        Self {
            differences: *differences,
            vectors: vectors(differences),
        }
    }

    fn vector(&self, index: usize) -> Point {
        let [minuend, subtrahend] = self.differences[index];
        [0, 1, 2].map(|axis: usize| minuend[axis] - subtrahend[axis])
    }

    /// The sign by Shewchuk's adaptive predicates (Adaptive precision floating-point arithmetic and fast
    /// robust geometric predicates, 1997), which are exact in the range, or in integers.
    #[cold]
    fn sign_near_zero(&self, predicate: Predicate) -> Ordering {
        if predicate.vanishes(&self.differences) {
            return Ordering::Equal;
        }
        let determinant = match predicate {
            Predicate::Volume(corners) => {
                let [a, b, c] = corners.map(|corner| self.vector(corner));
                orient3d(a, b, c, [0.0; 3])
            }
            Predicate::Turn(axis, ends) => {
                let along = |point: Point| [point[(axis + 1) % 3], point[(axis + 2) % 3]];
                let [a, b] = ends.map(|end| along(self.vector(end)));
                orient2d(a, b, [0.0; 2])
            }
            Predicate::Dot(_) | Predicate::Phi(_) => return integers(&self.differences).sign(predicate),
        };
        determinant.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
    }
}

impl Image for Floats {
    #[inline]
    fn sign(&self, predicate: Predicate) -> Ordering {
        let sign = predicate.value(&self.vectors).certain_sign();
        sign.unwrap_or_else(|| self.sign_near_zero(predicate))
    }
}
