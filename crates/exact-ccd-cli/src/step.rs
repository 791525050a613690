//! `exact-ccd step`: is the step from one mesh to another free of contact?

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

use ccd_mesh::{Bvh, Candidates, Motion, StepReport};

use crate::failure::Failure;
use crate::output::print;
use crate::progress::{self, during};
use crate::step_report::{Report, Seconds};

/// Is the step from one mesh to another free of contact?
///
/// Every vertex moves in a straight line, at constant speed, from where it is in START at t = 0 to where it is in END
/// at t = 1. Contact is a common point of a vertex and a face, or of two edges, that have no vertex in common.
///
/// The time of impact is the earliest contact time, rounded down to f64: until then the step is free of contact for
/// certain. Exit status: 0 free, 1 contact, 2 error.
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The mesh at the start of the step: a .ply, .obj, .stl, .off, .msh or .vtu file.
    start: PathBuf,
    /// The mesh at its end, with the same faces.
    end: PathBuf,
    /// Print the report as a JSON object.
    #[arg(long)]
    json: bool,
}

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let clock = Instant::now();
    let elapsed = || clock.elapsed().as_secs_f64();

    let motion = during(progress::stage("reading"), |_| {
        Motion::read(&arguments.start, &arguments.end)
    })?;
    let step = motion.step()?;
    let read = elapsed();

    let candidates = during(progress::stage("looking for pairs near each other"), |_| {
        Candidates::new(step, &Bvh)
    });
    let broad = elapsed();

    let pairs = candidates.counts().total();
    let contacts = during(progress::pairs(pairs), |progress| {
        StepReport::new(&candidates, progress)
    });
    let total = elapsed();

    let seconds = Seconds {
        read,
        broad: broad - read,
        narrow: total - broad,
        total,
    };
    let report = Report::new(&motion.mesh, &contacts, seconds);
    let text = if arguments.json {
        report.to_json()
    } else {
        report.to_string()
    };
    print(&text)?;
    Ok(ExitCode::from(u8::from(!contacts.is_free())))
}
