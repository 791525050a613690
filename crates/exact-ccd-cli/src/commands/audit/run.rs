//! The examination of frames one after the other, and the report of their results.

use std::path::Path;
use std::process::ExitCode;

use exact_ccd::Point;
use exact_ccd_mesh::{Audit, Frame, Violation};

use super::arguments::Arguments;
use super::frame_result::FrameResult;
use super::identity::identity;
use super::outputs::{record, show};
use super::share::Share;
use crate::assembly::{Assembly, Turns};
use crate::contacts::{ContactList, ContactRecord, note_of_rounding};
use crate::files::inputs::name;
use crate::messages::failure::Failure;
use crate::messages::notes::Notes;
use crate::motion::counts::Violations;
use crate::motion::half_spaces::HalfSpaces;
use crate::motion::report::{Report, ReportForm};
use crate::options::certificate::Certificate;
use crate::options::distances::Distances;
use crate::text::seconds::Seconds;
use crate::view::Recording;

/// The frames examined so far, and the outputs that they go to.
pub(super) struct Run<'a> {
    arguments: &'a Arguments,
    scene: Assembly,
    /// A frame that was read while the one before it was examined.
    next: Option<(usize, Result<Frame, Failure>)>,
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
    pub(super) fn begin(arguments: &'a Arguments) -> Result<Self, Failure> {
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
    pub(super) fn is_over(&self) -> bool {
        !self.report.collision_free && self.arguments.mesh.all.is_none()
    }

    pub(super) fn frame_count(&self) -> usize {
        self.scene.frame_count()
    }

    pub(super) fn frame_name(&self, frame: usize) -> String {
        self.scene.frame_name(frame)
    }

    /// The identity of the audit: its frames and the options on which results depend.
    pub(super) fn identity(&self) -> Result<String, Failure> {
        identity(self.arguments, &self.scene)
    }

    /// Examines a frame and the step that leads to it.
    pub(super) fn examine(&mut self, index: usize) -> Result<FrameResult, Failure> {
        if index > 0 && self.audit.frames() != index {
            // The frame before was examined by another process.
            let before = self.read(index - 1)?;
            self.audit
                .begin_after(before, index)
                .map_err(|error| self.scene.mismatch(index - 1, error))?;
        }
        let frame = self.read(index)?;
        self.clock.end("read");
        self.page.begin(&frame.mesh, || frame.bounds());
        let file = self.scene.frame_name(index);
        self.page.add(&name(Path::new(&file)), &frame.positions)?;
        self.clock.end(self.writing);
        let before = self.audit.last().map(|last| last.positions.clone());
        let found = self.examine_and_read(index, frame)?;
        let mut result = FrameResult {
            frame: index,
            violations: Vec::new(),
            note_of_violation: None,
            turns: Vec::new(),
            notes: Vec::new(),
        };
        let Some(last) = self.audit.last() else {
            return Ok(result);
        };
        self.certificate.add_frame(before.as_deref(), last, &found)?;
        let start = before.as_ref().unwrap_or(&last.positions);
        let records: Vec<_> = found
            .iter()
            .map(|violation| record(start, last, violation))
            .collect();
        if index == 0 {
            result.notes = self.notes_of_first(records.first(), &last.positions)?;
        }
        if let Some(before) = &before {
            result.turns = self
                .turns
                .in_step(&self.scene, index - 1, [before, &last.positions]);
        }
        let all = records.into_iter().chain(self.half_spaces.touching(index, last));
        result.violations = all.map(|record| self.scene.in_file(record)).collect();
        if let (Some(Violation::Contact { contact, .. }), Some(record)) =
            (found.first(), result.violations.first())
        {
            let ends = [&start[..], &last.positions];
            result.note_of_violation = note_of_rounding(&last.mesh, ends, contact, record);
        }
        self.clock.end("examine");
        show(&mut self.page, &found, &result.violations)?;
        if self.report.collision_free && !result.violations.is_empty() {
            let ends = [&start[..], &last.positions];
            self.arguments
                .write_impact(&self.scene, index, ends, &result.violations)?;
        }
        self.clock.end(self.writing);
        Ok(result)
    }

    /// The notes about the first frame.
    fn notes_of_first(
        &self,
        first: Option<&ContactRecord>,
        positions: &[Point],
    ) -> Result<Vec<String>, Failure> {
        let mut notes = Notes::unprinted();
        match first {
            Some(first) => self.scene.note_split_vertices(first, &[positions], &mut notes),
            None => self.scene.note_nesting(positions, &mut notes)?,
        }
        Ok(notes.into_texts())
    }

    /// The frame, unless it was read before.
    fn read(&mut self, index: usize) -> Result<Frame, Failure> {
        match self.next.take() {
            Some((next, frame)) if next == index => frame,
            _ => self.scene.read(index),
        }
    }

    /// Adds the result of the next frame.
    pub(super) fn add(&mut self, result: FrameResult) -> Result<(), Failure> {
        self.report.examined = result.frame + 1;
        result
            .notes
            .into_iter()
            .for_each(|note| self.report.notes.note(note));
        if self.report.collision_free
            && let Some(note) = result.note_of_violation
        {
            self.report.notes.note(note);
        }
        self.turns.add(&self.scene, &result.turns);
        for record in &result.violations {
            self.report.add(&self.scene, result.frame, record);
        }
        self.list.0.extend(result.violations);
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
        self.next = next.map(|frame| (index + 1, frame));
        violations.map_err(|error| self.scene.mismatch(index, error))
    }

    /// Prints what a part has found, and returns the exit status.
    pub(super) fn finish_part(self, share: Share) -> Result<ExitCode, Failure> {
        let frames = share.of(self.frame_count());
        let examined = self
            .report
            .examined
            .saturating_sub(frames.start)
            .min(frames.len());
        let violations = self.list.0.len();
        let line = format!(
            "{share}: {examined} of {} frames examined, violations: {violations}",
            frames.len()
        );
        self.arguments.mesh.write(&line)?;
        Ok(ExitCode::from(u8::from(violations > 0)))
    }

    /// Writes the outputs about all frames, and returns the exit status.
    pub(super) fn finish(mut self) -> Result<ExitCode, Failure> {
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
