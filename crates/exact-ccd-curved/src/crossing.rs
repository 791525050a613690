//! Proof of a contact that is stable: the primitives pass through each other.

use exact_ccd::{CONTACT, Query, Separation, VertexEdge};
use exact_ccd_mesh::vector::dot;

use crate::kind::CurvedKind;
use crate::straight::Straight;

/// Returns true if the curved primitives are certainly in contact at some time between the start and
/// the end.
///
/// Let F map the prism or cube of (t, u, v) to the difference of two points, on the curves, and F′ the
/// same on the chords: |F − F′| ≤ Δ. If |F′| > Δ on the boundary of the domain, then no map
/// (1 − σ) F′ + σ F has a root there, for σ from 0 to 1, and the degree of F on the domain is the degree
/// of F′. If that is not 0, F has a root. The boundary consists of the two ends in time and the sides. At
/// each side, a vertex meets an edge.
///
/// The degree of F′ is ±1 if the chords touch at one time only, and pass through each other then. No
/// vertex is on an edge at that time, so that the normal n = e₁ × e₂ is not 0, and F′ has one root. Near it,
/// one pair (u, v) for each t makes F′ parallel to n, and then F′ · n is the coplanarity c(t). So the
/// degree is, up to its sign, the degree of c at that time: ±1 if c changes its sign, otherwise 0.
pub(crate) fn is_certain<K: CurvedKind>(straight: &Straight<K>) -> bool {
    let Some(sides) = K::BOUNDARY else {
        return false;
    };
    let Ok(margin) = Separation::new(straight.deviation) else {
        return false;
    };
    let [start, end] = *straight.query.points();
    let is_apart_at = |now| Query::<K>::new(now, now).is_ok_and(|query| !query.collides(margin));
    let is_apart_on = |side: &[usize; 3]| {
        let [start, end] = [start, end].map(|points| side.map(|point| points.as_ref()[point]));
        Query::<VertexEdge>::new(start, end).is_ok_and(|query| !query.collides(margin))
    };
    is_apart_at(start)
        && is_apart_at(end)
        && passes_through::<K>([start, end])
        && sides.iter().all(is_apart_on)
}

/// Returns true if primitives that do not touch on the boundary of the domain touch at one time only, and
/// their coplanarity changes its sign then.
///
/// The normal of the earliest contact is on the side of the first primitive just before it. The normal of
/// the reversed motion is on the side just after the latest contact. Both are within 2⁻³² of ±n / |n|.
fn passes_through<K: CurvedKind>([start, end]: [K::Points; 2]) -> bool {
    let normal = |from, to| Query::<K>::new(from, to).ok()?.impact(CONTACT)?.normal;
    let touches_once =
        Query::<K>::new(start, end).is_ok_and(|query| query.intervals(CONTACT).count() == Some(1));
    let (Some(before), Some(after)) = (normal(start, end), normal(end, start)) else {
        return false;
    };
    touches_once && dot(before, after) < 0.0
}
