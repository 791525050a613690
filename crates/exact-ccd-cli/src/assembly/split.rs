//! Split vertices: several vertices in one place, as exporters write them at seams.

use exact_ccd_mesh::Point;

use super::Assembly;
use super::seams::Coincidence;
use crate::contacts::ContactRecord;
use crate::messages::notes::Notes;

impl Assembly {
    /// Adds a note if the primitives of a contact have vertices in the same place in all of these frames:
    /// vertices of one part that `--weld` makes one, or vertices of two parts, which it does not join.
    ///
    /// Only the reported contact is examined: a search for all pairs that touch would take much longer than
    /// the search for the first one.
    pub(crate) fn note_split_vertices(
        &self,
        contact: &ContactRecord,
        frames: &[&[Point]],
        notes: &mut Notes,
    ) {
        let part_of = |vertex| self.parts.iter().find(|part| part.vertices.contains(&vertex));
        for [v, w] in contact.vertices_in_same_place(frames) {
            let (Some(first), Some(second)) = (part_of(v), part_of(w)) else {
                continue;
            };
            let remedy = if first.name != second.name {
                let (a, b) = (&first.name, &second.name);
                format!(
                    "of the parts {a} and {b}, which --weld does not join; write them to one file, or leave their \
                     pairs out with --ignore {a}:{b}"
                )
            } else {
                match first.coincidence([v, w], frames) {
                    Coincidence::Seam => {
                        "as exporters split them at seams; --weld makes one vertex of such vertices"
                            .to_owned()
                    }
                    Coincidence::Layers => format!(
                        "and faces of the part {} lie on each other there: it has no thickness, or has faces twice; \
                         move the layers apart, or keep one of them",
                        first.name
                    ),
                    Coincidence::Other => continue,
                }
            };
            notes.note(format!(
                "the first pair that touches at the start has vertices in the same place, {remedy}"
            ));
            return;
        }
    }
}
