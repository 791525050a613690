//! A triangle mesh that moves from one frame to another.

use std::path::{Path, PathBuf};

use exact_ccd::Point;

use crate::frame::Frame;
use crate::mesh::TriangleMesh;
use crate::read::{Format, ReadError};
use crate::step::{Step, StepError};

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

/// What keeps two frames from being the start and the end of one motion.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MotionError {
    /// The numbers of vertices differ.
    #[error("{start} vertices at the start, {end} at the end, expected the same mesh")]
    VertexCount {
        /// How many vertices there are at t = 0.
        start: usize,
        /// How many vertices there are at t = 1.
        end: usize,
    },
    /// The numbers of faces differ.
    #[error("{start} faces at the start, {end} at the end, expected the same mesh")]
    FaceCount {
        /// How many faces there are at t = 0.
        start: usize,
        /// How many faces there are at t = 1.
        end: usize,
    },
    /// A face has other corners at the end than at the start.
    #[error("face {face} is {start:?} at the start and {end:?} at the end, expected the same mesh")]
    Face {
        /// The first such face, from 0.
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
    /// The positions are not sound.
    #[error(transparent)]
    Positions(#[from] StepError),
}

/// Why two files could not be read as one motion.
#[derive(Debug, thiserror::Error)]
pub enum ReadMotionError {
    /// One of the files could not be read.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// The two frames do not belong together.
    #[error("{} and {}: {source}", start.display(), end.display())]
    Motion {
        /// The file of the frame at t = 0.
        start: PathBuf,
        /// The file of the frame at t = 1.
        end: PathBuf,
        /// What differs.
        source: MotionError,
    },
}

impl Motion {
    /// The motion from one frame to another of the same mesh.
    ///
    /// # Errors
    /// [`MotionError`] names the first difference between the two meshes: they must have the same number of vertices
    /// and the same faces in the same order, each with its corners in the same order. Or else it names the positions
    /// that are too many, too few or not finite.
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

    /// The motion between the frames in two files, read at the same time.
    ///
    /// Two STL files are welded, see [`Motion::weld`].
    ///
    /// ```no_run
    /// use exact_ccd_mesh::Motion;
    ///
    /// let motion = Motion::read("start.obj", "end.ply")?;
    /// assert_eq!(motion.x0.len(), motion.x1.len());
    /// # Ok::<(), exact_ccd_mesh::ReadMotionError>(())
    /// ```
    ///
    /// # Errors
    /// [`ReadMotionError`] names the file that cannot be read, or both files and their first difference.
    pub fn read(start: impl AsRef<Path>, end: impl AsRef<Path>) -> Result<Self, ReadMotionError> {
        let (start, end) = (start.as_ref(), end.as_ref());
        let (frame0, frame1) = rayon::join(|| Frame::read(start), || Frame::read(end));
        let both_stl = [start, end].map(Format::of_path) == [Some(Format::Stl); 2];
        let join = if both_stl { Self::weld } else { Self::new };
        join(frame0?, frame1?).map_err(|source| ReadMotionError::Motion {
            start: start.to_owned(),
            end: end.to_owned(),
            source,
        })
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
    /// Checks that another mesh, that of a later frame, is the same.
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
        // Ahead of the counts: the first face that differs says more than that the numbers do.
        let pairs = self.faces().iter().zip(end.faces());
        if let Some((face, (&start, &end))) = pairs.enumerate().find(|(_, (start, end))| start != end) {
            return Err(MotionError::Face { face, start, end });
        }
        if self.faces().len() != end.faces().len() {
            return Err(MotionError::FaceCount {
                start: self.faces().len(),
                end: end.faces().len(),
            });
        }
        let (edges, end_edges) = (self.loose_edges(), end.loose_edges());
        let pairs = edges.iter().zip(end_edges);
        if let Some((edge, (&start, &end))) = pairs.enumerate().find(|(_, (start, end))| start != end) {
            return Err(MotionError::LooseEdge { edge, start, end });
        }
        if edges.len() != end_edges.len() {
            return Err(MotionError::LooseEdgeCount {
                start: edges.len(),
                end: end_edges.len(),
            });
        }
        Ok(())
    }
}
