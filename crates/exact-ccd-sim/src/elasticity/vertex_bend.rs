//! Bending of thin shells, averaged about vertices.

use std::collections::BTreeMap;
use std::sync::Arc;

use exact_ccd_mesh::Point;
use nalgebra::{DMatrix, DVector, Vector3};

use super::hinge::{Fold, Hinge};
use crate::energy::{Energy, Projection, gather};
use crate::hinges::{Side, hinges};

/// The part of the bending energy that hinges have on their own, see [`VertexBend`].
const OWN: f64 = 0.2;

/// The bending energy of the hinges that share a vertex.
///
/// The curvature of a surface of triangles is concentrated at its edges: its integral along an edge of length
/// l with the unit normal n in the surface is l θ n ⊗ n, where θ is the change of the angle between both
/// faces. The mean curvature tensor about a vertex, weighted by the linear function that is 1 at the vertex,
/// is H = Σ ½ l θ n ⊗ n / A, over the edges of the vertex, with a third of the area of its faces, A. The
/// energy is that of a plate: ½ A D ((1 − ν) H : H + ν (tr H)²), with the flexural rigidity D and Poisson's
/// ratio ν.
///
/// The energy of a shell is 0.8 times the sum of this over all vertices, and 0.2 times that of its
/// [hinges](Hinge), which also resist the folds whose mean about every vertex vanishes. That of hinges alone
/// depends on the arrangement of the triangles, not on their size: strips are up to 21 % too soft. The mean
/// is a mixed finite element of the Hessian with lumped masses, as that of O. Stein, E. Grinspun, M.
/// Wardetzky, A. Jacobson, *Natural boundary conditions for smoothing in geometry processing*, 2018, with
/// terms of the vertices on the boundary too.
#[derive(Debug)]
pub(crate) struct VertexBend {
    vertices: Vec<u32>,
    /// The vertices of each hinge, by their places in `vertices`.
    folds: Vec<[usize; 4]>,
    /// The angle of each hinge at rest.
    rest: Vec<f64>,
    /// The Hessian of the energy by the angles.
    stiffness: DMatrix<f64>,
}

impl VertexBend {
    fn shapes(&self, points: &[Point]) -> Vec<Fold> {
        let fold = |fold: &[usize; 4]| Fold::of(points, &fold.map(|place| self.vertices[place]));
        self.folds.iter().map(fold).collect()
    }

    /// The changes of the angles since rest.
    fn bends(&self, shapes: &[Fold]) -> DVector<f64> {
        let bends = shapes
            .iter()
            .zip(&self.rest)
            .map(|(shape, rest)| shape.angle() - rest);
        DVector::from_iterator(shapes.len(), bends)
    }

    /// The derivatives of the angles, a column each.
    fn changes(&self, shapes: &[Fold]) -> DMatrix<f64> {
        let mut changes = DMatrix::zeros(3 * self.vertices.len(), shapes.len());
        for (column, (shape, fold)) in shapes.iter().zip(&self.folds).enumerate() {
            let gradient = shape.gradient();
            for (corner, &place) in fold.iter().enumerate() {
                let mut rows = changes.fixed_view_mut::<3, 1>(3 * place, column);
                rows += gradient.fixed_rows::<3>(3 * corner);
            }
        }
        changes
    }
}

impl Energy for VertexBend {
    fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    fn value(&self, points: &[Point]) -> f64 {
        let bends = self.bends(&self.shapes(points));
        0.5 * bends.dot(&(&self.stiffness * &bends))
    }

    fn gradient(&self, points: &[Point]) -> DVector<f64> {
        let shapes = self.shapes(points);
        self.changes(&shapes) * (&self.stiffness * self.bends(&shapes))
    }

    /// The Hessian without second derivatives of angles, which is positive semi-definite.
    fn hessian(&self, points: &[Point], _: Projection) -> DMatrix<f64> {
        let changes = self.changes(&self.shapes(points));
        &changes * &self.stiffness * changes.transpose()
    }
}

/// The faces and hinges about a vertex.
#[derive(Default)]
struct Star {
    area: f64,
    normal: Vector3<f64>,
    sides: Vec<usize>,
    /// True if neighbouring faces have different orientations, so that angles have different signs.
    is_twisted: bool,
}

/// The bending energies of a shell with these faces.
pub(crate) fn bending(
    points: &[Point],
    faces: &[[u32; 3]],
    rigidity: f64,
    poisson: f64,
) -> Vec<Arc<dyn Energy>> {
    let sides = hinges(faces);
    let mut stars = BTreeMap::<u32, Star>::new();
    for face in faces {
        let [a, b, c] = gather(points, face);
        let normal = (b - a).cross(&(c - a));
        for &corner in face {
            let star = stars.entry(corner).or_default();
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
    let mut elements: Vec<Arc<dyn Energy>> = Vec::new();
    for side in &sides {
        let ends = side.vertices[..2].iter().filter_map(|end| stars.get(end));
        let twisted = ends.filter(|star| star.is_twisted).count();
        let share = OWN + (1.0 - OWN) * 0.5 * twisted as f64;
        let hinge = Hinge::new(side.vertices, points, share * rigidity);
        elements.extend(hinge.map(|hinge| Arc::new(hinge) as Arc<dyn Energy>));
    }
    let whole = stars
        .values()
        .filter(|star| !star.is_twisted && !star.sides.is_empty());
    for star in whole {
        elements.push(Arc::new(vertex_bend(points, star, &sides, rigidity, poisson)));
    }
    elements
}

fn vertex_bend(points: &[Point], star: &Star, sides: &[Side], rigidity: f64, poisson: f64) -> VertexBend {
    let corners: Vec<[u32; 4]> = star.sides.iter().map(|&side| sides[side].vertices).collect();
    let mut vertices = corners.as_flattened().to_vec();
    vertices.sort_unstable();
    vertices.dedup();
    let place = |vertex: u32| vertices.partition_point(|&other| other < vertex);
    let folds = corners.iter().map(|corners| corners.map(place)).collect();
    let rest = corners.iter().map(|corners| Fold::of(points, corners).angle());
    let normal = star.normal.try_normalize(0.0).unwrap_or_else(Vector3::zeros);
    // The edges at rest, with their lengths, in the tangent plane.
    let edges: Vec<Vector3<f64>> = corners
        .iter()
        .map(|corners| {
            let [a, b] = gather(points, &[corners[0], corners[1]]);
            let edge = b - a;
            let along = (edge - normal * normal.dot(&edge)).try_normalize(0.0);
            along.map_or(edge, |along| along * edge.norm())
        })
        .collect();
    let factor = (1.0 - OWN) * 0.25 * rigidity / star.area;
    let stiffness = DMatrix::from_fn(edges.len(), edges.len(), |row, column| {
        let (a, b) = (edges[row], edges[column]);
        let (lengths, along) = (a.norm() * b.norm(), a.dot(&b));
        // l l′ (ν + (1 − ν) (n · n′)²): normals in the plane enclose the angle of the edges.
        factor * (poisson * lengths + (1.0 - poisson) * along * along / lengths)
    });
    VertexBend {
        folds,
        rest: rest.collect(),
        stiffness,
        vertices,
    }
}
