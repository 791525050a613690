//! `exact-ccd repair`: positions of a mesh in which it does not intersect.

mod mesh_output;
mod report;

use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;
use std::time::{Duration, Instant};

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
use mesh_output::MeshOutput;
use report::Report;

/// Move the vertices of a mesh that intersects itself until it does not, and decide exactly that it does not
///
/// Vertices, edges and faces that are examined stay, in their order. The output is a mesh in which no
/// edge passes through a face and no pair touches; with --min-distance D, in which no
/// pair is within D. This is decided exactly, for the coordinates as they are in the
/// output file.
///
/// The parts of --with are obstacles: they do not move. They may intersect each other
/// and themselves. --pin names further parts or groups that do not move.
///
/// Not every mesh can be repaired. A closed surface with one side, as a Klein bottle,
/// is refused at once; otherwise, the program ends after --max-rounds.
///
/// Exit status: 0 free now, 1 not repaired, and no mesh is written without --partial,
/// 2 error, 3 the mesh is written, but some pairs have no certificate.
#[derive(clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The mesh. docs/files.md lists the formats.
    #[arg(value_name = "MESH")]
    mesh: PathBuf,
    #[command(flatten)]
    scene: AssemblyOptions,
    /// The file of the mesh with its new positions, PLY or OBJ. An OBJ file of an OBJ file is the same
    /// text with other coordinates; other files have vertices, triangles and loose edges.
    #[arg(long, short, value_name = "FILE")]
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
    /// Write the last positions of a mesh that is not repaired. They may intersect.
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
    let output = arguments.check_places()?;
    let mut clock = Seconds::begin();
    let mut notes = Notes::default();
    let mut scene = arguments.open(&mut notes)?;
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
    let mut report = Report::new(&scene, notes, Distances::new(distance, None));
    report.add(&scene, &mesh, &positions, limit, &outcome);
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
    fn check_places(&self) -> Result<MeshOutput<'_>, Failure> {
        let inputs = self.scene.inputs(std::slice::from_ref(&self.mesh));
        // Without the name of its part.
        let input = inputs.first().unwrap_or(&self.mesh).clone();
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

    /// The scene of the mesh and the obstacles.
    fn open(&self, notes: &mut Notes) -> Result<Assembly, Failure> {
        let files = std::slice::from_ref(&self.mesh);
        let scene = Assembly::of_sequence(files, false, &self.scene, notes)?;
        match scene.frame_count() {
            1 => Ok(scene),
            count => Err(Failure::of(
                &self.mesh,
                format_args!("{count} frames, expected one: `repair` changes one mesh, not a motion"),
            )),
        }
    }

    /// Repairs the mesh, with the number of rounds as progress.
    fn repair(
        &self,
        mesh: &Arc<TriangleMesh>,
        positions: &[Point],
        pinned: Vec<u32>,
        scene: &Assembly,
    ) -> Result<Outcome, Failure> {
        let budget = self.max_seconds.map(Duration::try_from_secs_f64).transpose();
        let budget = budget.map_err(|error| Failure::new(format_args!("--max-seconds: {error}")))?;
        let began = Instant::now();
        let repair = if self.f32 { repair_in_f32 } else { repair };
        let outcome = during(progress::count("rounds"), |progress| {
            let stop = |_: Progress| {
                progress(1);
                budget.is_some_and(|budget| began.elapsed() >= budget)
            };
            let options = RepairOptions::default()
                .with_min_distance(self.min_distance)
                .with_pinned(pinned)
                .with_can_collide(scene.can_collide())
                .with_max_rounds(self.max_rounds)
                .with_stop(&stop);
            repair(mesh, positions, &options)
        });
        outcome.map_err(|error| Failure::of(&self.mesh, error))
    }

    /// Writes the page of the mesh before and after, with the edges that pass through faces.
    fn write_page(
        &self,
        scene: &Assembly,
        mesh: &TriangleMesh,
        ends: [&[Point]; 2],
        report: &Report,
    ) -> Result<(), Failure> {
        if self.view.file().is_none() {
            return Ok(());
        }
        let files = std::slice::from_ref(&self.mesh);
        let mut page = self.view.recording(files, scene, &[]);
        let options = IntersectionOptions::default().with_meeting(Meeting::Crossing);
        let options = options.with_can_collide(scene.can_collide());
        page.begin(mesh, || ends.into_iter().flatten().copied().collect());
        for (label, x) in ["before", "after"].into_iter().zip(ends) {
            page.add(label, x)?;
            for crossing in intersections(mesh, x, &Bvh, &options)? {
                page.intersection(crossing)?;
            }
        }
        page.finish(&report.verdict(), &report.to_string())
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
