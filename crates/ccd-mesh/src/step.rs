//! One time step of a mesh: is it free of contact, and if not, until when?

use exact_ccd::{EdgeEdge, Point, VertexFace};

use crate::bvh::Bvh;
use crate::candidates::Candidates;
use crate::contacts::StepReport;
use crate::mesh::TriangleMesh;

/// A mesh whose vertices move in straight lines, at constant speed, from t = 0 to t = 1.
#[derive(Clone, Copy, Debug)]
pub struct Step<'a> {
    mesh: &'a TriangleMesh,
    positions: [&'a [Point]; 2],
}

/// The positions do not fit the mesh, or are no positions.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum StepError {
    /// The number of positions is not the number of vertices.
    #[error("{found} positions at t = {time}, but the mesh has {expected} vertices")]
    PositionCount {
        /// The end of the step, 0 or 1.
        time: usize,
        /// How many positions there are.
        found: usize,
        /// How many vertices the mesh has.
        expected: usize,
    },
    /// A coordinate is infinite or not a number.
    #[error("coordinate {} of vertex {vertex} at t = {time} is {value}, not a finite number", ["x", "y", "z"][*.axis])]
    NonFinite {
        /// The end of the step, 0 or 1.
        time: usize,
        /// The index of the vertex.
        vertex: usize,
        /// The index of the coordinate.
        axis: usize,
        /// The coordinate.
        value: f64,
    },
}

/// Looks for the contacts of a mesh with itself in one time step.
///
/// `x0` and `x1` are the positions of the vertices at t = 0 and t = 1. Pairs of primitives that share a vertex always
/// touch and are left out. To see progress, or to use another broad phase, call [`Candidates::new`] and
/// [`StepReport::new`] in turn, as this function does.
///
/// # Errors
/// [`StepError`] says which positions are too many, too few or not finite.
pub fn step(mesh: &TriangleMesh, x0: &[Point], x1: &[Point]) -> Result<StepReport, StepError> {
    let step = Step::new(mesh, x0, x1)?;
    let candidates = Candidates::new(&step, &Bvh);
    Ok(StepReport::new(&step, &candidates, &|_| ()))
}

impl<'a> Step<'a> {
    /// The step from positions `x0` to positions `x1`, one for each vertex.
    ///
    /// # Errors
    /// [`StepError`] says which positions are too many, too few or not finite.
    pub fn new(mesh: &'a TriangleMesh, x0: &'a [Point], x1: &'a [Point]) -> Result<Self, StepError> {
        let positions = [x0, x1];
        for (time, points) in positions.into_iter().enumerate() {
            if points.len() != mesh.vertex_count() {
                return Err(StepError::PositionCount {
                    time,
                    found: points.len(),
                    expected: mesh.vertex_count(),
                });
            }
            for (vertex, point) in points.iter().enumerate() {
                if let Some(axis) = point.iter().position(|value| !value.is_finite()) {
                    return Err(StepError::NonFinite {
                        time,
                        vertex,
                        axis,
                        value: point[axis],
                    });
                }
            }
        }
        Ok(Self { mesh, positions })
    }

    /// The mesh.
    #[must_use]
    pub fn mesh(&self) -> &'a TriangleMesh {
        self.mesh
    }

    /// The positions of the vertices at t = 0 and at t = 1.
    #[must_use]
    pub fn positions(&self) -> [&'a [Point]; 2] {
        self.positions
    }

    /// The query of a vertex against a face, its corners in the order of the face.
    ///
    /// # Panics
    /// If the mesh has no such vertex or no such face.
    #[must_use]
    pub fn vertex_face(&self, vertex: u32, face: u32) -> VertexFace {
        let [a, b, c] = self.mesh.faces()[face as usize];
        let [t0, t1] = self.at([vertex, a, b, c]);
        VertexFace::new(t0, t1).expect("all positions are finite")
    }

    /// The query of two edges, the vertices of each in increasing order.
    ///
    /// # Panics
    /// If the mesh does not have two such edges.
    #[must_use]
    pub fn edge_edge(&self, a: u32, b: u32) -> EdgeEdge {
        let [[a0, a1], [b0, b1]] = [a, b].map(|edge| self.mesh.edges()[edge as usize]);
        let [t0, t1] = self.at([a0, a1, b0, b1]);
        EdgeEdge::new(t0, t1).expect("all positions are finite")
    }

    fn at(&self, vertices: [u32; 4]) -> [[Point; 4]; 2] {
        self.positions.map(|x| vertices.map(|vertex| x[vertex as usize]))
    }
}
