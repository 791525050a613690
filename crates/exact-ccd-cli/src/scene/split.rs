//! Split vertices: several vertices in one place, as exporters write them at seams.

use exact_ccd_mesh::Point;

use super::options::SceneOptions;
use crate::contacts::ContactRecord;
use crate::notes::Notes;

/// Adds a note that names `--weld`, if the primitives of a contact have vertices that are in the same place
/// in all of these frames.
///
/// The contact is the one that is reported: a search for all pairs that touch would take much longer than
/// that for the first one.
pub(crate) fn note_split_vertices(
    contact: &ContactRecord,
    frames: &[&[Point]],
    options: &SceneOptions,
    notes: &mut Notes,
) {
    if !options.weld && contact.has_common_place(frames) {
        notes.note(
            "the first pair that touches at the start has vertices in the same place, as exporters split them at \
             seams; --weld makes one vertex of such vertices"
                .to_owned(),
        );
    }
}
