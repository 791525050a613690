//! Bending of thin shells, averaged about vertices.

use std::collections::BTreeMap;
use std::f64::consts::SQRT_2;
use std::sync::Arc;

use exact_ccd_mesh::Point;
use nalgebra::{DMatrix, DVector, Matrix3, Matrix3xX, MatrixXx3, RowVector3, Vector3};

use super::hinge::{Fold, Hinge};
use crate::energy::{Block, Energy, Projection, gather};
use crate::hinges::{Side, hinges};
use crate::zeros::with_zeros;

/// The stiffness against the part of a fold that no curvature explains, relative to that of a [`Hinge`]. It
/// has no effect on constant curvature; the value is that with the least errors of the strips of
/// `docs/simulation.md`.
const REST: f64 = 0.75;

/// The least singular value of the mean of a curvature about a vertex that counts: for most meshes, all are
/// near 1. Curvatures that the hinges of a vertex do not show count as zero.
const LEAST: f64 = 0.01;

/// The bending energy of the hinges that share a vertex.
///
/// The curvature of a surface of triangles is concentrated at its edges: its integral along an edge of length
/// l with the unit normal n in the surface is l θ n ⊗ n, where θ is the change of the angle between both
/// faces. The mean curvature tensor about a vertex, weighted by the linear function that is 1 at the vertex,
/// is M θ = Σ ½ l θ n ⊗ n / A, over the edges of the vertex, with a third of the area of its faces, A.
///
/// Let the angles be C κ where the vertices are on a graph of constant curvature κ. On regular meshes M C =
/// 1; on others, and at the boundary, the mean of constant curvature is another one. H = (M C)⁻¹ M θ is the
/// curvature of any such graph. What it does not explain is the rest r = θ − C H of the angles. The energy
/// is that of a plate and that of hinges for the rest, with the factor s = ¾:
///
/// ½ A D ((1 − ν) H : H + ν (tr H)²) + ½ Σ ½ s D (l² / a) r²,
///
/// with the flexural rigidity D, Poisson's ratio ν and the area a of both faces of an edge, of which
/// either end has half. The rest of constant curvature is 0: the energy is that of a plate then, about
/// each vertex whose edges show all three components of the curvature. Where they do not, as at a vertex
/// with one inner edge, the energy has the components that they show; a vertex of one face has none. This
/// is the principle of the virtual element method, a consistent part and a stable rest: L. Beirão da
/// Veiga, F. Brezzi, A. Cangiani, G. Manzini, L. Marini, A. Russo, *Basic principles of virtual element
/// methods*, 2013. The mean is that of O. Stein, E. Grinspun, M. Wardetzky, A. Jacobson, *Natural
/// boundary conditions for smoothing in geometry processing*, 2018, with terms of the vertices on the
/// boundary too.
#[derive(Debug)]
pub(crate) struct VertexBend {
    /// The vertex of all hinges is the first one: its blocks have the most terms, and the fewest are in its
    /// row of the lower triangle.
    vertices: Vec<u32>,
    /// The hinges at each vertex.
    hinges: Vec<Vec<usize>>,
    /// The four corners of each hinge: their vertices, by their places in `vertices`, and their places among
    /// the corners at the first vertex, at the second and so on.
    corners: Vec<[[usize; 2]; 4]>,
    /// The angle of each hinge at rest.
    rest: Vec<f64>,
    /// The Hessian of the energy by the angles.
    stiffness: DMatrix<f64>,
}

/// The number of hinges up to which their memory is on the stack.
const FEW: usize = 8;

impl VertexBend {
    /// The shape of each hinge, and its angle at rest.
    fn shapes(&self, points: &[Point]) -> impl Iterator<Item = (Fold, f64)> {
        let fold = |corners: &[[usize; 2]; 4]| {
            let vertices = corners.map(|[place, _]| self.vertices[place]);
            Fold::of(points, &vertices)
        };
        self.corners.iter().map(fold).zip(self.rest.iter().copied())
    }

    /// Writes the change of each angle since rest, and the gradient of each angle by the corners of its
    /// hinge.
    fn write_angles(&self, points: &[Point], bends: &mut [f64], slopes: &mut [[f64; 3]]) {
        let hinges = self.shapes(points).zip(&self.corners);
        for (bend, ((shape, rest), corners)) in bends.iter_mut().zip(hinges) {
            *bend = shape.angle() - rest;
            for (&[_, corner], slope) in corners.iter().zip(shape.slopes()) {
                slopes[corner] = slope;
            }
        }
    }

    /// The moment of each hinge, from the changes of all angles.
    fn moments(&self, bends: &[f64]) -> impl Iterator<Item = f64> {
        let columns = self.stiffness.as_slice().chunks_exact(bends.len());
        columns.map(move |column| column.iter().zip(bends).map(|(a, b)| a * b).sum())
    }

    /// The hinges at each vertex, with their gradients by this vertex.
    fn at_vertices<'a>(
        &'a self,
        slopes: &'a [[f64; 3]],
    ) -> impl Iterator<Item = (&'a [usize], &'a [[f64; 3]])> + Clone {
        self.hinges.iter().scan(slopes, |slopes, hinges| {
            let (own, others) = slopes.split_at(hinges.len());
            *slopes = others;
            Some((hinges.as_slice(), own))
        })
    }

    /// Writes J M, with the gradients of the angles as columns of J and the moments M.
    fn write_forces(&self, moments: &[f64], slopes: &[[f64; 3]], gradient: &mut [f64]) {
        let vertices = self.at_vertices(slopes).zip(gradient.as_chunks_mut().0);
        for ((hinges, slopes), to) in vertices {
            let mut force = [0.0; 3];
            for (&hinge, slope) in hinges.iter().zip(slopes) {
                add(&mut force, moments[hinge], slope);
            }
            *to = force;
        }
    }

    /// Writes J K Jᵀ with the stiffness K, a block column for each vertex. `columns` has memory for three
    /// columns of K Jᵀ.
    fn write_products(&self, slopes: &[[f64; 3]], columns: &mut [[f64; 3]], hessian: &mut [Block]) {
        let (stiffness, count) = (self.stiffness.as_slice(), columns.len());
        let mut blocks = hessian.iter_mut();
        let mut vertices = self.at_vertices(slopes);
        loop {
            let rows = vertices.clone();
            let Some((hinges, slopes)) = vertices.next() else {
                return;
            };
            columns.fill([0.0; 3]);
            for (&hinge, slope) in hinges.iter().zip(slopes) {
                let stiffness = &stiffness[hinge * count..][..count];
                for (sum, &factor) in columns.iter_mut().zip(stiffness) {
                    add(sum, factor, slope);
                }
            }
            for ((hinges, slopes), to) in rows.zip(&mut blocks) {
                let mut block = [[0.0; 3]; 3];
                for (&hinge, slope) in hinges.iter().zip(slopes) {
                    for (sum, factor) in block.iter_mut().zip(columns[hinge]) {
                        add(sum, factor, slope);
                    }
                }
                to.copy_from_slice(block.as_flattened());
            }
        }
    }
}

fn write(values: impl Iterator<Item = f64>, to: &mut [f64]) {
    to.iter_mut().zip(values).for_each(|(to, value)| *to = value);
}

fn add(sum: &mut [f64; 3], factor: f64, vector: &[f64; 3]) {
    for (sum, value) in sum.iter_mut().zip(vector) {
        *sum += factor * value;
    }
}

impl Energy for VertexBend {
    fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    fn value(&self, points: &[Point]) -> f64 {
        with_zeros::<FEW, _>(self.rest.len(), |bends| {
            for (bend, (shape, rest)) in bends.iter_mut().zip(self.shapes(points)) {
                *bend = shape.angle() - rest;
            }
            let terms = self.moments(bends).zip(&*bends);
            0.5 * terms.map(|(moment, bend)| moment * bend).sum::<f64>()
        })
    }

    fn write_gradient(&self, points: &[Point], gradient: &mut [f64]) {
        let count = self.rest.len();
        with_zeros::<{ 14 * FEW }, _>(14 * count, |memory| {
            let (bends, memory) = memory.split_at_mut(count);
            let (moments, slopes) = memory.split_at_mut(count);
            let (slopes, _) = slopes.as_chunks_mut();
            self.write_angles(points, bends, slopes);
            write(self.moments(bends), moments);
            self.write_forces(moments, slopes, gradient);
        });
    }

    fn write_hessian(&self, points: &[Point], projection: Projection, hessian: &mut [Block]) {
        let mut gradient = vec![0.0; 3 * self.vertices.len()];
        self.write_derivatives(points, projection, &mut gradient, hessian);
    }

    /// The Hessian leaves out the second derivatives of angles; so it is positive semi-definite.
    fn write_derivatives(
        &self,
        points: &[Point],
        _: Projection,
        gradient: &mut [f64],
        hessian: &mut [Block],
    ) {
        let count = self.rest.len();
        with_zeros::<{ 17 * FEW }, _>(17 * count, |memory| {
            let (bends, memory) = memory.split_at_mut(count);
            let (moments, memory) = memory.split_at_mut(count);
            let (slopes, columns) = memory.as_chunks_mut().0.split_at_mut(4 * count);
            self.write_angles(points, bends, slopes);
            write(self.moments(bends), moments);
            self.write_forces(moments, slopes, gradient);
            self.write_products(slopes, columns, hessian);
        });
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
        let bend = vertex_bend(points, vertex, star, &sides, rigidity, poisson);
        elements.push(Arc::new(bend));
    }
    elements
}

fn vertex_bend(
    points: &[Point],
    vertex: u32,
    star: &Star,
    sides: &[Side],
    rigidity: f64,
    poisson: f64,
) -> VertexBend {
    let corners: Vec<[u32; 4]> = star.sides.iter().map(|&side| sides[side].vertices).collect();
    let mut vertices = corners.as_flattened().to_vec();
    vertices.sort_unstable_by_key(|&other| (other != vertex, other));
    vertices.dedup();
    let place = |corner: u32| match vertices[1..].binary_search(&corner) {
        Ok(place) => 1 + place,
        Err(_) => 0,
    };
    let mut hinges = vec![Vec::new(); vertices.len()];
    let mut places: Vec<[[usize; 2]; 4]> = Vec::new();
    for (hinge, corners) in corners.iter().enumerate() {
        places.push(corners.map(|corner| {
            let place = place(corner);
            hinges[place].push(hinge);
            [place, hinges[place].len() - 1]
        }));
    }
    // A number among the corners at a vertex becomes one among all corners.
    for [place, corner] in places.as_flattened_mut() {
        *corner += hinges[..*place].iter().map(Vec::len).sum::<usize>();
    }
    let shapes: Vec<Fold> = corners.iter().map(|corners| Fold::of(points, corners)).collect();
    let plane = Plane::of(star);
    let (mut means, mut angles) = (Matrix3xX::zeros(corners.len()), MatrixXx3::zeros(corners.len()));
    for (place, (shape, corners)) in shapes.iter().zip(&corners).enumerate() {
        let corners = gather(points, corners);
        means.set_column(
            place,
            &(plane.across(corners[1] - corners[0]) * (0.5 / star.area)),
        );
        angles.set_row(
            place,
            &plane.angles(shape, corners.map(|corner| corner - corners[0])),
        );
    }
    let found = (&means * &angles).pseudo_inverse(LEAST);
    let curvature = found.unwrap_or_else(|_| Matrix3::zeros()) * means;
    let rest = DMatrix::identity(corners.len(), corners.len()) - angles * &curvature;
    let trace = Vector3::new(1.0, 1.0, 0.0);
    let plate = Matrix3::identity() * (1.0 - poisson) + trace * trace.transpose() * poisson;
    let of_rest = DVector::from_iterator(
        shapes.len(),
        shapes.iter().map(|shape| 0.5 * REST * shape.stiffness()),
    );
    let stiffness = curvature.transpose() * (plate * star.area) * &curvature
        + rest.transpose() * DMatrix::from_diagonal(&of_rest) * &rest;
    VertexBend {
        hinges,
        corners: places,
        rest: shapes.iter().map(Fold::angle).collect(),
        stiffness: stiffness * rigidity,
        vertices,
    }
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
