//! A triangle mesh that moves from one frame to another.

use exact_ccd::Point;

use super::step::{Step, StepError};
use crate::mesh::{Frame, TriangleMesh};
use crate::pairs::ThicknessCount;

/// A triangle mesh whose vertices move in straight lines, from `x0` at t = 0 to `x1` at t = 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    /// The connectivity, the same at both times.
    pub mesh: TriangleMesh,
    /// The position of each vertex at t = 0.
    pub x0: Vec<Point>,
    /// The position of each vertex at t = 1.
    pub x1: Vec<Point>,
}

/// The reason why two frames are not the start and the end of one motion.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MotionError {
    /// The numbers of vertices differ.
    #[error("{start} vertices at the start, {end} at the end, expected the same mesh")]
    VertexCount {
        /// The number of vertices at t = 0.
        start: usize,
        /// The number of vertices at t = 1.
        end: usize,
    },
    /// The numbers of faces differ.
    #[error("{start} faces at the start, {end} at the end, expected the same mesh")]
    FaceCount {
        /// The number of faces at t = 0.
        start: usize,
        /// The number of faces at t = 1.
        end: usize,
    },
    /// A face has other corners at the end than at the start.
    #[error("face {face} is {start:?} at the start and {end:?} at the end, expected the same mesh")]
    Face {
        /// The index of the first such face, from 0.
        face: usize,
        /// Its corners at t = 0.
        start: [u32; 3],
        /// Its corners at t = 1.
        end: [u32; 3],
    },
    /// The numbers of loose edges differ.
    #[error("{start} loose edges at the start, {end} at the end, expected the same mesh")]
    LooseEdgeCount {
        /// The number of loose edges at t = 0.
        start: usize,
        /// The number of loose edges at t = 1.
        end: usize,
    },
    /// A loose edge has other end points at the end than at the start.
    #[error("loose edge {edge} is {start:?} at the start and {end:?} at the end, expected the same mesh")]
    LooseEdge {
        /// The index of the first such edge in [`TriangleMesh::loose_edges`].
        edge: usize,
        /// Its end points at t = 0.
        start: [u32; 2],
        /// Its end points at t = 1.
        end: [u32; 2],
    },
    /// The positions are not valid.
    #[error(transparent)]
    Positions(#[from] StepError),
    /// The minimum distance does not fit the mesh.
    #[error(transparent)]
    ThicknessCount(#[from] ThicknessCount),
}

impl Motion {
    /// The motion from one frame to another of the same mesh.
    ///
    /// # Errors
    /// [`MotionError`] names the first difference between the two meshes. They must have the same
    /// number of vertices and the same faces and loose edges in the same order, each with its
    /// vertices in the same order. If the meshes agree, it names the positions whose number is
    /// wrong or that are not finite.
    pub fn new(start: Frame, end: Frame) -> Result<Self, MotionError> {
        start.mesh.check_same(&end.mesh)?;
        let motion = Self {
            mesh: start.mesh,
            x0: start.positions,
            x1: end.positions,
        };
        motion.step()?;
        Ok(motion)
    }

    /// The motion as a time step.
    ///
    /// # Errors
    /// As [`Step::new`].
    pub fn step(&self) -> Result<Step<'_>, StepError> {
        Step::new(&self.mesh, &self.x0, &self.x1)
    }
}

impl TriangleMesh {
    /// Checks that the mesh of a later frame is the same as this one.
    ///
    /// # Errors
    /// [`MotionError`] names the first difference, as [`Motion::new`] does.
    pub fn check_same(&self, end: &Self) -> Result<(), MotionError> {
        if self.vertex_count() != end.vertex_count() {
            return Err(MotionError::VertexCount {
                start: self.vertex_count(),
                end: end.vertex_count(),
            });
        }
        // Elements before their counts: the first element that differs is the more helpful message.
        if let Some((face, start, end)) = first_difference(self.faces(), end.faces()) {
            return Err(MotionError::Face { face, start, end });
        }
        if self.faces().len() != end.faces().len() {
            return Err(MotionError::FaceCount {
                start: self.faces().len(),
                end: end.faces().len(),
            });
        }
        if let Some((edge, start, end)) = first_difference(self.loose_edges(), end.loose_edges()) {
            return Err(MotionError::LooseEdge { edge, start, end });
        }
        if self.loose_edges().len() != end.loose_edges().len() {
            return Err(MotionError::LooseEdgeCount {
                start: self.loose_edges().len(),
                end: end.loose_edges().len(),
            });
        }
        Ok(())
    }
}

/// The first index at which both lists have an element and the elements differ, with these elements.
fn first_difference<T: Copy + PartialEq>(start: &[T], end: &[T]) -> Option<(usize, T, T)> {
    let mut pairs = start.iter().zip(end).enumerate();
    pairs.find_map(|(index, (&start, &end))| (start != end).then_some((index, start, end)))
}
