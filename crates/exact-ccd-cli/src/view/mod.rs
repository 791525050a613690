//! The pages of `--view`: HTML files that show motions and their contacts.

mod query;
mod recording;

use std::io::Write;
use std::path::{Path, PathBuf};

use exact_ccd_files::FileIds;
use exact_ccd_mesh::{Contact, Intersection, Motion};
use exact_ccd_view::Page;

use crate::failure::Failure;
use crate::output::replace_file;
pub(crate) use query::{ChosenQuery, QueryView};
use recording::Recording;

/// The option `--view`.
#[derive(clap::Args)]
pub(crate) struct View {
    /// Write an HTML file that shows the motion and the contacts in a browser. It contains all it needs.
    #[arg(long, value_name = "FILE.html")]
    view: Option<PathBuf>,
}

impl View {
    /// The file of the page, if there is to be one.
    pub(crate) fn file(&self) -> Option<&Path> {
        self.view.as_deref()
    }

    /// Writes the page of a step, if there is to be one: the intersections at its start, all contacts, and
    /// the answer that is printed.
    pub(crate) fn step(
        &self,
        files: &[PathBuf],
        motion: &Motion,
        start: &[Intersection],
        ids: &FileIds,
        contacts: &[Contact],
        answer: &str,
    ) -> Result<(), Failure> {
        let Some(file) = &self.view else { return Ok(()) };
        let page = Page::of_step(title(files), motion.step()?, start, contacts)?;
        let page = page.with_ids(ids.vertices.clone(), ids.faces.clone());
        write(file, &page.with_summary(lines(answer)))
    }

    /// The recording of a motion, which does nothing if there is to be no page of it.
    pub(crate) fn recording(&self, files: &[PathBuf]) -> Recording {
        Recording::new(self.view.clone(), title(files))
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
