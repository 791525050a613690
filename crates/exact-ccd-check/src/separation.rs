//! The proof that two primitives are not in contact, and not within the distance d.
//!
//! Let g be a direction, constant or linear in time, and x_i − x_j the difference of a vertex of the
//! first primitive and one of the second. The difference of any two points of the primitives is a mean
//! of such differences. If g · (x_i − x_j) > d |g| for all of them, the primitives are more than d
//! apart.
//!
//! On a stretch of time from s to e, let g turn from g_s to g_e. Then g · (x_i − x_j) is quadratic,
//! with the Bernstein coefficients g_s · x_s, (g_s · x_e + g_e · x_s) / 2 and g_e · x_e for x = x_i −
//! x_j. As length is convex, |g| is at most the linear function from |g_s| to |g_e|, with the Bernstein
//! coefficients |g_s|, (|g_s| + |g_e|) / 2 and |g_e|. It suffices that each coefficient is more than d
//! times the other. The square of |g_s| + |g_e| is at most 2 (|g_s|² + |g_e|²). If g is constant, the
//! middle coefficient is the mean of the others.
//!
//! For an edge and a face at t = 0, it suffices that g is not 0 and g · (x_i − x_j) ≥ 0. An edge that
//! pierces a face has a point inside of itself in common with the inside of the face; there, all of
//! these products would be 0, so that g would be orthogonal to the edge and to the plane of the face,
//! which the edge is not in: g would be 0.

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
    /// The direction at its end, if that is another one.
    pub to: Option<Point>,
}

/// Returns true if stretches prove that a pair is not within its distance at any time from `start` to
/// the end of the last one. Times must increase, but a single stretch may have the length 0.
#[must_use]
pub fn is_apart(motion: &Motion, kind: Kind, pair: &Pair, start: f64, stretches: &[Stretch]) -> bool {
    let mut start = start;
    stretches.iter().enumerate().all(|(number, stretch)| {
        let is_later = start < stretch.end || number == 0 && start == stretch.end;
        let holds = is_later && stretch.holds(motion, kind, pair, start);
        start = stretch.end;
        holds
    })
}

impl Stretch {
    /// Returns true if the direction separates the pair by more than its distance, from `start` on.
    #[must_use]
    pub fn holds(&self, motion: &Motion, kind: Kind, pair: &Pair, start: f64) -> bool {
        let times = [start, self.end].map(Time::new);
        let power = times[0].power.max(times[1].power);
        let [start, end] = times.map(|time| time.over(power));
        let to = self.to.as_ref().unwrap_or(&self.from);
        let squares = [dot(&self.from, &self.from), dot(to, to)];
        let both = &squares[0] + &squares[1];
        if both == IBig::ZERO {
            return false;
        }
        let points = [start, end]
            .map(|time| pair.vertices().iter().map(|&vertex| motion.at(vertex, &time)).collect::<Vec<_>>());
        let [at_start, at_end] = &points;
        let gap = |along: &dyn Fn(usize) -> IBig| {
            let vertices = 0..pair.vertices().len();
            let (first, second) = vertices.partition::<Vec<_>, _>(|&place| place < pair.first());
            let least = first.into_iter().map(along).min().unwrap_or(IBig::ZERO);
            least - second.into_iter().map(along).max().unwrap_or(IBig::ZERO)
        };
        // In the unit of the positions.
        let distance = if pair.has_distance { motion.distance() << power } else { IBig::ZERO };
        let is_beyond = |gap: IBig, square: &IBig| match kind {
            Kind::EdgeFace => gap >= IBig::ZERO,
            _ => gap > IBig::ZERO && &gap * &gap > &distance * &distance * square,
        };
        is_beyond(gap(&|place| dot(&self.from, &at_start[place])), &squares[0])
            && is_beyond(gap(&|place| dot(to, &at_end[place])), &squares[1])
            && (self.to.is_none() || {
                // Twice the middle coefficient.
                let middle = |place: usize| dot(&self.from, &at_end[place]) + dot(to, &at_start[place]);
                is_beyond(gap(&middle), &(both << 1))
            })
    }
}

/// The scalar product.
#[must_use]
pub fn dot(a: &Point, b: &Point) -> IBig {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}
