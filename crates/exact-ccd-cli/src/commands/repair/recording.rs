//! The repair of a recording: a folder with a mesh file for each frame.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;

use exact_ccd_files::Format;
use exact_ccd_mesh::{Point, TriangleMesh};
use exact_ccd_repair::{Phase, Progress, Recording, repair_recording};

use super::mesh_output::MeshOutput;
use super::recording_answer::RecordingAnswer;
use super::report::Report;
use super::{Arguments, Budget};
use crate::assembly::Assembly;
use crate::files::inputs::name;
use crate::files::outputs::{check_folder_place, check_is_no_input, make_folder, print};
use crate::messages::failure::Failure;
use crate::messages::notes::Notes;
use crate::messages::progress::{self, during};
use crate::options::distances::Distances;
use crate::text::seconds::Seconds;

impl Arguments {
    /// Repairs the frames of a recording, and writes them to the folder of the option `--output`.
    pub(super) fn run_recording(
        &self,
        mut scene: Assembly,
        notes: Notes,
        mut clock: Seconds,
    ) -> Result<ExitCode, Failure> {
        self.check_options()?;
        let places = self.places(&scene)?;
        let pinned = scene.resting_vertices(&self.pin)?;
        let mut mesh = TriangleMesh::default();
        let mut frames = Vec::new();
        for index in 0..scene.frame_count() {
            let frame = scene.read(index)?;
            mesh = frame.mesh;
            frames.push(frame.positions);
        }
        let mesh = Arc::new(mesh);
        clock.end("read");

        let budget = self.budget()?;
        let recording = self.repair_frames(&mesh, &frames, pinned, &scene, &budget)?;
        clock.end("repair");
        let answer = RecordingAnswer::new(&scene, &mesh, &recording, budget.is_spent());
        let distances = Distances::new(self.min_distance, None);
        let mut report = Report::new(&scene, notes, distances, answer.is_repaired(), answer);
        if let Some(first) = recording.frames.first() {
            scene.note_nesting(first, &mut report.notes)?;
        }
        if report.repaired || self.partial {
            make_folder(&self.output)?;
            for (index, (place, positions)) in places.iter().zip(&recording.frames).enumerate() {
                let output = MeshOutput::new(scene.frame_file(index).to_owned(), place)?;
                output.write(&scene, &mesh, positions, &mut report.notes)?;
            }
            report.output = Some(self.output.display().to_string());
        }
        clock.end("write");
        report.seconds = (!self.no_seconds).then_some(clock);
        print(&report.text(self.json))?;
        Ok(ExitCode::from(u8::from(!report.repaired)))
    }

    /// Refuses the options that are about one mesh.
    fn check_options(&self) -> Result<(), Failure> {
        let audit = "`exact-ccd audit` of the repaired frames has this option";
        let one = "this option is about one mesh, not a recording: leave it out";
        let refused = [
            (self.f32, "--f32", one),
            (self.max_displacement.is_some(), "--max-displacement", one),
            (self.certificate.file().is_some(), "--certificate", audit),
            (self.view.file().is_some(), "--view", audit),
        ];
        match refused.into_iter().find(|(is_given, ..)| *is_given) {
            Some((_, option, reason)) => Err(Failure::new(format_args!("{option}: {reason}"))),
            None => Ok(()),
        }
    }

    /// The file of each frame: with the name of its source, or with a number if several have one source.
    /// Sources that are neither PLY nor OBJ become PLY.
    fn places(&self, scene: &Assembly) -> Result<Vec<PathBuf>, Failure> {
        let folder = &self.output;
        if Format::of_path(folder).is_some() {
            let count = scene.frame_count();
            let reason = format_args!("{count} frames need a folder: name one in place of a mesh file");
            return Err(Failure::of(folder, reason));
        }
        check_folder_place(folder)?;
        let sources: Vec<&Path> = (0..scene.frame_count())
            .map(|index| scene.frame_file(index))
            .collect();
        let mut inputs = self.scene.inputs(&self.frames);
        inputs.extend(sources.iter().map(|&source| source.to_owned()));
        check_is_no_input(folder, &inputs)?;
        let names: Vec<PathBuf> = sources.iter().map(|source| name_of(source)).collect();
        let distinct: BTreeSet<&PathBuf> = names.iter().collect();
        let is_numbered = distinct.len() < names.len();
        let place = |(index, name): (usize, &PathBuf)| {
            let extension = name.extension().unwrap_or_default().to_string_lossy();
            if is_numbered {
                folder.join(format!("frame-{index:06}.{extension}"))
            } else {
                folder.join(name)
            }
        };
        let places: Vec<PathBuf> = names.iter().enumerate().map(place).collect();
        for place in &places {
            check_is_no_input(place, &inputs)?;
        }
        check_has_no_others(folder, &places)?;
        Ok(places)
    }

    /// Repairs the frames, with their number as progress.
    fn repair_frames(
        &self,
        mesh: &Arc<TriangleMesh>,
        frames: &[Vec<Point>],
        pinned: Vec<u32>,
        scene: &Assembly,
        budget: &Budget,
    ) -> Result<Recording, Failure> {
        let recording = during(progress::bar(frames.len(), "frames"), |progress| {
            let stop = |state: Progress| {
                // The first frame has none before it.
                progress(usize::from(state.phase == Phase::Follow && state.round > 0));
                budget.stops()
            };
            repair_recording(mesh, frames, &self.options(pinned, scene, &stop))
        });
        recording.map_err(|error| Failure::of(&self.frames[0], error))
    }
}

/// The name of the repaired file of a source.
fn name_of(source: &Path) -> PathBuf {
    let name = PathBuf::from(name(source));
    let extension = name.extension().unwrap_or_default().to_ascii_lowercase();
    if extension == "ply" || extension == "obj" {
        name
    } else {
        name.with_extension("ply")
    }
}

/// Checks that a folder has no other meshes, which would be among the frames of the result.
fn check_has_no_others(folder: &Path, places: &[PathBuf]) -> Result<(), Failure> {
    if !folder.exists() {
        return Ok(());
    }
    let failed = |error| Failure::of(folder, error);
    for entry in fs::read_dir(folder).map_err(failed)? {
        let file = entry.map_err(failed)?.path();
        if Format::of_path(&file).is_some() && !places.contains(&file) {
            let reason =
                "this mesh in the folder of the answer is none of the repaired frames: name another folder";
            return Err(Failure::of(&file, reason));
        }
    }
    Ok(())
}
