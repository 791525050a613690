//! Bodies that turn in a step, while their vertices move in straight lines.

use exact_ccd_mesh::{Point, RigidFit};
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;

use crate::mesh::Mesh;
use crate::positions::points;

/// The first vertex of a part that turns, its angle in degrees, its shrinkage halfway relative to its size,
/// and the number of steps that would keep the shrinkage below 0.1 %.
type Turn = (u32, f64, f64, f64);

/// The connected parts of a mesh that turn in a step as rigid bodies, such that the straight motion shrinks
/// them.
#[pyfunction]
pub(crate) fn turns(
    py: Python<'_>,
    mesh: &Mesh,
    x0: PyReadonlyArray2<'_, f64>,
    x1: PyReadonlyArray2<'_, f64>,
) -> PyResult<Vec<Turn>> {
    let (x0, x1) = (points(&x0)?, points(&x1)?);
    Ok(py.detach(|| {
        let part_of = mesh.mesh().components();
        let mut vertices: Vec<usize> = (0..part_of.len().min(x0.len()).min(x1.len())).collect();
        vertices.sort_by_key(|&vertex| part_of[vertex]);
        let parts = vertices.chunk_by(|&v, &w| part_of[v] == part_of[w]);
        parts.filter_map(|part| turn(part, [x0, x1])).collect()
    }))
}

/// The turn of the vertices of a part, if it is one.
fn turn(part: &[usize], ends: [&[Point]; 2]) -> Option<Turn> {
    let [start, end] = ends.map(|x| part.iter().map(|&vertex| x[vertex]).collect::<Vec<_>>());
    let fit = RigidFit::new(&start, &end).filter(RigidFit::is_turn)?;
    let vertex = u32::try_from(*part.first()?).ok()?;
    Some((vertex, fit.angle.to_degrees(), fit.shrinkage, fit.steps()))
}
