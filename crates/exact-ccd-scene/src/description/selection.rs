//! Selections of vertices of a body.

use exact_ccd_files::Group;
use exact_ccd_mesh::{Aabb, Point};

use super::Selection;

impl Selection {
    /// The selection of these vertices, of a body with these placed points: their bounding box if it contains
    /// no other vertex, otherwise their numbers.
    pub fn of_vertices(selected: &[u32], points: &[Point]) -> Self {
        if selected.len() == points.len() {
            return Self::All;
        }
        let bounds: Aabb = selected.iter().map(|&vertex| points[vertex as usize]).collect();
        if points.iter().filter(|point| bounds.contains(point)).count() == selected.len() {
            let Aabb { lower, upper } = bounds;
            Self::Box { lower, upper }
        } else {
            Self::Vertices(selected.to_vec())
        }
    }

    /// The selected vertices of a body with these placed points and the groups of its mesh, or the reason why
    /// there are none. `first` is the body's first vertex in the system.
    pub(crate) fn vertices(
        &self,
        points: &[Point],
        groups: &[Group],
        first: u32,
    ) -> Result<Vec<u32>, String> {
        let count = points.len() as u32;
        let mut selected = match self {
            Self::All => (0..count).collect(),
            Self::Vertices(vertices) => match vertices.iter().find(|&&vertex| vertex >= count) {
                Some(vertex) => {
                    return Err(format!(
                        "the body has no vertex {vertex}, expected numbers from 0, below {count}"
                    ));
                }
                None if vertices.is_empty() => {
                    return Err("no vertex is selected, expected at least one number".to_owned());
                }
                None => vertices.clone(),
            },
            Self::Group(key) => {
                let found = key.find(groups)?;
                let mut vertices: Vec<u32> =
                    found.iter().flat_map(|group| &group.vertices).copied().collect();
                vertices.sort_unstable();
                vertices.dedup();
                vertices
            }
            Self::Box { lower, upper } => in_box(*lower, *upper, points)?,
        };
        selected.iter_mut().for_each(|vertex| *vertex += first);
        Ok(selected)
    }
}

/// The points in a box.
fn in_box(lower: Point, upper: Point, points: &[Point]) -> Result<Vec<u32>, String> {
    if (0..3).any(|axis| lower[axis] > upper[axis]) {
        return Err(format!(
            "the box from {lower:?} to {upper:?} is empty, expected `lower` not above `upper`"
        ));
    }
    let bounds = Aabb { lower, upper };
    let inside = (0..).zip(points).filter(|(_, point)| bounds.contains(point));
    let selected: Vec<u32> = inside.map(|(vertex, _)| vertex).collect();
    if selected.is_empty() {
        let Aabb { lower, upper } = points.iter().copied().collect();
        return Err(format!(
            "the box contains no vertex of the body, expected a box that meets the placed body, \
             which extends from {lower:?} to {upper:?}"
        ));
    }
    Ok(selected)
}
