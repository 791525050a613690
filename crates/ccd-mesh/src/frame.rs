//! A triangle mesh at one time.

use std::path::Path;

use exact_ccd::Point;

use crate::mesh::{IndexOutOfRange, TriangleMesh};
use crate::read::{self, Format, ParseError, ReadError};

/// A triangle mesh at one time: its connectivity and where its vertices are.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// The faces, and the edges that they share.
    pub mesh: TriangleMesh,
    /// The position of each vertex of `mesh`.
    pub positions: Vec<Point>,
}

/// What keeps positions and faces from being a [`Frame`].
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FrameError {
    /// A coordinate is NaN or infinite.
    #[error("vertex {vertex} has {axis} = {value}, expected a finite number")]
    NotFinite {
        /// The index of the vertex, from 0.
        vertex: usize,
        /// `x`, `y` or `z`.
        axis: char,
        /// The coordinate.
        value: f64,
    },
    /// A face names a vertex that has no position.
    #[error(transparent)]
    Index(#[from] IndexOutOfRange),
    /// There is not one position for each vertex.
    #[error("{positions} positions, expected one for each of {vertex_count} vertices")]
    PositionCount {
        /// How many positions there are.
        positions: usize,
        /// How many vertices the mesh has.
        vertex_count: usize,
    },
}

impl Frame {
    /// The mesh of these faces, each three indices into `positions`.
    ///
    /// # Errors
    /// The first index that is out of range, or else the first coordinate that is not finite.
    pub fn new(positions: Vec<Point>, faces: Vec<[u32; 3]>) -> Result<Self, FrameError> {
        let mesh = TriangleMesh::new(positions.len(), faces)?;
        let frame = Self { mesh, positions };
        frame.check()?;
        Ok(frame)
    }

    /// The frame in a file. The extension tells the format, see [`Format::of_path`].
    ///
    /// Vertices and faces keep the numbers that they have in the file, counted from 0. Each coordinate is the `f64`
    /// nearest to the decimal text, or exactly the binary number. An STL file knows no shared vertices: it reads as
    /// three vertices for each face.
    ///
    /// # Errors
    /// [`ReadError`] names the file, the place in it, and what was expected there.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, ReadError> {
        read::read(path.as_ref())
    }

    /// The frame in the contents of a file, as [`Frame::read`] gives it.
    ///
    /// # Errors
    /// [`ParseError`] names the place and what was expected there.
    pub fn parse(bytes: &[u8], format: Format) -> Result<Self, ParseError> {
        read::parse(bytes, format)
    }

    /// Checks that there is one position for each vertex and that all coordinates are finite.
    pub(crate) fn check(&self) -> Result<(), FrameError> {
        let vertex_count = self.mesh.vertex_count();
        if self.positions.len() != vertex_count {
            return Err(FrameError::PositionCount {
                positions: self.positions.len(),
                vertex_count,
            });
        }
        for (vertex, position) in self.positions.iter().enumerate() {
            for (axis, &value) in ['x', 'y', 'z'].into_iter().zip(position) {
                if !value.is_finite() {
                    return Err(FrameError::NotFinite { vertex, axis, value });
                }
            }
        }
        Ok(())
    }
}
