//! The parity of a query by the definition of contact: the boundary of the domain made of smaller queries, and the
//! roots in its interior counted with their multiplicity.
//!
//! Where the four points are coplanar at all times, and where the edges are parallel or the face is flat, contact is
//! for a line of parameters or for an interval of time, and reaches the boundary. So contact that does not is at
//! roots of the coplanarity, and each counts as often as it is a root.

use exact_ccd::parity::Parity;
use exact_ccd::{
    ContactTime, ContactTimes, EdgeEdge, Kind, Point, PointTriangle, Query, SegmentSegment, exact,
};

use dashu_int::IBig;

use crate::integers::{exactly, in_one_unit};

/// A kind of query, as the vertices and edges that meet on the boundary of (u, v).
pub(crate) trait Rim: Kind + 'static {
    /// A vertex, and the ends of an edge of the other primitive.
    const MEETINGS: &'static [[usize; 3]];
}

impl Rim for PointTriangle {
    const MEETINGS: &'static [[usize; 3]] = &[[0, 1, 2], [0, 2, 3], [0, 3, 1]];
}

impl Rim for SegmentSegment {
    const MEETINGS: &'static [[usize; 3]] = &[[0, 2, 3], [1, 2, 3], [2, 0, 1], [3, 0, 1]];
}

pub(crate) fn expected<K: Rim>(query: &Query<K>) -> Parity {
    let times = exact::contact_times(query);
    if times.first().is_none() {
        return Parity::Even;
    }
    if touches_on_boundary(query) {
        return Parity::Boundary;
    }
    let ContactTimes::Finite(times) = times else {
        panic!("contact that lasts does not reach the boundary: {query:?}");
    };
    let graze = double_root(query.points());
    let grazes = times
        .iter()
        .any(|time| graze.as_ref().is_some_and(|root| root.may_be(*time)));
    if (times.len() + usize::from(grazes)) % 2 == 0 {
        Parity::Even
    } else {
        Parity::Odd
    }
}

/// Whether there is a contact at an end of the step, or of a vertex with an edge.
fn touches_on_boundary<K: Rim>(query: &Query<K>) -> bool {
    let is_met = |[vertex, x, y]: &[usize; 3]| {
        let [start, end] = query
            .points()
            .map(|now| [now[*vertex], now[*vertex], now[*x], now[*y]]);
        EdgeEdge::new(start, end).unwrap().collides()
    };
    let touches_at = |now: &[Point; 4]| Query::<K>::new(*now, *now).unwrap().collides();
    query.points().iter().any(touches_at) || K::MEETINGS.iter().any(is_met)
}

/// A rational number, with any denominator but zero.
struct Ratio {
    numerator: IBig,
    denominator: IBig,
}

impl Ratio {
    /// Whether a contact time may be this number: it is, or it lies between the same two f64.
    fn may_be(&self, time: ContactTime) -> bool {
        let sign = self.denominator.signum();
        let compare =
            |t: f64| (&self.numerator * &sign * exactly(1.0)).cmp(&(exactly(t) * &self.denominator * &sign));
        if time.is_exact() {
            compare(time.lower()).is_eq()
        } else {
            compare(time.lower()).is_gt() && compare(time.upper()).is_lt()
        }
    }
}

/// The root of multiplicity two of the coplanarity of four points, if there is one.
///
/// For a₃ (t − r)² (t − s), a₂² − 3 a₁ a₃ is a₃² (r − s)², and for a₂ (t − r)², a₂²; then the ratio below is r.
fn double_root(points: &[[Point; 4]; 2]) -> Option<Ratio> {
    let [a0, a1, a2, a3] = coplanarity(points);
    let numerator = IBig::from(9) * &a0 * &a3 - &a1 * &a2;
    let denominator = IBig::from(2) * (&a2 * &a2 - IBig::from(3) * &a1 * &a3);
    if denominator.is_zero() {
        return None;
    }
    let (n, d) = (&numerator, &denominator);
    let value = a0 * d.pow(3) + &a1 * d.pow(2) * n + &a2 * d * n.pow(2) + &a3 * n.pow(3);
    let slope = a1 * d.pow(2) + IBig::from(2) * a2 * d * n + IBig::from(3) * a3 * n.pow(2);
    (value.is_zero() && slope.is_zero()).then_some(Ratio {
        numerator,
        denominator,
    })
}

/// The coefficients of a multiple of the determinant of x₁ − x₀, x₂ − x₀, x₃ − x₀, from its values at four times.
fn coplanarity(points: &[[Point; 4]; 2]) -> [IBig; 4] {
    let axes = [0, 1, 2]
        .map(|axis: usize| in_one_unit([0, 1, 2, 3, 4, 5, 6, 7].map(|i: usize| points[i / 4][i % 4][axis])));
    let value = |t: i32| {
        let at = |axis: usize, i: usize| &axes[axis][i] + (&axes[axis][i + 4] - &axes[axis][i]) * t;
        let [a, b, c] = [1, 2, 3].map(|i| [0, 1, 2].map(|axis| at(axis, i) - at(axis, 0)));
        &a[0] * (&b[1] * &c[2] - &b[2] * &c[1])
            + &a[1] * (&b[2] * &c[0] - &b[0] * &c[2])
            + &a[2] * (&b[0] * &c[1] - &b[1] * &c[0])
    };
    let [before, start, end, after] = [-1, 0, 1, 2].map(value);
    // Newton's differences, times six.
    let cubic = &after - IBig::from(3) * &end + IBig::from(3) * &start - &before;
    let quadratic = IBig::from(3) * (&end + &before - IBig::from(2) * &start);
    let linear = IBig::from(3) * (end - before) - &cubic;
    [IBig::from(6) * start, linear, quadratic, cubic]
}
