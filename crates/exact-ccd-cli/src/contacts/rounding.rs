//! Contacts that rounding to single precision alone may have made.

use exact_ccd::{Point, with_kind};
use exact_ccd_mesh::{Contact, TriangleMesh};

use super::record::ContactRecord;
use crate::text::numbers::shortest;

/// The number of bits that the numbers of exact models have at most, such as 0.25 or 1000. Longer `f32` are
/// probably rounded.
const SHORT: u32 = 20;

/// A note about a contact, in a step between positions, if it is shallower than the rounding of these
/// positions to single precision: the primitives are past each other at the end by less than a unit in the
/// last place.
///
/// It is about vertices whose coordinates are all `f32`, and not all short. The depth is computed in floating
/// point: the note is about what the contact may mean, and the contact is exact in any case.
pub(crate) fn note_of_rounding(
    mesh: &TriangleMesh,
    ends: [&[Point]; 2],
    contact: &Contact,
    record: &ContactRecord,
) -> Option<String> {
    let normal = contact.impact.normal.filter(|_| contact.distance.upper == 0.0)?;
    let weights = with_kind!(contact.pair.kind(), K => {
        let vertices = <K as exact_ccd_mesh::PairKind>::vertices(mesh, contact.pair.ids())?;
        let weights = contact.impact.weights::<K>();
        let all = vertices.as_ref().iter().copied().zip(weights);
        all.collect::<Vec<(u32, f64)>>()
    });
    let points = |x: &[Point]| {
        weights
            .iter()
            .map(|&(vertex, _)| x[vertex as usize])
            .collect::<Vec<_>>()
    };
    let all = ends.map(points).concat();
    let coordinates = all.as_flattened();
    let is_single = coordinates.iter().all(|&x| f64::from(x as f32) == x);
    if !is_single || coordinates.iter().all(|&x| is_short(x)) {
        return None;
    }
    // The weights sum to 0: so the gap does not depend on the origin, which is one of the vertices.
    let [_, x1] = ends;
    let (first, _) = weights.first()?;
    let origin = x1[*first as usize];
    let along = |vertex: u32| -> f64 {
        let axes = x1[vertex as usize].into_iter().zip(origin).zip(normal);
        axes.map(|((x, x0), n)| (x - x0) * n).sum()
    };
    let depth = weights
        .iter()
        .map(|&(vertex, weight)| weight * along(vertex))
        .sum::<f64>()
        .abs();
    let largest = coordinates.iter().fold(0.0, |most: f64, x| most.max(x.abs())) as f32;
    let unit = f64::from(largest.next_up() - largest);
    (depth < unit).then(|| {
        format!(
            "{record} touch only because of rounding, perhaps: the positions are in single precision, and the contact \
             is {} deep at the end of the step, less than a unit in their last place, {}",
            shortest(f64::from(depth as f32)),
            shortest(unit)
        )
    })
}

/// Returns true for a number with few significant bits.
fn is_short(x: f64) -> bool {
    const LAST: u64 = (1 << (f64::MANTISSA_DIGITS - SHORT)) - 1;
    x.to_bits() & LAST == 0
}
