//! The ladder of the filters, from the cheapest to the costliest, for one query or for several side
//! by side.

use super::coplanarity::Coplanarity;
use super::decision::Decision;
use super::gap::{Gap, Touching, Within};
use super::hull::Hull;
use super::near_plane::decide_near_plane;
use super::within;
use crate::numbers::cubic::Cubic;
use crate::numbers::number::Lanes;
use crate::tables::{Points, Tables};
use crate::values::{CONTACT, Options, Separation, Stage};

/// Decides whether primitives touch, as far as the filters can.
#[inline(always)]
pub(crate) fn decide<K: Tables>(points: &Points<f64>, options: &Options) -> Decision {
    if !options.separation.is_zero() {
        return decide_within::<K>(points, options);
    }
    match screen::<K, _>(points, &Hull::new::<K>(points), Touching) {
        Ok(Some(cubic)) => decide_near_plane::<K>(points, &cubic, options.until),
        Ok(None) => Decision::Unknown,
        Err(stage) => Decision::Free(stage),
    }
}

/// The same for a separation above 0; apart, so that contact stays fast.
#[inline(never)]
fn decide_within<K: Tables>(points: &Points<f64>, options: &Options) -> Decision {
    let hull = Hull::new::<K>(points);
    match screen::<K, _>(points, &hull, Within(options.separation.get())) {
        Ok(_) => within::decide::<K>(points, &hull, options),
        Err(stage) => Decision::Free(stage),
    }
}

/// Decides a query of a batch whose primitives are known to be beyond d before the first of two times. A
/// collision after the second time, which is above 0, may be left out. If some vertices of the batch have the
/// thickness 0, d can be 0: then the stages of contact decide.
pub(crate) fn decide_between<K: Tables>(points: &Points<f64>, d: Separation, times: [f64; 2]) -> Decision {
    if d.is_zero() {
        return decide::<K>(points, &CONTACT);
    }
    within::decide_after::<K>(points, &Hull::new::<K>(points), d, times)
}

/// Passes a query through the stages that contact and a separation above 0 have in common: the stage that
/// proves that the primitives do not touch, otherwise the coplanarity cubic, or none if coordinates are out
/// of the range of the filters.
#[inline(always)]
fn screen<K: Tables, G: Gap<f64>>(
    points: &Points<f64>,
    hull: &Hull<f64>,
    gap: G,
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
    let coplanarity = Coplanarity::new::<K>(points);
    let [start, end] = coplanarity.normals;
    if hull.is_beyond(start, gap) || hull.is_beyond(end, gap) {
        return Err(Stage::Normals);
    }
    if G::IS_POSITIVE && hull.some_direction_separates::<K>(gap) {
        return Err(Stage::Direction);
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
pub(crate) fn screen_planes<K: Tables, T: Lanes>(points: &Points<T>, gap: impl Gap<T>) -> Screened<T> {
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
