//! `exact-ccd step`: is the step from one mesh to another free of contact?

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use clap::value_parser;
use exact_ccd::separation::Separation;
use exact_ccd_files::read_motion;
use exact_ccd_mesh::{Bvh, CandidateOptions, Detector, MinDistance, Motion, StepReport};

use crate::distances::{Distances, kept};
use crate::failure::Failure;
use crate::min_distance;
use crate::output::print;
use crate::progress::{self, during};
use crate::step_report::{Answer, Free, Output, Report, Seconds};
use crate::timed::Timed;
use crate::view::View;

/// Is the step from one mesh to another free of contact?
///
/// Every vertex moves in a straight line, at constant speed, from where it is in START at t = 0 to
/// where it is in END at t = 1. Contact is a common point of a vertex and a face, or of two edges,
/// that have no vertex in common. Vertices and edges without a face take part too.
///
/// With --min-distance D, primitives at most D apart are in contact. The pairs are then those above,
/// and loose vertices against loose edges and against each other.
///
/// The time of impact is the earliest contact time, rounded down to f64: until then the step is
/// free of contact for certain. Exit status: 0 free, 1 contact, 2 error.
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The mesh at the start of the step: a .ply, .obj, .stl, .off, .msh or .vtu file.
    start: PathBuf,
    /// The mesh at its end, with the same faces.
    end: PathBuf,
    /// Find the earliest contact only: contacts that are found cull the rest, and nothing is
    /// counted.
    #[arg(long, conflicts_with = "any")]
    toi: bool,
    /// Only decide if there is contact: the search ends at the first contact found.
    #[arg(long)]
    any: bool,
    /// Count primitives at most D apart as touching, in the unit of the coordinates.
    #[arg(long, value_name = "D", default_value = "0", value_parser = min_distance::parse, allow_hyphen_values = true)]
    min_distance: Separation,
    /// Count pairs that start within the minimum distance as touching only if they come within D, a
    /// smaller distance, which may be 0. A line search that starts there can move on so. For all
    /// other pairs, the minimum distance holds.
    #[arg(
        long,
        value_name = "D",
        requires = "min_distance",
        value_parser = min_distance::parse,
        allow_hyphen_values = true
    )]
    inner_distance: Option<Separation>,
    /// Repeat the computation N times, for measurements, and report the run of median duration.
    /// With --toi or --any, memory and the order of the primitives are kept from run to run, as in
    /// a simulation.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = value_parser!(u32).range(1..))]
    repeat: u32,
    /// Print the report as a JSON object.
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    view: View,
}

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let clock = Instant::now();
    let motion = during(progress::stage("reading"), |_| {
        read_motion(&arguments.start, &arguments.end)
    })?;
    let read = clock.elapsed();

    let broad_phase = Timed::new(Bvh);
    let distance = kept(arguments.min_distance, arguments.inner_distance);
    let detector = Detector::with_broad_phase(motion.mesh.clone(), &broad_phase);
    let mut detector = detector.with_min_distance(distance.clone())?;
    let mut answers = (0..arguments.repeat)
        .map(|_| arguments.answer(&motion, &broad_phase, &mut detector, &distance, read))
        .collect::<Result<Vec<Answer>, Failure>>()?;
    answers.sort_by(|a, b| a.seconds().total_cmp(&b.seconds()));
    let output = Output {
        distances: Distances::new(arguments.min_distance, arguments.inner_distance),
        answer: answers.swap_remove(answers.len() / 2),
    };
    let text = if arguments.json {
        output.to_json()
    } else {
        output.to_string()
    };
    print(&text)?;
    let files = [arguments.start.as_path(), &arguments.end];
    arguments
        .view
        .step(files, &motion, &mut detector, &output.to_string())?;
    Ok(ExitCode::from(u8::from(!output.answer.is_free())))
}

impl Arguments {
    fn answer(
        &self,
        motion: &Motion,
        broad_phase: &Timed<Bvh>,
        detector: &mut Detector<&Timed<Bvh>>,
        distance: &MinDistance,
        read: Duration,
    ) -> Result<Answer, Failure> {
        let Motion { mesh, x0, x1 } = motion;
        let clock = Instant::now();
        let seconds = || Seconds::new(read, clock.elapsed(), broad_phase.take_time_in_sinks());
        let stage = progress::stage("searching for contact");
        Ok(if self.any {
            let is_free = during(stage, |_| detector.is_free(x0, x1))?;
            Answer::Free(Free::new(is_free, seconds()))
        } else if self.toi {
            let earliest = during(stage, |_| detector.earliest_contact(x0, x1))?;
            Answer::Report(Report::earliest(mesh, earliest, seconds()))
        } else {
            let step = motion.step()?;
            let options = CandidateOptions::default().with_min_distance(distance.clone());
            let report = during(progress::pairs(), |progress| {
                StepReport::with_options(step, broad_phase, &options, progress)
            })?;
            Answer::Report(Report::new(mesh, &report, seconds()))
        })
    }
}
