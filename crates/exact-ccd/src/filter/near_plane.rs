//! The last stages of contact: for primitives near a common plane.

use super::alongside;
use super::coincident::coincidence;
use super::contact::Contact;
use super::decision::{Decision, Proved};
use super::gap::Touching;
use super::hull::Hull;
use super::planar::Planar;
use super::position::{self, Position};
use crate::fixed;
use crate::numbers::cubic::{Cubic, Root};
use crate::tables::{Points, Tables};
use crate::values::Stage;

/// The last stages of contact until a time, for a query in range that the stages before have not settled. A
/// contact that is later may be found or not.
///
/// Few candidates get here. It is not inlined, so that the stages above stay small.
#[inline(never)]
pub(crate) fn decide_near_plane<K: Tables>(points: &Points<f64>, cubic: &Cubic<f64>, until: f64) -> Decision {
    if (0.0..1.0).contains(&until)
        && let Some(decision) = decide_until::<K>(points, cubic, until)
    {
        return decision;
    }
    if let Some(roots) = cubic.roots() {
        return match Contact::at_roots::<K>(points, roots) {
            Some(Some(contact)) => Decision::Collision(Proved::Contact(contact)),
            Some(None) => Decision::Free(Stage::Roots),
            None => decide_in_integers::<K>(points),
        };
    }
    if let Some(coincidence) = coincidence::<K>(points, cubic) {
        return Decision::Collision(Proved::Contact(Contact::Coincident(coincidence)));
    }
    let hull = Hull::new::<K>(points);
    if alongside::separates::<K>(points, &hull) {
        return Decision::Free(Stage::Direction);
    }
    match Planar::new(points).and_then(|planar| planar.stretches::<K>()) {
        Some(stretches) => match stretches.into_iter().next() {
            Some([beginning, _]) => Decision::Collision(Proved::Contact(Contact::Sliding(beginning))),
            None => Decision::Free(Stage::Planar),
        },
        None => match decide_in_integers::<K>(points) {
            Decision::Unknown if hull.some_direction_separates::<K>(Touching) => {
                Decision::Free(Stage::Direction)
            }
            decision => decision,
        },
    }
}

/// The decision if the primitives certainly are not coplanar before a time, by the coefficients of the cubic
/// until then, which are computed in integers where their signs are not certain.
///
/// In a search for the earliest contact, many pairs may touch at almost the same time, or at the same one.
fn decide_until<K: Tables>(points: &Points<f64>, cubic: &Cubic<f64>, until: f64) -> Option<Decision> {
    let signs = cubic.signs_until(until);
    let mut known = signs.iter().flatten();
    let before = known.next();
    if known.any(|sign| Some(sign) != before) {
        return None;
    }
    if signs.iter().all(Option::is_some) {
        return Some(Decision::Free(Stage::Roots));
    }
    let [before, second, third, at_end] = fixed::signs_until::<K>(points, until)?;
    if before.is_eq() || before.reverse() == second || before.reverse() == third {
        return None;
    }
    if at_end == before {
        return Some(Decision::Free(Stage::FixedWidth));
    }
    if at_end.is_ne() {
        return None;
    }
    let root = Root::exactly(until, before);
    Some(match position::at::<K>(points, &root)? {
        Position::Inside => Decision::Collision(Proved::Contact(Contact::At(until))),
        Position::Outside => Decision::Free(Stage::Roots),
    })
}

/// The stage of integers of fixed width.
fn decide_in_integers<K: Tables>(points: &Points<f64>) -> Decision {
    match fixed::first_moment::<K>(points) {
        Some(Some(moment)) => Decision::Collision(Proved::Contact(Contact::AtMoment(moment))),
        Some(None) => Decision::Free(Stage::FixedWidth),
        None => Decision::Unknown,
    }
}
