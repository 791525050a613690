//! The folder of `--paraview`: the mesh at the time of impact, and the contacts, for ParaView.

use std::path::Path;

use exact_ccd_files::{FileIds, PointArray, UnstructuredGrid, write_vtp, write_vtu};
use exact_ccd_mesh::Step;

use crate::contacts::ContactList;
use crate::files::outputs::{make_folder, remove_file, write_file};
use crate::messages::failure::Failure;

/// The files in the folder.
pub(crate) const NAMES: [&str; 2] = ["impact.vtu", "contacts.vtp"];

/// Writes `impact.vtu`, the mesh at the time of the first contact, and `contacts.vtp`, the places of the
/// contacts with their times, normals and ids. Without a contact, there is no `impact.vtu`.
pub(crate) fn write(folder: &Path, step: Step<'_>, ids: &FileIds, list: &ContactList) -> Result<(), Failure> {
    make_folder(folder)?;
    let [impact, contacts] = NAMES.map(|name| folder.join(name));
    match list.0.first() {
        Some(first) => {
            let positions = step.at(first.toi());
            let mesh = step.mesh();
            let grid = UnstructuredGrid {
                positions: &positions,
                triangles: mesh.faces(),
                lines: mesh.loose_edges(),
                ids: Some(&ids.vertices),
                ..UnstructuredGrid::default()
            };
            write_file(&impact, |writer| write_vtu(writer, grid))?;
        }
        // The file of an earlier run would contradict this report.
        None => remove_file(&impact)?,
    }
    let places = list.places();
    let arrays = [
        ("time", PointArray::Reals(&places.times)),
        ("normal", PointArray::Vectors(&places.normals)),
        ("kind", PointArray::Integers(&places.kinds)),
        ("id_a", PointArray::Integers(&places.ids[0])),
        ("id_b", PointArray::Integers(&places.ids[1])),
    ];
    write_file(&contacts, |writer| write_vtp(writer, &places.points, &arrays))
}
