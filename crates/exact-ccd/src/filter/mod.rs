//! Floating-point filters: each proves an answer or says nothing.
//!
//! Conventions of the error bounds, after Higham (Accuracy and Stability of Numerical Algorithms, 2002, chapter 3) and
//! Meyer and Pion (FPG: a code generator for fast and certified geometric predicates, 2008). u = 2⁻⁵³ is the unit
//! roundoff; a result that went through n roundings differs from the exact one by at most
//! γₙ = n u / (1 − n u) times the same expression with all terms replaced by upper bounds of their magnitudes and
//! all subtractions by additions. Each bound rounds n up to a power of two, at least by a quarter, which covers the
//! roundings in the computation of the bound itself.
//!
//! Two things lie outside of that model. *Overflow* cannot happen: [`Hull::is_out_of_range`] limits differences to
//! [`LARGEST`], and no filter multiplies more than four of them. *Underflow* adds at most 2⁻¹⁰⁷⁵ to a product,
//! which later factors of at most (2 · LARGEST)² may enlarge; [`UNDERFLOW`] bounds the sum of hundreds of these. All
//! comparisons are written so that a NaN would prove nothing.

mod coincident;
mod coplanarity;
mod cubic;
mod double_double;
mod hull;
mod impact;
mod number;
mod planar;
mod rounding;
mod sides;

use arrayvec::ArrayVec;

pub(crate) use cubic::Cubic;
pub(crate) use double_double::{DoubleDouble, ROUNDOFF};
pub(crate) use hull::are_beyond_diagonal;
pub(crate) use number::{Lanes, Number, Points};

use coincident::{Coincidence, coincidence};
use coplanarity::Coplanarity;
use cubic::Root;
use hull::Hull;
use planar::{Beginning, Planar};
use sides::Position;

use crate::contact::Stage;
use crate::impact::Impact;
use crate::kind::Kind;
use crate::query::Query;
use crate::time::{ContactTime, ContactTimes, Times};

/// The unit roundoff u.
pub(crate) const UNIT: f64 = f64::EPSILON / 2.0;

/// 2²⁰⁰: the largest difference of two coordinates that the filters work on.
const LARGEST: f64 = f64::from_bits((1023 + 200) << 52);

/// 2⁻⁶⁰⁰ > 1000 · 2⁻¹⁰⁷⁵ · (2 · LARGEST)².
pub(crate) const UNDERFLOW: f64 = f64::from_bits((1023 - 600) << 52);

/// What the filters know before they look at where in the common plane the primitives are.
enum Screening {
    /// There is no contact, proved at this stage.
    Free(Stage),
    /// The primitives are coplanar exactly at these times.
    Coplanar(ArrayVec<Root, 3>),
    /// The primitives are coplanar at all times, and in contact for an interval that begins like this.
    Sliding(Beginning),
    /// The primitives touch, because of coordinates that are equal.
    Coincident(Coincidence),
    Unknown,
}

/// Whether the primitives touch, and the stage that proved it.
#[inline]
pub(crate) fn collides<K: Kind>(query: &Query<K>) -> Option<(bool, Stage)> {
    decide(query, screen(query))
}

#[inline]
fn decide<K: Kind>(query: &Query<K>, screening: Screening) -> Option<(bool, Stage)> {
    match screening {
        Screening::Free(stage) => Some((false, stage)),
        Screening::Coplanar(roots) => touches_at_any(query, &roots),
        Screening::Sliding(_) => Some((true, Stage::Planar)),
        Screening::Coincident(_) => Some((true, Stage::Coincident)),
        Screening::Unknown => None,
    }
}

#[inline]
fn screen<K: Kind>(query: &Query<K>) -> Screening {
    let hull = Hull::new::<K>(query.points());
    if hull.box_excludes_origin() {
        return Screening::Free(Stage::BoundingBox);
    }
    if hull.is_beyond_diagonal() {
        return Screening::Free(Stage::Diagonals);
    }
    if hull.is_out_of_range() {
        return Screening::Unknown;
    }
    let coplanarity = Coplanarity::new::<K>(query.points());
    if hull.is_beyond(coplanarity.normals[0]) || hull.is_beyond(coplanarity.normals[1]) {
        return Screening::Free(Stage::Normals);
    }
    if coplanarity.cubic.constant_sign().is_some() {
        return Screening::Free(Stage::Coplanarity);
    }
    screen_rest(query, &coplanarity.cubic)
}

/// Queries side by side after the stages `Normals` and `Coplanarity`.
pub(crate) struct Screened<T: Lanes> {
    /// Those which these stages prove to be free of contact.
    pub(crate) settled: T::Mask,
    /// Those which no filter can take.
    pub(crate) out_of_range: T::Mask,
    /// What [`collides_near_plane`] needs about the others.
    pub(crate) cubic: Cubic<T>,
}

/// Passes queries side by side through the stages `Normals` and `Coplanarity`.
#[inline(always)]
pub(crate) fn screen_planes<K: Kind, T: Lanes>(points: &Points<T>) -> Screened<T> {
    let hull = Hull::new::<K>(points);
    let Coplanarity {
        cubic,
        normals: [start, end],
    } = Coplanarity::new::<K>(points);
    let [positive, negative] = cubic.constant_signs();
    let out_of_range = hull.is_out_of_range();
    let settled = hull.is_beyond(start) | hull.is_beyond(end) | positive | negative;
    Screened {
        settled: settled & !out_of_range,
        out_of_range,
        cubic,
    }
}

/// Whether the primitives touch, and the stage that proved it; for a query in range that [`screen_planes`] has not
/// settled.
pub(crate) fn collides_near_plane<K: Kind>(query: &Query<K>, cubic: &Cubic<f64>) -> Option<(bool, Stage)> {
    decide(query, screen_rest(query, cubic))
}

/// Few candidates get here; apart, so that the stages above stay small.
#[inline(never)]
fn screen_rest<K: Kind>(query: &Query<K>, cubic: &Cubic<f64>) -> Screening {
    if let Some(roots) = cubic.roots() {
        return Screening::Coplanar(roots);
    }
    if let Some(coincidence) = coincidence(query, cubic) {
        return Screening::Coincident(coincidence);
    }
    if Hull::new::<K>(query.points()).is_beyond_some_direction() {
        return Screening::Free(Stage::Direction);
    }
    match Planar::new(query).and_then(|planar| planar.beginning()) {
        Some(Some(beginning)) => Screening::Sliding(beginning),
        Some(None) => Screening::Free(Stage::Planar),
        None => Screening::Unknown,
    }
}

fn touches_at_any<K: Kind>(query: &Query<K>, roots: &[Root]) -> Option<(bool, Stage)> {
    let mut all_outside = true;
    for root in roots {
        match sides::position(query, root) {
            Some(Position::Inside) => return Some((true, Stage::Roots)),
            Some(Position::Outside) => {}
            None => all_outside = false,
        }
    }
    all_outside.then_some((false, Stage::Roots))
}

/// All times of contact, and the stage that proved them.
pub(crate) fn contact_times<K: Kind>(query: &Query<K>) -> Option<(ContactTimes, Stage)> {
    let (times, stage) = match screen(query) {
        Screening::Free(stage) => (ContactTimes::Finite(Times::default()), stage),
        Screening::Coplanar(roots) => (ContactTimes::Finite(times_among(query, &roots)?), Stage::Roots),
        Screening::Sliding(beginning) => {
            let first = Planar::new(query)?.round(&beginning)?;
            (ContactTimes::Interval { first }, Stage::Planar)
        }
        Screening::Coincident(Coincidence::FromStart) => {
            let first = ContactTime::exactly(0.0);
            (ContactTimes::Interval { first }, Stage::Coincident)
        }
        Screening::Coincident(Coincidence::Only(time)) => {
            let times = Times([time].into_iter().collect());
            (ContactTimes::Finite(times), Stage::Coincident)
        }
        Screening::Coincident(Coincidence::SomeTime) | Screening::Unknown => return None,
    };
    Some((times, stage))
}

fn times_among<K: Kind>(query: &Query<K>, roots: &[Root]) -> Option<Times> {
    let mut times = Times::default();
    let mut precise = None;
    for root in roots {
        match sides::position(query, root)? {
            Position::Inside => {
                let precise = precise.get_or_insert_with(|| coplanarity::precise(query));
                times.0.push(precise.round(root)?);
            }
            Position::Outside => {}
        }
    }
    Some(times)
}

/// The earliest contact; `Some(None)` if there certainly is none.
pub(crate) fn impact<K: Kind>(query: &Query<K>) -> Option<Option<Impact>> {
    let roots = match screen(query) {
        Screening::Free(_) => return Some(None),
        Screening::Coplanar(roots) => roots,
        Screening::Coincident(_) => return coincident::impact(query).map(Some),
        Screening::Sliding(_) | Screening::Unknown => return None,
    };
    for root in &roots {
        if sides::position(query, root)? == Position::Inside {
            let time = coplanarity::precise(query).round(root)?;
            let (parameters, normal) = impact::parameters_and_normal(query, &root.at(time))?;
            let normal = Some(normal);
            return Some(Some(Impact {
                time,
                parameters,
                normal,
            }));
        }
    }
    Some(None)
}
