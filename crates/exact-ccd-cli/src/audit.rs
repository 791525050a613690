//! `exact-ccd audit`: the contacts of a mesh in a sequence of frames.

mod every;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use exact_ccd::Point;
use exact_ccd_mesh::{Audit, Frame, MotionError, Step, Violation};

use crate::contacts::{ContactList, ContactRecord};
use crate::distances::{Distances, kept};
use crate::failure::Failure;
use crate::mesh_arguments::MeshArguments;
use crate::notes::Notes;
use crate::progress::{self, during};
use crate::report::{Report, Violations};
use crate::scene::{Scene, note_split_vertices};
use crate::seconds::Seconds;
use crate::{impact_files, view};
use every::EveryViolation;

/// Certify that a mesh never touches itself in a sequence of frames.
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
/// Of a run of `exact-ccd simulate --output DIR --path`, DIR/path is the motion that is free of
/// contact. On the straight line from one time step to the next, as in DIR/frames, parts that turn
/// around each other may touch.
///
/// All ids count from 0. Exit status: 0 free, 1 violation, 2 error.
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// Meshes with the same faces: mesh files, folders of files of one format, lists of files (.pvd,
    /// .series), or files of several frames (.npz). Files whose names differ in one number are taken in
    /// the order of these numbers, others as they are given. docs/files.md lists the formats.
    #[arg(required = true)]
    frames: Vec<PathBuf>,
    /// Keep the order of the files on the command line, whatever their numbers.
    #[arg(long)]
    as_given: bool,
    #[command(flatten)]
    mesh: MeshArguments,
}

/// The search for the first violation, or for all.
enum Examination {
    First(Box<Audit>),
    Every(Box<EveryViolation>),
}

impl Examination {
    fn examine(&mut self, frame: Frame) -> Result<Vec<Violation>, MotionError> {
        match self {
            Self::First(audit) => Ok(audit.examine(frame)?.into_iter().collect()),
            Self::Every(every) => every.examine(frame),
        }
    }

    fn last(&self) -> Option<&Frame> {
        match self {
            Self::First(audit) => audit.last(),
            Self::Every(every) => every.last(),
        }
    }
}

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let Arguments {
        mesh,
        frames,
        as_given,
    } = arguments;
    mesh.check_places()?;
    let mut certificate = mesh.certificate.begin(frames, mesh.min_distance)?;
    if certificate.is_wanted() && mesh.all.is_some() {
        return Err(Failure::new(
            "a certificate ends with the first violation: leave out --all",
        ));
    }
    let mut clock = Seconds::begin();
    let mut notes = Notes::default();
    let mut scene = Scene::of_sequence(frames, *as_given, &mesh.scene, &mut notes)?;
    mesh.check(&scene)?;
    let mut report = Report::new("audit", &scene, notes, Distances::new(mesh.min_distance, None));
    let mut examination = arguments.examination(&scene);
    let vertices = scene.moving_vertices();
    let half_spaces = mesh.half_spaces.around(vertices, mesh.min_distance, None);
    let mut page = mesh.view.recording(frames, &scene, half_spaces.all());
    let mut list = ContactList::default();
    // Without files, nothing is written.
    let writing = if mesh.has_files() { "write" } else { "examine" };
    let count = scene.frame_count();
    during(progress::bar(count, "frames"), |progress| {
        let mut next = None;
        for index in 0..count {
            let frame = next.take().unwrap_or_else(|| scene.read(index))?;
            clock.end("read");
            page.begin(&frame.mesh, || frame.bounds());
            let file = scene.frame_name(index);
            page.add(&view::name(Path::new(&file)), &frame.positions)?;
            clock.end(writing);
            let before = examination.last().map(|last| last.positions.clone());
            // The next frame is read meanwhile. The time of reading is what remains after the examination.
            let examine = || {
                let violations = examination.examine(frame);
                clock.end("examine");
                violations
            };
            let read = || (index + 1 < count).then(|| scene.read(index + 1));
            let (violations, following) = rayon::join(examine, read);
            clock.end("read");
            next = following;
            let violations = violations.map_err(|error| scene.mismatch(index, error))?;
            report.examined = index + 1;
            let Some(last) = examination.last() else {
                continue;
            };
            certificate.add_frame(before.as_deref(), last, &violations)?;
            let start = before.as_ref().unwrap_or(&last.positions);
            let found = violations.iter().map(|violation| record(start, last, violation));
            let mut records: Vec<_> = found.collect();
            if let Some(first) = records.first().filter(|_| index == 0) {
                note_split_vertices(first, &[&last.positions], &mesh.scene, &mut report.notes);
            }
            records.extend(half_spaces.touching(index, last));
            let in_file = |record: ContactRecord| record.in_file(scene.ids());
            let mut records: Vec<_> = records.into_iter().map(in_file).collect();
            clock.end("examine");
            for violation in &violations {
                match violation {
                    Violation::Intersection { intersection, .. } => page.intersection(*intersection),
                    Violation::Contact { contact, .. } => page.contact(contact),
                }?;
            }
            for (vertex, number) in records.iter().filter_map(ContactRecord::in_half_space) {
                page.half_space_contact(vertex, number, None)?;
            }
            if report.collision_free && !records.is_empty() {
                arguments.write_impact(&scene, index, [start, &last.positions], &records)?;
            }
            records
                .iter()
                .for_each(|record| report.add(&scene, index, record));
            list.0.append(&mut records);
            clock.end(writing);
            if !report.collision_free && mesh.all.is_none() {
                break;
            }
            progress(1);
        }
        Ok::<_, Failure>(())
    })?;
    if let Some(file) = &mesh.all {
        report.counts.violations = Some(Violations::from(&list));
        list.write(file)?;
    }
    if let Some(last) = examination.last().filter(|_| report.collision_free) {
        arguments.write_impact(&scene, count, [&last.positions; 2], &[])?;
    }
    page.finish(&report.verdict(), &report.to_string())?;
    clock.end(writing);
    report.seconds = Some(clock);
    let status = mesh.finish(report)?;
    Ok(certificate.finish()?.unwrap_or(status))
}

/// The record of a violation, found in the frame `last` or in the step to it from these positions.
fn record(start: &[Point], last: &Frame, violation: &Violation) -> ContactRecord {
    let (mesh, positions) = (&last.mesh, &last.positions[..]);
    match violation {
        Violation::Intersection { frame, intersection } => {
            ContactRecord::of_intersection(*frame, mesh, positions, *intersection)
        }
        Violation::Contact { frame, contact } => {
            ContactRecord::of_contact(*frame, mesh, [start, positions], contact)
        }
    }
}

impl Arguments {
    /// Writes the files for ParaView: the first violation of the step that leads to a frame, and all others
    /// of that step, without those at rest in the frame after it.
    fn write_impact(
        &self,
        scene: &Scene,
        index: usize,
        [start, end]: [&[Point]; 2],
        records: &[ContactRecord],
    ) -> Result<(), Failure> {
        let Some(folder) = &self.mesh.paraview else {
            return Ok(());
        };
        let frame = records.first().map_or(index, |first| first.frame);
        let start = if frame == index { end } else { start };
        let of_step = records.iter().filter(|record| record.frame == frame);
        let list = ContactList(of_step.cloned().collect());
        impact_files::write(folder, Step::new(scene.mesh(), start, end)?, scene.ids(), &list)
    }

    fn examination(&self, scene: &Scene) -> Examination {
        let min_distance = kept(self.mesh.min_distance, None);
        if self.mesh.all.is_some() {
            let is_only_frame = scene.frame_count() == 1;
            let every = EveryViolation::new(min_distance, scene.can_collide(), is_only_frame);
            Examination::Every(Box::new(every))
        } else {
            let audit = Audit::with_min_distance(min_distance);
            Examination::First(Box::new(audit.with_can_collide(scene.can_collide())))
        }
    }
}
