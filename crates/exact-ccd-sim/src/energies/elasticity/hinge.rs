//! Bending of thin shells.

use exact_ccd_mesh::Point;
use nalgebra::{Matrix3, RowSVector, SMatrix, Vector3};

use crate::energies::distance::{Matrix12, Vector12};
use crate::energies::term::{Block, Energy, Projection, gather, write_blocks, write_rows};

/// The bending energy ½ k (θ − θ₀)² of two triangles that share an edge. θ is the angle between their
/// normals, θ₀ that angle at rest, and k = D |e|² / A with the flexural rigidity D, the length |e| of the
/// edge and the area A of both triangles.
///
/// The form is due to E. Grinspun, A. Hirani, M. Desbrun, P. Schröder, *Discrete shells*, 2003, who leave
/// the factor of k open (often it is 3). The factor 1 is exact for a plate that is rolled into a cylinder of
/// curvature κ, whose energy per area is ½ D κ², if edges run along the cylinder: two faces of height w on
/// such an edge have A = w |e| and θ = κ w, so that ½ k θ² = ½ D κ² A. For equilateral triangles, it is exact
/// for any direction of the cylinder. For a grid of squares that is rolled along a diagonal, the energy is
/// 1.5 times as large with alternating diagonals, and once or three times as large with parallel ones.
#[derive(Debug)]
pub(crate) struct Hinge {
    vertices: [u32; 4],
    stiffness: f64,
    rest: f64,
}

impl Hinge {
    /// The hinge of an edge (the first two vertices) between two triangles, whose opposite corners are the
    /// third and the fourth vertex. For a viewer at whom the normals point, the third vertex lies to the left
    /// of the edge and the fourth to its right. `rest` has the positions of all vertices at rest. `None` if a
    /// triangle has no area.
    pub(crate) fn new(vertices: [u32; 4], rest: &[Point], rigidity: f64) -> Option<Self> {
        let shape = Fold::of(rest, &vertices);
        let degenerate = shape.normals.iter().any(|normal| normal.norm_squared() == 0.0);
        (!degenerate).then(|| Self {
            vertices,
            stiffness: rigidity * shape.stiffness(),
            rest: shape.angle(),
        })
    }

    /// θ − θ₀. Both angles are in [−π, π]. θ is discontinuous only where the faces touch, which no
    /// intersection-free motion reaches.
    fn bend(&self, shape: &Fold) -> f64 {
        shape.angle() - self.rest
    }
}

impl Energy for Hinge {
    fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    fn value(&self, points: &[Point]) -> f64 {
        let bend = self.bend(&Fold::of(points, &self.vertices));
        0.5 * self.stiffness * bend * bend
    }

    fn write_gradient(&self, points: &[Point], gradient: &mut [f64]) {
        let shape = Fold::of(points, &self.vertices);
        let moment = self.stiffness * self.bend(&shape);
        write_rows(&(shape.gradient() * moment), gradient);
    }

    fn write_hessian(&self, points: &[Point], projection: Projection, hessian: &mut [Block]) {
        let shape = Fold::of(points, &self.vertices);
        if shape.is_degenerate() {
            return hessian.fill([0.0; 9]);
        }
        let gradient = shape.gradient();
        let second = gradient * gradient.transpose() + shape.hessian() * self.bend(&shape);
        write_blocks(&projection.of(second * self.stiffness), 4, hessian);
    }
}

/// The edge, the sides from its start to the opposite corners, and the normals; none of them is normalised.
pub(super) struct Fold {
    edge: Vector3<f64>,
    sides: [Vector3<f64>; 2],
    normals: [Vector3<f64>; 2],
}

impl Fold {
    /// The fold of four vertices.
    pub(super) fn of(points: &[Point], vertices: &[u32; 4]) -> Self {
        let [a, b, c, d] = gather(points, vertices);
        let edge = b - a;
        let sides = [c - a, d - a];
        let normals = [edge.cross(&sides[0]), sides[1].cross(&edge)];
        Self { edge, sides, normals }
    }

    /// |e|² / A.
    pub(super) fn stiffness(&self) -> f64 {
        self.edge.norm_squared() / (0.5 * (self.normals[0].norm() + self.normals[1].norm()))
    }

    /// The angle from the first normal to the second, counterclockwise about the edge.
    pub(super) fn angle(&self) -> f64 {
        let [n, m] = self.normals;
        let sine = n.cross(&m).dot(&self.edge) / self.edge.norm();
        sine.atan2(n.dot(&m))
    }

    /// Returns true if a face has no area, so that the angle has no derivatives.
    fn is_degenerate(&self) -> bool {
        let length = self.edge.norm();
        let is_line = |normal: &Vector3<f64>| !(length / normal.norm_squared()).is_finite();
        self.normals.iter().any(is_line)
    }

    /// The gradient of the angle by each of the four vertices. Zero if a face has no area.
    ///
    /// A displacement of a corner along the normal rotates its triangle about the edge, by 1 / height. The
    /// foot of the corner on the edge divides the opposite rotation between the ends of the edge.
    pub(super) fn slopes(&self) -> [[f64; 3]; 4] {
        if self.is_degenerate() {
            return [[0.0; 3]; 4];
        }
        let (squared, length) = (self.edge.norm_squared(), self.edge.norm());
        let turn = |normal: Vector3<f64>| normal * (-length / normal.norm_squared());
        let [left, right] = self.normals.map(turn);
        let [foot, other] = self.sides.map(|side| side.dot(&self.edge) / squared);
        let end = left * -foot - right * other;
        let start = -(left + right) - end;
        [start, end, left, right].map(<[f64; 3]>::from)
    }

    /// The gradient of the angle by all of them.
    fn gradient(&self) -> Vector12 {
        Vector12::from_column_slice(self.slopes().as_flattened())
    }

    /// The Hessian of the angle, by the product rule.
    fn hessian(&self) -> Matrix12 {
        let edge = self.edge;
        let (squared, length) = (edge.norm_squared(), edge.norm());
        let edge_change = difference(1);
        let mut hessian = Matrix12::zeros();
        for (index, (side, normal)) in self.sides.into_iter().zip(self.normals).enumerate() {
            let corner = 2 + index;
            let side_change = difference(corner);
            let area = normal.norm_squared();
            let turn = normal * (-length / area);
            let foot = side.dot(&edge) / squared;

            let orientation = if index == 0 { 1.0 } else { -1.0 };
            let normal_change =
                (edge.cross_matrix() * side_change - side.cross_matrix() * edge_change) * orientation;
            let reflection = Matrix3::identity() - normal * normal.transpose() * (2.0 / area);
            let turn_change: SMatrix<f64, 3, 12> = reflection * normal_change * (-length / area)
                - normal * (edge.transpose() * edge_change) * (1.0 / (length * area));
            let foot_change: RowSVector<f64, 12> = (edge.transpose() * side_change
                + side.transpose() * edge_change
                - edge.transpose() * edge_change * (2.0 * foot))
                / squared;

            let shares = [(corner, 1.0, 0.0), (0, foot - 1.0, 1.0), (1, -foot, -1.0)];
            for (vertex, share, change) in shares {
                let mut rows = hessian.fixed_rows_mut::<3>(3 * vertex);
                rows += turn_change * share + turn * foot_change * change;
            }
        }
        (hessian + hessian.transpose()) * 0.5
    }
}

/// The derivative by the four points of the vector from the first point to another.
fn difference(vertex: usize) -> SMatrix<f64, 3, 12> {
    SMatrix::from_fn(|row, column| match (row == column % 3, column / 3) {
        (true, 0) => -1.0,
        (true, other) if other == vertex => 1.0,
        _ => 0.0,
    })
}
