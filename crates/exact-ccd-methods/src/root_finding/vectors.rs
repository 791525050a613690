//! Moving points and their differences as polynomials in time.

use exact_ccd::{Kind, Point, Query};

use super::polynomial::Polynomial;
use crate::vector::{cross, dot};

/// A vector whose components are polynomials in time.
pub(super) type Vector = crate::vector::Vector<Polynomial>;

/// xᵢ − xⱼ, linear in time.
#[inline(always)]
pub(super) fn difference<K: Kind<Points = [Point; 4]>>(query: &Query<K>, i: usize, j: usize) -> Vector {
    let [start, end] = query.points();
    std::array::from_fn(|axis| {
        let [x, y] = [i, j].map(|point| (start[point][axis], end[point][axis] - start[point][axis]));
        Polynomial::new([x.0 - y.0, x.1 - y.1])
    })
}

/// c² − d² |n|² for n = e₁ × e₂ and c = w · n: not positive while w is within the distance d of the
/// plane that e₁ and e₂ span. Two roots of it, one on either side of a root of c, fall together for
/// d = 0.
pub(super) fn slab(w: &Vector, [e1, e2]: [&Vector; 2], distance: f64) -> Polynomial {
    let normal = cross(e1, e2);
    let volume = dot(w, &normal);
    volume * volume - dot(&normal, &normal) * (distance * distance)
}

/// The four points at t.
pub(super) fn points_at<K: Kind<Points = [Point; 4]>>(query: &Query<K>, t: f64) -> [Point; 4] {
    let [start, end] = query.points();
    std::array::from_fn(|i| std::array::from_fn(|axis| start[i][axis] + t * (end[i][axis] - start[i][axis])))
}
