//! Vertices in one place, or nearly so, that the mesh does not join.

use exact_ccd_mesh::{Aabb, Point, TriangleMesh, Welding};

use super::part::Part;
use crate::messages::notes::Notes;
use crate::text::numbers::shortest;

/// The distance of vertices that are nearly in one place, relative to the diagonal of the part.
const NEAR: f64 = 1e-6;

/// The reason why two vertices of a part are in one place.
pub(super) enum Coincidence {
    /// Faces meet there as at a seam: `--weld` joins them.
    Seam,
    /// Faces lie on each other: the part is flat, or has faces twice.
    Layers,
    Other,
}

impl Part {
    /// The reason why two vertices are in one place, if all frames agree with the given ones.
    ///
    /// At a seam, exporters split vertices of surfaces that end there: each is at an edge of one face. A
    /// vertex of a closed surface is not; and where welding makes two faces one, they lie on each other.
    pub(super) fn coincidence(&self, vertices: [u32; 2], frames: &[&[Point]]) -> Coincidence {
        if self.is_welded() {
            return Coincidence::Other;
        }
        let mut welding = Welding::default();
        let range = self.vertices.start as usize..self.vertices.end as usize;
        for positions in frames {
            welding.restrict(&positions[range.clone()]);
        }
        let welding = welding.along_edges(self.mesh());
        let vertices = vertices.map(|vertex| vertex - self.vertices.start);
        let [v, w] = vertices.map(|vertex| welding.vertex_of(vertex));
        if v != w {
            return Coincidence::Other;
        }
        let rim = rim(self.mesh());
        let is_at_rim = |vertex| rim.iter().any(|edge| edge.contains(&vertex));
        let has_layers = welding
            .mesh(self.mesh())
            .is_ok_and(|mesh| has_a_face_twice(&mesh));
        if vertices.into_iter().all(is_at_rim) && !has_layers {
            Coincidence::Seam
        } else {
            Coincidence::Layers
        }
    }

    /// Adds a note about the vertices that a tolerance has joined.
    pub(super) fn note_joined(&self, tolerance: f64, notes: &mut Notes) {
        let (count, most) = self.joined();
        if count > 0 {
            notes.note(format!(
                "--weld={} joins {count} vertices of the part {} to others, up to {} away in the first frame: they move \
                 as these, and the answer is about the mesh so changed",
                shortest(tolerance),
                self.name,
                shortest(most)
            ));
        }
    }

    /// Adds a note about vertices at seams that are nearly, but not quite, in one place in a frame.
    pub(super) fn note_near_vertices(&self, positions: &[Point], notes: &mut Notes) {
        let sides = positions.iter().copied().collect::<Aabb>().sides();
        let tolerance = NEAR * sides[0].hypot(sides[1]).hypot(sides[2]);
        if !tolerance.is_normal() {
            return;
        }
        let rim = TriangleMesh::with_edges(positions.len(), Vec::new(), &rim(self.mesh()));
        let (rim, vertices) = rim.unwrap_or_default().without_unused_vertices();
        let at_rim: Vec<Point> = vertices
            .iter()
            .map(|&vertex| positions[vertex as usize])
            .collect();
        let count = |restrict: &dyn Fn(&mut Welding)| {
            let mut welding = Welding::default();
            restrict(&mut welding);
            welding.along_edges(&rim).first_vertices().len()
        };
        let exact = count(&|welding| welding.restrict(&at_rim));
        let near = count(&|welding| welding.restrict_within(&at_rim, tolerance));
        if exact > near {
            let tolerance = shortest(first_digits(tolerance));
            notes.note(format!(
                "{} vertices of the part {} are at seams, less than {tolerance} from others but not in the same place; \
                 --weld={tolerance} joins them",
                exact - near,
                self.name
            ));
        }
    }
}

/// Two significant digits, rounded up.
fn first_digits(value: f64) -> f64 {
    format!("{:.1e}", value * 1.05).parse().unwrap_or(value)
}

/// The edges of one face, and the loose ones.
fn rim(mesh: &TriangleMesh) -> Vec<[u32; 2]> {
    let edges = mesh.edges().iter().zip(mesh.face_counts());
    edges
        .filter(|(_, count)| *count < 2)
        .map(|(edge, _)| *edge)
        .collect()
}

/// Returns true if two faces have the same corners, in any order.
fn has_a_face_twice(mesh: &TriangleMesh) -> bool {
    let sorted = |face: &[u32; 3]| {
        let mut face = *face;
        face.sort_unstable();
        face
    };
    let mut faces: Vec<_> = mesh.faces().iter().map(sorted).collect();
    faces.sort_unstable();
    faces.windows(2).any(|pair| pair[0] == pair[1])
}
