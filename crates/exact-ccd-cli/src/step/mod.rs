//! `exact-ccd step`: is the step from one mesh to another free of contact?

mod report;
mod seconds;
mod text;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::value_parser;
use exact_ccd::{Options, Separation};
use exact_ccd_files::FileIds;
use exact_ccd_mesh::{
    Bvh, CanCollide, CandidateOptions, Contact, Detector, Intersection, IntersectionOptions, Meeting,
    MinDistance, Motion, StepError, StepReport, intersections,
};

use crate::contacts::{ContactList, ContactRecord, ListFile};
use crate::distances::{Distances, kept};
use crate::failure::Failure;
use crate::half_spaces::{HalfSpaceCounts, HalfSpaceOption, HalfSpaces};
use crate::impact_files;
use crate::min_distance;
use crate::notes::Notes;
use crate::output::{check_folder_place, check_place, print};
use crate::progress::{self, during};
use crate::scene::{Scene, SceneOptions, note_split_vertices};
use crate::timed::Timed;
use crate::view::{ShownStep, View};
use report::{Answer, Output, Report, Start};
use seconds::{Laps, Phases};

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
/// With --half-space, a vertex is in contact with a half space when it is in it, or at most D outside.
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
    #[command(flatten)]
    half_spaces: HalfSpaceOption,
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
    arguments.check_outputs()?;
    let (mut clock, mut phases) = (Laps::begin(), Phases::default());
    let mut notes = Notes::default();
    let (scene, motion) = during(progress::stage("reading"), |_| arguments.read(&mut notes))?;
    let Arguments {
        min_distance,
        inner_distance,
        ..
    } = *arguments;
    let problem = Problem {
        can_collide: scene.can_collide(),
        distance: kept(min_distance, inner_distance),
        half_spaces: arguments
            .half_spaces
            .around(scene.moving_vertices(), min_distance, inner_distance),
        broad_phase: Timed::new(Bvh),
        ids: scene.ids().clone(),
        motion,
    };
    let mut detector = problem.detector();
    phases.read = clock.lap();

    let start = arguments.start(&problem)?;
    phases.start = clock.lap();

    let in_half_spaces = problem.in_half_spaces();
    phases.half_spaces = in_half_spaces.as_ref().map(|_| clock.lap());
    let (in_half_spaces, half_space_counts) = in_half_spaces.unzip();
    let in_half_spaces = in_half_spaces.unwrap_or_default();

    let mut runs = Vec::new();
    for _ in 0..arguments.repeat {
        let answer = arguments.answer(&problem, &in_half_spaces, &mut detector)?;
        runs.push((clock.lap(), problem.broad_phase.take_time_in_sinks(), answer));
    }
    runs.sort_by_key(|(duration, ..)| *duration);
    let (search, narrow, answer) = runs.swap_remove(runs.len() / 2);
    (phases.search, phases.narrow) = (search, narrow);

    let checked = (!arguments.no_start_check).then(|| Start::new(&problem.motion, &problem.ids, &start));
    let crossing = checked.as_ref().and_then(|start| start.first.as_ref());
    if let Some(first) = crossing.or(answer.contact().filter(|contact| contact.toi() == 0.0)) {
        let Motion { x0, x1, .. } = &problem.motion;
        note_split_vertices(first, &[x0, x1], &arguments.scene, &mut notes);
    }
    let mut output = Output {
        summary: scene.summary(),
        notes,
        distances: Distances::new(min_distance, inner_distance),
        collision_free: answer.is_free() && start.is_empty(),
        start: checked,
        answer,
        half_spaces: half_space_counts,
        seconds: phases.into(),
    };
    if arguments.has_files() {
        let contacts = during(progress::stage("listing all contacts"), |_| {
            let Motion { x0, x1, .. } = &problem.motion;
            detector.collisions(x0, x1, problem.options())
        })?;
        phases.list = Some(clock.lap());
        arguments.write((&scene, &problem), &start, &contacts, in_half_spaces, &output)?;
        phases.write = Some(clock.lap());
        output.seconds = phases.into();
    }
    print(&if arguments.json {
        output.to_json()
    } else {
        output.to_string()
    })?;
    Ok(ExitCode::from(u8::from(!output.collision_free)))
}

/// A motion, the ids of its vertices and faces, and the meaning of contact in it.
struct Problem {
    motion: Motion,
    ids: FileIds,
    can_collide: CanCollide,
    distance: MinDistance,
    half_spaces: HalfSpaces,
    broad_phase: Timed<Bvh>,
}

impl Problem {
    fn detector(&self) -> Detector<&Timed<Bvh>> {
        let detector = Detector::with_broad_phase(self.motion.mesh.clone(), &self.broad_phase);
        detector.with_can_collide(self.can_collide.clone())
    }

    fn options(&self) -> Options<MinDistance> {
        Options::within(self.distance.clone())
    }

    /// The contacts with half spaces, if there are half spaces, and their numbers.
    fn in_half_spaces(&self) -> Option<(Vec<ContactRecord>, HalfSpaceCounts)> {
        if self.half_spaces.is_empty() {
            return None;
        }
        let (records, counts) = self.half_spaces.in_step(&self.motion);
        let records = records.into_iter().map(|record| record.in_file(&self.ids));
        Some((records.collect(), counts))
    }

    fn record(&self, contact: &Contact) -> ContactRecord {
        let Motion { mesh, x0, x1 } = &self.motion;
        ContactRecord::of_contact(mesh, [x0, x1], contact).in_file(&self.ids)
    }
}

impl Arguments {
    fn read(&self, notes: &mut Notes) -> Result<(Scene, Motion), Failure> {
        let mut scene = Scene::of_pairs(&self.files, &self.scene, notes)?;
        scene.check_contents(self.min_distance != Separation::default() || self.half_spaces.is_given())?;
        let (start, end) = (scene.read(0)?, scene.read(1)?);
        let motion = Motion::new(start, end).map_err(|error| scene.mismatch(1, error))?;
        Ok((scene, motion))
    }

    /// Returns true if all contacts are written to files.
    fn has_files(&self) -> bool {
        self.all.is_some() || self.out.is_some() || self.view.file().is_some()
    }

    /// Checks the places of the files before anything is computed.
    fn check_outputs(&self) -> Result<(), Failure> {
        let list = self.all.iter().map(ListFile::path);
        list.chain(self.view.file()).try_for_each(check_place)?;
        self.out.as_deref().map_or(Ok(()), check_folder_place)
    }

    /// The intersections at the start, unless they are not searched for.
    fn start(&self, problem: &Problem) -> Result<Vec<Intersection>, Failure> {
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

    /// The answer, from the contacts of the mesh and those with half spaces, the earliest first.
    fn answer(
        &self,
        problem: &Problem,
        in_half_spaces: &[ContactRecord],
        detector: &mut Detector<&Timed<Bvh>>,
    ) -> Result<Answer, Failure> {
        let Motion { x0, x1, .. } = &problem.motion;
        let stage = progress::stage("searching for contact");
        let (earliest, report) = if self.any {
            let collides = during(stage, |_| detector.collides(x0, x1, problem.options()))?;
            let is_free = !collides && in_half_spaces.is_empty();
            return Ok(Answer::Free { is_free });
        } else if self.toi {
            (
                during(stage, |_| detector.collision(x0, x1, problem.options()))?,
                None,
            )
        } else {
            let options = CandidateOptions::default()
                .with_min_distance(problem.distance.clone())
                .with_can_collide(problem.can_collide.clone());
            let report = during(progress::count("pairs"), |progress| {
                let step = problem.motion.step()?;
                let report = StepReport::with_options(step, &problem.broad_phase, &options, progress);
                report.map_err(Failure::from)
            })?;
            (report.earliest, Some(report))
        };
        let record = earliest.map(|contact| problem.record(&contact));
        // Of contacts at the same time, those of the mesh are first.
        let first = record.into_iter().chain(in_half_spaces.first().cloned());
        let first = first.min_by(ContactRecord::compare_times);
        Ok(Answer::Report(Box::new(Report::new(first, report.as_ref()))))
    }

    /// Writes the files that have all contacts.
    fn write(
        &self,
        (scene, problem): (&Scene, &Problem),
        start: &[Intersection],
        contacts: &[Contact],
        in_half_spaces: Vec<ContactRecord>,
        output: &Output,
    ) -> Result<(), Failure> {
        let Problem { motion, ids, .. } = problem;
        let of_start = |&found: &Intersection| {
            ContactRecord::of_intersection(&motion.mesh, &motion.x0, found).in_file(ids)
        };
        let at_start = start.iter().map(of_start);
        let in_step = contacts.iter().map(|contact| problem.record(contact));
        let mut records: Vec<_> = at_start.chain(in_step).chain(in_half_spaces).collect();
        records.sort_by(ContactRecord::compare_times);
        let list = ContactList(records);
        if let Some(file) = &self.all {
            list.write(file)?;
        }
        if let Some(folder) = &self.out {
            impact_files::write(folder, motion.step()?, ids, &list)?;
        }
        let shown = ShownStep {
            motion,
            start,
            contacts,
            half_spaces: problem.half_spaces.all(),
            in_half_spaces: &list
                .0
                .iter()
                .filter(|record| record.in_half_space().is_some())
                .collect::<Vec<_>>(),
        };
        let (verdict, answer) = (output.verdict(), output.to_string());
        self.view.step(&self.files, scene, &shown, (&verdict, &answer))
    }
}
