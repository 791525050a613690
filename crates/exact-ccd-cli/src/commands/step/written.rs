//! `exact-ccd step --write-f32`: the motion of a mesh to its coordinates in single precision.

use std::path::PathBuf;

use exact_ccd_mesh::{Frame, Motion, Precision};

use crate::assembly::{Assembly, AssemblyOptions};
use crate::messages::failure::Failure;
use crate::messages::notes::Notes;
use crate::text::numbers::shortest;

/// The meshes in the files, and the motion to the same coordinates in single precision.
pub(super) fn read(
    files: &[PathBuf],
    options: &AssemblyOptions,
    notes: &mut Notes,
) -> Result<(Assembly, Motion), Failure> {
    let mut scene = Assembly::of_meshes(files, options, notes)?;
    let start = scene.read(0)?;
    let largest = f64::from(f32::MAX);
    if let Some(vertex) = start
        .positions
        .iter()
        .position(|x| x.iter().any(|x| x.abs() > largest))
    {
        return Err(Failure::new(format_args!(
            "vertex {vertex} of the mesh has a coordinate beyond the range of single precision, which ends at 3.4e38: \
             write it in double precision, or scale it"
        )));
    }
    let end: Vec<_> = start
        .positions
        .iter()
        .map(|&x| Precision::Single.round(x))
        .collect();
    let moved = start.positions.iter().zip(&end).filter(|(a, b)| a != b).count();
    let differences = start.positions.as_flattened().iter().zip(end.as_flattened());
    let most = differences.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
    notes.note(format!(
        "the end of the step is the mesh in single precision: {moved} of {} vertices move, by at most {} along an axis",
        end.len(),
        shortest(most)
    ));
    let mesh = start.mesh.clone();
    let motion = Motion::new(start, Frame { mesh, positions: end });
    Ok((scene, motion.map_err(Failure::from)?))
}
