//! `exact-ccd step`: is the step from one mesh to another free of contact?

mod report;
mod seconds;
mod text;

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use clap::value_parser;
use exact_ccd::separation::Separation;
use exact_ccd_files::FileIds;
use exact_ccd_mesh::{
    Bvh, CanCollide, CandidateOptions, Contact, Detector, Intersection, MinDistance, Motion, StepError,
    StepReport, crossings,
};

use crate::contacts::{ContactList, ContactRecord, ListFile};
use crate::distances::{Distances, kept};
use crate::failure::Failure;
use crate::impact_files;
use crate::min_distance;
use crate::notes::Notes;
use crate::output::print;
use crate::progress::{self, during};
use crate::scene::{Scene, SceneOptions, note_split_vertices};
use crate::timed::Timed;
use crate::view::View;
use report::{Answer, Output, Report, Start};
use seconds::Seconds;

/// Is the step from one mesh to another free of contact?
///
/// Every vertex moves in a straight line, at constant speed, from where it is in START at t = 0 to
/// where it is in END at t = 1. Contact is a common point of a vertex and a face, or of two edges,
/// that have no vertex in common. Vertices and edges without a face take part too: loose vertices, of
/// no edge, are compared with loose edges and with each other.
///
/// A mesh that passes through itself at t = 0 is reported as well: the first pair of an edge and a
/// face that meet.
///
/// With --min-distance D, primitives at most D apart are in contact. The pairs are the same.
///
/// The time of impact is the earliest contact time, rounded down to f64: until then the step is
/// free of contact for certain. All ids count from 0. Exit status: 0 free, 1 contact or intersection
/// at the start, 2 error.
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// Pairs of mesh files, START END: a mesh at the start of the step, and at its end, with the same
    /// faces. Each pair is a part; parts are compared with each other, too. Or one file with two
    /// frames. docs/files.md lists the formats.
    #[arg(required = true, value_name = "START END")]
    files: Vec<PathBuf>,
    #[command(flatten)]
    scene: SceneOptions,
    /// Do not search for places where the mesh passes through itself at t = 0.
    #[arg(long)]
    no_start_check: bool,
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
    /// List the intersections at t = 0 and all contacts of the step, sorted by time, in a file that
    /// ends in .csv, .jsonl (JSON lines) or .parquet. docs/reports.md has its columns.
    #[arg(long, value_name = "FILE")]
    all: Option<ListFile>,
    /// Write the mesh at the time of impact, impact.vtu, and all contacts as points, contacts.vtp, to
    /// this folder, for ParaView.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Repeat the computation N times, for measurements, and report the run of median duration.
    /// With --toi or --any, memory and the order of the primitives are kept from run to run, as in
    /// a simulation.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = value_parser!(u32).range(1..))]
    repeat: u32,
    /// Print the report as a JSON object. docs/reports.md has its schema.
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    view: View,
}

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let clock = Instant::now();
    let mut notes = Notes::default();
    let (scene, motion) = during(progress::stage("reading"), |_| arguments.read(&mut notes))?;
    let read = clock.elapsed();
    let problem = Problem {
        can_collide: scene.can_collide(),
        distance: kept(arguments.min_distance, arguments.inner_distance),
        broad_phase: Timed::new(Bvh),
        ids: scene.ids().clone(),
        motion,
    };

    let clock = Instant::now();
    let start = arguments.start(&problem)?;
    let start_check = clock.elapsed();

    let mut detector = problem.detector()?;
    let mut answers = (0..arguments.repeat)
        .map(|_| arguments.answer(&problem, &mut detector, [read, start_check]))
        .collect::<Result<Vec<Answer>, Failure>>()?;
    answers.sort_by(|a, b| a.seconds().total_cmp(&b.seconds()));
    let answer = answers.swap_remove(answers.len() / 2);

    let Motion { mesh, x0, x1 } = &problem.motion;
    if answer.may_touch_at_start() || !start.is_empty() {
        let touching = detector.contacts(x0, x1, 0.0)?;
        note_split_vertices(mesh, x0, &touching, &start, &arguments.scene, &mut notes);
    }
    let output = Output {
        summary: scene.summary(),
        notes,
        distances: Distances::new(arguments.min_distance, arguments.inner_distance),
        collision_free: answer.is_free() && start.is_empty(),
        start: (!arguments.no_start_check).then(|| Start::new(mesh, &problem.ids, &start)),
        answer,
    };
    let text = if arguments.json {
        output.to_json()
    } else {
        output.to_string()
    };
    print(&text)?;
    arguments.write_contacts(&problem, &start, &mut detector)?;
    arguments.view.step(
        &arguments.files,
        &problem.motion,
        &start,
        &problem.ids,
        &mut detector,
        &output.to_string(),
    )?;
    Ok(ExitCode::from(u8::from(!output.collision_free)))
}

/// A motion, the ids of its vertices and faces, and the meaning of contact in it.
struct Problem {
    motion: Motion,
    ids: FileIds,
    can_collide: CanCollide,
    distance: MinDistance,
    broad_phase: Timed<Bvh>,
}

impl Problem {
    fn detector(&self) -> Result<Detector<&Timed<Bvh>>, Failure> {
        let detector = Detector::with_broad_phase(self.motion.mesh.clone(), &self.broad_phase);
        let detector = detector.with_can_collide(self.can_collide.clone());
        Ok(detector.with_min_distance(self.distance.clone())?)
    }
}

impl Arguments {
    fn read(&self, notes: &mut Notes) -> Result<(Scene, Motion), Failure> {
        let mut scene = Scene::of_pairs(&self.files, &self.scene, notes)?;
        scene.check_contents(self.min_distance != Separation::default())?;
        let (start, end) = (scene.read(0)?, scene.read(1)?);
        let motion = Motion::new(start, end).map_err(|error| scene.mismatch(1, error))?;
        Ok((scene, motion))
    }

    /// The intersections at the start, unless they are not searched for.
    fn start(&self, problem: &Problem) -> Result<Vec<Intersection>, Failure> {
        if self.no_start_check {
            return Ok(Vec::new());
        }
        let Motion { mesh, x0, .. } = &problem.motion;
        let stage = progress::stage("examining the start");
        let found = during(stage, |_| crossings(mesh, x0, &problem.can_collide));
        Ok(found.map_err(StepError::from)?)
    }

    fn answer(
        &self,
        problem: &Problem,
        detector: &mut Detector<&Timed<Bvh>>,
        [read, start]: [Duration; 2],
    ) -> Result<Answer, Failure> {
        let Problem {
            motion,
            ids,
            broad_phase,
            ..
        } = problem;
        let Motion { x0, x1, .. } = motion;
        let clock = Instant::now();
        let seconds = || Seconds::new(read, start, clock.elapsed(), broad_phase.take_time_in_sinks());
        let stage = progress::stage("searching for contact");
        Ok(if self.any {
            let is_free = during(stage, |_| detector.is_free(x0, x1))?;
            Answer::free(is_free, seconds())
        } else if self.toi {
            let earliest = during(stage, |_| detector.earliest_contact(x0, x1))?;
            Answer::Report(Box::new(Report::earliest(motion, ids, earliest, seconds())))
        } else {
            let options = CandidateOptions::default()
                .with_min_distance(problem.distance.clone())
                .with_can_collide(problem.can_collide.clone());
            let report = during(progress::pairs(), |progress| {
                StepReport::with_options(motion.step()?, broad_phase, &options, progress)
                    .map_err(Failure::from)
            })?;
            Answer::Report(Box::new(Report::new(motion, ids, &report, seconds())))
        })
    }

    /// Writes the files that have all contacts.
    fn write_contacts(
        &self,
        problem: &Problem,
        start: &[Intersection],
        detector: &mut Detector<&Timed<Bvh>>,
    ) -> Result<(), Failure> {
        if self.all.is_none() && self.out.is_none() {
            return Ok(());
        }
        let Problem { motion, ids, .. } = problem;
        let Motion { mesh, x0, x1 } = motion;
        let contacts: Vec<Contact> = detector.contacts(x0, x1, 1.0)?;
        let at_start = start
            .iter()
            .map(|&found| ContactRecord::of_intersection(mesh, found).in_file(ids));
        let in_step = contacts
            .iter()
            .map(|found| ContactRecord::of_contact(mesh, [x0, x1], found).in_file(ids));
        let list = ContactList(at_start.chain(in_step).collect());
        if let Some(file) = &self.all {
            list.write(file)?;
        }
        if let Some(folder) = &self.out {
            impact_files::write(folder, motion.step()?, ids, &list)?;
        }
        Ok(())
    }
}
