//! From the description of a selection to vertices.

use exact_ccd_files::Group;
use exact_ccd_mesh::{Aabb, Point};

use super::description::Selection;

/// The selected vertices of a body, or the reason why there are none. `first` is the body's first vertex in
/// the system.
pub(super) fn select(
    selection: &Selection,
    points: &[Point],
    groups: &[Group],
    first: u32,
) -> Result<Vec<u32>, String> {
    let all = (first..).zip(points);
    let (lower, upper) = match selection {
        Selection::All => return Ok(all.map(|(vertex, _)| vertex).collect()),
        Selection::Vertices(vertices) => return numbered(vertices, points.len(), first),
        Selection::Group(key) => {
            let vertices = key.find(groups)?.into_iter().flat_map(|group| &group.vertices);
            let mut selected: Vec<u32> = vertices.map(|vertex| first + vertex).collect();
            selected.sort_unstable();
            selected.dedup();
            return Ok(selected);
        }
        Selection::Box { lower, upper } => (lower, upper),
    };
    if (0..3).any(|axis| lower[axis] > upper[axis]) {
        return Err(format!(
            "the box from {lower:?} to {upper:?} is empty, expected `lower` not above `upper`"
        ));
    }
    let is_selected = |point: &Point| (0..3).all(|axis| (lower[axis]..=upper[axis]).contains(&point[axis]));
    let selected: Vec<u32> = all
        .filter(|(_, point)| is_selected(point))
        .map(|(vertex, _)| vertex)
        .collect();
    if selected.is_empty() {
        let body: Aabb = points.iter().copied().collect();
        return Err(format!(
            "the box contains no vertex of the body, expected a box that meets the placed body, \
             which extends from {:?} to {:?}",
            body.lower, body.upper
        ));
    }
    Ok(selected)
}

/// The vertices with these numbers of a body.
fn numbered(vertices: &[u32], count: usize, first: u32) -> Result<Vec<u32>, String> {
    match vertices.iter().find(|&&vertex| vertex as usize >= count) {
        Some(vertex) => Err(format!(
            "the body has no vertex {vertex}, expected numbers from 0, below {count}"
        )),
        None if vertices.is_empty() => Err("no vertex is selected, expected at least one number".to_owned()),
        None => Ok(vertices.iter().map(|vertex| first + vertex).collect()),
    }
}
