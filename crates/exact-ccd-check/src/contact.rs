//! The proof that two primitives are in contact, or within the distance, at a time after T and not after T⁺.
//!
//! Any of three proofs suffices:
//!
//! - *A point at T⁺.* Weights, not negative and with the same positive sum w for either primitive, name
//!   a point of each. Their difference, times w, is a vector of integers of length at most w d.
//! - *A root of coplanarity.* Let n be the normal of the face or of both edges, and c = n · (x_i −
//!   x_j), which vanishes when all four vertices are in one plane. A polynomial f divides c and has
//!   different signs at T and T⁺, so c vanishes at a root of f between them. One component of n has a
//!   strict sign. So have all sides, which are that component times the barycentric coordinates of the
//!   vertex in the face, or times u, 1 − u, v, 1 − v for the crossing of the lines of the edges; or f
//!   divides a side, which then is 0. So the vertex is in the face, or the edges meet, at the root.
//! - *A vertex q on an edge x y.* f, as above, divides all components of (x − q) × (y − q), so that q
//!   is on the line at a root of f. (x − q) · (y − q) is negative, or f divides it: q is between x and
//!   y, or at one of them. For two vertices, x = y.

use dashu_int::IBig;

use crate::mesh::{Kind, Pair};
use crate::motion::{Motion, Time};
use crate::polynomial::{Polynomial, Vector, cross, difference, dot};
use crate::separation;

/// A proof of contact.
#[derive(Clone, Debug, PartialEq)]
pub enum Proof {
    /// Points at T⁺: the weights of all vertices of the pair.
    Point(Vec<IBig>),
    /// A root of f, or of c itself, at which the component of the normal on this axis does not vanish.
    Coplanar {
        /// The axis, from 0.
        axis: usize,
        /// f; c itself if there is none.
        factor: Option<Polynomial>,
    },
    /// A root of f at which a vertex is on an edge.
    OnEdge {
        /// The row of [`vertex_on_edge`].
        row: usize,
        /// f.
        factor: Polynomial,
    },
}

/// Returns true if a proof shows contact of a pair at a time in (T, T⁺], or at T⁺ = 0.
pub fn is_contact(motion: &Motion, kind: Kind, pair: &Pair<'_>, times: [f64; 2], proof: &Proof) -> bool {
    let moving = || Moving::new(motion, pair, times);
    let is_proved = match proof {
        Proof::Point(weights) => is_near(motion, pair, times[1], weights),
        Proof::Coplanar { axis, factor } => moving().is_inside(kind, *axis, factor.as_ref()),
        Proof::OnEdge { row, factor } => moving().is_on_edge(kind, *row, factor),
    };
    is_proved.unwrap_or(false)
}

fn is_near(motion: &Motion, pair: &Pair<'_>, time: f64, weights: &[IBig]) -> Option<bool> {
    let [time] = Time::together([time]);
    let (first, second) = weights.split_at_checked(pair.first.len())?;
    let mut difference = [IBig::ZERO; 3];
    let signed = first.iter().cloned().chain(second.iter().map(|weight| -weight));
    for (vertex, weight) in pair.vertices().zip(signed) {
        for (sum, x) in difference.iter_mut().zip(motion.at(vertex, &time)) {
            *sum += &weight * x;
        }
    }
    let [sum, other]: [IBig; 2] = [first, second].map(|weights| weights.iter().sum());
    let reach = (pair.distance(motion) << time.power) * &sum;
    let is_point = weights.iter().all(|weight| *weight >= IBig::ZERO) && sum > IBig::ZERO && sum == other;
    let is_complete = second.len() == pair.second.len();
    Some(is_point && is_complete && separation::dot(&difference, &difference) <= &reach * &reach)
}

/// The vertices of a pair, by their positions at T and T⁺, with one denominator.
pub struct Moving(Vec<Vector>);

/// The vertex q and the edge x y of each row of a kind, as places in the pair.
pub fn vertex_on_edge(kind: Kind) -> &'static [[usize; 3]] {
    match kind {
        Kind::VertexFace => &[[0, 1, 2], [0, 2, 3], [0, 3, 1]],
        Kind::EdgeEdge => &[[0, 2, 3], [1, 2, 3], [2, 0, 1], [3, 0, 1]],
        Kind::VertexEdge => &[[0, 1, 2]],
        Kind::VertexVertex => &[[0, 1, 1]],
        Kind::EdgeFace => &[],
    }
}

impl Moving {
    /// The motion from T to T⁺.
    pub fn new(motion: &Motion, pair: &Pair<'_>, times: [f64; 2]) -> Self {
        let times = Time::together(times);
        let linear = |vertex: u32| {
            let ends = times.each_ref().map(|time| motion.at(vertex, time));
            [0, 1, 2].map(|axis: usize| Polynomial(ends.iter().map(|end| end[axis].clone()).collect()))
        };
        Self(pair.vertices().map(linear).collect())
    }

    /// The normal n, the coplanarity c and the sides. One component of each side's vector counts.
    pub fn coplanarity(&self, kind: Kind) -> Option<(Vector, Polynomial, Vec<Vector>)> {
        let [a, b, c, d] = &self.0[..] else { return None };
        match kind {
            Kind::VertexFace => {
                let normal = cross(&difference(c, b), &difference(d, b));
                let side = |[x, y]: [&Vector; 2]| cross(&difference(x, a), &difference(y, a));
                let coplanarity = dot(&normal, &difference(a, b));
                Some((normal, coplanarity, [[b, c], [c, d], [d, b]].map(side).into()))
            }
            Kind::EdgeEdge => {
                let [e, f, w] = [difference(b, a), difference(d, c), difference(c, a)];
                let normal = cross(&e, &f);
                // a + u e = c + v f, so u e × f = w × f and v e × f = w × e.
                let [u, v] = [cross(&w, &f), cross(&w, &e)];
                let coplanarity = dot(&normal, &w);
                let sides = vec![difference(&normal, &u), difference(&normal, &v), u, v];
                Some((normal, coplanarity, sides))
            }
            _ => None,
        }
    }

    /// The components of (x − q) × (y − q), and (x − q) · (y − q).
    pub fn on_edge(&self, kind: Kind, row: usize) -> Option<(Vector, Polynomial)> {
        let [q, x, y] = vertex_on_edge(kind).get(row)?.map(|place| self.0.get(place));
        let [x, y] = [difference(x?, q?), difference(y?, q?)];
        Some((cross(&x, &y), dot(&x, &y)))
    }

    fn is_inside(&self, kind: Kind, axis: usize, factor: Option<&Polynomial>) -> Option<bool> {
        let (normal, c, sides) = self.coplanarity(kind)?;
        let factor = factor.unwrap_or(&c);
        let component = normal.get(axis)?;
        let sign = if component.has_sign(1) { 1 } else { -1 };
        let is_inner = |side: &Vector| side[axis].has_sign(sign) || side[axis].is_multiple_of(factor);
        Some(
            factor.changes_sign()
                && c.is_multiple_of(factor)
                && component.has_sign(sign)
                && sides.iter().all(is_inner),
        )
    }

    fn is_on_edge(&self, kind: Kind, row: usize, factor: &Polynomial) -> Option<bool> {
        let (cross, dot) = self.on_edge(kind, row)?;
        Some(
            factor.changes_sign()
                && cross.iter().all(|component| component.is_multiple_of(factor))
                && (dot.has_sign(-1) || dot.is_multiple_of(factor)),
        )
    }
}
