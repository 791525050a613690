//! Selections of vertices by their numbers.

use exact_ccd_mesh::{Aabb, Point};

use crate::description::Selection;

/// The selection of these vertices, of a body with these placed points: their bounding box if it contains no
/// other vertex, otherwise their numbers.
pub(super) fn of_vertices(selected: &[u32], points: &[Point]) -> Selection {
    if selected.len() == points.len() {
        return Selection::All;
    }
    let Aabb { lower, upper } = selected.iter().map(|&vertex| points[vertex as usize]).collect();
    let is_inside = |point: &&Point| (0..3).all(|axis| (lower[axis]..=upper[axis]).contains(&point[axis]));
    if points.iter().filter(is_inside).count() == selected.len() {
        Selection::Box { lower, upper }
    } else {
        Selection::Vertices(selected.to_vec())
    }
}
