//! Linear tetrahedra.

use exact_ccd_mesh::Point;
use nalgebra::{Matrix3, SMatrix};

use super::isotropic::{Curvature, Isotropic};
use crate::energies::term::{Block, Energy, Projection, gather, write_each};

/// A tetrahedron with constant deformation gradient.
#[derive(Debug)]
pub(crate) struct Tetrahedron<M> {
    vertices: [u32; 4],
    /// Row i is the gradient of vertex i's barycentric coordinate.
    shape: SMatrix<f64, 4, 3>,
    volume: f64,
    density: M,
}

impl Tetrahedron<()> {
    /// The tetrahedron of these vertices, with the positions of all vertices at rest. `None` if its volume at
    /// rest is not positive.
    pub(crate) fn new(vertices: [u32; 4], rest: &[Point]) -> Option<Self> {
        let [a, b, c, d] = gather(rest, &vertices);
        let edges = Matrix3::from_columns(&[b - a, c - a, d - a]);
        let volume = edges.determinant() / 6.0;
        let inverse = edges.try_inverse().filter(|_| volume > 0.0)?;
        let mut shape = SMatrix::<f64, 4, 3>::zeros();
        shape.fixed_view_mut::<3, 3>(1, 0).copy_from(&inverse);
        shape.set_row(0, &-inverse.row_sum());
        Some(Self {
            vertices,
            shape,
            volume,
            density: (),
        })
    }
}

impl<M> Tetrahedron<M> {
    /// The volume by which the energy density is multiplied, in m³: at first, that at rest.
    pub(crate) fn volume(&self) -> f64 {
        self.volume
    }

    /// The same tetrahedron with another volume.
    pub(crate) fn with_volume(self, volume: f64) -> Self {
        Self { volume, ..self }
    }

    /// The same tetrahedron with another energy density.
    pub(crate) fn of<N>(self, density: N) -> Tetrahedron<N> {
        let Self {
            vertices,
            shape,
            volume,
            ..
        } = self;
        Tetrahedron {
            vertices,
            shape,
            volume,
            density,
        }
    }

    fn deformation(&self, points: &[Point]) -> Matrix3<f64> {
        let [a, b, c, d] = gather(points, &self.vertices);
        Matrix3::from_columns(&[b - a, c - a, d - a]) * self.shape.fixed_view::<3, 3>(1, 0)
    }
}

impl<M: Isotropic> Energy for Tetrahedron<M> {
    fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    fn value(&self, points: &[Point]) -> f64 {
        self.volume * self.density.value(&self.deformation(points))
    }

    fn write_gradient(&self, points: &[Point], gradient: &mut [f64]) {
        // F is linear in the points. Its column c is Σᵢ xᵢ shape(i, c).
        let stress = self.density.stress(&self.deformation(points));
        let forces = stress * self.shape.transpose() * self.volume;
        gradient.copy_from_slice(forces.as_slice());
    }

    /// F does not depend on the place of the tetrahedron, so that the blocks of the first vertex follow from
    /// the others.
    fn write_hessian(&self, points: &[Point], projection: Projection, hessian: &mut [Block]) {
        let curvature = Curvature::new(&self.density, &self.deformation(points), projection);
        let shape = [1, 2, 3].map(|i: usize| curvature.in_frame(&self.shape.row(i).transpose()));
        let block = |[row, column]: [usize; 2]| curvature.block(&shape[row], &shape[column]) * self.volume;
        let [bb, cb, db, cc, dc, dd] = [[0, 0], [1, 0], [2, 0], [1, 1], [2, 1], [2, 2]].map(block);
        let ba = -(bb + cb.transpose() + db.transpose());
        let ca = -(cb + cc + dc.transpose());
        let da = -(db + dc + dd);
        let aa = -(ba + ca + da);
        write_each([aa, ba, ca, da, bb, cb, db, cc, dc, dd], hessian);
    }
}
