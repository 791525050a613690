//! The pages of `--view`: HTML files that show motions and their contacts.

#[cfg(feature = "queries")]
mod query;
mod recording;
mod setup;
#[cfg(feature = "simulate")]
mod simulation;
mod step;
mod up;

use std::io::Write;
use std::path::{Path, PathBuf};

use exact_ccd_mesh::{HalfSpace, Point};
use exact_ccd_view::Page;

use crate::failure::Failure;
use crate::output::replace_file;
use crate::scene::Scene;
#[cfg(feature = "queries")]
pub(crate) use query::{ChosenQuery, QueryView};
use recording::Recording;
use setup::Setup;
pub(crate) use step::ShownStep;
use up::Up;

/// The options `--view` and `--view-up`.
#[derive(clap::Args)]
pub(crate) struct View {
    /// Write an HTML file that shows the motion and the contacts in a browser. It contains all it needs.
    #[arg(long, value_name = "FILE.html")]
    view: Option<PathBuf>,
    /// The direction upwards on that page: x, y, z, -x, -y, -z, or three numbers [default: z; of a
    /// simulation, `up` of the scene's table `[render]`, or else opposite to gravity, or y without gravity]
    #[arg(long, value_name = "AXIS", requires = "view", allow_hyphen_values = true)]
    view_up: Option<Up>,
}

impl View {
    /// The file of the page, if there is to be one.
    pub(crate) fn file(&self) -> Option<&Path> {
        self.view.as_deref()
    }

    /// Writes the page of a step, if there is to be one, with the answer that is printed, of which one
    /// line is the verdict.
    pub(crate) fn step(
        &self,
        files: &[PathBuf],
        scene: &Scene,
        step: &ShownStep<'_>,
        (verdict, answer): (&str, &str),
    ) -> Result<(), Failure> {
        let Some(file) = &self.view else { return Ok(()) };
        let setup = Setup::of_scene(scene, step.half_spaces.to_vec()).with_up(self.up());
        write(
            file,
            &with_answer(step.page(title(files), setup)?, verdict, answer),
        )
    }

    /// The recording of frames from files, which does nothing if there is to be no page of them.
    pub(crate) fn recording(&self, files: &[PathBuf], scene: &Scene, half_spaces: &[HalfSpace]) -> Recording {
        let setup = || Setup::of_scene(scene, half_spaces.to_vec()).with_up(self.up());
        Recording::new(self.view.clone(), title(files), setup)
    }

    fn up(&self) -> Option<Point> {
        self.view_up.map(|Up(up)| up)
    }
}

/// The page with the answer that was printed, of which one line is the verdict.
fn with_answer(page: Page, verdict: &str, answer: &str) -> Page {
    let others = lines(answer).filter(|line| line != verdict);
    page.with_summary(others).with_verdict(verdict)
}

fn write(file: &Path, page: &Page) -> Result<(), Failure> {
    replace_file(file, |writer| {
        let written = page.write(writer).and_then(|()| writer.flush());
        written.map_err(|source| Failure::write(file, source))
    })
}

/// The first and the last file.
fn title(files: &[PathBuf]) -> String {
    match files {
        [start, .., end] => format!("{} to {}", name(start), name(end)),
        [file] => name(file),
        [] => String::new(),
    }
}

/// The last part of a path.
fn name(path: &Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str());
    name.to_string_lossy().into_owned()
}

/// The lines of an answer, without those that the page has elsewhere (the contents of the mesh, the place of
/// the contact) and that of the durations.
fn lines(answer: &str) -> impl Iterator<Item = String> {
    let left_out = ["read: ", "  at ", "seconds: "];
    let is_kept = move |line: &&str| !left_out.iter().any(|start| line.starts_with(start));
    answer.lines().filter(is_kept).map(str::to_owned)
}
