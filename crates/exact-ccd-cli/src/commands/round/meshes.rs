//! Mesh files, rounded.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use exact_ccd_files::{Format, read_frame, write_ply};
use exact_ccd_mesh::{Aabb, Frame};

use super::arguments::Arguments;
use super::displacement::shared_displacement;
use super::report::Report;
use crate::files::outputs::{make_folder, write_file};
use crate::messages::failure::Failure;

/// Reads each mesh twice, so that only one is in memory at a time: a simulation can have many frames.
pub(super) fn round(arguments: &Arguments) -> Result<Report, Failure> {
    let inputs = &arguments.inputs;
    let outputs = arguments
        .output
        .as_ref()
        .map(|output| destinations(inputs, output))
        .transpose()?;
    let bounds = inputs.iter().try_fold(Aabb::EMPTY, |bounds, input| {
        Ok::<_, Failure>(bounds.union(&read(input)?.bounds()))
    })?;
    let displacement = shared_displacement(&bounds)?;
    if let (Some(folder), 2..) = (&arguments.output, inputs.len()) {
        make_folder(folder)?;
    }
    let mut report = Report::new(Some(displacement));
    for (index, input) in inputs.iter().enumerate() {
        let frame = read(input)?;
        report.add(displacement, &frame.positions);
        let shifted = Frame {
            positions: displacement.apply_to_all(&frame.positions)?,
            mesh: frame.mesh,
        };
        if let Some(outputs) = &outputs {
            write_file(&outputs[index], |writer| write_ply(writer, &shifted))?;
        }
    }
    Ok(report)
}

fn read(file: &Path) -> Result<Frame, Failure> {
    if Format::of_path(file).is_none() {
        return Err(Failure::of(
            file,
            format_args!(
                "expected a mesh file, {}, or --kind for a query file",
                Format::extensions()
            ),
        ));
    }
    Ok(read_frame(file)?)
}

/// The output file of each mesh: `output` of a single one, files of the same names in that folder of several.
fn destinations(inputs: &[PathBuf], output: &Path) -> Result<Vec<PathBuf>, Failure> {
    if inputs.len() == 1 {
        let is_ply = output
            .extension()
            .is_some_and(|extension| extension.eq_ignore_ascii_case("ply"));
        if Format::of_path(output).is_some() && !is_ply {
            let reason = "the rounded mesh is a PLY file: name one that ends in .ply";
            return Err(Failure::of(output, reason));
        }
        return Ok(vec![output.to_owned()]);
    }
    let name = |input: &PathBuf| Path::new(input.file_name().unwrap_or_default()).with_extension("ply");
    let files: Vec<_> = inputs.iter().map(|input| output.join(name(input))).collect();
    let mut distinct = BTreeSet::new();
    if let Some(file) = files.iter().find(|file| !distinct.insert(*file)) {
        return Err(Failure::new(format_args!(
            "two meshes would be written to {}",
            file.display()
        )));
    }
    Ok(files)
}
