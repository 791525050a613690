//! The bending of thin shells.

use arrayvec::ArrayVec;
use nalgebra::{Matrix3, RowSVector, SMatrix, Vector3};

use crate::element::{Element, Matrix12, Vector12};
use crate::psd;

/// Two triangles that share an edge resist bending about it: ½ k (θ − θ₀)² with the angle θ between their normals, the
/// angle θ₀ at rest and k = D |e|² / A for the flexural rigidity D, the length of the edge and the area of both triangles.
///
/// That is the energy of E. Grinspun, A. Hirani, M. Desbrun, P. Schröder, *Discrete shells*, 2003, with the factor (there it
/// is open, and often 3) with which a plate that is rolled into a cylinder of curvature κ has ½ D κ² per area if edges run
/// along the cylinder: two faces of height w on such an edge have A = w |e|, and θ = κ w, so that ½ k θ² = ½ D κ² A.
/// Equilateral triangles have it whichever way they are rolled; squares that are rolled along a diagonal have 1.5 times as
/// much with diagonals in turn, once or three times with parallel ones.
#[derive(Clone, Debug)]
pub struct Hinge {
    vertices: [u32; 4],
    stiffness: f64,
    rest: f64,
}

impl Hinge {
    /// The hinge of an edge, the first two vertices, between two triangles, whose third corners are the others: seen from
    /// outside, the third lies to the left of the edge and the fourth to its right. `None` if a triangle has no area.
    #[must_use]
    pub fn new(vertices: [u32; 4], rest: &[Vector3<f64>; 4], rigidity: f64) -> Option<Self> {
        let shape = Shape::new(rest);
        let area = 0.5 * (shape.normals[0].norm() + shape.normals[1].norm());
        let degenerate = shape.normals.iter().any(|normal| normal.norm_squared() == 0.0);
        (!degenerate).then(|| Self {
            vertices,
            stiffness: rigidity * shape.edge.norm_squared() / area,
            rest: shape.angle(),
        })
    }

    /// The vertices.
    #[must_use]
    pub fn vertices(&self) -> [u32; 4] {
        self.vertices
    }

    /// The energy with the vertices at these points, in J.
    #[must_use]
    pub fn value(&self, points: &[Vector3<f64>; 4]) -> f64 {
        let bend = self.bend(&Shape::new(points));
        0.5 * self.stiffness * bend * bend
    }

    /// The gradient of the energy.
    #[must_use]
    pub fn gradient(&self, points: &[Vector3<f64>; 4]) -> Vector12 {
        let shape = Shape::new(points);
        let (gradient, _) = shape.derivatives();
        gradient * (self.stiffness * self.bend(&shape))
    }

    /// The derivatives of the energy; the Hessian is projected if asked for.
    #[must_use]
    pub fn derivatives(&self, points: &[Vector3<f64>; 4], projected: bool) -> Element {
        let shape = Shape::new(points);
        let bend = self.bend(&shape);
        let (gradient, second) = shape.derivatives();
        let hessian = (gradient * gradient.transpose() + second * bend) * self.stiffness;
        Element {
            vertices: ArrayVec::from(self.vertices),
            gradient: gradient * (self.stiffness * bend),
            hessian: if projected { psd::project(hessian) } else { hessian },
        }
    }

    /// θ − θ₀. Both are within half a turn: where the angle jumps, the faces touch, and there nothing passes.
    fn bend(&self, shape: &Shape) -> f64 {
        shape.angle() - self.rest
    }
}

/// The edge, the other sides from its start, and the normals, all with their lengths.
struct Shape {
    edge: Vector3<f64>,
    sides: [Vector3<f64>; 2],
    normals: [Vector3<f64>; 2],
}

impl Shape {
    fn new(points: &[Vector3<f64>; 4]) -> Self {
        let edge = points[1] - points[0];
        let sides = [points[2] - points[0], points[3] - points[0]];
        let normals = [edge.cross(&sides[0]), sides[1].cross(&edge)];
        Self { edge, sides, normals }
    }

    /// The angle from the first normal to the second, counterclockwise about the edge.
    fn angle(&self) -> f64 {
        let [n, m] = self.normals;
        let sine = n.cross(&m).dot(&self.edge) / self.edge.norm();
        sine.atan2(n.dot(&m))
    }

    /// Gradient and Hessian of the angle.
    ///
    /// A corner turns its triangle when it moves along the normal, by 1 / height; where the corner is above the edge tells
    /// how the ends of the edge turn it. The Hessian follows by the product rule.
    fn derivatives(&self) -> (Vector12, Matrix12) {
        let edge = self.edge;
        let (squared, length) = (edge.norm_squared(), edge.norm());
        let edge_change = difference(1);
        let mut gradient = Vector12::zeros();
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
                let mut rows = gradient.fixed_rows_mut::<3>(3 * vertex);
                rows += turn * share;
                let mut rows = hessian.fixed_rows_mut::<3>(3 * vertex);
                rows += turn_change * share + turn * foot_change * change;
            }
        }
        (gradient, (hessian + hessian.transpose()) * 0.5)
    }
}

/// How the vector from the first point to another changes with the four points.
fn difference(vertex: usize) -> SMatrix<f64, 3, 12> {
    SMatrix::from_fn(|row, column| match (row == column % 3, column / 3) {
        (true, 0) => -1.0,
        (true, other) if other == vertex => 1.0,
        _ => 0.0,
    })
}
