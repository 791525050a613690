//! One time step of a mesh: is it free of contact, and if not, until when?

use exact_ccd::{EdgeEdge, Kind, Point, Query, VertexFace};

use crate::broad_phase::Bvh;
use crate::contacts::StepReport;
use crate::mesh::TriangleMesh;
use crate::positions::{self, PositionsError};

/// A mesh whose vertices move in straight lines, at constant speed, from t = 0 to t = 1.
#[derive(Clone, Copy, Debug)]
pub struct Step<'a> {
    mesh: &'a TriangleMesh,
    positions: [&'a [Point]; 2],
}

/// Which positions of a step do not fit its mesh.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum StepError {
    /// Those at t = 0.
    #[error("at the start, {0}")]
    Start(#[source] PositionsError),
    /// Those at t = 1.
    #[error("at the end, {0}")]
    End(#[source] PositionsError),
}

/// Looks for the contacts of a mesh with itself in one time step.
///
/// `x0` and `x1` are the positions of the vertices at t = 0 and t = 1. Pairs of primitives that share a vertex always
/// touch and are left out. To see progress, or to use another broad phase, call [`StepReport::new`], as this function
/// does; if only the earliest contact is wanted, or only whether there is one, [`Step::earliest_contact`] and
/// [`Step::is_free`] are faster.
///
/// ```
/// use exact_ccd_mesh::{Pair, TriangleMesh, step};
///
/// // A vertex of one triangle falls through another triangle, which rests.
/// let mesh = TriangleMesh::new(6, vec![[0, 1, 2], [3, 4, 5]])?;
/// let floor = [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0]];
/// let falling = |height: f64| [[1.0, 1.0, height], [1.0, 2.0, height + 4.0], [2.0, 1.0, height + 4.0]];
/// let (x0, x1) = ([floor, falling(1.0)].concat(), [floor, falling(-1.0)].concat());
///
/// let report = step(&mesh, &x0, &x1)?;
/// assert_eq!(report.time_of_impact(), Some(0.5));
/// assert_eq!(report.earliest.map(|contact| contact.pair), Some(Pair::VertexFace { vertex: 3, face: 0 }));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`StepError`] says which positions are too many, too few or not finite.
pub fn step(mesh: &TriangleMesh, x0: &[Point], x1: &[Point]) -> Result<StepReport, StepError> {
    let step = Step::new(mesh, x0, x1)?;
    Ok(StepReport::new(step, &Bvh, &|_| ()))
}

impl<'a> Step<'a> {
    /// The step from positions `x0` to positions `x1`, one for each vertex.
    ///
    /// # Errors
    /// [`StepError`] says which positions are too many, too few or not finite.
    pub fn new(mesh: &'a TriangleMesh, x0: &'a [Point], x1: &'a [Point]) -> Result<Self, StepError> {
        positions::check(mesh, x0).map_err(StepError::Start)?;
        positions::check(mesh, x1).map_err(StepError::End)?;
        let positions = [x0, x1];
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

    /// The query of a vertex against a face, its corners in the order of the face, or `None` if the mesh has no such
    /// vertex or no such face.
    #[must_use]
    pub fn vertex_face(&self, vertex: u32, face: u32) -> Option<Query<VertexFace>> {
        let &[a, b, c] = self.mesh.faces().get(face as usize)?;
        self.query([vertex, a, b, c])
    }

    /// The query of two edges, the vertices of each in increasing order, or `None` if the mesh does not have both.
    #[must_use]
    pub fn edge_edge(&self, a: u32, b: u32) -> Option<Query<EdgeEdge>> {
        let edge = |index: u32| self.mesh.edges().get(index as usize).copied();
        let ([a0, a1], [b0, b1]) = (edge(a)?, edge(b)?);
        self.query([a0, a1, b0, b1])
    }

    fn query<K: Kind<Points = [Point; 4]>>(&self, [a, b, c, d]: [u32; 4]) -> Option<Query<K>> {
        let [x0, x1] = self.positions;
        let at = |x: &[Point]| {
            let point = |vertex: u32| x.get(vertex as usize).copied();
            Some([point(a)?, point(b)?, point(c)?, point(d)?])
        };
        // All positions are finite.
        Query::new(at(x0)?, at(x1)?).ok()
    }
}
