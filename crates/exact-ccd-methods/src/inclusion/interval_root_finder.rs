//! Interval bisection in time and in the parameters of the primitives.

use exact_ccd::{Decide, Point, Query};

use super::bisection::Bisection;
use super::cell::Cell;
use super::gap::{Coordinates, Gap};
use crate::interval::Enclosure;
use crate::vector::{dot, minus};

/// IRF, the multivariate interval root finder: bisects (t, u, v) depth-first, and keeps the boxes
/// over which F, in interval arithmetic, contains zero, until they are small.
///
/// J. M. Snyder, *Interval Analysis for Computer Graphics*, SIGGRAPH 1992; with the tolerances, the
/// order and the natural interval extension of F in the comparison of B. Wang, Z. Ferguson, T.
/// Schneider, X. Jiang, M. Attene and D. Panozzo, *A Large-Scale Benchmark and an Inclusion-Based
/// Algorithm for Continuous Collision Detection*, ACM Transactions on Graphics 40(5), 2021. Theirs
/// stops at the first small box, which need not be the earliest; this one continues with the boxes
/// that begin earlier.
///
/// # When it fails
/// It has no false negatives. Primitives that come closer than about the tolerance count as a
/// contact. A corner of a face, or an end of an edge, occurs several times in F, so that interval
/// arithmetic bounds F loosely, and near misses take many boxes. After
/// [`max_iterations`](Self::max_iterations) it reports contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IntervalRootFinder {
    /// A box is small if F varies by less than about this along each of t, u and v: 10⁻⁶.
    pub tolerance: f64,
    /// The number of boxes that it tests before it reports contact: 10⁶. There is no limit in the comparison.
    pub max_iterations: usize,
}

impl Default for IntervalRootFinder {
    fn default() -> Self {
        Self {
            tolerance: 1e-6,
            max_iterations: 1_000_000,
        }
    }
}

/// The distance between two points; infinite where it, or its square, overflows.
pub(super) fn distance(a: Point, b: Point) -> f64 {
    let displacement = minus(&b, &a);
    dot(&displacement, &displacement).sqrt()
}

/// The largest displacement of a point.
pub(super) fn greatest_displacement([start, end]: &[[Point; 4]; 2]) -> f64 {
    (0..4)
        .map(|point| distance(start[point], end[point]))
        .fold(0.0, f64::max)
}

impl<K: Gap> Decide<K> for IntervalRootFinder {
    fn collides(&self, query: &Query<K>) -> bool {
        self.time_of_impact(query).is_some()
    }

    fn time_of_impact(&self, query: &Query<K>) -> Option<f64> {
        let points = query.points();
        let [u_length, v_length] = K::EDGES.map(|[from, to]| {
            let [start, end] = points.map(|points| distance(points[from], points[to]));
            start.max(end)
        });
        let search = Bisection {
            tolerances: [greatest_displacement(points), u_length, v_length]
                .map(|length| self.tolerance / length),
            max_iterations: self.max_iterations,
        };
        let coordinates = Coordinates::<Enclosure>::new(points);
        let may_contain_root = |cell: &Cell<3>| {
            let [t, u, v] = [0, 1, 2].map(|axis| cell.interval(axis));
            K::meets_domain(cell) && (0..3).all(|axis| K::gap(coordinates.at(axis, t), u, v).contains_zero())
        };
        search.earliest(may_contain_root, |_| true)
    }
}
