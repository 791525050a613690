//! `exact-ccd step`: is the step from one mesh to another free of contact?

use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

use ccd_mesh::{Bvh, Candidates, Motion, Step, StepReport};

use crate::failure::Failure;
use crate::progress::Progress;
use crate::step_report::{Report, Seconds};

/// Is the step from one mesh to another free of contact?
///
/// The vertices move in straight lines from where they are in START to where they are in END. Primitives that share
/// a vertex are not tested against each other. Exit status: 0 free, 1 contact, 2 error.
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The mesh at the start of the step: a .ply, .obj, .stl or .off file.
    start: PathBuf,
    /// The mesh at its end, with the same faces.
    end: PathBuf,
    /// Print one JSON object.
    #[arg(long)]
    json: bool,
}

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let clock = Instant::now();
    let elapsed = || clock.elapsed().as_secs_f64();

    let motion = Motion::read(&arguments.start, &arguments.end)?;
    let step = Step::new(&motion.mesh, &motion.x0, &motion.x1)?;
    let read = elapsed();

    let candidates = Candidates::new(&step, &Bvh);
    let broad = elapsed();

    let progress = Progress::new(candidates.counts().total());
    let contacts = StepReport::new(&step, &candidates, &|count| progress.add(count));
    drop(progress);
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
    print(&text).or_else(Failure::unless_closed_pipe)?;
    Ok(ExitCode::from(u8::from(!contacts.is_free())))
}

fn print(text: &str) -> Result<(), Failure> {
    let mut output = std::io::stdout().lock();
    writeln!(output, "{text}")?;
    Ok(output.flush()?)
}
