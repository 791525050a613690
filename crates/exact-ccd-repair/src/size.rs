//! The size of a mesh, to which all lengths of a repair are relative.

use exact_ccd_mesh::vector::{dot, minus};
use exact_ccd_mesh::{Point, TriangleMesh};

use crate::error::RepairError;

/// The size of a mesh.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Size {
    /// The diagonal of the box around all vertices.
    pub(crate) diagonal: f64,
    /// The mean length of edges, or the diagonal if there is no edge.
    pub(crate) mean_edge: f64,
}

impl Size {
    pub(crate) fn new(mesh: &TriangleMesh, x: &[Point]) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for point in x {
            for axis in 0..3 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        let length = |vector: Point| dot(vector, vector).sqrt();
        let diagonal = length(minus(high, low));
        let of_edge = |&[a, b]: &[u32; 2]| length(minus(x[a as usize], x[b as usize]));
        let sum: f64 = mesh.edges().iter().map(of_edge).sum();
        let mean_edge = if mesh.edges().is_empty() {
            diagonal
        } else {
            sum / mesh.edges().len() as f64
        };
        Self { diagonal, mean_edge }
    }

    /// Checks that squares of lengths neither overflow nor vanish.
    pub(crate) fn check(self) -> Result<(), RepairError> {
        let range = 1e-140..1e140;
        if range.contains(&self.diagonal) && range.contains(&self.mean_edge) {
            Ok(())
        } else {
            Err(RepairError::Size(self.diagonal))
        }
    }
}
