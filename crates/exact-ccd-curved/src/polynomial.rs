//! Polynomial trajectories.

use exact_ccd::{Point, environment};
use exact_ccd_mesh::vector::minus;

use crate::rounding::{UNIT, above, length};
use crate::trajectory::{Position, Trajectory, deviation_by_acceleration};

/// A point on a polynomial curve of degree N − 1, given by its N control points p₀ … (a Bézier
/// curve): x(t) = Σ bᵢ(t) pᵢ with Bernstein's polynomials bᵢ of degree N − 1.
///
/// The control points are taken exactly. The curve begins at the first and ends at the last, without
/// error. One control point is a point at rest, two are straight motion, three are constant
/// acceleration, as in free fall.
///
/// ```
/// use exact_ccd_curved::{Polynomial, Trajectory};
///
/// // Thrown up from 0 at speed 4, with acceleration −8: control points 0, v/2 and v + a/2.
/// let ball = Polynomial::new([[0.0, 0.0, 0.0], [0.0, 0.0, 2.0], [0.0, 0.0, 0.0]]);
/// assert_eq!(ball.at(0.5).point, [0.0, 0.0, 1.0]);
/// assert!(ball.deviation(0.0, 1.0) >= 1.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polynomial<const N: usize> {
    control_points: [Point; N],
    /// A bound of the distance between this curve and the intended one, at each time.
    offset: f64,
    /// A bound of |x″|.
    acceleration: f64,
    /// A bound of |pᵢ|, each component on its own.
    magnitude: f64,
}

impl<const N: usize> Polynomial<N> {
    /// The curve with these control points, at least one.
    #[must_use]
    pub fn new(control_points: [Point; N]) -> Self {
        const { assert!(N > 0, "a curve has a control point") };
        let largest = [0, 1, 2].map(|axis| control_points.iter().fold(0.0_f64, |m, p| m.max(p[axis].abs())));
        Self {
            control_points,
            offset: 0.0,
            acceleration: acceleration(&control_points),
            magnitude: above(length(largest)),
        }
    }

    /// The curve x(t) = c₀ + c₁ t + c₂ t² + …, with coefficients taken exactly.
    ///
    /// With velocity v and acceleration a, they are x(0), v and a / 2.
    ///
    /// The control points of this curve of degree n are pᵢ = Σⱼ C(i, j) / C(n, j) cⱼ. The quotients are
    /// at most 1. For n ≤ 50 the binomials are f64, so a quotient and its product have two errors,
    /// and the sum n more: pᵢ is off by at most (n + 3) u Σ |cⱼ|. The functions bᵢ are not negative and
    /// their sum is 1, so the curve is off by no more. For n > 50 nothing is known: the error is
    /// infinite.
    ///
    /// ```
    /// use exact_ccd_curved::Polynomial;
    ///
    /// let ball = Polynomial::from_coefficients([[0.0; 3], [0.0, 0.0, 4.0], [0.0, 0.0, -4.0]]);
    /// assert_eq!(ball.control_points(), &[[0.0; 3], [0.0, 0.0, 2.0], [0.0; 3]]);
    /// ```
    #[must_use]
    pub fn from_coefficients(coefficients: [Point; N]) -> Self {
        let degree = N - 1;
        let control_point = |i: usize| {
            [0, 1, 2].map(|axis: usize| {
                let term = |j: usize| binomial(i, j) / binomial(degree, j) * coefficients[j][axis];
                (0..=i).map(term).sum()
            })
        };
        let size: f64 = coefficients.iter().map(|&c| length(c)).sum();
        let offset = match degree {
            0 if environment::is_default() => 0.0,
            1..=50 => above((degree as f64 + 3.0) * UNIT * size),
            _ => f64::INFINITY,
        };
        Self {
            offset,
            ..Self::new(std::array::from_fn(control_point))
        }
    }

    /// The control points.
    #[must_use]
    pub fn control_points(&self) -> &[Point; N] {
        &self.control_points
    }
}

impl<const N: usize> Trajectory for Polynomial<N> {
    /// By de Casteljau's algorithm: (1 − t) a + t b at each of n = N − 1 levels. A level has three
    /// errors of u in each term, so the result is off by at most ((1 + u)³ⁿ − 1) Σ bᵢ |pᵢ| ≤ 4 n u max
    /// |pᵢ|, on each axis.
    fn at(&self, time: f64) -> Position {
        let points = &self.control_points;
        let at_end = if time == 0.0 {
            points.first()
        } else {
            points.last()
        };
        if let (true, Some(&point)) = (N == 1 || time == 0.0 || time == 1.0, at_end) {
            let error = self.offset;
            return Position { point, error };
        }
        let mut points = *points;
        for level in (1..N).rev() {
            for i in 0..level {
                let (a, b) = (points[i], points[i + 1]);
                points[i] = [0, 1, 2].map(|axis: usize| (1.0 - time) * a[axis] + time * b[axis]);
            }
        }
        let degree = (N - 1) as f64;
        Position {
            point: points[0],
            error: above(4.0 * degree * UNIT * self.magnitude + self.offset),
        }
    }

    /// The bound follows from |x″|. The intended curve is within `offset` of this one, and so are their
    /// chords.
    fn deviation(&self, start: f64, end: f64) -> f64 {
        let deviation = deviation_by_acceleration(self.acceleration, start, end);
        if self.offset == 0.0 {
            return deviation;
        }
        above(deviation + 2.0 * self.offset)
    }
}

/// A bound of |x″|: x″ is the Bézier curve of the points n (n − 1) (pᵢ − 2 pᵢ₊₁ + pᵢ₊₂), n = N − 1,
/// and stays in their convex hull.
///
/// The second difference is computed as a − b with a = pᵢ − pᵢ₊₁ and b = pᵢ₊₁ − pᵢ₊₂. On each axis its
/// error is at most u (|a| + |b| + |a − b|) ≤ 2 u (|a| + |b|), to first order; the bound has 4 u.
fn acceleration(control_points: &[Point]) -> f64 {
    let degree = control_points.len() as f64 - 1.0;
    control_points
        .windows(3)
        .map(|p| {
            let (a, b) = (minus(p[0], p[1]), minus(p[1], p[2]));
            let difference = length(minus(a, b)) + 4.0 * UNIT * (length(a) + length(b));
            above(degree * (degree - 1.0) * difference)
        })
        .fold(0.0, f64::max)
}

/// The binomial coefficient C(n, k), exactly for n ≤ 50: below 2⁵³, and so is each product here.
fn binomial(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |product, i| product * (n - i) as f64 / (i + 1) as f64)
}
