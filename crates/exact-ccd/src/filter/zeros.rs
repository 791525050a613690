//! The moments at which a cubic with exact coefficients vanishes.

use arrayvec::ArrayVec;

use super::cubic::Cubic;
use super::dyadic::Dyadic;
use super::length::Volume;
use super::moment::Moment;
use super::wide::Wide;
use super::window::{Window, sign_at};

/// Moments in increasing order: at most three roots in the step, and its ends.
pub(super) type Moments = ArrayVec<Moment, 5>;

/// The number of times that windows are cut inside each other.
const MOST_CUTS: u32 = 3;

/// Half of the narrowest window, in units.
const LEAST_HALF: i64 = 1 << 2;

/// The moments at which a cubic that is not zero vanishes, if they are certain.
pub(super) fn zeros(cubic: &[Volume; 4]) -> Option<Moments> {
    let mut moments = Moments::new();
    moments.extend(cubic[0].is_zero().then_some(Moment::At(Dyadic::START)));
    push_zeros_inside(cubic, Window::STEP, MOST_CUTS, &mut moments)?;
    moments.extend(cubic[3].is_zero().then_some(Moment::At(Dyadic::END)));
    Some(moments)
}

/// The same moment, if it certainly is a time with few digits, or a root in a narrower window.
///
/// A window that contains the bracket of a root, and in which the cubic certainly has only one, has this one.
pub(super) fn narrowed(cubic: &[Volume; 4], moment: &Moment) -> Option<Moment> {
    let Moment::Root(window, root) = moment else {
        return None;
    };
    let [low, high] = [root.low, root.high].map(|place| window.floor(place));
    let shortest = Dyadic::between(low, high.plus(1)).filter(|&time| window.is_before(time, root.high));
    if let Some(time) = shortest
        && sign_at(cubic, time).is_eq()
    {
        return Some(Moment::At(time));
    }
    let margin = 4 * (high.units() - low.units()) + 1;
    let [first, last] = window.ends();
    let narrow = Window::new(low.plus(-margin).max(first), high.plus(1 + margin).min(last))?;
    let mut moments = Moments::new();
    if narrow.units() < window.units() / 4 {
        push_zeros_inside(cubic, narrow, MOST_CUTS, &mut moments)?;
    }
    moments.pop().filter(|_| moments.is_empty())
}

/// Appends the moments inside a window, without its ends.
///
/// Without coefficients of opposite signs, there is no root. Otherwise the bounds of [`Cubic::new`] hold with
/// the largest coefficient as magnitude: each coefficient is rounded once, n = 1 of the ten roundings there,
/// and the largest rounded one is below its integer by one rounding at most. Coefficients are below 2⁴⁴⁵
/// ([`Window::cubic`]): nothing overflows. The largest is at least 1, so that what underflows is far below
/// the bounds. If these do not suffice, the window is cut.
fn push_zeros_inside(cubic: &[Volume; 4], window: Window, cuts_left: u32, moments: &mut Moments) -> Option<()> {
    let inner = without_ends(window.cubic(cubic));
    let signs = inner.map(|c| c.sign());
    if signs.iter().all(|&sign| sign == signs[0] || sign.is_eq()) {
        return Some(());
    }
    let values = inner.map(|c| c.approximate().high);
    let local = Cubic::new(values, values.into_iter().map(f64::abs).fold(0.0, f64::max));
    if let Some(roots) = local.roots() {
        for root in roots {
            moments.try_push(Moment::Root(window, root)).ok()?;
        }
        return Some(());
    }
    let cuts_left = cuts_left.checked_sub(1)?;
    let [mut low, end] = window.ends();
    for high in cuts(cubic, window, &local).into_iter().chain([end]) {
        push_zeros_inside(cubic, Window::new(low, high)?, cuts_left, moments)?;
        if high < end && sign_at(cubic, high).is_eq() {
            moments.try_push(Moment::At(high)).ok()?;
        }
        low = high;
    }
    Some(())
}

/// The ends of narrow windows around the times at which a cubic, given in a window too, may have almost double
/// or triple roots, in increasing order; with the time of fewest digits in each, if the cubic vanishes there.
///
/// An almost triple root is near that of c″, which is far more accurate then than those of c′.
fn cuts(cubic: &[Volume; 4], window: Window, local: &Cubic<f64>) -> ArrayVec<Dyadic, 6> {
    /// Roots of c′ at this distance may be one root, with roundings under a square root.
    const TRIPLE: f64 = 1.0 / (1_u64 << 24) as f64;
    let mut places = local.cuts();
    let mut multiplicity = 2;
    let is_triple = match places[..] {
        [first, second] => second - first < TRIPLE,
        _ => true,
    };
    if is_triple {
        places = [local.inflection()].into_iter().filter(|place| (0.0..1.0).contains(place)).collect();
        multiplicity = 3;
    }
    let mut cuts = ArrayVec::new();
    let [mut last, end] = window.ends();
    for place in places {
        let middle = window.floor(place);
        let half = radius(cubic, middle, multiplicity);
        if half > window.units() / 8 {
            continue;
        }
        let [low, high] = [middle.plus(-half), middle.plus(half)];
        if low > last && high < end {
            let shortest = Dyadic::between(low, high).filter(|&time| sign_at(cubic, time).is_eq());
            cuts.extend([Some(low), shortest, Some(high)].into_iter().flatten());
            last = high;
        }
    }
    cuts
}

/// A few times the distance to a time of the roots of a cubic, two or three, that are near it, in units.
///
/// It needs no error bound.
fn radius(cubic: &[Volume; 4], time: Dyadic, multiplicity: usize) -> i64 {
    let Some(window) = Window::new(time, Dyadic::END) else {
        return i64::MAX;
    };
    let [c0, c1, c2, c3] = window.cubic(cubic);
    // The coefficients of the powers of the place in the window.
    let powers = [c0, c1 - c0.times(3), c2 - c1.times(2) + c0.times(3), c3 - c2 + c1 - c0];
    let [a0, a1, a2, a3] = powers.map(|a| a.approximate().high.abs());
    let place = if multiplicity == 2 {
        (a1 / a2).max(libm::sqrt(a0 / a2))
    } else {
        (a2 / a3).max(libm::sqrt(a1 / a3)).max(libm::cbrt(a0 / a3))
    };
    ((4.0 * place * window.units() as f64) as i64).max(LEAST_HALF)
}

/// The cubic without its roots at t = 0 and t = 1.
///
/// c₀ = 0 means that c is t times a quadratic with coefficients c₁, c₂, c₃. This one times t + (1 − t), which
/// is 1, is a cubic again. A cubic that is not zero has at most three such roots.
fn without_ends<const N: usize>(mut c: [Wide<N>; 4]) -> [Wide<N>; 4] {
    for _ in 0..3 {
        if c[0].is_zero() {
            c = [c[1], c[1] + c[2], c[2] + c[3], c[3]];
        } else if c[3].is_zero() {
            c = [c[0], c[0] + c[1], c[1] + c[2], c[2]];
        }
    }
    c
}
