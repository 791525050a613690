//! Interval bisection in time.

use exact_ccd::{Decide, EdgeEdge, Kind, Point, Query, VertexFace};

use super::bisection::Bisection;
use super::cell::Cell;
use super::gap::Coordinates;
use super::interval_root_finder::greatest_displacement;
use crate::interval::Enclosure;
use crate::vector::{Vector, cross, dot, minus};

/// UIRF, the univariate interval root finder: bisects t, and keeps the intervals in which the four
/// points may be coplanar, until they are short. An interval counts as contact if the primitives may
/// meet in it, in interval arithmetic.
///
/// S. Redon, A. Kheddar and S. Coquillart, *Fast Continuous Collision Detection between Rigid
/// Bodies*, Computer Graphics Forum 21(3), 2002, with the root finder of J. M. Snyder, *Interval
/// Analysis for Computer Graphics*, SIGGRAPH 1992, as in the comparison of B. Wang, Z. Ferguson, T.
/// Schneider, X. Jiang, M. Attene and D. Panozzo, *A Large-Scale Benchmark and an Inclusion-Based
/// Algorithm for Continuous Collision Detection*, ACM Transactions on Graphics 40(5), 2021.
///
/// # When it fails
/// It has no false negatives. It reports primitives that pass each other within about the tolerance, and, at
/// any distance, primitives whose plane is undetermined: a vertex in line with a face without area, parallel
/// edges that are coplanar at some time. Points that are always coplanar allow no interval to be dropped: it
/// tests all of them, a million for a motion of length 1, and reports contact after
/// [`max_iterations`](Self::max_iterations).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnivariateIntervalRootFinder {
    /// An interval is short if no point moves further than this during it: 10⁻⁶.
    pub tolerance: f64,
    /// The number of intervals that it tests before it reports contact: 10⁷. There is no limit in
    /// the comparison.
    pub max_iterations: usize,
}

impl Default for UnivariateIntervalRootFinder {
    fn default() -> Self {
        Self {
            tolerance: 1e-6,
            max_iterations: 10_000_000,
        }
    }
}

/// A point q and a triangle x y z, and the signs of the barycentric coordinates of q where the
/// primitives meet.
struct Barycentric {
    point: usize,
    triangle: [usize; 3],
    signs: [f64; 3],
}

/// The barycentric coordinates that decide a kind of query.
trait Decided: Kind<Points = [Point; 4]> {
    const BARYCENTRIC: Barycentric;
}

/// The vertex lies in the face.
impl Decided for VertexFace {
    const BARYCENTRIC: Barycentric = Barycentric {
        point: 0,
        triangle: [1, 2, 3],
        signs: [1.0, 1.0, 1.0],
    };
}

/// (1 − u) a₀ + u a₁ = (1 − v) b₀ + v b₁ gives b₁ = ((1 − u) a₀ + u a₁ − (1 − v) b₀) / v. If v = 0,
/// then a₀, a₁ and b₀ are collinear, and all products with the normal of their triangle vanish.
impl Decided for EdgeEdge {
    const BARYCENTRIC: Barycentric = Barycentric {
        point: 3,
        triangle: [0, 1, 2],
        signs: [1.0, 1.0, -1.0],
    };
}

impl Barycentric {
    /// q, x, y and z in an interval of time.
    fn at(
        &self,
        coordinates: &Coordinates<Enclosure>,
        t: Enclosure,
    ) -> (Vector<Enclosure>, [Vector<Enclosure>; 3]) {
        let axes = [0, 1, 2].map(|axis| coordinates.at(axis, t));
        let position = |point: usize| axes.map(|axis| axis[point]);
        (position(self.point), self.triangle.map(position))
    }

    /// Returns true if q may lie in the plane of the triangle.
    fn may_be_coplanar(&self, coordinates: &Coordinates<Enclosure>, t: Enclosure) -> bool {
        let (q, [x, y, z]) = self.at(coordinates, t);
        dot(&minus(&q, &x), &cross(&minus(&y, &x), &minus(&z, &x))).contains_zero()
    }

    /// Returns true if the barycentric coordinates may have their signs. For the normal n, the one of x is n
    /// · ((y − q) × (z − q)) / n², and so on around the triangle.
    fn may_meet(&self, coordinates: &Coordinates<Enclosure>, t: Enclosure) -> bool {
        let (q, triangle) = self.at(coordinates, t);
        let [x, y, z] = triangle;
        let normal = cross(&minus(&y, &x), &minus(&z, &x));
        let to_corner = triangle.map(|corner| minus(&corner, &q));
        (0..3).all(|k| {
            let area = dot(&normal, &cross(&to_corner[(k + 1) % 3], &to_corner[(k + 2) % 3]));
            (area * Enclosure::from(self.signs[k])).upper >= 0.0
        })
    }
}

impl<K: Decided> Decide<K> for UnivariateIntervalRootFinder {
    fn collides(&self, query: &Query<K>) -> bool {
        self.time_of_impact(query).is_some()
    }

    fn time_of_impact(&self, query: &Query<K>) -> Option<f64> {
        let search = Bisection {
            tolerances: [self.tolerance / greatest_displacement(query.points())],
            max_iterations: self.max_iterations,
        };
        let coordinates = Coordinates::new(query.points());
        search.earliest(
            |cell: &Cell<1>| K::BARYCENTRIC.may_be_coplanar(&coordinates, cell.interval(0)),
            |cell: &Cell<1>| K::BARYCENTRIC.may_meet(&coordinates, cell.interval(0)),
        )
    }
}
