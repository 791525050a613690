//! `exact-ccd repair`: positions of a mesh in which it does not intersect.

mod budget;
mod figures;
mod mesh_answer;
mod mesh_output;
mod recording;
mod recording_answer;
mod remaining;
mod report;

use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;

use exact_ccd::Separation;
use exact_ccd_mesh::{Bvh, Frame, IntersectionOptions, Meeting, Point, TriangleMesh, intersections};
use exact_ccd_repair::{Outcome, Progress, RepairOptions, repair, repair_in_f32};

use crate::assembly::{Assembly, AssemblyOptions};
use crate::files::outputs::{check_distinct, check_is_no_input, check_place, print};
use crate::messages::failure::Failure;
use crate::messages::notes::Notes;
use crate::messages::progress::{self, during};
use crate::options::certificate::{Certificate, CertificateOption};
use crate::options::distances::{self, Distances};
use crate::text::seconds::Seconds;
use crate::view::View;
use budget::Budget;
use mesh_answer::MeshAnswer;
use mesh_output::MeshOutput;
use report::Report;

/// Move the vertices of a mesh that intersects itself until it does not, and decide exactly that it does not
///
/// Vertices, edges and faces that are examined stay, in their order. The output is
/// a mesh in which no edge passes through a face and no pair touches; with
/// --min-distance D, in which no pair is within D. This is decided exactly, for
/// the coordinates as they are in the output file.
///
/// The parts of --with are obstacles: they do not move. They may intersect each
/// other and themselves. --pin names further parts or groups that do not move.
///
/// Of several frames, as of `exact-ccd audit`, the output is a folder with a file
/// for each, of the name of its source. The straight motion from each frame to the
/// next is certified to be free, too.
///
/// Not every mesh can be repaired. A closed surface with one side, as a Klein
/// bottle, is refused at once; otherwise, the program ends after --max-rounds.
///
/// Exit status: 0 free now, 1 not repaired, and no mesh is written without
/// --partial, 2 error, 3 the mesh is written, but some pairs have no certificate.
#[derive(clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The mesh; or the frames of a recording: mesh files, folders of files of one format, lists of files
    /// (.pvd, .series), or files of several frames (.npz). docs/files.md lists the formats.
    #[arg(value_name = "MESH", required = true)]
    frames: Vec<PathBuf>,
    /// Keep the order of the files on the command line, whatever their numbers.
    #[arg(long)]
    as_given: bool,
    #[command(flatten)]
    scene: AssemblyOptions,
    /// The file of the mesh with its new positions, PLY or OBJ. An OBJ file of an OBJ file is the same
    /// text with other coordinates; other files have vertices, triangles and loose edges. Of a recording,
    /// a folder.
    #[arg(long, short, value_name = "PATH")]
    output: PathBuf,
    /// Reach this distance between all pairs, in the unit of the coordinates.
    #[arg(long, value_name = "D", default_value = "0", value_parser = distances::parse, allow_hyphen_values = true)]
    min_distance: Separation,
    /// The vertices of this part or group do not move; may be repeated.
    #[arg(long, value_name = "NAME")]
    pin: Vec<String>,
    /// Make the coordinates of all vertices that move numbers in single precision, and decide about these.
    #[arg(long)]
    f32: bool,
    /// Accept no larger displacement of a vertex: beyond it, the mesh counts as not repaired.
    #[arg(long, value_name = "D", value_parser = distances::parse, allow_hyphen_values = true)]
    max_displacement: Option<Separation>,
    /// Give up after this number of rounds of a phase.
    #[arg(long, value_name = "N", default_value_t = RepairOptions::default().max_rounds)]
    max_rounds: usize,
    /// End after this time, with the state that was reached. The result depends on the speed of the machine.
    #[arg(long, value_name = "SECONDS", allow_hyphen_values = true)]
    max_seconds: Option<f64>,
    /// Write the last positions of a mesh that is not repaired. They may intersect. Of a recording, write
    /// the repaired frames, which are free.
    #[arg(long)]
    partial: bool,
    #[command(flatten)]
    certificate: CertificateOption,
    #[command(flatten)]
    view: View,
    /// Print the report as a JSON object. docs/reports.md has its schema.
    #[arg(long)]
    json: bool,
    /// Leave the durations out.
    #[arg(long)]
    no_seconds: bool,
}

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let mut clock = Seconds::begin();
    let mut notes = Notes::default();
    let mut scene = Assembly::of_sequence(
        &arguments.frames,
        arguments.as_given,
        &arguments.scene,
        &mut notes,
    )?;
    if scene.frame_count() > 1 {
        return arguments.run_recording(scene, notes, clock);
    }
    let output = arguments.check_places(&scene)?;
    let distance = arguments.min_distance;
    let certificate = arguments
        .certificate
        .begin([arguments.output.clone()], distance)?;
    let pinned = scene.resting_vertices(&arguments.pin)?;
    let Frame { mesh, positions } = scene.read(0)?;
    let mesh = Arc::new(mesh);
    clock.end("read");

    let outcome = arguments.repair(&mesh, &positions, pinned, &scene)?;
    clock.end("repair");
    let limit = arguments.max_displacement.map(Separation::get);
    let answer = MeshAnswer::new(&scene, &mesh, &positions, limit, &outcome);
    let distances = Distances::new(distance, None);
    let mut report = Report::new(&scene, notes, distances, answer.is_repaired(), answer);
    let after = positions_of(&outcome);
    if report.repaired {
        scene.note_nesting(after, &mut report.notes)?;
    }
    if report.repaired || arguments.partial {
        output.write(&scene, &mesh, after, &mut report.notes)?;
        report.output = Some(arguments.output.display().to_string());
    }
    clock.end("write");
    report.seconds = (!arguments.no_seconds).then_some(clock);
    arguments.write_page(&scene, &mesh, [&positions, after], &report)?;
    print(&report.text(arguments.json))?;
    if report.repaired {
        certify(certificate, &mesh, after)
    } else {
        Ok(ExitCode::from(1))
    }
}

impl Arguments {
    /// Checks the places of the files before anything is computed.
    fn check_places(&self, scene: &Assembly) -> Result<MeshOutput<'_>, Failure> {
        let input = scene.frame_file(0).to_owned();
        let mut inputs = self.scene.inputs(&self.frames);
        inputs.push(input.clone());
        let output = MeshOutput::new(input, &self.output)?;
        let others = self.view.file().into_iter().chain(self.certificate.file());
        let mut files = vec![self.output.clone()];
        files.extend(others.map(PathBuf::from));
        for file in &files {
            check_place(file)?;
            check_is_no_input(file, &inputs)?;
        }
        check_distinct(&files)?;
        Ok(output)
    }

    /// Repairs the mesh, with the number of rounds as progress.
    fn repair(
        &self,
        mesh: &Arc<TriangleMesh>,
        positions: &[Point],
        pinned: Vec<u32>,
        scene: &Assembly,
    ) -> Result<Outcome, Failure> {
        let budget = self.budget()?;
        let repair = if self.f32 { repair_in_f32 } else { repair };
        let outcome = during(progress::count("rounds"), |progress| {
            let stop = |_: Progress| {
                progress(1);
                budget.stops()
            };
            repair(mesh, positions, &self.options(pinned, scene, &stop))
        });
        outcome.map_err(|error| Failure::of(&self.frames[0], error))
    }

    /// The options of the library. The vertices of obstacles are among the pinned ones.
    fn options<'a>(
        &self,
        pinned: Vec<u32>,
        scene: &Assembly,
        stop: &'a (dyn Fn(Progress) -> bool + Sync),
    ) -> RepairOptions<'a> {
        RepairOptions::default()
            .with_min_distance(self.min_distance)
            .with_pinned(pinned)
            .with_can_collide(scene.can_collide())
            .with_max_rounds(self.max_rounds)
            .with_stop(stop)
    }

    /// The time of the option `--max-seconds`, from now on.
    fn budget(&self) -> Result<Budget, Failure> {
        Budget::begin(self.max_seconds)
    }

    /// Writes the page of the mesh before and after, with the edges that pass through faces.
    fn write_page(
        &self,
        scene: &Assembly,
        mesh: &TriangleMesh,
        ends: [&[Point]; 2],
        report: &Report<MeshAnswer>,
    ) -> Result<(), Failure> {
        if self.view.file().is_none() {
            return Ok(());
        }
        let mut page = self.view.recording(&self.frames, scene, &[]);
        let options = IntersectionOptions::default().with_meeting(Meeting::Crossing);
        let options = options.with_can_collide(scene.can_collide());
        page.begin(mesh, || ends.into_iter().flatten().copied().collect());
        for (label, x) in ["before", "after"].into_iter().zip(ends) {
            page.add(label, x)?;
            for crossing in intersections(mesh, x, &Bvh, &options)? {
                page.intersection(crossing)?;
            }
        }
        page.finish(&report.answer.verdict(), &report.to_string())
    }
}

/// The last positions of a repair.
fn positions_of(outcome: &Outcome) -> &[Point] {
    match outcome {
        Outcome::Repaired(repaired) => &repaired.positions,
        Outcome::Unrepaired(unrepaired) => &unrepaired.positions,
    }
}

/// Writes the certificate that the mesh at rest is free, and returns the exit status.
fn certify(
    mut certificate: Certificate<'_>,
    mesh: &TriangleMesh,
    positions: &[Point],
) -> Result<ExitCode, Failure> {
    certificate.add_rest(mesh, positions)?;
    Ok(certificate.finish()?.unwrap_or(ExitCode::SUCCESS))
}
