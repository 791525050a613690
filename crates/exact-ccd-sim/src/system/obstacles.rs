//! The obstacles of a system, and their motions relative to each other.

use std::ops::Range;

use exact_ccd_mesh::CanCollide;

use crate::energies::contact::Part;
use crate::prescribed::Coordinates;

/// The part in contact of each vertex of some bodies.
pub(super) fn contact_parts(
    bodies: &[Range<u32>],
    is_obstacle: &[bool],
    scripts: &[Coordinates],
) -> Vec<Part> {
    let part = |(number, range): (u32, &Range<u32>)| {
        let vertices = range.start as usize..range.end as usize;
        let scripts = &scripts[vertices.clone()];
        let is_rigid = scripts.windows(2).all(|pair| pair[0] == pair[1])
            && scripts.first().is_none_or(Coordinates::are_rigid);
        let part = if is_obstacle[vertices.clone()].contains(&false) {
            Part::Body
        } else if !is_rigid {
            Part::DeformingObstacle
        } else if scripts.iter().all(Coordinates::are_fixed) {
            Part::Obstacle { motion: 0 }
        } else {
            Part::Obstacle { motion: number }
        };
        std::iter::repeat_n(part, vertices.len())
    };
    (1..).zip(bodies).flat_map(part).collect()
}

/// The pairs of obstacles of different motions, and the pairs within obstacles that do not move as a whole.
/// `None` if there are none.
pub(super) fn obstacle_pairs(parts: Vec<Part>) -> Option<CanCollide> {
    let are_together = |a: Part, b: Part| a == b && a != Part::DeformingObstacle;
    let obstacles = || parts.iter().filter(|part| **part != Part::Body);
    let first = *obstacles().next()?;
    if obstacles().all(|part| are_together(*part, first)) {
        return None;
    }
    // A primitive belongs to one body.
    let part = move |primitive: &[u32]| {
        primitive
            .first()
            .map_or(Part::Body, |&vertex| parts[vertex as usize])
    };
    Some(CanCollide::new(move |a, b| {
        let [a, b] = [part(a), part(b)];
        a != Part::Body && b != Part::Body && !are_together(a, b)
    }))
}
