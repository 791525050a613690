//! A query in integers of fixed width, and the contact of its primitives by the signs of quadratics.

use core::cmp::Ordering;
use core::marker::PhantomData;

use super::moment::Moment;
use super::number::{Points, subtract};
use super::vector::{add, cross, cross_along, dot};
use super::wide::Wide;
use crate::exact::decompose;
use crate::kind::{Difference, Kind, Side};
use crate::query::Query;

/// A difference of two points at t = 0 and at t = 1.
type Ends<const N: usize> = [[Wide<N>; 3]; 2];

/// The points of a query in integers, each axis in a unit of its own: contact is invariant under such
/// scalings.
pub(super) struct Lattice<K, const N: usize> {
    /// Integers, although of type f64.
    points: Points<f64>,
    /// The number of bits of the coordinates.
    pub(super) bits: u32,
    kind: PhantomData<K>,
}

impl<K: Kind, const N: usize> Lattice<K, N> {
    /// The largest number of bits of coordinates.
    ///
    /// If coordinates are below 2ᵇ, differences are below 2ᵇ⁺¹, the terms of a coefficient of the cubic
    /// below 2³ᵇ⁺³, and there are at most 18 of them: it is below 2³ᵇ⁺⁸. [`without_ends`] makes it at
    /// most 2³ times as large.
    const MOST_BITS: u32 = (64 * N as u32 - 12) / 3;

    /// The query in the largest units that make all coordinates integers; `None` if these are too long, or
    /// the units are near the ends of the range of f64.
    pub(super) fn new(query: &Query<K>) -> Option<Self> {
        let mut points = *query.four();
        let mut bits = 0;
        for axis in 0..3 {
            let (mut low, mut high) = (i32::MAX, i32::MIN);
            for point in points.as_flattened() {
                let (mantissa, exponent) = decompose(point[axis]);
                if mantissa != 0 {
                    low = low.min(exponent);
                    high = high.max(exponent + 64 - mantissa.unsigned_abs().leading_zeros() as i32);
                }
            }
            if low > high {
                continue;
            }
            if low.abs() > 1000 || high - low > Self::MOST_BITS as i32 {
                return None;
            }
            bits = bits.max((high - low) as u32);
            let unit = f64::from_bits(((1023 - low) as u64) << 52);
            for point in points.as_flattened_mut() {
                point[axis] *= unit;
            }
        }
        Some(Self {
            points,
            bits,
            kind: PhantomData,
        })
    }

    fn difference(&self, difference: Difference) -> Ends<N> {
        subtract(&self.points, difference)
    }

    /// True if the four points are coplanar at the time that splits the step into these two parts.
    ///
    /// If the parts add up to at most 2ᵏ, the points are multiples of 2⁻ᵏ then: with 2ᵏ as the unit, their
    /// coordinates are below 2ᵇ⁺ᵏ, and the volume is below 6 · 2³⁽ᵇ⁺ᵏ⁺¹⁾ < 2³⁽ᵇ⁺ᵏ⁾⁺⁶.
    pub(super) fn is_flat_at(&self, [elapsed, left]: [i128; 2]) -> bool {
        let parts = [left, elapsed].map(Wide::from);
        let [w, e1, e2] = K::SPAN.map(|difference| {
            let [start, end] = self.difference(difference);
            [0, 1, 2].map(|axis: usize| start[axis] * parts[0] + end[axis] * parts[1])
        });
        dot(w, cross(e1, e2)).is_zero()
    }

    /// The coplanarity cubic c₀ (1−t)³ + c₁ (1−t)² t + c₂ (1−t) t² + c₃ t³.
    pub(super) fn cubic(&self) -> [Wide<N>; 4] {
        let [w, e1, e2] = K::SPAN.map(|difference| self.difference(difference));
        let [start, mixed, end] = product(&e1, &e2);
        [
            dot(w[0], start),
            dot(w[1], start) + dot(w[0], mixed),
            dot(w[0], end) + dot(w[1], mixed),
            dot(w[1], end),
        ]
    }

    /// Returns true if the primitives touch at each time of a moment, false if they do so at none, if it is
    /// certain; the four points are coplanar then. The tests are those of the exact path.
    pub(super) fn touches(&self, moment: &Moment) -> Option<bool> {
        let [e1, e2] = [1, 2].map(|i: usize| self.difference(K::SPAN[i]));
        let mut facing = Some(Ordering::Equal);
        let mut along = 0;
        for axis in 0..3 {
            match sign(moment, &e1, &e2, component(axis)) {
                Some(Ordering::Equal) => {}
                None => facing = None,
                certain => {
                    (facing, along) = (certain, axis);
                    break;
                }
            }
        }
        let facing = facing?;
        if facing.is_eq() {
            return holds(K::SIDES.iter().map(|side| self.lies_on(side, moment)), true);
        }
        let is_inside = |side: &Side| {
            let [x, y] = self.edge(side);
            let inside = if side.along { facing } else { facing.reverse() };
            let sign = sign(moment, &x, &y, component(along))?;
            Some(sign.is_eq() || sign == inside)
        };
        holds(K::SIDES.iter().map(is_inside), false)
    }

    /// Returns true if a vertex lies on an edge.
    fn lies_on(&self, side: &Side, moment: &Moment) -> Option<bool> {
        let [x, y] = self.edge(side);
        let is_on_line = |axis| Some(sign(moment, &x, &y, component(axis))?.is_eq());
        if holds((0..3).map(is_on_line), false)? {
            return sign(moment, &x, &y, dot).map(Ordering::is_le);
        }
        Some(false)
    }

    /// The ends of an edge, from a vertex.
    fn edge(&self, side: &Side) -> [Ends<N>; 2] {
        side.edge.map(|end| self.difference((end, side.vertex)))
    }
}

/// One of the conditions is `decisive` if any is; the other way round if all are certain and none is.
fn holds(conditions: impl Iterator<Item = Option<bool>>, decisive: bool) -> Option<bool> {
    let mut result = Some(!decisive);
    for condition in conditions {
        match condition {
            Some(holds) if holds == decisive => return Some(decisive),
            Some(_) => {}
            None => result = None,
        }
    }
    result
}

/// The coefficients of a × b.
fn product<const N: usize>(a: &Ends<N>, b: &Ends<N>) -> [[Wide<N>; 3]; 3] {
    [
        cross(a[0], b[0]),
        add(cross(a[0], b[1]), cross(a[1], b[0])),
        cross(a[1], b[1]),
    ]
}

/// The sign of a bilinear product of two differences.
fn sign<const N: usize>(
    moment: &Moment,
    a: &Ends<N>,
    b: &Ends<N>,
    product: impl Fn([Wide<N>; 3], [Wide<N>; 3]) -> Wide<N>,
) -> Option<Ordering> {
    moment.sign(|coefficient| match coefficient {
        0 => product(a[0], b[0]),
        1 => product(a[0], b[1]) + product(a[1], b[0]),
        _ => product(a[1], b[1]),
    })
}

/// One component of a × b.
fn component<const N: usize>(axis: usize) -> impl Fn([Wide<N>; 3], [Wide<N>; 3]) -> Wide<N> {
    move |a, b| cross_along(axis, a, b)
}

/// The cubic without its roots at t = 0 and t = 1, and true for each of these that it has.
///
/// c₀ = 0 means that c is t times a quadratic with coefficients c₁, c₂, c₃. This one times t + (1 − t), which
/// is 1, is a cubic again. A cubic that is not zero has at most three such roots.
pub(super) fn without_ends<const N: usize>(mut c: [Wide<N>; 4]) -> ([Wide<N>; 4], [bool; 2]) {
    let ends = [c[0].is_zero(), c[3].is_zero()];
    for _ in 0..3 {
        if c[0].is_zero() {
            c = [c[1], c[1] + c[2], c[2] + c[3], c[3]];
        } else if c[3].is_zero() {
            c = [c[0], c[0] + c[1], c[1] + c[2], c[2]];
        }
    }
    (c, ends)
}
