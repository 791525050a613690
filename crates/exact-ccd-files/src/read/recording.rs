//! The frames in one file: positions of all frames, and the mesh that they share.

use std::path::{Path, PathBuf};

use exact_ccd_mesh::Point;

use super::gltf::PlacedMeshes;
use super::mesh_file::MeshFile;
use super::numpy::Arrays;
use super::point_cache::PointCache;
use crate::error::{Fault, ParseError, Place, ReadError};

/// Positions of all frames, and the first frame, with the mesh that all share.
#[derive(Debug)]
pub(super) struct Recording {
    pub(super) positions: Positions,
    pub(super) first: MeshFile,
    /// The file of the mesh, if it is another one.
    pub(super) mesh: Option<PathBuf>,
}

/// Positions of all frames.
#[derive(Debug)]
pub(super) enum Positions {
    Arrays(Arrays),
    Placed(PlacedMeshes),
    Cached(PointCache),
}

impl Positions {
    pub(super) fn frame_count(&self) -> usize {
        match self {
            Self::Arrays(arrays) => arrays.frame_count,
            Self::Placed(meshes) => meshes.frame_count(),
            Self::Cached(cache) => cache.frame_count(),
        }
    }

    /// The positions of a frame in the file of this path.
    fn of_frame(&self, frame: usize, path: &Path) -> Result<Vec<Point>, ReadError> {
        match self {
            Self::Arrays(arrays) => Ok(arrays.positions(frame)),
            Self::Placed(meshes) => {
                let positions = meshes.positions(frame);
                positions.map_err(|fault| in_file(path, fault.at(Place::Frame(frame))))
            }
            Self::Cached(cache) => cache.positions(frame),
        }
    }

    pub(super) fn time(&self, frame: usize) -> Option<f64> {
        match self {
            Self::Arrays(_) => None,
            Self::Placed(meshes) => meshes.time(frame),
            Self::Cached(cache) => cache.time(frame),
        }
    }
}

impl Recording {
    /// Reads a frame of the file of this path.
    pub(super) fn read(&self, frame: usize, path: &Path) -> Result<MeshFile, ReadError> {
        let mut file = self.first.clone();
        let all = self.positions.of_frame(frame, path)?;
        let checked = exact_ccd_mesh::check_positions(all.len(), &all);
        checked.map_err(|error| in_file(path, Fault::Frame(error.into()).at(Place::Frame(frame))))?;
        let kept = file.ids.vertices.iter();
        file.frame.positions = kept.map(|&vertex| all[vertex as usize]).collect();
        Ok(file)
    }
}

/// An error in the contents of a file.
pub(super) fn in_file(path: &Path, source: ParseError) -> ReadError {
    let path = path.to_owned();
    ReadError::Parse { path, source }
}
