//! Motion in a plane across an axis, as that of a cloth on the ground or between two walls: the coplanarity cubic is zero,
//! and what matters is on which sides of the edges' lines the vertices are.
//!
//! Each side is the sign of a quadratic. Where all of them have simple roots, apart from each other, one changes at a
//! time, so that contact which begins within the step lasts for a while.

use arrayvec::ArrayVec;

use super::cubic::{Cubic, Root};
use super::double_double::DoubleDouble;
use super::number::{Number, reach, subtract};
use super::rounding::PreciseCubic;
use crate::kind::{Difference, Kind, Side};
use crate::query::Query;
use crate::time::ContactTime;

/// The most sides that a kind of query has, times the roots of a quadratic.
const MOST_ROOTS: usize = 8;

/// A query in a plane.
pub(super) struct Planar<'a, K> {
    query: &'a Query<K>,
    /// The axes along the plane.
    axes: [usize; 2],
}

/// When contact begins.
pub(super) enum Beginning {
    /// It is there at t = 0.
    Start,
    /// A vertex comes to lie on the line of an edge, as the last one to do so.
    Side(&'static Side, Root),
}

/// A root of a side's quadratic.
struct Crossing {
    side: usize,
    root: Root,
}

impl<'a, K: Kind> Planar<'a, K> {
    /// The query, if all its points move in one plane across an axis. Exact: it only compares coordinates.
    pub(super) fn new(query: &'a Query<K>) -> Option<Self> {
        let is_flat = |axis: usize| {
            query
                .points()
                .iter()
                .all(|[a, rest @ ..]| rest.iter().all(|b| a[axis] == b[axis]))
        };
        let axes = [[1, 2], [2, 0], [0, 1]];
        (0..3).find(|&axis| is_flat(axis)).map(|axis| Self {
            query,
            axes: axes[axis],
        })
    }

    /// When contact begins, `Some(None)` if it certainly never does.
    pub(super) fn beginning(&self) -> Option<Option<Beginning>> {
        let [_, e1, e2] = K::SPAN;
        let facing = self.area(e1, e2).constant_sign()?;
        let mut inside = ArrayVec::<bool, 4>::new();
        let mut crossings = ArrayVec::<Crossing, MOST_ROOTS>::new();
        for (index, side) in K::SIDES.iter().enumerate() {
            let [x, y] = side.edge.map(|end| (end, side.vertex));
            let area = self.area(x, y);
            inside.push(area.starts_positive() == (facing.is_gt() == side.along));
            crossings.extend(
                area.roots()?
                    .into_iter()
                    .map(|root| Crossing { side: index, root }),
            );
        }
        crossings.sort_unstable_by(|a, b| a.root.near.total_cmp(&b.root.near));
        if crossings
            .windows(2)
            .any(|pair| pair[0].root.high > pair[1].root.low)
        {
            return None;
        }
        if inside.iter().all(|&inside| inside) {
            return Some(Some(Beginning::Start));
        }
        for Crossing { side, root } in crossings {
            inside[side] = !inside[side];
            if inside.iter().all(|&inside| inside) {
                return Some(Some(Beginning::Side(&K::SIDES[side], root)));
            }
        }
        Some(None)
    }

    /// The cross product of two differences in the plane.
    fn area(&self, x: Difference, y: Difference) -> Cubic<f64> {
        let (coefficients, magnitude) = self.expand::<f64>(x, y);
        Cubic::new(coefficients, magnitude)
    }

    /// When contact begins, to the last bit.
    pub(super) fn round(&self, beginning: &Beginning) -> Option<ContactTime> {
        match beginning {
            Beginning::Start => Some(ContactTime::exactly(0.0)),
            Beginning::Side(side, root) => {
                let [x, y] = side.edge.map(|end| (end, side.vertex));
                let (coefficients, magnitude) = self.expand::<DoubleDouble>(x, y);
                PreciseCubic::new(coefficients, magnitude).round(root)
            }
        }
    }

    /// The quadratic q₀ (1−t)² + m (1−t) t + q₁ t², raised to a cubic. The longest way to a coefficient is a difference, a
    /// product, the difference in `cross`, the sum in `mixed` and one more; and the other difference in each term.
    fn expand<T: Number<Real = f64>>(&self, x: Difference, y: Difference) -> ([T; 4], f64) {
        let along = |difference| {
            subtract(self.query.points(), difference).map(|d: [T; 3]| self.axes.map(|axis| d[axis]))
        };
        let (x, y) = (along(x), along(y));
        let cross = |a: [T; 2], b: [T; 2]| a[0] * b[1] - a[1] * b[0];
        let (q0, q1) = (cross(x[0], y[0]), cross(x[1], y[1]));
        let mixed = cross(x[0], y[1]) + cross(x[1], y[0]);
        let (x, y) = (reach(&x), reach(&y));
        ([q0, q0 + mixed, mixed + q1, q1], x[0] * y[1] + x[1] * y[0])
    }
}
