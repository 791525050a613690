//! The proof that two primitives are not in contact, and not within the distance d.
//!
//! Let g be a direction, constant or linear in time, and x_i − x_j the difference of a vertex of the first
//! primitive and a vertex of the second. The difference of any two points of the primitives is a mean of
//! such differences. If g · (x_i − x_j) > d |g| for all of them, the primitives are more than d apart.
//!
//! On a stretch of time from s to e, let g turn from g_s to g_e. Then g · (x_i − x_j) is quadratic,
//! with the Bernstein coefficients g_s · x_s, (g_s · x_e + g_e · x_s) / 2 and g_e · x_e for x = x_i −
//! x_j. As length is convex, |g| is at most the linear function from |g_s| to |g_e|, with the Bernstein
//! coefficients |g_s|, (|g_s| + |g_e|) / 2 and |g_e|. It suffices that each coefficient is more than d
//! times the other. The square of |g_s| + |g_e| is at most 2 (|g_s|² + |g_e|²). If g is constant, so g_s =
//! g_e, the middle coefficients are the means of the others.
//!
//! For an edge and a face at t = 0, it suffices that g is not 0 and g · (x_i − x_j) ≥ 0. If an edge pierces
//! a face, a point inside of the edge is also inside of the face. There, all of these products would be 0,
//! so that g would be orthogonal to the edge and to the plane of the face. The edge is not in this plane, so
//! g would be 0. An edge that has a vertex in common with a face does not pierce it, and needs no row: if it
//! is not in the plane of the face, it meets the plane only at that vertex.

use dashu_int::IBig;

use crate::mesh::{Kind, Pair};
use crate::motion::{Motion, Point, Time};

/// A stretch of time, from the end of the one before, and the direction during it.
#[derive(Clone, Debug, PartialEq)]
pub struct Stretch {
    /// The time at which it ends.
    pub end: f64,
    /// The direction at its start.
    pub from: Point,
    /// The direction at its end.
    pub to: Point,
}

/// Returns true if stretches prove that a pair is not within its distance at any time from 0 to the end of
/// the last one. Each begins where the one before it ends, so that no time is left out, whatever their order.
pub fn is_apart(motion: &Motion, kind: Kind, pair: &Pair<'_>, stretches: &[Stretch]) -> bool {
    let starts = std::iter::once(0.0).chain(stretches.iter().map(|stretch| stretch.end));
    stretches.iter().zip(starts).all(|(stretch, start)| stretch.holds(motion, kind, pair, start))
}

impl Stretch {
    /// Returns true if the direction separates the pair by more than its distance, from `start` on.
    pub fn holds(&self, motion: &Motion, kind: Kind, pair: &Pair<'_>, start: f64) -> bool {
        let times = Time::together([start, self.end]);
        let [first, second] = [pair.first, pair.second].map(|vertices| {
            let ends = |&vertex: &u32| times.each_ref().map(|time| motion.at(vertex, time));
            vertices.iter().map(ends).collect::<Vec<_>>()
        });
        // In the unit of the positions.
        let distance = pair.distance(motion) << times[0].power;
        let is_beyond = |along: &dyn Fn(&[Point; 2]) -> IBig, square: &IBig| {
            let (least, most) = (first.iter().map(along).min(), second.iter().map(along).max());
            let gap = least.unwrap_or(IBig::ZERO) - most.unwrap_or(IBig::ZERO);
            match kind {
                Kind::EdgeFace => gap >= IBig::ZERO && *square > IBig::ZERO,
                _ => gap > IBig::ZERO && &gap * &gap > &distance * &distance * square,
            }
        };
        let squares = [dot(&self.from, &self.from), dot(&self.to, &self.to)];
        is_beyond(&|[s, _]| dot(&self.from, s), &squares[0])
            && is_beyond(&|[_, e]| dot(&self.to, e), &squares[1])
            // Twice the middle coefficient.
            && is_beyond(&|[s, e]| dot(&self.from, e) + dot(&self.to, s), &((&squares[0] + &squares[1]) << 1))
    }
}

/// The scalar product.
pub fn dot(a: &Point, b: &Point) -> IBig {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}
