//! The search of the parts of a step, from the left.

use core::cmp::Ordering;

use arrayvec::ArrayVec;

use super::corners::Corners;
use super::piece::Piece;
use super::place::Place;
use super::volume::Roots;
use crate::filter::gap::Gap;
use crate::tables::Tables;

/// The most halvings of the step.
const LEVELS: u32 = 16;

/// The most halvings towards the only root of the volume.
const LEVELS_OF_ROOT: u32 = 30;

/// The most parts that are examined. A pair that passes by needs two for each halving.
const PARTS: usize = 64;

/// The outcome of the filters for motion on curves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum CurvedDecision {
    /// The primitives do not touch until the last time that counts.
    Free,
    /// The primitives first touch between these two times, and only where the volume of the corners vanishes
    /// there, at one time between these two. Before that, it has this sign.
    Touching { times: [f64; 2], before: Ordering },
    /// The filters prove neither.
    Unknown,
}

/// Halves the step until each part is proved to be free, or the first contact is proved in one.
///
/// Parts are halved from the left, so that all before the first one that remains are free.
pub(super) fn search<K: Tables, G: Gap<f64>>(corners: &Corners, gap: G, until: f64) -> CurvedDecision {
    let crosses = !G::IS_POSITIVE && K::FEATURES.inner.is_some();
    let mut parts = ArrayVec::<Piece<'_>, { LEVELS as usize + 1 }>::new();
    parts.push(Piece::whole(corners));
    // The nearest direction to begin with: any will do.
    let mut direction = [1.0, 0.0, 0.0];
    for _ in 0..PARTS {
        let Some(part) = parts.pop() else {
            return CurvedDecision::Free;
        };
        if is_after(&part, until) {
            return CurvedDecision::Free;
        }
        if let Some(separating) = part.plain_direction(direction, gap) {
            direction = separating;
            continue;
        }
        match if crosses { part.roots() } else { Roots::Unknown } {
            Roots::None => continue,
            Roots::One(before) => match follow::<K>(&part, before, until) {
                CurvedDecision::Free => continue,
                CurvedDecision::Unknown => {}
                touching => return touching,
            },
            Roots::Unknown => {}
        }
        if let Some(separating) = part.iterated_direction(gap) {
            direction = separating;
            continue;
        }
        if part.level() == LEVELS {
            return CurvedDecision::Unknown;
        }
        let [first, second] = part.halves();
        parts.push(second);
        parts.push(first);
    }
    if parts.is_empty() {
        CurvedDecision::Free
    } else {
        CurvedDecision::Unknown
    }
}

/// No contact counts after the last time, and none at all if that is not a number.
fn is_after(part: &Piece<'_>, until: f64) -> bool {
    until.is_nan() || part.times()[0] > until
}

/// Halves a part in which the volume has one root, towards that, until it is certain that the primitives
/// touch there or do not.
fn follow<K: Tables>(part: &Piece<'_>, before: Ordering, until: f64) -> CurvedDecision {
    let mut part = part.clone();
    loop {
        if is_after(&part, until) {
            return CurvedDecision::Free;
        }
        match part.place::<K>() {
            Place::Outside => return CurvedDecision::Free,
            Place::Inside => {
                return CurvedDecision::Touching {
                    times: part.times(),
                    before,
                };
            }
            Place::Unknown if part.level() == LEVELS_OF_ROOT => return CurvedDecision::Unknown,
            Place::Unknown => {}
        }
        let [first, second] = part.halves();
        part = match second.volume_sign(0) {
            Some(sign) if sign == before => second,
            Some(_) => first,
            None => return CurvedDecision::Unknown,
        };
    }
}
