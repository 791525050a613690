//! `exact-ccd audit`: the contacts of a mesh in a sequence of frames.

mod bodies;
mod frame_result;
mod identity;
mod outputs;
mod pose_table;
mod results;
mod run;
mod share;

use std::path::PathBuf;
use std::process::ExitCode;

use crate::messages::failure::Failure;
use crate::messages::progress::{self, during};
use crate::motion::arguments::MeshArguments;
use results::Results;
use run::Run;
use share::Share;

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
    frames: Vec<PathBuf>,
    /// Keep the order of the files on the command line, whatever their numbers.
    #[arg(long)]
    as_given: bool,
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
    poses: Option<PathBuf>,
    /// Keep the result of each frame in this folder as soon as it is examined. The same command later, after
    /// the end or the death of the process, examines the other frames only, and its report is the same one.
    #[arg(
        long,
        value_name = "DIR",
        conflicts_with_all = ["poses", "paraview", "view", "view_up", "certificate"]
    )]
    results: Option<PathBuf>,
    /// Examine part I of N of the frames, for N processes on any machines that share the folder of results.
    /// `exact-ccd merge` with the same arguments makes the report of all parts.
    #[arg(long, value_name = "I/N", requires = "results", conflicts_with = "json")]
    part: Option<Share>,
    #[command(flatten)]
    mesh: MeshArguments,
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
    audit: Arguments,
}

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    if let Some(poses) = &arguments.poses {
        return bodies::run(&arguments.frames, poses, &arguments.mesh);
    }
    let mut run = Run::begin(arguments)?;
    let share = arguments.part.unwrap_or(Share::WHOLE);
    let mut results = match &arguments.results {
        Some(folder) => Some(Results::open(folder, &run.identity()?, Some(share))?),
        None => None,
    };
    let frames = share.of(run.frame_count());
    let has = |frame: &usize| results.as_ref().is_some_and(|results| results.has(*frame));
    let left = frames.clone().filter(|frame| !has(frame)).count();
    during(progress::bar(left, "frames"), |progress| {
        for frame in frames.clone() {
            if let Some(result) = results.as_mut().and_then(|results| results.take(frame)) {
                run.add(result)?;
            } else {
                let result = run.examine(frame)?;
                if let Some(results) = &mut results {
                    results.add(&result)?;
                }
                run.add(result)?;
                progress(1);
            }
            if run.is_over() {
                break;
            }
        }
        Ok::<_, Failure>(())
    })?;
    match arguments.part {
        Some(share) => run.finish_part(share),
        None => run.finish(),
    }
}

pub(crate) fn merge(MergeArguments { audit }: &MergeArguments) -> Result<ExitCode, Failure> {
    let folder = match (&audit.results, audit.part, &audit.poses) {
        (Some(folder), None, None) => folder,
        _ => {
            return Err(Failure::new(
                "expected --results DIR, and neither --part nor --poses",
            ));
        }
    };
    let mut run = Run::begin(audit)?;
    let mut results = Results::open(folder, &run.identity()?, None)?;
    for frame in 0..run.frame_count() {
        let Some(result) = results.take(frame) else {
            let reason = format_args!(
                "no result of frame {frame} ({}): run the parts to their ends, or `exact-ccd audit --results` for the rest",
                run.frame_name(frame)
            );
            return Err(Failure::of(folder, reason));
        };
        run.add(result)?;
        if run.is_over() {
            break;
        }
    }
    run.finish()
}
