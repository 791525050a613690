//! The arguments that `step` and `audit` have in common: the scene, the meaning of contact, and the answer.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use exact_ccd::Separation;

use super::half_spaces::HalfSpaceOption;
use super::paraview;
use super::report::Report;
use crate::assembly::AssemblyOptions;
use crate::contacts::ListFile;
use crate::files::outputs::{Output, check_distinct, check_folder_place, check_is_no_input, check_place};
use crate::messages::failure::Failure;
use crate::options::certificate::CertificateOption;
use crate::options::distances;
use crate::view::View;

#[derive(clap::Args)]
pub(crate) struct MeshArguments {
    #[command(flatten)]
    pub(crate) scene: AssemblyOptions,
    /// Count primitives at most D apart as touching, in the unit of the coordinates.
    #[arg(long, value_name = "D", default_value = "0", value_parser = distances::parse, allow_hyphen_values = true)]
    pub(crate) min_distance: Separation,
    #[command(flatten)]
    pub(crate) half_spaces: HalfSpaceOption,
    /// Search for all intersections and contacts, also after the first one, and list them in a file that
    /// ends in .csv, .jsonl (JSON lines) or .parquet. docs/reports.md has its columns.
    #[arg(long, value_name = "FILE")]
    pub(crate) all: Option<ListFile>,
    /// Write the mesh at the time of the first contact, impact.vtu, and the contacts of its step that
    /// were found as points, contacts.vtp, to this folder, for ParaView.
    #[arg(long, value_name = "DIR")]
    pub(crate) paraview: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) view: View,
    #[command(flatten)]
    pub(crate) certificate: CertificateOption,
    /// Print the report as a JSON object. docs/reports.md has its schema.
    #[arg(long)]
    json: bool,
    /// Leave the durations out, so that the report has the same bytes each time.
    #[arg(long)]
    no_seconds: bool,
    #[command(flatten)]
    output: Output,
}

impl MeshArguments {
    /// Returns true if contacts are written to files.
    pub(crate) fn has_files(&self) -> bool {
        self.all.is_some() || self.paraview.is_some() || self.view.file().is_some()
    }

    /// Checks the places of the files before anything is computed: none is an input, or another one.
    pub(crate) fn check_places(&self, moving: &[PathBuf]) -> Result<(), Failure> {
        let inputs = self.scene.inputs(moving);
        let list = self.all.iter().map(ListFile::path);
        let files = list.chain(self.view.file()).chain(self.certificate.file());
        let mut files: Vec<PathBuf> = files.chain(self.output.file()).map(Path::to_owned).collect();
        files.iter().try_for_each(|file| check_place(file))?;
        if let Some(folder) = &self.paraview {
            check_folder_place(folder)?;
            // Its files would be among the frames of the next run.
            check_is_no_input(folder, &inputs)?;
            files.extend(paraview::NAMES.map(|name| folder.join(name)));
        }
        files
            .iter()
            .try_for_each(|file| check_is_no_input(file, &inputs))?;
        check_distinct(&files)
    }

    /// Writes the answer.
    pub(crate) fn write(&self, text: &str) -> Result<(), Failure> {
        self.output.write(text)
    }

    /// Writes the report, and returns its exit status.
    pub(crate) fn finish(&self, mut report: Report) -> Result<ExitCode, Failure> {
        if self.no_seconds {
            report.seconds = None;
        }
        let text = if self.json {
            report.to_json()
        } else {
            report.to_string()
        };
        self.write(&text)?;
        Ok(ExitCode::from(u8::from(!report.collision_free)))
    }
}
