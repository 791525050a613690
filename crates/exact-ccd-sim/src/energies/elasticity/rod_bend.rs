//! Bending of rods.

use exact_ccd_mesh::Point;
use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

use crate::energies::term::{Block, Energy, Projection, gather, write_blocks, write_rows};

/// A vertex of a rod between two edges, with the energy (E I / M) (κ − κ₀)² of the curvature κ = 2
/// tan(φ/2). φ is the angle by which the second edge deviates from the direction of the first, κ₀ the
/// curvature at rest, I the second moment of area of the cross section, and M the sum of the lengths of
/// both edges at rest.
///
/// Source: M. Bergou, M. Wardetzky, S. Robinson, B. Audoly, E. Grinspun, *Discrete elastic rods*, ACM
/// Transactions on Graphics 27(3), 2008, section 4.2, for an isotropic rod. κ is the length of their
/// curvature binormal. A vertex stands for the half M / 2 of its edges, on which the curvature of the rod is
/// κ / (M/2): ½ E I κ² / (M/2) is the energy of a beam. The cross sections of a rod that is curved at rest
/// are taken to turn until this energy is least, whatever resistance there is to twist, so that it depends
/// only on the lengths of the curvatures, not on their directions.
///
/// The energy is infinite if an edge has no length, or if the second edge returns along the first; the
/// derivatives are zero there.
#[derive(Debug)]
pub(crate) struct RodBend {
    vertices: [u32; 3],
    /// E I / M, in J.
    stiffness: f64,
    rest: f64,
}

impl RodBend {
    /// The bending at the second of three vertices, with the positions of all vertices at rest and the
    /// flexural rigidity E I in N m². `None` if an edge has no length at rest, or if the second edge returns
    /// along the first.
    pub(crate) fn new(vertices: [u32; 3], rest: &[Point], rigidity: f64) -> Option<Self> {
        let shape = Shape::new(&gather(rest, &vertices))?;
        let squared = shape.squared();
        squared.is_finite().then(|| Self {
            vertices,
            stiffness: rigidity / (shape.lengths[0] + shape.lengths[1]),
            rest: squared.sqrt(),
        })
    }

    fn shape(&self, points: &[Point]) -> Option<Shape> {
        Shape::new(&gather(points, &self.vertices))
    }

    /// The first and the second derivative of the energy by c = cos φ.
    ///
    /// With κ² = 4 (1 − c) / (1 + c): ∂κ²/∂c = −8 / (1 + c)² and ∂²κ²/∂c² = 16 / (1 + c)³. The energy has the
    /// derivatives k (1 − κ₀/κ) and k κ₀ / (2 κ³) by κ². A straight rod that is curved at rest may bend in
    /// any direction: its energy has a peak there, and no derivatives.
    fn slopes(&self, shape: &Shape) -> [f64; 2] {
        let squared = shape.squared();
        let curvature = squared.sqrt();
        let sum = 0.5 * shape.sum.norm_squared();
        let (first, second) = (-8.0 / (sum * sum), 16.0 / (sum * sum * sum));
        let ratio = if curvature > 0.0 {
            self.rest / curvature
        } else {
            0.0
        };
        let slope = self.stiffness * (1.0 - ratio);
        let bend = if ratio > 0.0 {
            0.5 * self.stiffness * ratio / squared
        } else {
            0.0
        };
        let slopes = [slope * first, bend * first * first + slope * second];
        if slopes.iter().all(|slope| slope.is_finite()) {
            slopes
        } else {
            [0.0; 2]
        }
    }
}

impl Energy for RodBend {
    fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    fn value(&self, points: &[Point]) -> f64 {
        let squared = self.shape(points).map_or(f64::INFINITY, |shape| shape.squared());
        self.stiffness * (squared.sqrt() - self.rest).powi(2)
    }

    fn write_gradient(&self, points: &[Point], gradient: &mut [f64]) {
        let Some(shape) = self.shape(points) else {
            return gradient.fill(0.0);
        };
        let by_edges = shape.gradient() * self.slopes(&shape)[0];
        write_rows(&ends().tr_mul(&by_edges), gradient);
    }

    fn write_hessian(&self, points: &[Point], projection: Projection, hessian: &mut [Block]) {
        let Some(shape) = self.shape(points) else {
            return hessian.fill([0.0; 9]);
        };
        let [first, second] = self.slopes(&shape);
        let gradient = shape.gradient();
        let by_edges = shape.hessian() * first + gradient * gradient.transpose() * second;
        let ends = ends();
        write_blocks(&ends.tr_mul(&(projection.of(by_edges) * ends)), 3, hessian);
    }
}

/// The directions of both edges, their difference and sum, and the lengths of the edges.
struct Shape {
    directions: [Vector3<f64>; 2],
    difference: Vector3<f64>,
    sum: Vector3<f64>,
    lengths: [f64; 2],
}

impl Shape {
    /// `None` if an edge has no length.
    fn new(points: &[Vector3<f64>; 3]) -> Option<Self> {
        let edges = [points[1] - points[0], points[2] - points[1]];
        let directions = [edges[0].try_normalize(0.0)?, edges[1].try_normalize(0.0)?];
        Some(Self {
            directions,
            difference: directions[1] - directions[0],
            sum: directions[0] + directions[1],
            lengths: edges.map(|edge| edge.norm()),
        })
    }

    /// κ² = 4 tan²(φ/2), from the diagonals of the rhombus of both directions: no digits are lost near φ = 0.
    fn squared(&self) -> f64 {
        4.0 * self.difference.norm_squared() / self.sum.norm_squared()
    }

    /// The gradient of cos φ by both edges.
    fn gradient(&self) -> SVector<f64, 6> {
        let [p, q] = self.across();
        let mut gradient = SVector::<f64, 6>::zeros();
        gradient.fixed_rows_mut::<3>(0).copy_from(&(p / self.lengths[0]));
        gradient.fixed_rows_mut::<3>(3).copy_from(&(q / self.lengths[1]));
        gradient
    }

    /// The Hessian of cos φ by both edges.
    fn hessian(&self) -> SMatrix<f64, 6, 6> {
        let [u, v] = self.directions;
        let cosine = u.dot(&v);
        let [p, q] = self.across();
        let [a, b] = self.lengths;
        let own = |u: Vector3<f64>, p: Vector3<f64>, length: f64| {
            let mixed = u * p.transpose();
            let plane = Matrix3::identity() - u * u.transpose();
            (mixed + mixed.transpose() + plane * cosine) / (-length * length)
        };
        let crossed = (Matrix3::identity() - v * v.transpose() - u * q.transpose()) / (a * b);
        let mut hessian = SMatrix::<f64, 6, 6>::zeros();
        hessian.fixed_view_mut::<3, 3>(0, 0).copy_from(&own(u, p, a));
        hessian.fixed_view_mut::<3, 3>(3, 3).copy_from(&own(v, q, b));
        hessian.fixed_view_mut::<3, 3>(0, 3).copy_from(&crossed);
        hessian
            .fixed_view_mut::<3, 3>(3, 0)
            .copy_from(&crossed.transpose());
        hessian
    }

    /// The part of each direction across the other edge: v − (u · v) u and u − (u · v) v.
    fn across(&self) -> [Vector3<f64>; 2] {
        let [u, v] = self.directions;
        [
            self.difference - u * u.dot(&self.difference),
            v * v.dot(&self.difference) - self.difference,
        ]
    }
}

/// The derivative of both edges by the points.
pub(super) fn ends() -> SMatrix<f64, 6, 9> {
    SMatrix::from_fn(
        |row, column| match (row % 3 == column % 3, (column / 3).checked_sub(row / 3)) {
            (true, Some(0)) => -1.0,
            (true, Some(1)) => 1.0,
            _ => 0.0,
        },
    )
}
