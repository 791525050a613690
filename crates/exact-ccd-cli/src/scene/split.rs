//! Split vertices: several vertices in one place, as exporters write them at seams.

use exact_ccd_mesh::{Contact, Intersection, Point, TriangleMesh};

use super::options::SceneOptions;
use crate::notes::Notes;

/// Adds a note that names `--weld`, if something touches in a frame, and every pair that does so has
/// vertices in the same place.
pub(crate) fn note_split_vertices(
    mesh: &TriangleMesh,
    positions: &[Point],
    contacts: &[Contact],
    intersections: &[Intersection],
    options: &SceneOptions,
    notes: &mut Notes,
) {
    let count = contacts.len() + intersections.len();
    if options.weld || count == 0 {
        return;
    }
    let coincide = |a: &[u32], b: &[u32]| {
        let at = |vertex: &u32| positions[*vertex as usize];
        a.iter().any(|v| b.iter().any(|w| at(v) == at(w)))
    };
    let of_contact = |contact: &Contact| {
        let vertices = contact.pair.vertices(mesh).unwrap_or_default();
        let (a, b) = vertices.split_at(contact.pair.first_len().min(vertices.len()));
        coincide(a, b)
    };
    let of_intersection = |&Intersection { edge, face }: &Intersection| {
        coincide(&mesh.edges()[edge as usize], &mesh.faces()[face as usize])
    };
    if contacts.iter().all(of_contact) && intersections.iter().all(of_intersection) {
        let pairs = match count {
            1 => "the pair that touches at the start has".to_owned(),
            _ => format!("all {count} pairs that touch at the start have"),
        };
        notes.note(format!(
            "{pairs} vertices in the same place, as exporters split them at seams; --weld makes one vertex of them"
        ));
    }
}
