//! The options of commands that read meshes.

use std::path::PathBuf;

use super::PartPair;

/// The options `--with`, `--ignore`, `--only`, `--weld` and `--triangles-only`.
#[derive(clap::Args)]
pub(crate) struct SceneOptions {
    /// A further part; may be repeated. One frame is a mesh at rest, an obstacle: obstacles are not
    /// compared with each other nor with themselves. A folder, a list of files or a file of several
    /// frames moves, and has as many frames as the other parts that move.
    #[arg(long = "with", value_name = "FILE")]
    pub(super) others: Vec<PathBuf>,
    /// The parts A and B do not collide; may be repeated. A part is named as its file is, without
    /// folder and extension, or by NAME=FILE in place of FILE. Objects and groups of OBJ files (`o`
    /// and `g`) are named GROUP or PART/GROUP. A:A leaves out the pairs of a part with itself.
    #[arg(long, value_name = "A:B", conflicts_with = "only")]
    pub(super) ignore: Vec<PartPair>,
    /// Only the parts A and B collide; may be repeated.
    #[arg(long, value_name = "A:B")]
    pub(super) only: Vec<PartPair>,
    /// Make one vertex of those that are in the same place in all frames, if edges that coincide end
    /// in them: exporters split vertices so at seams of textures and normals. In STL files, which have
    /// no shared vertices, all vertices in the same place are one, always. Parts are not joined.
    #[arg(long)]
    pub(super) weld: bool,
    /// Refuse faces with more than three corners, which otherwise become fans of triangles from their
    /// lowest vertex.
    #[arg(long)]
    pub(super) triangles_only: bool,
}
