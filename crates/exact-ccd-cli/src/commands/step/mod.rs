//! `exact-ccd step`: the contacts of a mesh over one time step.

mod outputs;
mod problem;
mod timed;
mod written;

use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;

use clap::value_parser;
use exact_ccd::Separation;
use exact_ccd_mesh::{
    Bvh, CandidateOptions, Detector, Intersection, IntersectionOptions, Meeting, Motion, StepError,
    StepReport, intersections,
};

use crate::assembly::{Assembly, Turns};
use crate::contacts::{ContactRecord, note_of_rounding};
use crate::messages::failure::Failure;
use crate::messages::notes::Notes;
use crate::messages::progress::{self, during};
use crate::motion::arguments::MeshArguments;
use crate::motion::counts::{Counts, Pairs, Violations};
use crate::motion::report::{Report, ReportForm};
use crate::options::distances::{self, Distances, kept};
use crate::text::seconds::Seconds;
use problem::{Answer, Found, Problem};

/// Find the contacts of a mesh in the step from one file to another.
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
/// With --half-space, a vertex is in contact with a half space when it is in it, or at most D outside.
///
/// The time of impact is the earliest contact time, rounded down to f64: until then the step is
/// free of contact for certain. All ids count from 0. Exit status: 0 free, 1 contact or intersection
/// at the start, 2 error, 3 if some pairs have no certificate.
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// Pairs of mesh files, START END: a mesh at the start of the step, and at its end, with the same
    /// faces. Each pair is a part; parts are compared with each other, too. Or one file with two
    /// frames. docs/files.md lists the formats.
    #[arg(required = true, value_name = "START END")]
    files: Vec<PathBuf>,
    /// Take each file as a mesh at t = 0, which moves to its coordinates rounded to single precision at
    /// t = 1: if the step is free of contact, the mesh stays as it is, without intersections, where it is
    /// written as f32, as in STL, GLB and many PLY files.
    #[arg(long, conflicts_with = "certificate")]
    write_f32: bool,
    #[command(flatten)]
    mesh: MeshArguments,
    /// Do not search for places where the mesh passes through itself at t = 0.
    #[arg(long)]
    no_start_check: bool,
    /// Find the earliest contact only. Pairs that cannot be earlier are skipped, and nothing is
    /// counted.
    #[arg(long, conflicts_with = "any")]
    toi: bool,
    /// Only decide if there is contact: the search ends at the first contact found.
    #[arg(long)]
    any: bool,
    /// Count pairs that start within the minimum distance as touching only if they come within D, a
    /// smaller distance, which may be 0. A line search that starts there can move on so. For all
    /// other pairs, the minimum distance holds. A D that is not smaller changes nothing.
    #[arg(
        long,
        value_name = "D",
        requires = "min_distance",
        value_parser = distances::parse,
        allow_hyphen_values = true
    )]
    inner_distance: Option<Separation>,
    /// Repeat the computation N times, for measurements, and report the run of median duration.
    /// With --toi or --any, memory and the order of the primitives are kept from run to run, as in
    /// a simulation.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = value_parser!(u32).range(1..))]
    repeat: u32,
}

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let Arguments { mesh, .. } = arguments;
    mesh.check_places(&arguments.files)?;
    let mut certificate = mesh
        .certificate
        .begin(arguments.files.iter().cloned(), mesh.min_distance)?;
    if certificate.is_wanted() && (arguments.files.len() != 2 || arguments.inner_distance().is_some()) {
        return Err(Failure::new(
            "a certificate is about one pair of files, without --inner-distance",
        ));
    }
    let mut clock = Seconds::begin();
    let mut notes = Notes::default();
    let (scene, motion) = during(progress::stage("reading"), |_| arguments.read(&mut notes))?;
    let problem = arguments.problem(&scene, motion);
    let mut detector = problem.detector();
    clock.end("read");

    let mut found = arguments.find(&problem, &mut detector, &mut clock)?;
    let distances = Distances::new(mesh.min_distance, arguments.inner_distance());
    let mut report = Report::new(ReportForm::Step, &scene, notes, distances).with_frames(2);
    report.examined = 2;
    arguments.tell(&problem, &found, &mut report)?;
    if mesh.has_files() {
        let contacts = match found.answer.contacts.take() {
            Some(contacts) => contacts,
            None => during(progress::stage("listing all contacts"), |_| {
                let Motion { x0, x1, .. } = &problem.motion;
                detector.collisions(x0, x1, problem.options())
            })?,
        };
        clock.end("list");
        let list = found.list(&problem, &contacts);
        report.counts.violations = mesh.all.as_ref().map(|_| Violations::from(&list));
        arguments.write(&problem, &found.start, &contacts, &list, &report)?;
        clock.end("write");
    }
    if certificate.is_wanted() {
        let Motion { x0, x1, .. } = &problem.motion;
        let earliest = if found.answer.touches && found.answer.earliest.is_none() {
            detector.collision(x0, x1, problem.options())?
        } else {
            found.answer.earliest
        };
        let starts_apart = (!arguments.no_start_check).then_some(found.start.is_empty());
        certificate.add_step(&problem.motion, earliest.as_ref(), starts_apart)?;
        clock.end("certificate");
    }
    report.seconds = Some(clock);
    let status = mesh.finish(report)?;
    Ok(certificate.finish()?.unwrap_or(status))
}

impl Arguments {
    /// The distance of pairs that start within the minimum distance, if it is a smaller one.
    fn inner_distance(&self) -> Option<Separation> {
        let is_smaller = |inner: &Separation| *inner < self.mesh.min_distance;
        self.inner_distance.filter(is_smaller)
    }

    fn read(&self, notes: &mut Notes) -> Result<(Assembly, Motion), Failure> {
        if self.write_f32 {
            return written::read(&self.files, &self.mesh.scene, notes);
        }
        let mut scene = Assembly::of_pairs(&self.files, &self.mesh.scene, notes)?;
        let (start, end) = (scene.read(0)?, scene.read(1)?);
        let motion = Motion::new(start, end).map_err(|error| scene.mismatch(1, error))?;
        Ok((scene, motion))
    }

    fn problem<'a>(&self, scene: &'a Assembly, motion: Motion) -> Problem<'a> {
        let (min_distance, inner_distance) = (self.mesh.min_distance, self.inner_distance());
        let half_spaces = &self.mesh.half_spaces;
        Problem {
            can_collide: scene.can_collide(),
            distance: kept(min_distance, inner_distance),
            half_spaces: half_spaces.around(scene.moving_vertices(), min_distance, inner_distance),
            broad_phase: Arc::default(),
            scene,
            motion,
        }
    }

    /// All answers. The answer about the mesh is computed as often as `--repeat` says.
    fn find(
        &self,
        problem: &Problem<'_>,
        detector: &mut Detector,
        clock: &mut Seconds,
    ) -> Result<Found, Failure> {
        let start = self.start(problem)?;
        clock.end("start");
        let (in_half_spaces, half_spaces) = problem.half_spaces.in_step(&problem.motion);
        let in_file = |record: ContactRecord| problem.scene.in_file(record);
        let in_half_spaces = in_half_spaces.into_iter().map(in_file).collect();
        let half_spaces = self.mesh.half_spaces.is_given().then_some(half_spaces);
        if half_spaces.is_some() {
            clock.end("half_spaces");
        }
        let mut runs = Vec::new();
        for _ in 0..self.repeat {
            let answer = self.answer(problem, detector)?;
            runs.push((clock.lap(), problem.broad_phase.take_time_in_sinks(), answer));
        }
        runs.sort_by_key(|(duration, ..)| *duration);
        let (search, narrow, answer) = runs.swap_remove(runs.len() / 2);
        clock.add("broad", search.saturating_sub(narrow));
        clock.add("narrow", narrow.min(search));
        Ok(Found {
            start,
            in_half_spaces,
            half_spaces,
            answer,
        })
    }

    /// Adds the contacts and counts to the report.
    fn tell(&self, problem: &Problem<'_>, found: &Found, report: &mut Report) -> Result<(), Failure> {
        let scene = problem.scene;
        let at_start = found.start.first().map(|&found| problem.record_of_start(found));
        // Of contacts at the same time, contacts within the mesh are first.
        let answer = &found.answer;
        let earliest = answer.earliest.as_ref().map(|contact| problem.record(contact));
        let earliest = earliest.into_iter().chain(found.in_half_spaces.first().cloned());
        let earliest = earliest.min_by(ContactRecord::compare_times);
        let touches = |record: &&ContactRecord| !self.any && record.toi() == 0.0;
        if let Some(first) = at_start.as_ref().or(earliest.as_ref().filter(touches)) {
            let Motion { x0, x1, .. } = &problem.motion;
            scene.note_split_vertices(first, &[x0, x1], &mut report.notes);
        }
        let Motion { x0, x1, .. } = &problem.motion;
        if at_start.is_none() {
            scene.note_nesting(x0, &mut report.notes)?;
        }
        if let Some(contact) = &answer.earliest {
            let record = problem.record(contact);
            let note = note_of_rounding(&problem.motion.mesh, [x0, x1], contact, &record);
            note.into_iter().for_each(|note| report.notes.note(note));
        }
        let mut turns = Turns::of(scene);
        turns.add(scene, &turns.in_step(scene, 0, [x0, x1]));
        turns.note(scene, &mut report.notes);
        if let Some(record) = &at_start {
            report.add(scene, 1, record);
        }
        match earliest {
            Some(record) if !self.any => report.add(scene, 1, &record),
            None if !answer.touches => {}
            _ => report.touch(),
        }
        report.counts = Counts {
            intersections: (!self.no_start_check).then_some(found.start.len()),
            pairs: answer.pairs,
            half_spaces: found.half_spaces,
            violations: None,
        };
        Ok(())
    }

    /// The intersections at the start, unless they are not searched for.
    fn start(&self, problem: &Problem<'_>) -> Result<Vec<Intersection>, Failure> {
        if self.no_start_check {
            return Ok(Vec::new());
        }
        let Motion { mesh, x0, .. } = &problem.motion;
        let stage = progress::stage("examining the start");
        let options = IntersectionOptions::default().with_meeting(Meeting::Crossing);
        let options = options.with_can_collide(problem.can_collide.clone());
        let found = during(stage, |_| intersections(mesh, x0, &Bvh, &options));
        Ok(found.map_err(StepError::from)?)
    }

    fn answer(&self, problem: &Problem<'_>, detector: &mut Detector) -> Result<Answer, Failure> {
        let Motion { x0, x1, .. } = &problem.motion;
        let stage = progress::stage("searching for contact");
        let mut answer = Answer::default();
        if self.any {
            answer.touches = during(stage, |_| detector.collides(x0, x1, problem.options()))?;
        } else if self.toi {
            answer.earliest = during(stage, |_| detector.collision(x0, x1, problem.options()))?;
        } else {
            let options = CandidateOptions::default()
                .with_min_distance(problem.distance.clone())
                .with_can_collide(problem.can_collide.clone());
            let report = during(progress::count("pairs"), |progress| {
                let (step, broad_phase) = (problem.motion.step()?, &*problem.broad_phase);
                if self.mesh.has_files() {
                    let found = StepReport::with_contacts(step, broad_phase, &options, progress)?;
                    answer.contacts = Some(found.1);
                    return Ok(found.0);
                }
                StepReport::with_options(step, broad_phase, &options, progress).map_err(Failure::from)
            })?;
            answer.pairs = Some(Pairs::from(&report));
            answer.earliest = report.earliest;
        }
        Ok(answer)
    }
}
