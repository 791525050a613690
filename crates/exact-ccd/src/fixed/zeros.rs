//! The moments at which a cubic with exact coefficients vanishes.

use core::cmp::Ordering;

use arrayvec::ArrayVec;

use super::dyadic::Dyadic;
use super::fraction::Fraction;
use super::length::Volume;
use super::moment::Moment;
use super::wide::Wide;
use super::window::{Window, changes_of_sign, powers_since, sign_at};
use crate::numbers::cubic::{Cubic, Root};

/// Moments in increasing order.
pub(super) type Moments = ArrayVec<Moment, 3>;

/// The number of times that windows are cut inside each other.
const MOST_CUTS: u32 = 3;

/// The widest bracket of a root, as a fraction of its window, if that can be cut.
const WIDEST: f64 = 1.0 / (1_u64 << 10) as f64;

/// The binary logarithm of the quotient of a window and the part that is cut off beside an end.
const PART_AT_END: u32 = 20;

/// Half of the narrowest window around a cluster of roots, in units.
const LEAST_HALF: i64 = 1 << 2;

/// 2⁻¹²⁸.
const SCALE: f64 = f64::from_bits((1023 - 128) << 52);

/// The moments at which a cubic that is not zero vanishes, if they are certain.
pub(super) fn zeros(cubic: &[Volume; 4]) -> Option<Moments> {
    let mut moments = Moments::new();
    if cubic[0].is_zero() {
        moments.try_push(Moment::At(Fraction::START)).ok()?;
    }
    push_zeros_inside(cubic, Window::STEP, MOST_CUTS, &mut moments)?;
    if cubic[3].is_zero() {
        moments.try_push(Moment::At(Fraction::END)).ok()?;
    }
    Some(moments)
}

/// Inserts a time into the moments at which a cubic vanishes, which are in increasing order, if its place is
/// certain.
pub(super) fn insert(moments: &mut Moments, cubic: &[Volume; 4], time: Fraction) -> Option<()> {
    let orders = moments.iter().map(|moment| order(moment, cubic, time));
    let orders: ArrayVec<Ordering, 3> = orders.collect::<Option<_>>()?;
    let place = orders.iter().filter(|order| order.is_lt()).count();
    if orders.contains(&Ordering::Equal) {
        moments[place] = Moment::At(time);
        return Some(());
    }
    moments.try_insert(place, Moment::At(time)).ok()
}

/// The order of a moment at which a cubic vanishes and a time, if it is certain.
fn order(moment: &Moment, cubic: &[Volume; 4], time: Fraction) -> Option<Ordering> {
    match moment {
        Moment::At(other) => Some(other.cmp(&time)),
        Moment::Root(window, root) => order_of_root(window, root, cubic, time),
        Moment::QuadraticRoot(_) | Moment::Later => None,
    }
}

/// The order of a root of a cubic and a time, if it is certain.
///
/// A root is strictly inside its window. The cubic may vanish at the ends of the window too. Between these
/// ends, the cubic has one root in the bracket, and opposite signs on both sides of it.
pub(super) fn order_of_root(
    window: &Window,
    root: &Root,
    cubic: &[Volume; 4],
    time: Fraction,
) -> Option<Ordering> {
    let [first, last] = window.ends().map(Fraction::from);
    if time <= first {
        return Some(Ordering::Greater);
    }
    if time >= last {
        return Some(Ordering::Less);
    }
    let [before_low, after_low] = window.around(root.low).map(Fraction::from);
    let [before_high, after_high] = window.around(root.high).map(Fraction::from);
    if time < before_low {
        Some(Ordering::Greater)
    } else if time > after_high {
        Some(Ordering::Less)
    } else if time < after_low || time > before_high {
        None
    } else {
        let sign = sign_at(cubic, time);
        Some(if root.before.is_lt() { sign.reverse() } else { sign })
    }
}

/// The same root, if it certainly is a time with few digits, or the root in a narrower window.
///
/// The only root in a window that contains the bracket is the root of the bracket.
pub(super) fn narrowed(cubic: &[Volume; 4], window: &Window, root: &Root) -> Option<Moment> {
    if let Some(time) = window.shortest(root)
        && sign_at(cubic, time).is_eq()
    {
        return Some(Moment::At(time.into()));
    }
    let [low, high] = window.bracket(root);
    let width = high.units() - low.units();
    if width > window.units() / 64 {
        return None;
    }
    // Four times the bracket on each side, where the coefficients are of the size of the cubic.
    let [first, last] = window.ends();
    let narrow = Window::new(low.plus(-4 * width).max(first), high.plus(4 * width).min(last))?;
    let mut moments = Moments::new();
    push_zeros_inside(cubic, narrow, MOST_CUTS, &mut moments)?;
    moments.pop().filter(|_| moments.is_empty())
}

/// Appends the moments inside a window, without its ends.
///
/// The number of sign changes of the exact coefficients is at least the number of roots, and has the same
/// parity: none and one are certain (Descartes' rule). Otherwise the bounds of [`Cubic::new`] hold with the
/// largest coefficient as magnitude: each coefficient is rounded once, n = 1 of the ten roundings there,
/// and the largest rounded one is below its integer by one rounding at most. Coefficients are below 2⁵⁷¹
/// ([`Window::cubic`]), and scaled by 2⁻¹²⁸: products of two do not overflow. The largest is at least 2⁻¹²⁸,
/// so that underflow is far below the bounds. If these do not suffice, the window is cut.
fn push_zeros_inside(
    cubic: &[Volume; 4],
    window: Window,
    cuts_left: u32,
    moments: &mut Moments,
) -> Option<()> {
    let inner = without_ends(window.cubic(cubic));
    let changes = changes_of_sign(&inner);
    if changes == 0 {
        return Some(());
    }
    let values = inner.map(|c| c.approximate().high * SCALE);
    let local = Cubic::new(values, largest(values));
    let roots = if changes == 1 {
        Some([local.only_root()].into_iter().collect())
    } else {
        local.roots()
    };
    let are_narrow = |roots: &ArrayVec<Root, 3>| roots.iter().all(|root| root.high - root.low < WIDEST);
    let cuts = if roots.as_ref().is_some_and(are_narrow) {
        ArrayVec::new()
    } else {
        cuts(cubic, window, &local)
    };
    if cuts.is_empty() || cuts_left == 0 {
        let mut roots = roots?.into_iter().map(|root| Moment::Root(window, root));
        return roots.try_for_each(|root| moments.try_push(root).ok());
    }
    let [mut low, end] = window.ends();
    for high in cuts.into_iter().chain([end]) {
        push_zeros_inside(cubic, Window::new(low, high)?, cuts_left - 1, moments)?;
        if high < end && sign_at(cubic, high).is_eq() {
            moments.try_push(Moment::At(high.into())).ok()?;
        }
        low = high;
    }
    Some(())
}

/// The times at which a window is cut, in increasing order.
///
/// These are the ends of narrow windows around almost triple roots of a cubic, or else around almost double
/// ones; with the time of fewest digits in each, if the cubic vanishes there. An almost triple root is near
/// the zero of c″, an almost double one near a zero of c′. If there are none, the part beside an end at which
/// the rounded cubic has no certain sign is cut off: there, the sign of the exact coefficient counts.
fn cuts(cubic: &[Volume; 4], window: Window, local: &Cubic<f64>) -> ArrayVec<Dyadic, 6> {
    let mut cuts = ArrayVec::new();
    push_cuts(cubic, window, &[local.inflection()], 3, &mut cuts);
    if cuts.is_empty() {
        push_cuts(cubic, window, &local.cuts(), 2, &mut cuts);
    }
    let part = window.units() >> PART_AT_END;
    if cuts.is_empty() && part > 0 {
        let [low, high] = window.ends();
        let beside = [low.plus(part), high.plus(-part)];
        cuts.extend(
            (0..2)
                .filter(|&end| !local.is_certain_at(end))
                .map(|end| beside[end]),
        );
    }
    cuts
}

/// Appends the ends around the places of some clusters of two or three roots, if these are small.
fn push_cuts(
    cubic: &[Volume; 4],
    window: Window,
    places: &[f64],
    roots: usize,
    cuts: &mut ArrayVec<Dyadic, 6>,
) {
    let space = match places {
        [first, second] => second - first,
        _ => 1.0,
    };
    let most = (0.125 * space * window.units() as f64) as i64;
    let [mut last, end] = window.ends();
    for &place in places {
        let [middle, _] = window.around(place);
        let half = radius(cubic, middle, roots);
        if half <= most {
            let [low, high] = [middle.plus(-half).max(last), middle.plus(half).min(end)];
            let shortest = Dyadic::between(low, high).filter(|&time| sign_at(cubic, time).is_eq());
            let all = [Some(low), shortest, Some(high)].into_iter().flatten();
            cuts.extend(all.filter(|&time| time > last && time < end));
            last = last.max(high);
        }
    }
}

/// A few times the distance from a time to the two or three roots of a cubic in a cluster near it, in units.
///
/// It needs no error bound.
fn radius(cubic: &[Volume; 4], time: Dyadic, roots: usize) -> i64 {
    let [a0, a1, a2, a3] = powers_since(time, cubic).map(f64::abs);
    let radius = if roots == 2 {
        (a1 / a2).max(libm::sqrt(a0 / a2))
    } else {
        (a2 / a3).max(libm::sqrt(a1 / a3)).max(libm::cbrt(a0 / a3))
    };
    ((4.0 * radius) as i64).max(LEAST_HALF)
}

/// The largest magnitude.
pub(super) fn largest(values: [f64; 4]) -> f64 {
    values.into_iter().map(f64::abs).fold(0.0, f64::max)
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
