//! The options of commands that read meshes.

use std::path::PathBuf;

use exact_ccd_files::{Polygons, ReadOptions};

use super::named_file::named;
use super::rules::Rules;

/// The options `--with`, `--ignore`, `--only`, `--weld`, `--faces-only`, `--points`,
/// `--triangles-only`, `--max-size`, `--positions` and `--faces`.
#[derive(clap::Args, Debug)]
pub(crate) struct AssemblyOptions {
    /// A further part; may be repeated. One frame is a mesh at rest, an obstacle: obstacles are not
    /// compared with each other nor with themselves. A folder, a list of files or a file of several
    /// frames moves, and has as many frames as the other parts that move.
    #[arg(long = "with", value_name = "FILE")]
    pub(super) others: Vec<PathBuf>,
    #[command(flatten)]
    pub(super) rules: Rules,
    /// Make one vertex of vertices that are in the same place in all frames, if edges that coincide end
    /// in them: exporters split vertices so at seams of textures and normals. In STL files, which have
    /// no shared vertices, all vertices in the same place are one, always. Parts are not joined.
    /// --weld=TOLERANCE joins vertices that are at most TOLERANCE apart in all frames, in the unit of the
    /// coordinates. They move as the first of them, and the answer is about this changed mesh.
    #[arg(
        long,
        value_name = "TOLERANCE",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "0",
        value_parser = tolerance
    )]
    pub(super) weld: Option<f64>,
    /// Leave out edges and vertices of no face, as wires and sewing edges. --faces-only=PART does so in
    /// one part; may be repeated.
    #[arg(
        long,
        value_name = "PART",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = ""
    )]
    pub(super) faces_only: Vec<String>,
    /// Examine points alone: without this option, files that have neither a face nor an edge are an error.
    #[arg(long)]
    pub(super) points: bool,
    /// Refuse faces with more than three corners, which otherwise become fans of triangles from their
    /// lowest vertex.
    #[arg(long)]
    pub(super) triangles_only: bool,
    /// Refuse files of more than this number of bytes, and files whose data expand to more: compressed
    /// data, or data that a file names several times. The memory of reading is proportional to it.
    #[arg(long, value_name = "BYTES")]
    pub(super) max_size: Option<u64>,
    /// The name of the array of positions in the .npz files of parts that move, not of --with.
    #[arg(long, value_name = "NAME")]
    pub(super) positions: Option<String>,
    /// The name of the array of faces in the .npz files of parts that move, not of --with; or a file
    /// .npy with their faces, which .npy files of positions need.
    #[arg(long, value_name = "NAME")]
    pub(super) faces: Option<String>,
}

impl AssemblyOptions {
    /// The files that are read, given the files of the parts that move.
    pub(crate) fn inputs(&self, moving: &[PathBuf]) -> Vec<PathBuf> {
        moving
            .iter()
            .chain(&self.others)
            .map(|path| named(path).1)
            .chain(
                self.faces
                    .iter()
                    .filter(|name| name.ends_with(".npy"))
                    .map(PathBuf::from),
            )
            .collect()
    }

    /// The options of reading a part that moves.
    pub(super) fn read_options(&self) -> ReadOptions {
        self.of_others()
            .with_arrays(self.positions.clone(), self.faces.clone())
    }

    /// The options of reading another part: its arrays have other names.
    pub(super) fn of_others(&self) -> ReadOptions {
        let polygons = if self.triangles_only {
            Polygons::Refuse
        } else {
            Polygons::Triangulate
        };
        ReadOptions::from(polygons).with_max_size(self.max_size.unwrap_or(u64::MAX))
    }

    /// Returns true if only the faces of the part count.
    pub(super) fn has_faces_only(&self, part: &str) -> bool {
        self.faces_only.iter().any(|name| name.is_empty() || name == part)
    }
}

/// The tolerance of `--weld`.
fn tolerance(text: &str) -> Result<f64, String> {
    let value: Option<f64> = text.parse().ok();
    let value = value.filter(|value| value.is_finite() && *value >= 0.0);
    value.ok_or_else(|| "expected a distance, 0 or more".to_owned())
}
