//! One time step of a mesh.

use exact_ccd::{Point, Query, TimeOutOfStep};

use crate::broad_phase::{TooManyPrimitives, check_primitive_count};
use crate::mesh::{PositionsError, TriangleMesh, check_positions};
use crate::pairs::{PairKind, ThicknessCount};

/// A mesh whose vertices move in straight lines, at constant speed, from t = 0 to t = 1.
#[derive(Clone, Copy, Debug)]
pub struct Step<'a> {
    mesh: &'a TriangleMesh,
    positions: [&'a [Point]; 2],
}

/// The reason why positions are not a step of a mesh, or a time is not one of the step.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StepError {
    /// The positions at t = 0 do not fit the mesh.
    #[error("at the start, {0}")]
    Start(#[source] PositionsError),
    /// The positions at t = 1 do not fit the mesh.
    #[error("at the end, {0}")]
    End(#[source] PositionsError),
    /// An edge passes through a face at t = 0: see [`Meeting`](crate::Meeting). Only a detector with
    /// [`Detector::with_start_check`](crate::Detector::with_start_check) has this error.
    #[error(
        "at the start, edge {edge} ({}, {}) passes through face {face} ({}, {}, {}): begin at positions \
         where no edge does, or leave this pair out of those that can collide",
        ends[0], ends[1], corners[0], corners[1], corners[2]
    )]
    Crossing {
        /// The index of the edge in [`TriangleMesh::edges`].
        edge: u32,
        /// The vertices of the edge.
        ends: [u32; 2],
        /// The index of the face in [`TriangleMesh::faces`].
        face: u32,
        /// The vertices of the face.
        corners: [u32; 3],
    },
    /// The mesh is too large.
    #[error(transparent)]
    TooManyPrimitives(#[from] TooManyPrimitives),
    /// The minimum distance does not fit the mesh.
    #[error(transparent)]
    ThicknessCount(#[from] ThicknessCount),
    /// The time until which contacts are searched is not in [0, 1].
    #[error(transparent)]
    Time(#[from] TimeOutOfStep),
}

impl<'a> Step<'a> {
    /// The step from positions `x0` to positions `x1`, one for each vertex.
    ///
    /// # Errors
    /// [`StepError`] names the positions that are too many, too few or not finite, or the number of
    /// primitives if 32-bit indices do not suffice.
    pub fn new(mesh: &'a TriangleMesh, x0: &'a [Point], x1: &'a [Point]) -> Result<Self, StepError> {
        for count in [mesh.vertex_count(), mesh.edges().len(), mesh.faces().len()] {
            check_primitive_count(count)?;
        }
        check_positions(mesh.vertex_count(), x0).map_err(StepError::Start)?;
        check_positions(mesh.vertex_count(), x1).map_err(StepError::End)?;
        let positions = [x0, x1];
        Ok(Self { mesh, positions })
    }

    /// The step in which all vertices stay at positions that were checked before.
    pub(crate) fn at_rest(mesh: &'a TriangleMesh, positions: &'a [Point]) -> Self {
        let positions = [positions, positions];
        Self { mesh, positions }
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

    /// The largest absolute value of a coordinate, at the start or at the end.
    pub(crate) fn largest_coordinate(&self) -> f64 {
        let coordinates = self.positions.into_iter().flatten().flatten();
        // Not f64::max: its handling of NaN costs time, and there is no NaN here.
        let larger = |a: f64, b: f64| if b > a { b } else { a };
        coordinates.fold(0.0, |largest, x| larger(largest, x.abs()))
    }

    /// The positions at a time of the step, rounded: `x0` exactly for t ≤ 0 (and NaN), `x1` exactly
    /// for t ≥ 1.
    ///
    /// Each coordinate lies between its values at the two ends; on a thread that reads subnormal numbers as
    /// zero, it may be less than 2⁻¹⁰²² outside. It is at most 3 ε M away from the exact one, M being the
    /// larger absolute value of the two; 6 ε M if the thread rounds in another direction than to nearest. So
    /// [`Candidates`](crate::Candidates) of this step also hold for the step from `x0` to these positions.
    #[must_use]
    pub fn at(&self, time: f64) -> Vec<Point> {
        let [x0, x1] = self.positions;
        x0.iter().zip(x1).map(|(&a, &b)| place(a, b, time)).collect()
    }

    /// The position of a vertex at a time of the step, as in [`at`](Self::at); the mesh has the vertex.
    pub(crate) fn vertex_at(&self, vertex: usize, time: f64) -> Point {
        let [x0, x1] = self.positions;
        place(x0[vertex], x1[vertex], time)
    }

    /// The query of a pair by the indices of its primitives, or `None` if the mesh does not have
    /// both.
    #[must_use]
    pub fn query<K: PairKind>(&self, ids: [u32; 2]) -> Option<Query<K>> {
        let vertices = K::vertices(self.mesh, ids)?;
        let at = |x: &[Point]| {
            let mut points = K::Points::default();
            for (point, &vertex) in points.as_mut().iter_mut().zip(vertices.as_ref()) {
                *point = *x.get(vertex as usize)?;
            }
            Some(points)
        };
        let [x0, x1] = self.positions;
        // All positions are finite.
        Query::new(at(x0)?, at(x1)?).ok()
    }
}

/// The position at a time on the way from a to b, rounded; a for NaN.
pub(crate) fn place(a: Point, b: Point, time: f64) -> Point {
    if time >= 1.0 {
        b
    } else if time > 0.0 {
        core::array::from_fn(|axis| between(a[axis], b[axis], time))
    } else {
        a
    }
}

/// a + t (b − a), rounded, between a and b, for 0 < t < 1.
///
/// The difference, the product and the sum are each rounded, by at most u = ε/2 of their value. |b
/// − a| is at most 2 M, so the errors are at most 2 u · 2 M + u M = 2.5 ε M to first order, plus a
/// subnormal product's. The clamp only lessens the error, because the exact value lies between a
/// and b. If the difference overflows, the weighted sum does not, and its error is at most 3 u M.
fn between(a: f64, b: f64, time: f64) -> f64 {
    let difference = b - a;
    let x = if difference.is_finite() {
        a + time * difference
    } else {
        (1.0 - time) * a + time * b
    };
    x.max(a.min(b)).min(a.max(b))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_coordinate_is_that_of_both_ends() {
        let mesh = TriangleMesh::new(2, Vec::new()).expect("there are no faces");
        let (less, more) = ([[0.5, -0.25, 0.0]; 2], [[0.0, 0.5, 0.125], [0.25, -0.75, 0.5]]);
        for [x0, x1] in [[less, more], [more, less]] {
            let step = Step::new(&mesh, &x0, &x1).expect("all positions are finite");
            assert_eq!(step.largest_coordinate(), 0.75);
        }
    }

    #[test]
    fn the_ends_of_a_step_have_their_bits() {
        let mesh = TriangleMesh::new(1, Vec::new()).expect("there are no faces");
        let (x0, x1) = ([[-0.0; 3]], [[1.0, -0.0, 0.0]]);
        let step = Step::new(&mesh, &x0, &x1).expect("all positions are finite");
        for time in [0.0, -1.0, f64::NAN] {
            assert!(
                step.at(time)[0]
                    .iter()
                    .all(|x| x.to_bits() == (-0.0_f64).to_bits())
            );
        }
        assert_eq!(step.at(1.0)[0].map(f64::to_bits), x1[0].map(f64::to_bits));
    }
}
