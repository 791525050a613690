//! The smallest ball around points.

use exact_ccd_mesh::Point;
use nalgebra::{Matrix3, Vector3};

/// The diameter of the smallest ball that contains some points, which does not depend on the axes. 0 without
/// points.
///
/// At most four of the points, the support, determine the ball. The farthest point joins them, and the
/// smallest ball of these five replaces the ball, until no point is outside. Each ball is larger than the
/// one before, so that no support repeats.
pub(crate) fn diameter(points: impl Iterator<Item = Point>) -> f64 {
    let mut points: Vec<Vector3<f64>> = points.map(Vector3::from).collect();
    let Some(&first) = points.first() else {
        return 0.0;
    };
    // Far from the origin, distances from the first point have smaller rounding errors.
    points.iter_mut().for_each(|point| *point -= first);
    let mut ball = Ball::through(vec![Vector3::zeros()]);
    loop {
        let center = ball.center;
        let distance = |point: &Vector3<f64>| (point - center).norm();
        let farthest = points
            .iter()
            .max_by(|a, b| distance(a).total_cmp(&distance(b)))
            .unwrap_or(&points[0]);
        match ball.with(*farthest) {
            Some(next) if !ball.contains(farthest) && next.radius > ball.radius => ball = next,
            // All points are inside; or rounding errors or an overflow end the search.
            _ => return 2.0 * ball.radius.max(distance(farthest)),
        }
    }
}

/// The ball with some points on its sphere.
struct Ball {
    support: Vec<Vector3<f64>>,
    center: Vector3<f64>,
    radius: f64,
}

/// The tolerance for points outside, relative to the radius: much more than its rounding errors.
const OUTSIDE: f64 = 1e-9;

impl Ball {
    /// The ball with a center in the affine hull of these points. It is not finite if they depend on each
    /// other.
    fn through(support: Vec<Vector3<f64>>) -> Self {
        let origin = support[0];
        let edges: Vec<Vector3<f64>> = support[1..].iter().map(|point| point - origin).collect();
        // The center c from the origin has 2 c · e = e · e for each edge e, and no part across them.
        let products = Matrix3::from_fn(|row, column| match (edges.get(row), edges.get(column)) {
            (Some(a), Some(b)) => a.dot(b),
            _ => f64::from(u8::from(row == column)),
        });
        let halves = Vector3::from_fn(|row, _| edges.get(row).map_or(0.0, |edge| 0.5 * edge.norm_squared()));
        let factors = products.lu().solve(&halves);
        let factors = factors.unwrap_or_else(|| Vector3::repeat(f64::NAN));
        let center: Vector3<f64> = edges
            .iter()
            .zip(&factors)
            .map(|(edge, factor)| edge * *factor)
            .sum();
        Self {
            support,
            center: origin + center,
            radius: center.norm(),
        }
    }

    fn contains(&self, point: &Vector3<f64>) -> bool {
        (point - self.center).norm() <= self.radius * (1.0 + OUTSIDE)
    }

    /// The smallest ball of the support and a further point.
    fn with(&self, point: Vector3<f64>) -> Option<Self> {
        let all: Vec<Vector3<f64>> = self.support.iter().copied().chain([point]).collect();
        let subsets = (1_u32..1 << all.len()).filter(|subset| subset.count_ones() <= 4);
        let ball = |subset: u32| {
            let chosen = (0..all.len()).filter(|place| subset >> place & 1 == 1);
            Self::through(chosen.map(|place| all[place]).collect())
        };
        let balls = subsets
            .map(ball)
            .filter(|ball| all.iter().all(|point| ball.contains(point)));
        balls.min_by(|a, b| a.radius.total_cmp(&b.radius))
    }
}
