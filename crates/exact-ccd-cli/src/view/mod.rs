//! The pages of `--view`: HTML files that show motions and their contacts.

#[cfg(feature = "simulate")]
pub(crate) mod curves;
#[cfg(feature = "queries")]
mod query;
mod recording;
mod setup;
#[cfg(feature = "simulate")]
mod simulation;
mod up;

use std::io::Write;
use std::path::{Path, PathBuf};

use exact_ccd_mesh::{HalfSpace, Point};
use exact_ccd_view::Page;

use crate::assembly::Assembly;
use crate::files::inputs::name;
use crate::files::outputs::{page, replace_file};
use crate::messages::failure::Failure;
#[cfg(feature = "queries")]
pub(crate) use query::QueryView;
pub(crate) use recording::Recording;
use setup::Setup;
#[cfg(feature = "simulate")]
pub(crate) use simulation::SimulationPage;

/// The options `--view` and `--view-up` of the commands that read meshes, and of `exact-ccd simulate`.
#[derive(clap::Args)]
pub(crate) struct View {
    /// Write an HTML file that shows the motion and the contacts in a browser. It contains all it needs.
    #[arg(long, value_name = "FILE.html", value_parser = page())]
    view: Option<PathBuf>,
    /// The direction upwards on that page: x, y, z, -x, -y, -z, or three numbers [default: z]
    #[arg(long, value_name = "AXIS", requires = "view", value_parser = up::parse, allow_hyphen_values = true)]
    view_up: Option<Point>,
}

impl View {
    /// The file of the page, if there is to be one.
    pub(crate) fn file(&self) -> Option<&Path> {
        self.view.as_deref()
    }

    /// The recording of frames from files, which does nothing if there is to be no page of them.
    pub(crate) fn recording(
        &self,
        files: &[PathBuf],
        scene: &Assembly,
        half_spaces: &[HalfSpace],
    ) -> Recording {
        let setup = || Setup::of_scene(scene, half_spaces.to_vec()).with_up(self.view_up);
        Recording::new(self.view.clone(), title(files), setup)
    }
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

/// The page with the verdict and the other lines of the printed answer, without the lines that the page has
/// elsewhere: the contents of the mesh, and the place of the contact.
fn with_answer(page: Page, verdict: &str, answer: &str) -> Page {
    let is_shown =
        |line: &&str| *line != verdict && !line.starts_with("read: ") && !line.starts_with("  at ");
    page.with_summary(answer.lines().filter(is_shown).map(str::to_owned))
        .with_verdict(verdict)
}
