//! Contact decided by the signs of integers of fixed width.
//!
//! Where primitives are flat, parallel and in touch, the numbers whose signs decide are zero, or so near to
//! it that no error bound of floating point proves a sign. They are computed exactly here. Contact at t = 0
//! is decided for four points at rest. Later, the roots of the cubic are computed from its exact
//! coefficients, each rounded only once.

use core::cmp::Ordering;

use super::coplanar;
use super::dyadic::Dyadic;
use super::exact_cubic::ExactCubic;
use super::fraction::Fraction;
use super::lattice::Integers;
use super::length::Volume;
use super::moment::Moment;
use super::window::Window;
use super::zeros::{Moments, insert, narrowed, zeros};
use crate::tables::{Points, Tables};
use crate::values::{ContactTime, Interval, Intervals};

const AT_START: Moment = Moment::At(Fraction::START);

/// The moment of the first contact; `Some(None)` if there certainly is no contact, `None` if that is unknown.
#[inline(never)]
pub(crate) fn first_moment<K: Tables>(points: &Points<f64>) -> Option<Option<Moment>> {
    let integers = Integers::<K>::new(points)?;
    if integers.volume_at_start().is_zero() && integers.touches(&AT_START)? {
        return Some(Some(AT_START));
    }
    let cubic = integers.rest_of_cubic();
    if cubic == [Volume::ZERO; 4] {
        return match integers.touches(&Moment::Later) {
            Some(touches) => (!touches).then_some(None),
            None => coplanar::first(&integers),
        };
    }
    for moment in moments_in_plane(&integers, &cubic)? {
        let (moment, touches) = integers.decided(moment, |moment| narrower(&cubic, moment))?;
        if touches {
            return Some(Some(moment));
        }
    }
    Some(None)
}

/// The first time of contact, if it is certain.
pub(crate) fn first<K: Tables>(points: &Points<f64>) -> Option<ContactTime> {
    time::<K>(points, &first_moment::<K>(points)??)
}

/// All times of contact, if they certainly are isolated moments.
pub(crate) fn moments<K: Tables>(points: &Points<f64>) -> Option<Intervals> {
    let integers = Integers::<K>::new(points)?;
    let cubic = integers.rest_of_cubic();
    if cubic == [Volume::ZERO; 4] {
        let only_at_start = integers.touches(&AT_START)? && !integers.touches(&Moment::Later)?;
        return only_at_start.then(|| {
            [Interval::moment(ContactTime::exactly(0.0))]
                .into_iter()
                .collect()
        });
    }
    let times = ExactCubic::new(cubic);
    let of_contact = moments_in_plane(&integers, &cubic)?
        .into_iter()
        .filter_map(
            |moment| match integers.decided(moment, |moment| narrower(&cubic, moment)) {
                Some((_, false)) => None,
                Some((moment, true)) => Some(times.time(&moment)),
                None => Some(None),
            },
        );
    of_contact.map(|time| time.map(Interval::moment)).collect()
}

/// The moments at which the points are coplanar, with the cubic without its factors, if they are certain.
fn moments_in_plane<K: Tables>(integers: &Integers<K>, cubic: &[Volume; 4]) -> Option<Moments> {
    let mut moments = zeros(cubic)?;
    for &time in integers.zeros_of_factors() {
        insert(&mut moments, cubic, time)?;
    }
    Some(moments)
}

/// A moment at which a cubic vanishes, in a narrower window if it is a root.
fn narrower(cubic: &[Volume; 4], moment: &Moment) -> Option<Moment> {
    match moment {
        Moment::Root(window, root) => narrowed(cubic, window, root),
        moment => Some(moment.clone()),
    }
}

/// The time of a moment of contact. A known time needs no integers.
pub(crate) fn time<K: Tables>(points: &Points<f64>, moment: &Moment) -> Option<ContactTime> {
    match moment {
        Moment::At(time) => return Some(time.time()),
        Moment::QuadraticRoot(of) => {
            return ExactCubic::new(of.raised()).time(&Moment::Root(of.window, of.root));
        }
        Moment::Root(..) | Moment::Later => {}
    }
    ExactCubic::new(Integers::<K>::new(points)?.rest_of_cubic()).time(moment)
}

/// The signs of the Bernstein coefficients of the coplanarity cubic until a time, if that is a multiple
/// of the unit of windows.
#[inline(never)]
pub(crate) fn signs_until<K: Tables>(points: &Points<f64>, time: f64) -> Option<[Ordering; 4]> {
    let window = Window::new(Dyadic::START, Dyadic::new(time)?)?;
    let cubic = Integers::<K>::new(points)?.cubic();
    Some(window.cubic(&cubic).map(|coefficient| coefficient.sign()))
}

#[cfg(test)]
mod tests;
