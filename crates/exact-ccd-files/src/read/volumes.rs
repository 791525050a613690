//! The signs of the volumes of tetrahedra.

use std::cmp::Ordering;

use exact_ccd::predicates::orient3d;
use exact_ccd_mesh::Point;

use super::solids::Solid;
use crate::error::Place;
use crate::note::{Fact, Note};

/// Notes about tetrahedra that are inverted or flat, by the exact signs of their volumes. All positions are
/// finite.
pub(super) fn notes(solids: &[Solid], positions: &[Point]) -> impl Iterator<Item = Note> {
    let (mut positive, mut negative, mut flat) = (0, 0, 0);
    for solid in solids {
        if let Solid::Tetrahedron(corners) = solid {
            let side = orient3d(corners.map(|vertex| positions[vertex as usize]));
            *match side {
                Ok(Ordering::Less) => &mut positive,
                Ok(Ordering::Greater) => &mut negative,
                Ok(Ordering::Equal) | Err(_) => &mut flat,
            } += 1;
        }
    }
    let (inverted, of) = (negative.min(positive), positive + negative + flat);
    let inverted = (inverted > 0).then_some(Fact::Inverted { count: inverted, of });
    let flat = (flat > 0).then_some(Fact::Flat { count: flat, of });
    [inverted, flat]
        .into_iter()
        .flatten()
        .map(|fact| fact.at(Place::File))
}
