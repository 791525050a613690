//! Contact decided by the signs of integers of fixed width.
//!
//! Where primitives are flat, parallel and in touch, the numbers whose signs decide are zero, or so near to it
//! that no error bound of floating point proves a sign. They are computed exactly here. At t = 0 contact is a
//! property of four points at rest. Later, the roots of the cubic are those of its exact coefficients, each
//! rounded only once.

use arrayvec::ArrayVec;

use super::cubic::{Cubic, Root};
use super::lattice::{Lattice, without_ends};
use super::moment::Moment;
use super::precise_cubic::PreciseCubic;
use super::wide::Wide;
use crate::kind::Kind;
use crate::query::Query;
use crate::time::{ContactTime, ContactTimes, Times};

/// Integers of 256 bits: coordinates of all 53 bits that differ by a factor of 2²⁸ at most.
type Integer = Wide<4>;
type Integers<K> = Lattice<K, 4>;

/// The number of times at which a cubic may vanish, with the ends of the step.
const MAX_MOMENTS: usize = 5;

/// The moment of the first contact; `Some(None)` if there certainly is no contact, `None` if that is unknown.
#[inline(never)]
pub(super) fn first_moment<K: Kind>(query: &Query<K>) -> Option<Option<Moment>> {
    let integers = Integers::new(query)?;
    if integers.is_flat_at_start() && integers.touches(&Moment::Start)? {
        return Some(Some(Moment::Start));
    }
    let cubic = integers.cubic();
    if cubic == [Integer::ZERO; 4] {
        let touches = integers.touches(&Moment::Later)?;
        return (!touches).then_some(None);
    }
    for moment in flat_moments(&cubic)? {
        if integers.touches(&moment)? {
            return Some(Some(moment));
        }
    }
    Some(None)
}

/// The first time of contact, if it is certain.
pub(super) fn first<K: Kind>(query: &Query<K>) -> Option<ContactTime> {
    time(query, &first_moment(query)??)
}

/// All times of contact, if they are certain.
pub(super) fn times<K: Kind>(query: &Query<K>) -> Option<ContactTimes> {
    let integers = Integers::new(query)?;
    let cubic = integers.cubic();
    let mut times = Times::default();
    if cubic == [Integer::ZERO; 4] {
        let first = ContactTime::exactly(0.0);
        if !integers.touches(&Moment::Start)? {
            return None;
        }
        if integers.touches(&Moment::Soon)? {
            return Some(ContactTimes::Interval { first });
        }
        if integers.touches(&Moment::Later)? {
            return None;
        }
        times.push(first);
        return Some(ContactTimes::Finite(times));
    }
    for moment in flat_moments(&cubic)? {
        if integers.touches(&moment)? {
            times.push(rounded(&integers, &cubic, &moment)?);
        }
    }
    Some(ContactTimes::Finite(times))
}

/// The time of a moment of contact.
pub(super) fn time<K: Kind>(query: &Query<K>, moment: &Moment) -> Option<ContactTime> {
    let integers = Integers::new(query)?;
    rounded(&integers, &integers.cubic(), moment)
}

/// The moments at which a cubic that is not zero vanishes, in increasing order, if they are certain.
fn flat_moments(cubic: &[Integer; 4]) -> Option<ArrayVec<Moment, MAX_MOMENTS>> {
    let (inner, [at_start, at_end]) = without_ends(*cubic);
    let values = inner.map(|c| c.approximate().high);
    let roots = Cubic::new(values, largest(values)).roots()?;
    let mut moments = ArrayVec::new();
    moments.extend(at_start.then_some(Moment::Start));
    moments.extend(roots.into_iter().map(Moment::Root));
    moments.extend(at_end.then_some(Moment::End));
    Some(moments)
}

fn largest(values: [f64; 4]) -> f64 {
    values.into_iter().map(f64::abs).fold(0.0, f64::max)
}

/// The time of a moment at which a cubic vanishes.
fn rounded<K: Kind>(integers: &Integers<K>, cubic: &[Integer; 4], moment: &Moment) -> Option<ContactTime> {
    match moment {
        Moment::Root(root) => {
            dyadic_root(cubic, integers.bits, root).or_else(|| between_adjacent(cubic, root))
        }
        Moment::End => Some(ContactTime::exactly(1.0)),
        Moment::Start | Moment::Soon | Moment::Later => Some(ContactTime::exactly(0.0)),
    }
}

/// The root in a bracket, if it is a multiple of a small power of two: the cubic vanishes there.
///
/// For coordinates of b bits and t = m / 2ᵏ, c(t) times 2³ᵏ is less than 2³ᵇ⁺⁶⁺³ᵏ, the bound of a Bernstein
/// coefficient being 2³ᵇ⁺⁶.
fn dyadic_root(&[c0, c1, c2, c3]: &[Integer; 4], bits: u32, root: &Root) -> Option<ContactTime> {
    const MOST: u32 = 24;
    let most = MOST.min(83_u32.saturating_sub(bits));
    let whole = 1_i128 << most;
    let elapsed = libm::round(root.near * whole as f64) as i128;
    let t = elapsed as f64 / whole as f64;
    if t <= root.low || t >= root.high {
        return None;
    }
    let zeros = elapsed.trailing_zeros().min(most);
    let [t1, t0] = [elapsed, whole - elapsed].map(|part| Integer::from(part >> zeros));
    let value = ((c0 * t0 + c1 * t1) * t0 + c2 * t1 * t1) * t0 + c3 * t1 * t1 * t1;
    value.is_zero().then(|| ContactTime::exactly(t))
}

/// The root in a bracket between two adjacent f64, if the signs of the cubic at both are certain.
fn between_adjacent(cubic: &[Integer; 4], root: &Root) -> Option<ContactTime> {
    let values = cubic.map(Wide::approximate);
    let [c0, c1, c2, c3] = values.map(|value| value.high);
    // The slope in the units of the integers.
    let [a1, a2, a3] = [c1 - 3.0 * c0, c2 - 2.0 * c1 + 3.0 * c0, c3 - c2 + c1 - c0];
    let slope = (3.0 * a3 * root.near + 2.0 * a2) * root.near + a1;
    let precise = PreciseCubic::new(values, largest([c0, c1, c2, c3]));
    precise.round(&Root { slope, ..*root })
}
