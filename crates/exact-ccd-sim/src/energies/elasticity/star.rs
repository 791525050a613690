//! Bending of thin shells, averaged about vertices.
//!
//! The curvature of a surface of triangles is concentrated at its edges: its integral along an edge of length
//! l with the unit normal n in the surface is l θ n ⊗ n, where θ is the change of the angle between both
//! faces. The mean curvature tensor about a vertex, weighted by the linear function that is 1 at the vertex,
//! is M θ = Σ ½ l θ n ⊗ n / A, over the edges of the vertex, with a third of the area of its faces, A.
//!
//! Let the angles be C κ where the vertices are on a graph of constant curvature κ. On regular meshes M C =
//! 1; on others, and at the boundary, the mean of constant curvature is another one. H = (M C)⁻¹ M θ is the
//! curvature of any such graph. It does not explain the rest r = θ − C H of the angles. The energy is the sum
//! of a plate's energy and of hinges for the rest, with the factor s = ¾:
//!
//! ½ A D ((1 − ν) H : H + ν (tr H)²) + ½ Σ ½ s D (l² / a) r²,
//!
//! with the flexural rigidity D, Poisson's ratio ν and the area a of both faces of an edge; either end of the
//! edge has half of its term. The rest of a constant curvature is 0: the energy then equals the plate's,
//! about each vertex whose edges show all three components of the curvature. Where they do not, as at a
//! vertex with one inner edge, the energy has the components that they show; a vertex of one face has none.
//! This is the principle of the virtual element method, a consistent part and a stable rest: L. Beirão da
//! Veiga, F. Brezzi, A. Cangiani, G. Manzini, L. Marini, A. Russo, *Basic principles of virtual element
//! methods*, 2013. The mean follows O. Stein, E. Grinspun, M. Wardetzky, A. Jacobson, *Natural boundary
//! conditions for smoothing in geometry processing*, 2018, with terms of the vertices on the boundary too.

use std::collections::BTreeMap;
use std::f64::consts::SQRT_2;
use std::sync::Arc;

use exact_ccd_mesh::Point;
use nalgebra::{DMatrix, DVector, Matrix3, Matrix3xX, MatrixXx3, RowVector3, Vector3};

use super::hinge::{Fold, Hinge};
use super::interior_edges::{InteriorEdge, interior_edges};
use super::vertex_bend::VertexBend;
use crate::energies::term::{Energy, gather};

/// The stiffness against the part of a fold that no curvature explains, relative to a [`Hinge`]. It has no
/// effect on constant curvature. The value has the least errors of the strips of
/// `docs/simulation/validation.md`.
const REST: f64 = 0.75;

/// The least singular value of the mean of a curvature about a vertex that counts: for most meshes, all are
/// near 1. Curvatures that the hinges of a vertex do not show count as zero.
const LEAST: f64 = 0.01;

/// The faces and hinges about a vertex.
#[derive(Default)]
struct Star {
    faces: usize,
    area: f64,
    normal: Vector3<f64>,
    sides: Vec<usize>,
    /// True if neighbouring faces have different orientations, so that angles have different signs.
    is_twisted: bool,
}

impl Star {
    /// The corners of each of its hinges.
    fn corners(&self, sides: &[InteriorEdge]) -> Vec<[u32; 4]> {
        self.sides.iter().map(|&side| sides[side].vertices).collect()
    }

    /// M and C for the hinges with these corners.
    fn mean(&self, points: &[Point], corners: &[[u32; 4]]) -> (Matrix3xX<f64>, MatrixXx3<f64>) {
        let plane = Plane::of(self);
        let (mut means, mut angles) = (Matrix3xX::zeros(corners.len()), MatrixXx3::zeros(corners.len()));
        for (place, corners) in corners.iter().enumerate() {
            let shape = Fold::of(points, corners);
            let corners = gather(points, corners);
            means.set_column(
                place,
                &(plane.across(corners[1] - corners[0]) * (0.5 / self.area)),
            );
            angles.set_row(
                place,
                &plane.angles(&shape, corners.map(|corner| corner - corners[0])),
            );
        }
        (means, angles)
    }

    /// The stiffness of a plate and of the rest by the angles of the hinges with these corners, for D = 1.
    fn stiffness(&self, points: &[Point], corners: &[[u32; 4]], poisson: f64) -> DMatrix<f64> {
        let (means, angles) = self.mean(points, corners);
        let found = (&means * &angles).pseudo_inverse(LEAST);
        let curvature = found.unwrap_or_else(|_| Matrix3::zeros()) * means;
        let rest = DMatrix::identity(corners.len(), corners.len()) - angles * &curvature;
        let trace = Vector3::new(1.0, 1.0, 0.0);
        let plate = Matrix3::identity() * (1.0 - poisson) + trace * trace.transpose() * poisson;
        let of_rest = DVector::from_iterator(
            corners.len(),
            corners
                .iter()
                .map(|corners| 0.5 * REST * Fold::of(points, corners).stiffness()),
        );
        curvature.transpose() * (plate * self.area) * &curvature
            + rest.transpose() * DMatrix::from_diagonal(&of_rest) * &rest
    }
}

/// The hinges of a shell with these faces, and the stars of its vertices.
fn stars(points: &[Point], faces: &[[u32; 3]]) -> (Vec<InteriorEdge>, BTreeMap<u32, Star>) {
    let sides = interior_edges(faces);
    let mut stars = BTreeMap::<u32, Star>::new();
    for face in faces {
        let [a, b, c] = gather(points, face);
        let normal = (b - a).cross(&(c - a));
        for &corner in face {
            let star = stars.entry(corner).or_default();
            star.faces += 1;
            star.area += normal.norm() / 6.0;
            star.normal += normal;
        }
    }
    for (number, side) in sides.iter().enumerate() {
        for end in &side.vertices[..2] {
            let star = stars.entry(*end).or_default();
            star.sides.push(number);
            star.is_twisted |= !side.is_oriented;
        }
    }
    (sides, stars)
}

/// The part of the inner vertices of a shell with these faces whose edges do not show all components of the
/// curvature: mostly those of four edges along two directions, which do not resist twist. 0 without inner
/// vertices.
pub(crate) fn incomplete_part(points: &[Point], faces: &[[u32; 3]]) -> f64 {
    let (sides, stars) = stars(points, faces);
    let inner: Vec<&Star> = stars
        .values()
        .filter(|star| star.sides.len() == star.faces)
        .collect();
    let is_incomplete = |star: &&&Star| {
        let (means, angles) = star.mean(points, &star.corners(&sides));
        (means * angles).singular_values().min() <= LEAST
    };
    let incomplete = inner.iter().filter(is_incomplete).count();
    incomplete as f64 / inner.len().max(1) as f64
}

/// The bending energies of a shell with these faces.
pub(crate) fn bending(
    points: &[Point],
    faces: &[[u32; 3]],
    rigidity: f64,
    poisson: f64,
) -> Vec<Arc<dyn Energy>> {
    let (sides, stars) = stars(points, faces);
    let mut elements: Vec<Arc<dyn Energy>> = Vec::new();
    for side in &sides {
        let ends = side.vertices[..2].iter().filter_map(|end| stars.get(end));
        let twisted = ends.filter(|star| star.is_twisted).count();
        if twisted == 0 {
            continue;
        }
        let hinge = Hinge::new(side.vertices, points, 0.5 * twisted as f64 * rigidity);
        elements.extend(hinge.map(|hinge| Arc::new(hinge) as Arc<dyn Energy>));
    }
    let whole = stars
        .iter()
        .filter(|(_, star)| !star.is_twisted && !star.sides.is_empty());
    for (&vertex, star) in whole {
        let corners = star.corners(&sides);
        let stiffness = star.stiffness(points, &corners, poisson) * rigidity;
        elements.push(Arc::new(VertexBend::new(vertex, &corners, points, stiffness)));
    }
    elements
}

/// The tangent plane of a vertex at rest. Symmetric tensors in it are vectors of xx, yy and √2 xy, which
/// have the same products.
struct Plane {
    normal: Vector3<f64>,
    axes: [Vector3<f64>; 2],
}

impl Plane {
    fn of(star: &Star) -> Self {
        let normal = star.normal.try_normalize(0.0).unwrap_or_else(Vector3::z);
        let first = normal.cross(&Vector3::ith(normal.iamin(), 1.0)).normalize();
        Self {
            normal,
            axes: [first, normal.cross(&first)],
        }
    }

    fn coordinates(&self, vector: &Vector3<f64>) -> [f64; 2] {
        self.axes.map(|axis| axis.dot(vector))
    }

    /// l n ⊗ n for an edge of length l in space and the normal n to it in the plane.
    fn across(&self, edge: Vector3<f64>) -> Vector3<f64> {
        let [x, y] = self.coordinates(&edge);
        let square = x * x + y * y;
        if square > 0.0 {
            Vector3::new(y * y, x * x, -SQRT_2 * x * y) * (edge.norm() / square)
        } else {
            Vector3::zeros()
        }
    }

    /// The change of the angle of a fold, if its vertices rise along the normal to ½ x κ x, for each of the
    /// three coordinates of κ. The derivatives of an angle do not depend on linear functions of x: its
    /// origin is arbitrary.
    fn angles(&self, shape: &Fold, corners: [Vector3<f64>; 4]) -> RowVector3<f64> {
        let changes = corners.iter().zip(shape.slopes()).map(|(corner, slope)| {
            let [x, y] = self.coordinates(corner);
            let rise = Vector3::from(slope).dot(&self.normal);
            RowVector3::new(0.5 * x * x, 0.5 * y * y, x * y / SQRT_2) * rise
        });
        changes.sum()
    }
}
