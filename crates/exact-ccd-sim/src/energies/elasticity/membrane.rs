//! In-plane deformation of thin shells.

use exact_ccd_mesh::Point;
use nalgebra::{Matrix2, Matrix3, Matrix3x2, SMatrix, Vector2, Vector3};

use super::lame::ElasticModuli;
use super::strain_limit::{StrainLimit, principal};
use crate::energies::term::{Block, Energy, Projection, gather, write_each};

/// A triangle of a thin shell under plane stress, with the Saint Venant-Kirchhoff energy
/// h A (μ |E|² + λ/2 tr² E) of the strain E = ½ (FᵀF − 1) in the plane of the triangle. The stretches can
/// have a limit.
#[derive(Debug)]
pub(crate) struct Membrane {
    vertices: [u32; 3],
    /// Row i is the gradient of vertex i's barycentric coordinate, in coordinates of the plane at rest.
    shape: SMatrix<f64, 3, 2>,
    area: f64,
    thickness: f64,
    mu: f64,
    lambda: f64,
    limit: Option<StrainLimit>,
}

impl Membrane {
    /// The triangle of these vertices, with the positions of all vertices at rest. `None` if it has no area
    /// at rest.
    pub(crate) fn new(
        vertices: [u32; 3],
        rest: &[Point],
        thickness: f64,
        moduli: ElasticModuli,
    ) -> Option<Self> {
        let [origin, a, b] = gather(rest, &vertices);
        let (a, b) = (a - origin, b - origin);
        let area = 0.5 * a.cross(&b).norm();
        let along = a.try_normalize(0.0)?;
        let across = (b - along * along.dot(&b)).try_normalize(0.0)?;
        let plane = Matrix2::new(a.dot(&along), b.dot(&along), 0.0, b.dot(&across));
        let inverse = plane.try_inverse().filter(|_| area > 0.0)?;
        let mut shape = SMatrix::<f64, 3, 2>::zeros();
        shape.fixed_view_mut::<2, 2>(1, 0).copy_from(&inverse);
        shape.set_row(0, &-inverse.row_sum());
        Some(Self {
            vertices,
            shape,
            area,
            thickness,
            mu: moduli.shear(),
            lambda: moduli.plane_lambda(),
            limit: None,
        })
    }

    /// The same triangle with another limit of its stretches.
    pub(crate) fn with_limit(self, limit: Option<StrainLimit>) -> Self {
        Self { limit, ..self }
    }

    /// The volume at rest, in m³.
    pub(crate) fn volume(&self) -> f64 {
        self.area * self.thickness
    }

    fn deformation(&self, points: &[Point]) -> Matrix3x2<f64> {
        let [origin, a, b] = gather(points, &self.vertices);
        Matrix3x2::from_columns(&[a - origin, b - origin]) * self.shape.fixed_view::<2, 2>(1, 0)
    }

    /// The second Piola-Kirchhoff stress at C = FᵀF.
    fn stress(&self, c: &Matrix2<f64>) -> Matrix2<f64> {
        let stress = self.linear(&strain(c));
        match &self.limit {
            None => stress,
            Some(limit) => stress + limit.stress(c),
        }
    }

    /// The second derivatives in a frame. Their eigenvalues are projected.
    fn modes(&self, frame: &Frame, projection: Projection) -> Modes {
        let stretches = &frame.stretches;
        let squares = stretches.component_mul(stretches);
        let strains = squares.add_scalar(-1.0) * 0.5;
        let mut stresses = (strains * (2.0 * self.mu)).add_scalar(self.lambda * strains.sum());
        let mut slopes = Matrix2::repeat(0.5 * self.lambda) + Matrix2::from_diagonal_element(self.mu);
        let mut quotient = self.mu;
        if let Some(limit) = &self.limit {
            let limited = limit.principal(&frame.squares);
            stresses += limited.stresses;
            slopes += Matrix2::from_diagonal(&limited.slopes);
            quotient += limited.quotient;
        }
        let products = stretches * stretches.transpose() * 2.0;
        let stretch = Matrix2::from_diagonal(&stresses) + slopes.component_mul(&products);
        let mean = 0.5 * stresses.sum();
        let [twist, flip] = [stretches.x - stretches.y, stretches.sum()]
            .map(|size| 0.5 * projection.of_value(mean + 0.5 * size * size * quotient));
        Modes {
            stretch: projection.of(stretch),
            own: flip + twist,
            crossed: flip - twist,
            out: stresses.map(|stress| projection.of_value(stress)),
        }
    }

    /// The stress 2 μ E + λ tr E without a limit.
    fn linear(&self, strain: &Matrix2<f64>) -> Matrix2<f64> {
        strain * (2.0 * self.mu) + Matrix2::identity() * (self.lambda * strain.trace())
    }
}

impl Energy for Membrane {
    fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    fn value(&self, points: &[Point]) -> f64 {
        let f = self.deformation(points);
        let c = f.tr_mul(&f);
        let strain = strain(&c);
        let trace = strain.trace();
        let density = self.mu * strain.norm_squared() + 0.5 * self.lambda * trace * trace;
        let limited = self.limit.map_or(0.0, |limit| limit.value(&c));
        self.volume() * (density + limited)
    }

    fn write_gradient(&self, points: &[Point], gradient: &mut [f64]) {
        let f = self.deformation(points);
        let forces = f * self.stress(&f.tr_mul(&f)) * self.shape.transpose() * self.volume();
        gradient.copy_from_slice(forces.as_slice());
    }

    /// The Hessian in the frame of the singular vectors of F. The columns of F do not depend on the place of
    /// the triangle, so that the blocks of the first vertex follow from the others.
    fn write_hessian(&self, points: &[Point], projection: Projection, hessian: &mut [Block]) {
        let frame = Frame::of(&self.deformation(points));
        let modes = self.modes(&frame, projection);
        let [_, b, c] = [0, 1, 2].map(|row| frame.plane.tr_mul(&self.shape.row(row).transpose()));
        let block = |a: &Vector2<f64>, b: &Vector2<f64>| {
            frame.axes * modes.block(a, b) * frame.axes.transpose() * self.volume()
        };
        let [bb, cb, cc] = [block(&b, &b), block(&c, &b), block(&c, &c)];
        let [ba, ca] = [-bb - cb.transpose(), -cb - cc];
        let aa = -(ba + ca);
        write_each([aa, ba, ca, bb, cb, cc], hessian);
    }
}

/// The singular values of F = Σ σᵢ uᵢ vᵢᵀ, and its singular vectors.
struct Frame {
    /// u₁, u₂ and the normal.
    axes: Matrix3<f64>,
    /// v₁ and v₂.
    plane: Matrix2<f64>,
    /// σ₁ ≥ σ₂ ≥ 0.
    stretches: Vector2<f64>,
    /// The eigenvalues of FᵀF, with the bits that the value and the stress have.
    squares: Vector2<f64>,
}

impl Frame {
    /// v₁ and v₂ are the eigenvectors of FᵀF. Then u₁ σ₁ = F v₁, and u₂ σ₂ is the part of F v₂ across u₁.
    /// Up to rounding that is all of F v₂, so that the error of σ₂ is a few ulps of σ₁.
    fn of(f: &Matrix3x2<f64>) -> Self {
        let (squares, plane) = principal(&f.tr_mul(f));
        let [along, across] = [f * plane.column(0), f * plane.column(1)];
        let first = along.try_normalize(0.0).unwrap_or_else(Vector3::x);
        let across = across - first * first.dot(&across);
        let any = || first.cross(&Vector3::ith(first.iamin(), 1.0)).normalize();
        // A part across u₁ of a few ulps of σ₁ is rounding, without a direction of its own.
        let least = 4.0 * f64::EPSILON * along.norm();
        let second = across.try_normalize(least).unwrap_or_else(any);
        Self {
            axes: Matrix3::from_columns(&[first, second, first.cross(&second)]),
            plane,
            stretches: Vector2::new(along.norm(), across.norm()),
            squares,
        }
    }
}

/// The second derivatives of the energy by volume, ψ(σ₁, σ₂), in the frame of the singular vectors of F.
///
/// With the principal stresses Sᵢ = ∂ψ/∂σᵢ / σᵢ, which are functions of λ = σ², and the quotient Q = (S₁ −
/// S₂) / (λ₁ − λ₂), the eigenvalues of both rotations and shears of the plane into itself, (σ₁ S₁ ± σ₂ S₂) /
/// (σ₁ ± σ₂), are ½ (S₁ + S₂) + ½ (σ₁ ∓ σ₂)² Q. The eigenvalues of both rotations out of the plane are S₁ and
/// S₂.
struct Modes {
    /// ∂²ψ/∂σᵢ∂σⱼ = Sᵢ δᵢⱼ + 2 σᵢ σⱼ ∂Sᵢ/∂λⱼ.
    stretch: Matrix2<f64>,
    /// ∂²ψ/∂F₁₂² = ∂²ψ/∂F₂₁².
    own: f64,
    /// ∂²ψ/∂F₁₂∂F₂₁.
    crossed: f64,
    /// ∂²ψ/∂F₃ᵢ².
    out: Vector2<f64>,
}

impl Modes {
    /// The second derivatives by two points x and y on which F depends as x aᵀ and y bᵀ.
    fn block(&self, a: &Vector2<f64>, b: &Vector2<f64>) -> Matrix3<f64> {
        let crossed = |i: usize, j: usize| a[i] * b[j] * self.stretch[(i, j)] + a[j] * b[i] * self.crossed;
        Matrix3::new(
            a.x * b.x * self.stretch.m11 + a.y * b.y * self.own,
            crossed(0, 1),
            0.0,
            crossed(1, 0),
            a.x * b.x * self.own + a.y * b.y * self.stretch.m22,
            0.0,
            0.0,
            0.0,
            a.x * b.x * self.out.x + a.y * b.y * self.out.y,
        )
    }
}

/// The Green strain ½ (C − 1) of C = FᵀF.
fn strain(c: &Matrix2<f64>) -> Matrix2<f64> {
    (c - Matrix2::identity()) * 0.5
}
