//! A root of c between two adjacent f64, by signs of c in twice the precision.

use core::cmp::Ordering;

use super::UNDERFLOW;
use super::coplanarity::Root;
use super::double_double::{DoubleDouble, ROUNDOFF};
use crate::kind::{Difference, Kind};
use crate::query::Query;
use crate::time::ContactTime;

type Vector = [DoubleDouble; 3];

/// c(t) = a₀ + a₁ t + a₂ t² + a₃ t³.
pub(super) struct PreciseCoplanarity {
    powers: [DoubleDouble; 4],
    error: f64,
}

impl PreciseCoplanarity {
    pub(super) fn new<K: Kind>(query: &Query<K>) -> Self {
        let [w, e1, e2] = K::SPAN.map(|difference| [0, 1].map(|time| subtract(query, time, difference)));
        let normals = [0, 1].map(|time: usize| cross(&e1[time], &e2[time]));
        let (one, other) = (cross(&e1[0], &e2[1]), cross(&e1[1], &e2[0]));
        let mixed = [0, 1, 2].map(|axis: usize| one[axis] + other[axis]);
        let b0 = dot(&w[0], &normals[0]);
        let three_b1 = dot(&w[1], &normals[0]) + dot(&w[0], &mixed);
        let three_b2 = dot(&w[0], &normals[1]) + dot(&w[1], &mixed);
        let b3 = dot(&w[1], &normals[1]);
        let powers = [
            b0,
            three_b1 - b0 * 3.0,
            three_b2 - three_b1 * 2.0 + b0 * 3.0,
            b3 - three_b2 + three_b1 - b0,
        ];
        let magnitude = [&w, &e1, &e2]
            .map(|ends| [0, 1, 2].map(|axis: usize| ends[0][axis].high.abs().max(ends[1][axis].high.abs())));
        let [w, e1, e2] = magnitude;
        let magnitude = w[0] * (e1[1] * e2[2] + e1[2] * e2[1])
            + w[1] * (e1[2] * e2[0] + e1[0] * e2[2])
            + w[2] * (e1[0] * e2[1] + e1[1] * e2[0]);
        // With m for `magnitude`: differences are exact; six operations lead to b₀ and b₃, which m bounds, eight to
        // 3 b₁ and 3 b₂, which 3 m bounds; at most six more to the powers, which m, 6 m, 12 m and 8 m bound; then
        // six in Horner's scheme: at most 20 operations on terms that add up to no more than 27 m · (1 + 2 + 3).
        let error = 4096.0 * ROUNDOFF * magnitude + UNDERFLOW;
        Self { powers, error }
    }

    fn value(&self, t: f64) -> DoubleDouble {
        let [a0, a1, a2, a3] = self.powers;
        ((a3 * t + a2) * t + a1) * t + a0
    }

    /// The sign of c(t), if it is certainly not zero.
    fn sign(&self, value: DoubleDouble) -> Option<Ordering> {
        (value.high.abs() > self.error).then(|| value.high.total_cmp(&0.0))
    }

    /// The root between two adjacent f64, if it can be told on which side of them it is.
    pub(super) fn round(&self, root: &Root) -> Option<ContactTime> {
        const STEPS: usize = 4;
        let below = if root.rising {
            Ordering::Less
        } else {
            Ordering::Greater
        };
        let mut floor = root.near;
        for _ in 0..STEPS {
            let value = self.value(floor);
            let newton = DoubleDouble::sum(floor, -value.high / root.slope);
            let next = if newton.low < 0.0 {
                newton.high.next_down()
            } else {
                newton.high
            };
            if next == floor {
                let above = self.sign(self.value(floor.next_up()))?;
                let proved = self.sign(value)? == below && above == below.reverse();
                return proved.then(|| ContactTime::just_above(floor));
            }
            floor = next;
        }
        None
    }
}

fn subtract<K: Kind>(query: &Query<K>, time: usize, (i, j): Difference) -> Vector {
    let points = &query.points()[time];
    [0, 1, 2].map(|axis: usize| DoubleDouble::difference(points[i][axis], points[j][axis]))
}

fn dot(a: &Vector, b: &Vector) -> DoubleDouble {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    [(1, 2), (2, 0), (0, 1)].map(|(next, last): (usize, usize)| a[next] * b[last] - a[last] * b[next])
}
