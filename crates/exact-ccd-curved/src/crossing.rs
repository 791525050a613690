//! Proof of a contact that is stable: the primitives pass through each other.

use exact_ccd::parity::{Displacement, Parity, Rounded};
use exact_ccd::{Query, Separation, VertexEdge};

use crate::kind::{CurvedKind, points};
use crate::rounding::{above, length};
use crate::straight::Straight;

/// Returns true if the curved primitives are certainly in contact at some time between the start and
/// the end.
///
/// Let F map the prism or cube of (t, u, v) to the difference of two points, on the curves, and F′ the
/// same on the chords, rounded for the parity. |F − F′| ≤ Δ + ρ with the error ρ of that rounding. If
/// |F′| > Δ + ρ on the boundary of the domain, then no map (1 − σ) F′ + σ F has a root there, for σ from 0
/// to 1, and the degree of F on the domain is that of F′. The number of roots of F′, counted with
/// multiplicity, has the parity of its degree. If it is odd, the degree of F is not 0, and F has a root.
///
/// The boundary are the two ends in time, and the sides, at each of which a vertex meets an edge.
pub(crate) fn is_certain<K: CurvedKind>(straight: &Straight<K>) -> bool {
    let Some(sides) = K::BOUNDARY else {
        return false;
    };
    let query = &straight.query;
    let Ok(rounded) = Rounded::shift(query) else {
        return false;
    };
    // |F′| > Δ + ρ if |F| on the chords is above Δ + 2 ρ. Two points are rounded.
    let displacement = Displacement::of_query(query);
    let four = query.points();
    let errors = four
        .iter()
        .flatten()
        .map(|&point| length(displacement.error(point)));
    let rounding = 2.0 * errors.fold(0.0, |a: f64, b| if b > a || b.is_nan() { b } else { a });
    let Ok(margin) = Separation::new(above(straight.deviation + 2.0 * rounding)) else {
        return false;
    };
    let is_apart_at = |time: usize| {
        let at_rest = points::<K>(|point| four[time][point]);
        Query::<K>::new(at_rest, at_rest).is_ok_and(|query| !query.collides(margin))
    };
    let is_apart_on = |side: &[usize; 3]| {
        let at = |time: usize| side.map(|point| four[time][point]);
        Query::<VertexEdge>::new(at(0), at(1)).is_ok_and(|query| !query.collides(margin))
    };
    [0, 1].into_iter().all(is_apart_at) && rounded.parity() == Parity::Odd && sides.iter().all(is_apart_on)
}
