//! The options of commands that read meshes.

use std::path::PathBuf;

use super::part::named;
use super::rules::Rules;

/// The options `--with`, `--ignore`, `--only`, `--weld`, `--triangles-only`, `--max-size`, `--positions` and
/// `--faces`.
#[derive(clap::Args)]
pub(crate) struct SceneOptions {
    /// A further part; may be repeated. One frame is a mesh at rest, an obstacle: obstacles are not
    /// compared with each other nor with themselves. A folder, a list of files or a file of several
    /// frames moves, and has as many frames as the other parts that move.
    #[arg(long = "with", value_name = "FILE")]
    pub(super) others: Vec<PathBuf>,
    #[command(flatten)]
    pub(super) rules: Rules,
    /// Make one vertex of those that are in the same place in all frames, if edges that coincide end
    /// in them: exporters split vertices so at seams of textures and normals. In STL files, which have
    /// no shared vertices, all vertices in the same place are one, always. Parts are not joined.
    #[arg(long)]
    pub(super) weld: bool,
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

impl SceneOptions {
    /// The files that are read, given those of the parts that move.
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
}
