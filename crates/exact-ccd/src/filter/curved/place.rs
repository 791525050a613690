//! The sides of the origin in a part of the step: proofs that the primitives touch where they are coplanar,
//! or that they do not.

use core::cmp::Ordering;

use super::piece::{Piece, of_area};
use super::polynomial::MOST;
use crate::numbers::roundoff::{UNDERFLOW, UNIT, certain_sign, margin};
use crate::numbers::vector::{cross_along, minus};
use crate::tables::{Point, Tables};

/// The place of the origin in the image of F at all times of a part at which that is flat.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Place {
    Inside,
    Outside,
    Unknown,
}

impl Piece<'_> {
    /// The place of the origin where the primitives are coplanar in this part.
    ///
    /// The normal has one sign on an axis in all of the part. If each side has the required one there, then
    /// `touches` (`exact/motion.rs`) holds; if one side has the opposite one, it does not. A component of a
    /// cross product of two curves is a mean of the cross products of their control points, of each with
    /// each, with the Bernstein polynomials as positive weights.
    pub(super) fn place<K: Tables>(&self) -> Place {
        let middle = self.normal((self.curves.points - 1) / 2);
        let axis = (1..3).fold(0, |best, axis| {
            if middle[axis].abs() > middle[best].abs() {
                axis
            } else {
                best
            }
        });
        let Some(facing) = self.facing(axis) else {
            return Place::Unknown;
        };
        let mut place = Place::Inside;
        for side in K::SIDES {
            let [x, y] = side.corners.map(|corner| self.curves.corner(corner));
            let required = if side.along { facing } else { facing.reverse() };
            match self.constant_sign(axis, x, y, 0) {
                None => place = Place::Unknown,
                Some(sign) if sign == required => {}
                Some(_) => return Place::Outside,
            }
        }
        place
    }

    /// The sign of a component of e₁ × e₂, if it is constant. An edge is a difference of corners, one more
    /// rounding of twice the magnitude.
    fn facing(&self, axis: usize) -> Option<Ordering> {
        let [a, b, c] = self.first_corners().map(|corner| &self.curves.corners[corner]);
        let mut edges = [[[0.0; 3]; MOST]; 2];
        for k in 0..self.curves.points {
            edges[0][k] = minus(b[k], a[k]);
            edges[1][k] = minus(c[k], a[k]);
        }
        let [one, other] = [&edges[0][..self.curves.points], &edges[1][..self.curves.points]];
        // (b − a) × (c − a) is e₁ × e₂, of a vertex and a face and of two edges.
        self.constant_sign(axis, one, other, 1)
    }

    /// The sign of a component of the cross product of two curves, if it is constant in this part. Their
    /// control points are sums of 2ᵏ corners, with k more roundings.
    fn constant_sign(&self, axis: usize, x: &[Point], y: &[Point], k: u32) -> Option<Ordering> {
        let [next, last] = [[1, 2], [2, 0], [0, 1]][axis];
        let magnitude = self.corners.magnitude;
        let n = of_area(self.corners.roundings + self.roundings() + k);
        let scale = f64::from(1_u32 << (2 * k)) * (2.0 * margin(n) * UNIT);
        let error = magnitude[next] * magnitude[last] * scale + UNDERFLOW;
        let mut products = x
            .iter()
            .flat_map(|&x| y.iter().map(move |&y| cross_along(axis, x, y)));
        let sign = certain_sign(products.next()?, error)?;
        products
            .all(|product| certain_sign(product, error) == Some(sign))
            .then_some(sign)
    }
}
