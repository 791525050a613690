//! `exact-ccd audit`: does a mesh touch itself in a sequence of frames?

mod every;
mod found;
mod report;

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use exact_ccd::Separation;
use exact_ccd_mesh::{Audit, Frame, MotionError, Step, Violation};

use crate::certificate::CertificateOption;
use crate::contacts::{ContactList, ContactRecord, ListFile};
use crate::distances::{Distances, kept};
use crate::failure::Failure;
use crate::half_spaces::HalfSpaceOption;
use crate::impact_files;
use crate::min_distance;
use crate::notes::Notes;
use crate::output::{check_folder_place, check_place, print};
use crate::progress::{self, during};
use crate::scene::{Scene, SceneOptions, note_split_vertices};
use crate::view::View;
use every::EveryViolation;
use found::{Found, Moved, record};
use report::{Report, Seconds, Totals};

/// Does a mesh touch itself in a sequence of frames?
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
/// Of a run of `exact-ccd simulate --out DIR --path`, DIR/path is the motion that is free of
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
    scene: SceneOptions,
    /// Count primitives at most D apart as touching, in the unit of the coordinates.
    #[arg(long, value_name = "D", default_value = "0", value_parser = min_distance::parse, allow_hyphen_values = true)]
    min_distance: Separation,
    #[command(flatten)]
    half_spaces: HalfSpaceOption,
    /// Go on after the first violation: examine every frame at rest and every step, and list all
    /// intersections and contacts in a file that ends in .csv, .jsonl (JSON lines) or .parquet.
    /// docs/reports.md has its columns.
    #[arg(long, value_name = "FILE")]
    all: Option<ListFile>,
    /// Write the mesh at the time of the first violation, impact.vtu, and all violations of its step
    /// that were found as points, contacts.vtp, to this folder, for ParaView.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    #[command(flatten)]
    certificate: CertificateOption,
    /// Print the report as a JSON object. docs/reports.md has its schema.
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    view: View,
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
    arguments.check_outputs()?;
    let mut certificate = arguments
        .certificate
        .begin(&arguments.frames, arguments.min_distance)?;
    if certificate.is_wanted() && arguments.all.is_some() {
        return Err(Failure::new(
            "a certificate ends with the first violation: leave out --all",
        ));
    }
    let clock = Instant::now();
    let mut notes = Notes::default();
    let mut scene = Scene::of_sequence(
        &arguments.frames,
        arguments.as_given,
        &arguments.scene,
        &mut notes,
    )?;
    scene.check_contents(
        arguments.min_distance != Separation::default() || arguments.half_spaces.is_given(),
    )?;
    let (mut read, mut write) = (clock.elapsed(), Duration::ZERO);
    let mut examination = arguments.examination(&scene);
    let mut found = Found::default();
    let vertices = scene.moving_vertices();
    let half_spaces = arguments
        .half_spaces
        .around(vertices, arguments.min_distance, None);
    let mut recording = arguments
        .view
        .recording(&arguments.frames, &scene, half_spaces.all());
    let (count, mut examined) = (scene.frame_count(), 0);
    during(progress::bar(count, "frames"), |progress| {
        for index in 0..count {
            let frame = timed(&mut read, || scene.read(index))?;
            timed(&mut write, || recording.add(&scene.frame_name(index), &frame))?;
            let before = examination.last().map(|last| last.positions.clone());
            let violations = examination
                .examine(frame)
                .map_err(|error| scene.mismatch(index, error))?;
            examined = index + 1;
            let Some(last) = examination.last() else {
                continue;
            };
            timed(&mut write, || {
                certificate.add_frame(before.as_deref(), last, &violations)
            })?;
            timed(&mut write, || {
                violations
                    .iter()
                    .try_for_each(|violation| recording.violation(violation))
            })?;
            let start = before.as_ref().unwrap_or(&last.positions);
            let moved = Moved { index, start, last };
            let mut records: Vec<_> = violations
                .iter()
                .map(|violation| record(&moved, violation))
                .collect();
            if let Some(first) = records.first().filter(|_| index == 0) {
                note_split_vertices(first, &[&last.positions], &arguments.scene, &mut notes);
            }
            let in_half_spaces = half_spaces.touching(index, last);
            timed(&mut write, || {
                let mut found = in_half_spaces.iter().filter_map(ContactRecord::in_half_space);
                found.try_for_each(|(vertex, number)| recording.half_space_contact(vertex, number))
            })?;
            records.extend(in_half_spaces);
            let records: Vec<_> = records
                .into_iter()
                .map(|record| record.in_file(scene.ids()))
                .collect();
            if records.is_empty() {
                progress(1);
                continue;
            }
            timed(&mut write, || {
                found.add(&scene, &moved, records, arguments.out.as_deref())
            })?;
            if arguments.all.is_none() {
                break;
            }
            progress(1);
        }
        Ok::<_, Failure>(())
    })?;
    let mut report = Report {
        summary: scene.summary(),
        notes,
        distances: Distances::new(arguments.min_distance, None),
        collision_free: found.first.is_none(),
        frames: count,
        examined,
        violations: arguments.all.is_some().then(|| Totals::of(&found.list)),
        violation: found.first.clone(),
        seconds: Seconds::default(),
    };
    timed(&mut write, || {
        arguments.write(&scene, &found, examination.last())?;
        recording.finish(&report.verdict(), &report.to_string())
    })?;
    let write = arguments.has_files().then_some(write);
    report.seconds = Seconds::new(read, write, clock.elapsed());
    let text = if arguments.json {
        report.to_json()
    } else {
        report.to_string()
    };
    print(&text)?;
    let status = ExitCode::from(u8::from(!report.collision_free));
    Ok(certificate.finish()?.unwrap_or(status))
}

/// Runs `work`, and adds its duration to a sum.
fn timed<T>(sum: &mut Duration, work: impl FnOnce() -> T) -> T {
    let clock = Instant::now();
    let result = work();
    *sum += clock.elapsed();
    result
}

impl Arguments {
    fn has_files(&self) -> bool {
        self.all.is_some() || self.out.is_some() || self.view.file().is_some()
    }

    /// Checks the places of the files before anything is computed.
    fn check_outputs(&self) -> Result<(), Failure> {
        let list = self.all.iter().map(ListFile::path);
        list.chain(self.view.file()).try_for_each(check_place)?;
        self.out.as_deref().map_or(Ok(()), check_folder_place)
    }

    /// Writes the list of violations, and the files for ParaView if there is no violation: those of the first
    /// one are written when it is found.
    fn write(&self, scene: &Scene, found: &Found, last: Option<&Frame>) -> Result<(), Failure> {
        if let Some(file) = &self.all {
            found.list.write(file)?;
        }
        if let (Some(folder), Some(last), None) = (&self.out, last, &found.first) {
            let rest = Step::new(&last.mesh, &last.positions, &last.positions)?;
            impact_files::write(folder, rest, scene.ids(), &ContactList::default())?;
        }
        Ok(())
    }

    fn examination(&self, scene: &Scene) -> Examination {
        let min_distance = kept(self.min_distance, None);
        if self.all.is_some() {
            let is_only_frame = scene.frame_count() == 1;
            let every = EveryViolation::new(min_distance, scene.can_collide(), is_only_frame);
            Examination::Every(Box::new(every))
        } else {
            let audit = Audit::with_min_distance(min_distance);
            Examination::First(Box::new(audit.with_can_collide(scene.can_collide())))
        }
    }
}
