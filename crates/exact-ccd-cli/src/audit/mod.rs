//! `exact-ccd audit`: does a mesh touch itself in a sequence of frames?

mod frames;
mod report;

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use exact_ccd::separation::Separation;
use exact_ccd_mesh::Audit;

use crate::distances::{Distances, kept};
use crate::failure::Failure;
use crate::min_distance;
use crate::output::print;
use crate::progress::{self, during};
use crate::view::View;
use frames::Frames;
use report::{Report, ReportedViolation, Seconds};

/// Does a mesh touch itself in a sequence of frames?
///
/// The first frame is examined at rest: no edge may meet a face, no vertex a face, and no edge
/// another edge. From each frame to the next, every vertex moves in a straight line, and no contact
/// may occur, as in `exact-ccd step`. If there is none, then no frame passes through itself, nor
/// does the mesh at any time between; otherwise, the first violation is named. Parts of the mesh
/// that have a vertex in common are neighbours and may touch.
///
/// With --min-distance D, no two of them may come within D of each other, in the first frame and
/// after it.
///
/// Of a run of `exact-ccd simulate --out DIR --path`, DIR/path is the motion that is free of
/// contact. On the straight line from one time step to the next, as in DIR/frames, parts that turn
/// around each other may touch.
///
/// Exit status: 0 free, 1 violation, 2 error.
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// Meshes with the same faces, in the order of time: .ply, .obj, .stl, .off, .msh or .vtu
    /// files, or a folder of files of one of these formats, which are taken in the order of the
    /// numbers in their names, or a .pvd collection.
    #[arg(required = true)]
    frames: Vec<PathBuf>,
    /// Count primitives at most D apart as touching, in the unit of the coordinates.
    #[arg(long, value_name = "D", default_value = "0", value_parser = min_distance::parse, allow_hyphen_values = true)]
    min_distance: Separation,
    /// Print the report as a JSON object.
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    view: View,
}

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let clock = Instant::now();
    let frames = Frames::find(&arguments.frames)?;
    let mut read = clock.elapsed();
    let mut recording = arguments.view.recording(&arguments.frames);
    let mut audit = Audit::with_min_distance(kept(arguments.min_distance, None));
    let violation = during(progress::frames(frames.count()), |progress| {
        for index in 0..frames.count() {
            let start = Instant::now();
            let frame = frames.read(index)?;
            read += start.elapsed();
            recording.add(frames.file(index), &frame)?;
            let violation = audit
                .examine(frame)
                .map_err(|error| frames.mismatch(index, error))?;
            if let (Some(violation), Some(last)) = (violation, audit.last()) {
                recording.violation(&violation)?;
                return Ok(Some(ReportedViolation::new(
                    &frames, index, &last.mesh, violation,
                )));
            }
            progress(1);
        }
        Ok::<_, Failure>(None)
    })?;
    let total = clock.elapsed();
    let seconds = |duration: Duration| duration.as_secs_f64();
    let report = Report {
        distances: Distances::new(arguments.min_distance, None),
        collision_free: violation.is_none(),
        frames: frames.count(),
        examined: audit.frames(),
        violation,
        seconds: Seconds {
            read: seconds(read),
            examine: seconds(total - read),
            total: seconds(total),
        },
    };
    let text = if arguments.json {
        report.to_json()
    } else {
        report.to_string()
    };
    print(&text)?;
    recording.finish(&report.to_string())?;
    Ok(ExitCode::from(u8::from(!report.collision_free)))
}
