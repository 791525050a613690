//! `exact-ccd round`: queries and meshes shifted and rounded, so that differences of coordinates are exact.

mod arguments;
mod displacement;
mod histogram;
mod meshes;
mod plot;
mod queries;
mod report;

use std::io::Write;
use std::process::ExitCode;

use exact_ccd::{AnyKind, EdgeEdge, VertexFace};

use crate::files::inputs::check_file;
use crate::files::outputs::{check_is_no_input, print, write_file};
use crate::messages::failure::Failure;
use crate::messages::notes::Notes;
use crate::messages::progress::{self, during};
use crate::query_files::recognise::note_other_folders;
use crate::query_files::rows;
use crate::text::json::to_json;
pub(crate) use arguments::Arguments;

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    rows::check(&arguments.inputs, |input| {
        check_file(input, "a mesh file, or a query file with --kind")
    })?;
    // A mesh can take the place of its input. A query file would lose its answers.
    let output = arguments.output.iter().filter(|_| arguments.kind.is_some());
    for file in output.chain(&arguments.plot) {
        check_is_no_input(file, &arguments.inputs)?;
    }
    if let Some(kind) = arguments.kind {
        note_other_folders(kind, &arguments.inputs, &mut Notes::default());
    }
    let report = during(progress::stage("rounding"), |_| match arguments.kind {
        None => meshes::round(arguments),
        Some(AnyKind::VertexFace) => queries::round::<VertexFace>(arguments),
        Some(_) => queries::round::<EdgeEdge>(arguments),
    })?;
    if let Some(file) = &arguments.plot {
        let drawing = plot::svg(&report.errors);
        write_file(file, |writer| writer.write_all(drawing.as_bytes()))?;
    }
    let text = if arguments.json {
        to_json("round", &report)
    } else {
        report.to_string()
    };
    print(&text)?;
    Ok(ExitCode::SUCCESS)
}
