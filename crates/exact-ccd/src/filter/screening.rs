//! The ladder of the filters, from the cheapest to the costliest, for one query or for several side
//! by side.

use super::alongside;
use super::coincident::coincidence;
use super::contact::{Contact, Unknown};
use super::coplanarity::Coplanarity;
use super::cubic::{Cubic, Root};
use super::fixed_width;
use super::gap::{Gap, Touching, Within};
use super::hull::Hull;
use super::nearness;
use super::number::{Lanes, Points};
use super::planar::Planar;
use super::position::{self, Position};
use crate::kind::Kind;
use crate::options::Options;
use crate::query::Query;
use crate::stage::Stage;
use crate::time::ContactTime;

/// The outcome of the filters.
pub(crate) enum Decision {
    /// The primitives do not touch until the last time that counts, proved at this stage.
    Free(Stage),
    /// The primitives touch.
    Collision(Proved),
    /// The filters prove neither.
    Unknown,
}

/// The proof that primitives touch.
pub(crate) enum Proved {
    Contact(Contact),
    /// The first time within a separation above 0, and the stage that found it.
    Within(ContactTime, Stage),
}

/// Decides whether primitives touch, as far as the filters can.
#[inline(always)]
pub(crate) fn decide<K: Kind>(query: &Query<K>, options: &Options) -> Decision {
    if !options.separation.is_zero() {
        return decide_within(query, options);
    }
    match screen(query, &Hull::new::<K>(&query.four()), Touching) {
        Ok(Some(cubic)) => decide_near_plane(query, &cubic, options.until),
        Ok(None) => Decision::Unknown,
        Err(stage) => Decision::Free(stage),
    }
}

/// The same for a separation above 0; apart, so that contact stays fast.
#[inline(never)]
fn decide_within<K: Kind>(query: &Query<K>, options: &Options) -> Decision {
    let hull = Hull::new::<K>(&query.four());
    match screen(query, &hull, Within(options.separation.get())) {
        Ok(_) => nearness::decide(query, &hull, options),
        Err(stage) => Decision::Free(stage),
    }
}

/// Passes a query through the stages that contact and a separation above 0 have in common: the stage that
/// proves that the primitives do not touch, otherwise the coplanarity cubic, or none if coordinates are out
/// of the range of the filters.
#[inline(always)]
fn screen<K: Kind>(
    query: &Query<K>,
    hull: &Hull<f64>,
    gap: impl Gap<f64>,
) -> Result<Option<Cubic<f64>>, Stage> {
    if hull.is_beyond_axis(gap) {
        return Err(Stage::BoundingBox);
    }
    if hull.is_beyond_diagonal(gap) {
        return Err(Stage::Diagonals);
    }
    if hull.is_out_of_range(gap) {
        return Ok(None);
    }
    let coplanarity = Coplanarity::new::<K>(&query.four());
    let [start, end] = coplanarity.normals;
    if hull.is_beyond(start, gap) || hull.is_beyond(end, gap) {
        return Err(Stage::Normals);
    }
    if coplanarity.are_planes_beyond(gap) {
        return Err(Stage::Coplanarity);
    }
    Ok(Some(coplanarity.cubic))
}

/// Queries side by side after the stages `Normals` and `Coplanarity`.
pub(crate) struct Screened<T: Lanes> {
    /// True where these stages prove that the primitives do not touch.
    pub(crate) settled: T::Mask,
    /// True where the coordinates are out of the range of these filters.
    pub(crate) out_of_range: T::Mask,
    /// The coplanarity cubics, for [`decide_near_plane`].
    pub(crate) cubic: Cubic<T>,
}

/// Passes queries side by side through the stages `Normals` and `Coplanarity`.
#[inline(always)]
pub(crate) fn screen_planes<K: Kind, T: Lanes>(points: &Points<T>, gap: impl Gap<T>) -> Screened<T> {
    let hull = Hull::new::<K>(points);
    let coplanarity = Coplanarity::new::<K>(points);
    let [start, end] = coplanarity.normals;
    let out_of_range = hull.is_out_of_range(gap);
    let settled = hull.is_beyond(start, gap) | hull.is_beyond(end, gap) | coplanarity.are_planes_beyond(gap);
    Screened {
        settled: settled & !out_of_range,
        out_of_range,
        cubic: coplanarity.cubic,
    }
}

/// The last stages of contact until a time, for a query in range that the stages before have not settled. A
/// contact that is later may be found or not.
///
/// Few candidates get here. It is not inlined, so that the stages above stay small.
#[inline(never)]
pub(crate) fn decide_near_plane<K: Kind>(query: &Query<K>, cubic: &Cubic<f64>, until: f64) -> Decision {
    if (0.0..1.0).contains(&until)
        && let Some(decision) = decide_until(query, cubic, until)
    {
        return decision;
    }
    if let Some(roots) = cubic.roots() {
        return match Contact::at_roots(query, roots) {
            Ok(Some(contact)) => Decision::Collision(Proved::Contact(contact)),
            Ok(None) => Decision::Free(Stage::Roots),
            Err(Unknown) => decide_in_integers(query),
        };
    }
    if let Some(coincidence) = coincidence(query, cubic) {
        return Decision::Collision(Proved::Contact(Contact::Coincident(coincidence)));
    }
    let hull = Hull::new::<K>(&query.four());
    if alongside::separates(query, &hull) {
        return Decision::Free(Stage::Direction);
    }
    match Planar::new(query).and_then(|planar| planar.stretches()) {
        Some(stretches) => match stretches.into_iter().next() {
            Some([beginning, _]) => Decision::Collision(Proved::Contact(Contact::Sliding(beginning))),
            None => Decision::Free(Stage::Planar),
        },
        None => match decide_in_integers(query) {
            Decision::Unknown if hull.some_direction_separates() => Decision::Free(Stage::Direction),
            decision => decision,
        },
    }
}

/// The decision if the primitives certainly are not coplanar before a time, by the cubic there, which is
/// computed in integers where its sign is not certain.
///
/// In a search for the earliest contact, many pairs may touch at almost the same time, or at the same one.
fn decide_until<K: Kind>(query: &Query<K>, cubic: &Cubic<f64>, until: f64) -> Option<Decision> {
    let [before, at_end] = cubic.signs_until(until)?;
    let (before, at_end) = (before?, at_end.or_else(|| fixed_width::sign_at(query, until))?);
    if at_end == before {
        return Some(Decision::Free(Stage::Roots));
    }
    if at_end.is_ne() {
        return None;
    }
    let root = Root::exactly(until, before);
    Some(match position::at(query, &root)? {
        Position::Inside => Decision::Collision(Proved::Contact(Contact::At(root))),
        Position::Outside => Decision::Free(Stage::Roots),
    })
}

/// The stage of integers of fixed width.
fn decide_in_integers<K: Kind>(query: &Query<K>) -> Decision {
    match fixed_width::first_moment(query) {
        Some(Some(moment)) => Decision::Collision(Proved::Contact(Contact::AtMoment(moment))),
        Some(None) => Decision::Free(Stage::FixedWidth),
        None => Decision::Unknown,
    }
}
