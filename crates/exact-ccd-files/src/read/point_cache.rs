//! Caches of positions, PC2 and MDD: the positions of all frames, without the mesh.
//!
//! PC2, of 3ds Max, in little-endian bytes: `POINTCACHE2` and a zero byte, the version 1 as `i32`, the number
//! of vertices as `i32`, the first frame and the frames from one sample to the next as `f32`, the number of
//! samples as `i32`; then x, y, z of each vertex as `f32`, sample by sample.
//!
//! MDD, of LightWave, in big-endian bytes: the numbers of frames and of vertices as `i32`, the time of each
//! frame in seconds as `f32`; then the positions as in PC2.

use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use exact_ccd_mesh::Point;

use super::scalar::{ByteOrder, Scalar};
use crate::error::{Fault, ParseError, Place, ReadError, quoted};
use crate::format::{extension, is_gzip};

/// A file of positions. Frames are read when they are needed.
#[derive(Debug)]
pub(super) struct PointCache {
    path: PathBuf,
    layout: Layout,
}

/// The contents of a file before the positions.
#[derive(Debug)]
struct Layout {
    order: ByteOrder,
    vertex_count: u64,
    frame_count: u64,
    /// The first byte of the positions.
    start: u64,
    times: Times,
}

#[derive(Debug)]
enum Times {
    /// The time of the first frame, and the difference from each frame to the next one.
    Regular(f64, f64),
    Listed(Vec<f64>),
}

/// The size of a vertex: three `f32`.
const VERTEX: u64 = 12;
const MAGIC: &[u8; 12] = b"POINTCACHE2\0";

impl PointCache {
    /// Returns true for the name of a cache.
    pub(super) fn has_name(path: &Path) -> bool {
        matches!(extension(path).as_deref(), Some("pc2" | "mdd"))
    }

    /// Reads what is before the positions, and checks that the file has all of them.
    pub(super) fn open(path: &Path) -> Result<Self, ReadError> {
        let layout = read_at(path, |file| {
            if is_gzip(path) {
                return Err(fault(Fault::expected(
                    "a cache without compression (decompress it)",
                    "gzip",
                )));
            }
            let length = file.metadata()?.len();
            match extension(path).as_deref() {
                Some("mdd") => Layout::of_mdd(file, length),
                _ => Layout::of_pc2(file, length),
            }
        })?;
        Ok(Self {
            path: path.to_owned(),
            layout,
        })
    }

    pub(super) fn vertex_count(&self) -> u64 {
        self.layout.vertex_count
    }

    pub(super) fn frame_count(&self) -> usize {
        usize::try_from(self.layout.frame_count).unwrap_or(usize::MAX)
    }

    /// The time of a frame, from 0: in PC2 the number of a frame of its animation, in MDD seconds.
    pub(super) fn time(&self, frame: usize) -> Option<f64> {
        match &self.layout.times {
            Times::Regular(first, step) => Some(first + frame as f64 * step),
            Times::Listed(times) => times.get(frame).copied(),
        }
    }

    /// The positions of a frame, from 0.
    pub(super) fn positions(&self, frame: usize) -> Result<Vec<Point>, ReadError> {
        let Layout {
            order,
            vertex_count,
            start,
            ..
        } = self.layout;
        read_at(&self.path, |file| {
            let size = vertex_count * VERTEX;
            file.seek(SeekFrom::Start(start + frame as u64 * size))?;
            let mut bytes = Vec::new();
            bytes.try_reserve_exact(usize::try_from(size).unwrap_or(usize::MAX))?;
            if file.take(size).read_to_end(&mut bytes)? as u64 != size {
                // The file was shortened after it was opened.
                return Err(Fault::ends("the positions of this frame")
                    .at(Place::Frame(frame))
                    .into());
            }
            Ok(Scalar::F32.reals(&bytes, order).as_chunks().0.to_vec())
        })
    }
}

impl Layout {
    fn of_pc2(file: &mut impl Read, length: u64) -> Result<Self, Problem> {
        let magic: [u8; 12] = beginning(file, "the header of PC2, 32 bytes")?;
        if &magic != MAGIC {
            let expected = "`POINTCACHE2` at the beginning of a PC2 file";
            return Err(fault(Fault::expected(expected, quoted(&magic))));
        }
        let header: [u8; 20] = beginning(file, "the header of PC2, 32 bytes")?;
        let order = ByteOrder::LittleEndian;
        let [version, vertices, _, _, frames] = words(&header, order);
        let [_, _, first, step, _] = numbers(&header, order);
        if version != 1 {
            return Err(fault(Fault::expected(
                "the version 1 of PC2",
                version.to_string(),
            )));
        }
        let is_regular = first.is_finite() && step.is_finite() && step >= 0.0;
        if !is_regular {
            let expected = "a first frame and a number of frames for each sample, which is not negative";
            return Err(fault(Fault::expected(expected, format!("{first} and {step}"))));
        }
        let times = Times::Regular(first, step);
        Self::new(order, [vertices, frames], 32, times).checked(length)
    }

    fn of_mdd(file: &mut impl Read, length: u64) -> Result<Self, Problem> {
        let header: [u8; 8] = beginning(file, "the header of MDD, 8 bytes")?;
        let order = ByteOrder::BigEndian;
        let [frames, vertices] = words(&header, order);
        let start = 8 + 4 * u64::from(frames.max(0).unsigned_abs());
        let layout =
            Self::new(order, [vertices, frames], start, Times::Listed(Vec::new())).checked(length)?;
        // The file is at least as long as the times.
        let mut bytes = vec![0; 4 * layout.frame_count as usize];
        file.read_exact(&mut bytes)?;
        let times = Scalar::F32.reals(&bytes, order);
        let is_wrong = |frame: &usize| {
            let time = times[*frame];
            !time.is_finite() || *frame > 0 && time < times[frame - 1]
        };
        if let Some(frame) = (0..times.len()).find(is_wrong) {
            let expected = "times that do not decrease (export the cache again)";
            return Err(Fault::expected(expected, times[frame].to_string())
                .at(Place::Frame(frame))
                .into());
        }
        Ok(Self {
            times: Times::Listed(times),
            ..layout
        })
    }

    /// Negative numbers become 0, which is refused.
    fn new(order: ByteOrder, [vertices, frames]: [i32; 2], start: u64, times: Times) -> Self {
        let [vertex_count, frame_count] =
            [vertices, frames].map(|count| u64::from(count.max(0).unsigned_abs()));
        Self {
            order,
            vertex_count,
            frame_count,
            start,
            times,
        }
    }

    /// Checks that a file of this length has the positions of all frames, and nothing else.
    fn checked(self, length: u64) -> Result<Self, Problem> {
        let Self {
            vertex_count,
            frame_count,
            start,
            ..
        } = self;
        let contents = format!("{frame_count} frames of {vertex_count} vertices");
        if vertex_count == 0 || frame_count == 0 {
            return Err(fault(Fault::expected(
                "at least one frame and one vertex",
                contents,
            )));
        }
        // Both counts are below 2³¹, so the product is below 2⁶⁶: no more than 2⁶⁴ can be in a file.
        let size = (frame_count * vertex_count).checked_mul(VERTEX);
        let size = size.and_then(|size| size.checked_add(start)).unwrap_or(u64::MAX);
        if length < size {
            let whole = length.saturating_sub(start) / (vertex_count * VERTEX);
            let expected = format!("{contents}, {size} bytes (export the cache again)");
            return Err(Fault::ends(expected).at(Place::Frame(whole as usize)).into());
        }
        if length > size {
            let expected = format!("{contents}, {size} bytes (export the cache again)");
            return Err(fault(Fault::expected(expected, format!("{length} bytes"))));
        }
        Ok(self)
    }
}

/// An error of the system or of the contents, before the file is named.
enum Problem {
    Io(io::Error),
    Parse(ParseError),
}

impl From<io::Error> for Problem {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}

impl From<std::collections::TryReserveError> for Problem {
    fn from(error: std::collections::TryReserveError) -> Self {
        Self::Io(error.into())
    }
}

impl From<ParseError> for Problem {
    fn from(error: ParseError) -> Self {
        Self::Parse(error)
    }
}

fn fault(fault: Fault) -> Problem {
    fault.at(Place::File).into()
}

/// Opens a file and reads from it, with errors that name it.
fn read_at<T>(path: &Path, read: impl FnOnce(&mut File) -> Result<T, Problem>) -> Result<T, ReadError> {
    let result = File::open(path).map_err(Problem::from);
    result.and_then(|mut file| read(&mut file)).map_err(|problem| {
        let path = path.to_owned();
        match problem {
            Problem::Io(source) => ReadError::Io { path, source },
            Problem::Parse(source) => ReadError::Parse { path, source },
        }
    })
}

/// The next bytes of a file that must have them.
fn beginning<const N: usize>(file: &mut impl Read, expected: &str) -> Result<[u8; N], Problem> {
    let mut bytes = [0; N];
    file.read_exact(&mut bytes).map_err(|error| match error.kind() {
        io::ErrorKind::UnexpectedEof => fault(Fault::ends(expected)),
        _ => error.into(),
    })?;
    Ok(bytes)
}

/// The integers in a header.
fn words<const N: usize>(header: &[u8], order: ByteOrder) -> [i32; N] {
    let words = Scalar::I32.integers(header, order);
    std::array::from_fn(|index| words[index] as i32)
}

/// The numbers in a header.
fn numbers<const N: usize>(header: &[u8], order: ByteOrder) -> [f64; N] {
    let numbers = Scalar::F32.reals(header, order);
    std::array::from_fn(|index| numbers[index])
}
