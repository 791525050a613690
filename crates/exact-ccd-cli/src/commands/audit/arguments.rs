//! The arguments of `exact-ccd audit` and `exact-ccd merge`.

use std::path::PathBuf;

use super::share::Share;
use crate::motion::arguments::MeshArguments;

/// Certify that a mesh never touches itself in a sequence of frames.
///
/// The first frame is examined at rest: no edge may meet a face, no vertex a face, and no edge
/// another edge. From each frame to the next, every vertex moves in a straight line, and no contact
/// may occur, as in `exact-ccd step`. If there is none, then no frame passes through itself, nor
/// does the mesh at any time between; otherwise, the first violation is named. Parts of the mesh
/// that have a vertex in common are neighbours and may touch. With --ignore or --only, every frame is
/// examined for edges that meet faces: a pair that is left out may have led there.
///
/// With --min-distance D, no two primitives may come within D of each other, in the first frame
/// and after it.
///
/// Of a run of `exact-ccd simulate --output DIR --path`, DIR/path is the motion that is free of
/// contact. On the straight line from one time step to the next, as in DIR/frames, parts that turn
/// around each other may touch.
///
/// With --poses, the files are rigid bodies, which turn and translate from pose to pose. The motion is
/// decided exactly, on its curves.
///
/// All ids count from 0. Exit status: 0 free, 1 violation, 2 error, 3 if some pairs have no
/// certificate.
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// Meshes with the same faces: mesh files, folders of files of one format, lists of files (.pvd,
    /// .series), or files of several frames (.npz); or a mesh and a cache of its positions (.pc2, .mdd).
    /// Files whose names differ in one number are taken in the order of these numbers, others as they are
    /// given. docs/files.md lists the formats.
    #[arg(required = true)]
    pub(super) frames: Vec<PathBuf>,
    /// Keep the order of the files on the command line, whatever their numbers.
    #[arg(long)]
    pub(super) as_given: bool,
    /// Examine rigid bodies: each file is one of them, and has its coordinates. Their poses are in this CSV
    /// file, with the header frame,body,x,y,z,qw,qx,qy,qz: frames from 0 on, in order; the name of the file
    /// of the body, without folder and extension; the place of its origin; and its quaternion, scalar first,
    /// of any length. From pose to pose, a body turns the shorter way.
    #[arg(
        long,
        value_name = "FILE",
        conflicts_with_all = [
            "as_given", "others", "ignore", "only", "weld", "faces_only", "points", "positions", "faces",
            "half_space", "all", "paraview", "view", "view_up", "certificate"
        ]
    )]
    pub(super) poses: Option<PathBuf>,
    /// Keep the result of each frame in this folder as soon as it is examined. The same command later, after
    /// the end or the death of the process, examines the other frames only, and its report is the same one.
    #[arg(
        long,
        value_name = "DIR",
        conflicts_with_all = ["poses", "paraview", "view", "view_up", "certificate"]
    )]
    pub(super) results: Option<PathBuf>,
    /// Examine part I of N of the frames, for N processes on any machines that share the folder of results.
    /// `exact-ccd merge` with the same arguments makes the report of all parts.
    #[arg(long, value_name = "I/N", requires = "results", conflicts_with = "json")]
    pub(super) part: Option<Share>,
    #[command(flatten)]
    pub(super) mesh: MeshArguments,
}

/// Report an audit from the results of all of its parts.
///
/// The arguments are the same as of `exact-ccd audit --part I/N --results DIR`, without --part. The report
/// is the one that a single process makes. Nothing is examined: frames without a result are an error.
///
/// Exit status: as of `exact-ccd audit`.
#[derive(clap::Args)]
pub(crate) struct MergeArguments {
    #[command(flatten)]
    pub(super) audit: Arguments,
}
