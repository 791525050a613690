//! The ladder of the filters, from the cheapest to the costliest, for one query or for several side
//! by side.

use super::alongside;
use super::coincident::coincidence;
use super::contact::{Contact, Unknown};
use super::coplanarity::Coplanarity;
use super::cubic::Cubic;
use super::fixed_width;
use super::hull::Hull;
use super::number::{Lanes, Points};
use super::planar::Planar;
use crate::kind::Kind;
use crate::query::Query;
use crate::stage::Stage;

/// The outcome of the filters.
pub(crate) enum Decision {
    /// There is no contact, proved at this stage.
    Free(Stage),
    /// There is a contact.
    Contact(Contact),
    /// The filters prove neither.
    Unknown,
}

/// Decides contact as far as the filters can.
#[inline]
pub(crate) fn decide<K: Kind>(query: &Query<K>) -> Decision {
    let hull = Hull::new::<K>(query.points());
    if hull.box_excludes_origin() {
        return Decision::Free(Stage::BoundingBox);
    }
    if hull.diagonal_separates() {
        return Decision::Free(Stage::Diagonals);
    }
    if hull.is_out_of_range() {
        return Decision::Unknown;
    }
    let coplanarity = Coplanarity::new::<K>(query.points());
    if hull.separates(coplanarity.normals[0]) || hull.separates(coplanarity.normals[1]) {
        return Decision::Free(Stage::Normals);
    }
    if coplanarity.cubic.constant_sign().is_some() {
        return Decision::Free(Stage::Coplanarity);
    }
    decide_near_plane(query, &coplanarity.cubic)
}

/// Queries side by side after the stages `Normals` and `Coplanarity`.
pub(crate) struct Screened<T: Lanes> {
    /// True where these stages prove that there is no contact.
    pub(crate) settled: T::Mask,
    /// True where the coordinates are out of the range of all filters.
    pub(crate) out_of_range: T::Mask,
    /// The coplanarity cubics, for [`decide_near_plane`].
    pub(crate) cubic: Cubic<T>,
}

/// Passes queries side by side through the stages `Normals` and `Coplanarity`.
#[inline(always)]
pub(crate) fn screen_planes<K: Kind, T: Lanes>(points: &Points<T>) -> Screened<T> {
    let hull = Hull::new::<K>(points);
    let Coplanarity {
        cubic,
        normals: [start, end],
        ..
    } = Coplanarity::new::<K>(points);
    let [positive, negative] = cubic.constant_signs();
    let out_of_range = hull.is_out_of_range();
    let settled = hull.separates(start) | hull.separates(end) | positive | negative;
    Screened {
        settled: settled & !out_of_range,
        out_of_range,
        cubic,
    }
}

/// The last stages, for a query in range that [`screen_planes`] has not settled.
///
/// Few candidates get here. It is not inlined, so that the stages above stay small.
#[inline(never)]
pub(crate) fn decide_near_plane<K: Kind>(query: &Query<K>, cubic: &Cubic<f64>) -> Decision {
    if let Some(roots) = cubic.roots() {
        return match Contact::at_roots(query, roots) {
            Ok(Some(contact)) => Decision::Contact(contact),
            Ok(None) => Decision::Free(Stage::Roots),
            Err(Unknown) => decide_in_integers(query),
        };
    }
    if let Some(coincidence) = coincidence(query, cubic) {
        return Decision::Contact(Contact::Coincident(coincidence));
    }
    let hull = Hull::new::<K>(query.points());
    if alongside::separates(query, &hull) || hull.some_direction_separates() {
        return Decision::Free(Stage::Direction);
    }
    match Planar::new(query).and_then(|planar| planar.beginning()) {
        Some(Some(beginning)) => Decision::Contact(Contact::Sliding(beginning)),
        Some(None) => Decision::Free(Stage::Planar),
        None => decide_in_integers(query),
    }
}

/// The last stage before the exact path.
fn decide_in_integers<K: Kind>(query: &Query<K>) -> Decision {
    match fixed_width::first_moment(query) {
        Some(Some(moment)) => Decision::Contact(Contact::AtMoment(moment)),
        Some(None) => Decision::Free(Stage::FixedWidth),
        None => Decision::Unknown,
    }
}
