//! The search of the parts of a step, from the left.

use arrayvec::ArrayVec;

use super::corners::Corners;
use super::piece::Piece;
use crate::filter::gap::Gap;
use crate::tables::Tables;

/// The most halvings of the step.
const LEVELS: u32 = 16;

/// The most parts that are examined. A pair that passes by needs two for each halving.
const PARTS: usize = 64;

/// The outcome of the filters for motion on curves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum CurvedDecision {
    /// The primitives do not touch until the last time that counts.
    Free,
    /// The primitives first touch between these two times, and only where the volume of the corners vanishes
    /// there, which it does not at these two. If `is_simple`, it has one root there.
    Touching { times: [f64; 2], is_simple: bool },
    /// The filters prove neither.
    Unknown,
}

/// Halves the step until each part is proved to be free, or the first contact is proved in one.
///
/// Parts are halved from the left, so that all before the first one that remains are free.
pub(super) fn search<K: Tables, G: Gap<f64>>(corners: &Corners, gap: G, until: f64) -> CurvedDecision {
    let mut parts = ArrayVec::<Piece<'_>, { LEVELS as usize + 1 }>::new();
    parts.push(Piece::whole(corners));
    // The nearest direction to begin with: any will do.
    let mut direction = [1.0, 0.0, 0.0];
    for _ in 0..PARTS {
        let Some(part) = parts.pop() else {
            return CurvedDecision::Free;
        };
        // No contact counts after the last time, and none at all if that is not a number.
        let [start, end] = part.times();
        if until.is_nan() || start > until {
            return CurvedDecision::Free;
        }
        if let Some(separating) = part.separating_direction(direction, gap) {
            direction = separating;
            continue;
        }
        if !G::IS_POSITIVE && part.is_crossed::<K>() {
            return CurvedDecision::Touching {
                times: [start, end],
                is_simple: part.has_one_root(),
            };
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
