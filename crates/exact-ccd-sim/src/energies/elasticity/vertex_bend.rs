//! The bending energy of the hinges that share a vertex.

use exact_ccd_mesh::Point;
use nalgebra::DMatrix;

use super::hinge::Fold;
use crate::energies::term::{Block, Energy, Projection};

/// The energy ½ (θ − θ₀)ᵀ K (θ − θ₀) of the angles θ of some hinges, with the angles θ₀ at rest and a
/// constant, positive semi-definite stiffness K.
#[derive(Debug)]
pub(super) struct VertexBend {
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
    /// The energy of hinges at a vertex, with the stiffness by their angles. Each hinge has the two ends of
    /// its edge and the opposite corners of both faces. `rest` has the positions of all vertices at rest.
    pub(super) fn new(vertex: u32, corners: &[[u32; 4]], rest: &[Point], stiffness: DMatrix<f64>) -> Self {
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
        Self {
            hinges,
            corners: places,
            rest: corners
                .iter()
                .map(|corners| Fold::of(rest, corners).angle())
                .collect(),
            stiffness,
            vertices,
        }
    }

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

/// Calls a function with zeros, which are on the heap only if there are more than `FEW`.
fn with_zeros<const FEW: usize, T>(count: usize, f: impl FnOnce(&mut [f64]) -> T) -> T {
    if count <= FEW {
        f(&mut [0.0; FEW][..count])
    } else {
        f(&mut vec![0.0; count])
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
