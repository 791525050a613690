//! Contact decided by the signs of integers of fixed width.
//!
//! Where primitives are flat, parallel and in touch, the numbers whose signs decide are zero, or so near to
//! it that no error bound of floating point proves a sign. They are computed exactly here. Contact at t = 0
//! is that of four points at rest. Later, the roots of the cubic are those of its exact coefficients, each
//! rounded only once.

use core::cmp::Ordering;

use super::cubic::Root;
use super::dyadic::Dyadic;
use super::fraction::Fraction;
use super::lattice::Integers;
use super::length::Volume;
use super::moment::Moment;
use super::precise_cubic::PreciseCubic;
use super::wide::Wide;
use super::window::{self, Window};
use super::zeros::{Moments, insert, largest, narrowed, zeros};
use crate::interval::{Interval, Intervals};
use crate::kind::Kind;
use crate::query::Query;
use crate::time::ContactTime;

const AT_START: Moment = Moment::At(Fraction::START);

/// The moment of the first contact; `Some(None)` if there certainly is no contact, `None` if that is unknown.
#[inline(never)]
pub(super) fn first_moment<K: Kind>(query: &Query<K>) -> Option<Option<Moment>> {
    let integers = Integers::new(query)?;
    if integers.volume_at_start().is_zero() && integers.touches(&AT_START)? {
        return Some(Some(AT_START));
    }
    let cubic = integers.rest_of_cubic();
    if cubic == [Volume::ZERO; 4] {
        let touches = integers.touches(&Moment::Later)?;
        return (!touches).then_some(None);
    }
    for moment in coplanar(&integers, &cubic)? {
        let (moment, touches) = decided(&integers, &cubic, moment)?;
        if touches {
            return Some(Some(moment));
        }
    }
    Some(None)
}

/// The first time of contact, if it is certain.
pub(super) fn first<K: Kind>(query: &Query<K>) -> Option<ContactTime> {
    time(query, &first_moment(query)??)
}

/// All times of contact, if they certainly are isolated moments.
pub(super) fn moments<K: Kind>(query: &Query<K>) -> Option<Intervals> {
    let integers = Integers::new(query)?;
    let cubic = integers.rest_of_cubic();
    if cubic == [Volume::ZERO; 4] {
        let only_at_start = integers.touches(&AT_START)? && !integers.touches(&Moment::Later)?;
        return only_at_start.then(|| {
            [Interval::moment(ContactTime::exactly(0.0))]
                .into_iter()
                .collect()
        });
    }
    let of_contact = coplanar(&integers, &cubic)?.into_iter().filter_map(|moment| {
        match decided(&integers, &cubic, moment) {
            Some((_, false)) => None,
            Some((moment, true)) => Some(rounded(&cubic, &moment)),
            None => Some(None),
        }
    });
    of_contact.map(|time| time.map(Interval::moment)).collect()
}

/// The moments at which the points are coplanar, with the cubic without its factors, if they are certain.
fn coplanar<K: Kind>(integers: &Integers<K>, cubic: &[Volume; 4]) -> Option<Moments> {
    let mut moments = zeros(cubic)?;
    for &time in integers.zeros_of_factors() {
        insert(&mut moments, cubic, time)?;
    }
    Some(moments)
}

/// A moment at which the cubic vanishes, in a narrower window if that is necessary, and true if the
/// primitives touch then; `None` if that is not certain.
fn decided<K: Kind>(integers: &Integers<K>, cubic: &[Volume; 4], moment: Moment) -> Option<(Moment, bool)> {
    if let Some(touches) = integers.touches(&moment) {
        return Some((moment, touches));
    }
    let narrow = narrowed(cubic, &moment)?;
    let touches = integers.touches(&narrow)?;
    Some((narrow, touches))
}

/// The time of a root of the coplanarity cubic in a bracket.
pub(super) fn round<K: Kind>(query: &Query<K>, root: &Root) -> Option<ContactTime> {
    rounded(&Integers::new(query)?.cubic(), &Moment::Root(Window::STEP, *root))
}

/// The time of a moment of contact. One that is known needs no integers.
pub(super) fn time<K: Kind>(query: &Query<K>, moment: &Moment) -> Option<ContactTime> {
    if let Moment::At(time) = moment {
        return Some(time.time());
    }
    rounded(&Integers::new(query)?.rest_of_cubic(), moment)
}

/// The time at which a cubic vanishes, if it is certain.
///
/// In flat worlds, many are multiples of 2⁻¹⁰. In the step as a window, twice the precision suffices for most
/// others.
fn rounded(cubic: &[Volume; 4], moment: &Moment) -> Option<ContactTime> {
    const DIGITS: u32 = 10;
    match moment {
        Moment::At(time) => Some(time.time()),
        Moment::Root(window, root) => {
            let shortest = window.shortest(root).filter(|time| time.digits() <= DIGITS);
            if let Some(time) = shortest.filter(|&time| window::sign_at(cubic, time).is_eq()) {
                return Some(Fraction::from(time).time());
            }
            let is_step = *window == Window::STEP;
            let precise = is_step.then(|| between_adjacent(cubic, root)).flatten();
            precise.or_else(|| window.time(cubic, root))
        }
        // An interval of times has none.
        Moment::Later => None,
    }
}

/// The time of a root of the step between two adjacent f64, if the signs of the cubic at both are certain.
fn between_adjacent(cubic: &[Volume; 4], root: &Root) -> Option<ContactTime> {
    let (precise, [c0, c1, c2, c3]) = precise(cubic);
    // The slope in the units of the integers.
    let [a1, a2, a3] = [c1 - 3.0 * c0, c2 - 2.0 * c1 + 3.0 * c0, c3 - c2 + c1 - c0];
    let slope = (3.0 * a3 * root.near + 2.0 * a2) * root.near + a1;
    precise.round(&Root { slope, ..*root })
}

/// The signs of the Bernstein coefficients of the coplanarity cubic until a time, if that is a multiple
/// of the unit of windows.
#[inline(never)]
pub(super) fn signs_until<K: Kind>(query: &Query<K>, time: f64) -> Option<[Ordering; 4]> {
    let window = Window::new(Dyadic::START, Dyadic::new(time)?)?;
    let cubic = Integers::new(query)?.cubic();
    Some(window.cubic(&cubic).map(|coefficient| coefficient.sign()))
}

/// The cubic in twice the precision, and its coefficients, rounded.
///
/// The bound of [`PreciseCubic::new`] holds with the largest coefficient as magnitude: one in twice the
/// precision is off by 2⁻¹⁰⁴ of itself, less than one operation, of which seven lead to a coefficient there.
fn precise(cubic: &[Volume; 4]) -> (PreciseCubic, [f64; 4]) {
    let values = cubic.map(Wide::approximate);
    let rounded = values.map(|value| value.high);
    (PreciseCubic::new(values, largest(rounded)), rounded)
}

#[cfg(test)]
mod tests;
