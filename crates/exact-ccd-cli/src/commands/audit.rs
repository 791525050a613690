//! `exact-ccd audit`: the contacts of a mesh in a sequence of frames.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use exact_ccd::Point;
use exact_ccd_mesh::{Audit, Frame, Step, Violation};

use crate::assembly::{Assembly, Turns};
use crate::contacts::{ContactList, ContactRecord};
use crate::files::inputs::name;
use crate::messages::failure::Failure;
use crate::messages::notes::Notes;
use crate::messages::progress::{self, during};
use crate::motion::arguments::MeshArguments;
use crate::motion::counts::Violations;
use crate::motion::half_spaces::HalfSpaces;
use crate::motion::paraview;
use crate::motion::report::{Report, ReportForm};
use crate::options::certificate::Certificate;
use crate::options::distances::Distances;
use crate::text::seconds::Seconds;
use crate::view::Recording;

/// Certify that a mesh never touches itself in a sequence of frames.
///
/// The first frame is examined at rest: no edge may meet a face, no vertex a face, and no edge
/// another edge. From each frame to the next, every vertex moves in a straight line, and no contact
/// may occur, as in `exact-ccd step`. If there is none, then no frame passes through itself, nor
/// does the mesh at any time between; otherwise, the first violation is named. Parts of the mesh
/// that have a vertex in common are neighbours and may touch. With --ignore or --only, every frame is
/// examined for edges that meet faces: a pair that is left out may have led there.
///
/// With --min-distance D, no two primitives may come within D of each other, in the first frame
/// and after it.
///
/// Of a run of `exact-ccd simulate --output DIR --path`, DIR/path is the motion that is free of
/// contact. On the straight line from one time step to the next, as in DIR/frames, parts that turn
/// around each other may touch.
///
/// All ids count from 0. Exit status: 0 free, 1 violation, 2 error, 3 if some pairs have no
/// certificate.
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

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let mut run = Run::begin(arguments)?;
    let count = run.scene.frame_count();
    during(progress::bar(count, "frames"), |progress| {
        for index in 0..count {
            run.examine(index)?;
            if run.is_over() {
                break;
            }
            progress(1);
        }
        Ok::<_, Failure>(())
    })?;
    run.finish()
}

/// The frames examined so far, and the outputs that they go to.
struct Run<'a> {
    arguments: &'a Arguments,
    scene: Assembly,
    /// The next frame, read while the last one was examined.
    next: Option<Result<Frame, Failure>>,
    half_spaces: HalfSpaces,
    audit: Audit,
    certificate: Certificate<'a>,
    page: Recording,
    turns: Turns,
    report: Report,
    /// All violations.
    list: ContactList,
    clock: Seconds,
    /// The phase of the clock to which the outputs count; none without files to write.
    writing: &'static str,
}

impl<'a> Run<'a> {
    fn begin(arguments: &'a Arguments) -> Result<Self, Failure> {
        let Arguments { mesh, frames, .. } = arguments;
        mesh.check_places(frames)?;
        let clock = Seconds::begin();
        let mut notes = Notes::default();
        let scene = Assembly::of_sequence(frames, arguments.as_given, &mesh.scene, &mut notes)?;
        let names = (0..scene.frame_count()).map(|index| scene.frame_name(index).into());
        let certificate = mesh.certificate.begin(names, mesh.min_distance)?;
        if certificate.is_wanted() && mesh.all.is_some() {
            return Err(Failure::new(
                "a certificate ends with the first violation: leave out --all",
            ));
        }
        let half_spaces = mesh
            .half_spaces
            .around(scene.moving_vertices(), mesh.min_distance, None);
        let audit = Audit::default().with_min_distance(mesh.min_distance);
        Ok(Self {
            arguments,
            next: None,
            audit: audit.with_can_collide(scene.can_collide()),
            certificate,
            page: mesh.view.recording(frames, &scene, half_spaces.all()),
            report: Report::new(
                ReportForm::Frames,
                &scene,
                notes,
                Distances::new(mesh.min_distance, None),
            ),
            turns: Turns::of(&scene),
            list: ContactList::default(),
            clock,
            writing: if mesh.has_files() { "write" } else { "examine" },
            scene,
            half_spaces,
        })
    }

    /// Returns true if a violation was found, and the first one suffices.
    fn is_over(&self) -> bool {
        !self.report.collision_free && self.arguments.mesh.all.is_none()
    }

    /// Examines a frame and the step that leads to it.
    fn examine(&mut self, index: usize) -> Result<(), Failure> {
        let frame = self.next.take().unwrap_or_else(|| self.scene.read(index))?;
        self.clock.end("read");
        self.page.begin(&frame.mesh, || frame.bounds());
        let file = self.scene.frame_name(index);
        self.page.add(&name(Path::new(&file)), &frame.positions)?;
        self.clock.end(self.writing);
        let before = self.audit.last().map(|last| last.positions.clone());
        let violations = self.examine_and_read(index, frame)?;
        self.report.examined = index + 1;
        let Some(last) = self.audit.last() else {
            return Ok(());
        };
        self.certificate.add_frame(before.as_deref(), last, &violations)?;
        let start = before.as_ref().unwrap_or(&last.positions);
        let found: Vec<_> = violations
            .iter()
            .map(|violation| record(start, last, violation))
            .collect();
        if let Some(first) = found.first().filter(|_| index == 0) {
            self.scene
                .note_split_vertices(first, &[&last.positions], &mut self.report.notes);
        }
        if index == 0 && found.is_empty() {
            self.scene.note_nesting(&last.positions, &mut self.report.notes)?;
        }
        if let Some(before) = &before {
            self.turns.add(&self.scene, index - 1, [before, &last.positions]);
        }
        let all = found.into_iter().chain(self.half_spaces.touching(index, last));
        let in_file = |record: ContactRecord| self.scene.in_file(record);
        let mut records: Vec<_> = all.map(in_file).collect();
        self.clock.end("examine");
        show(&mut self.page, &violations, &records)?;
        if self.report.collision_free && !records.is_empty() {
            let ends = [&start[..], &last.positions];
            self.arguments.write_impact(&self.scene, index, ends, &records)?;
        }
        for record in &records {
            self.report.add(&self.scene, index, record);
        }
        self.list.0.append(&mut records);
        self.clock.end(self.writing);
        Ok(())
    }

    /// Examines a frame, while the next one is read. Only reading that lasts longer than the examination
    /// counts as reading.
    fn examine_and_read(&mut self, index: usize, frame: Frame) -> Result<Vec<Violation>, Failure> {
        let all = self.arguments.mesh.all.is_some();
        let examine = || {
            let violations = if all {
                self.audit.examine_all(frame)
            } else {
                let first = self.audit.examine(frame);
                first.map(|first| first.into_iter().collect())
            };
            self.clock.end("examine");
            violations
        };
        let is_last = index + 1 == self.scene.frame_count();
        let read = || (!is_last).then(|| self.scene.read(index + 1));
        let (violations, next) = rayon::join(examine, read);
        self.clock.end("read");
        self.next = next;
        violations.map_err(|error| self.scene.mismatch(index, error))
    }

    /// Writes the outputs about all frames, and returns the exit status.
    fn finish(mut self) -> Result<ExitCode, Failure> {
        let mesh = &self.arguments.mesh;
        self.turns.note(&self.scene, &mut self.report.notes);
        self.report.set_times(&self.scene);
        if let Some(file) = &mesh.all {
            self.report.counts.violations = Some(Violations::from(&self.list));
            self.list.write(file)?;
        }
        if let Some(last) = self.audit.last().filter(|_| self.report.collision_free) {
            let count = self.scene.frame_count();
            self.arguments
                .write_impact(&self.scene, count, [&last.positions; 2], &[])?;
        }
        self.page
            .finish(&self.report.verdict(), &self.report.to_string())?;
        self.clock.end(self.writing);
        self.report.seconds = Some(self.clock);
        let status = mesh.finish(self.report)?;
        Ok(self.certificate.finish()?.unwrap_or(status))
    }
}

/// Adds the violations in a frame, and in the step to it, to the page.
fn show(page: &mut Recording, violations: &[Violation], records: &[ContactRecord]) -> Result<(), Failure> {
    for violation in violations {
        match violation {
            Violation::Intersection { intersection, .. } => page.intersection(*intersection),
            Violation::Contact { contact, .. } => page.contact(contact),
        }?;
    }
    for (vertex, number) in records.iter().filter_map(ContactRecord::in_half_space) {
        page.half_space_contact(vertex, number, None)?;
    }
    Ok(())
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
    /// of this step, without violations at rest in the frame after it.
    fn write_impact(
        &self,
        scene: &Assembly,
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
        paraview::write(folder, Step::new(scene.mesh(), start, end)?, scene.ids(), &list)
    }
}
