//! `exact-ccd audit`: the contacts of a mesh in a sequence of frames.

mod arguments;
mod bodies;
mod frame_result;
mod identity;
mod outputs;
mod pose_table;
mod results;
mod run;
mod share;

use std::process::ExitCode;

use crate::messages::failure::Failure;
use crate::messages::progress::{self, during};
use results::Results;
use run::Run;
use share::Share;

pub(crate) use arguments::{Arguments, MergeArguments};

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
