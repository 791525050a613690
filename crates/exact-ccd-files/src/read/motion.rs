//! Motions from two files.

use std::path::{Path, PathBuf};

use exact_ccd_mesh::{Motion, MotionError};

use super::frame::read_frame;
use crate::error::ReadError;
use crate::format::Format;

/// The reason why two files could not be read as one motion.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReadMotionError {
    /// One of the files could not be read.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// The two frames are not frames of the same mesh.
    #[error("{} and {}: {source}", start.display(), end.display())]
    Motion {
        /// The file of the frame at t = 0.
        start: PathBuf,
        /// The file of the frame at t = 1.
        end: PathBuf,
        /// The first difference.
        source: MotionError,
    },
}

/// Reads the motion from the frame in one file to the frame in another.
///
/// Two STL files are welded, see [`Motion::weld`].
///
/// ```no_run
/// use exact_ccd_files::read_motion;
///
/// let motion = read_motion("start.obj", "end.ply")?;
/// assert_eq!(motion.x0.len(), motion.x1.len());
/// # Ok::<(), exact_ccd_files::ReadMotionError>(())
/// ```
///
/// # Errors
/// [`ReadMotionError`] names the file that cannot be read, or both files and their first difference.
pub fn read_motion(start: impl AsRef<Path>, end: impl AsRef<Path>) -> Result<Motion, ReadMotionError> {
    let (start, end) = (start.as_ref(), end.as_ref());
    let (frame0, frame1) = rayon::join(|| read_frame(start), || read_frame(end));
    let both_stl = [start, end].map(Format::of_path) == [Some(Format::Stl); 2];
    let join = if both_stl { Motion::weld } else { Motion::new };
    join(frame0?, frame1?).map_err(|source| ReadMotionError::Motion {
        start: start.to_owned(),
        end: end.to_owned(),
        source,
    })
}
