//! Filters for motion on curves: Bézier curves, and rigid bodies in the coordinates of each other.
//!
//! F, times a positive weight, lies in the hull of the control points of its corners. If that hull does not
//! reach the origin, the primitives do not touch; otherwise the step is divided. Contact is proved in a part
//! in which the coplanarity polynomial changes its sign while the normal and all sides have constant ones.

mod bounds;
mod corners;
mod counted;
mod displacement;
mod guess;
mod motion;
mod piece;
mod place;
mod polynomial;
#[cfg(test)]
mod proof;
mod relative;
mod search;
mod time;
mod twice;
mod volume;

use core::cmp::Ordering;
use core::iter::ExactSizeIterator;

use corners::Corners;
pub(crate) use relative::Relative;
pub(crate) use search::CurvedDecision;
use time::{OfBodies, OnCurves};

use super::gap::{Touching, Within};
use crate::environment;
use crate::numbers::roundoff::LARGEST;
use crate::tables::{Point, Tables};
use crate::values::{ContactTime, Options};

/// Decides about points on Bézier curves, as far as the filters can, given the control points of x₀ … x₃ in
/// order.
pub(crate) fn decide_curved<K: Tables>(
    control: impl ExactSizeIterator<Item = [Point; 4]>,
    options: &Options,
) -> CurvedDecision {
    decide::<K>(Corners::along::<K>(control), options)
}

/// Decides about points of two bodies, each in the coordinates of its own.
pub(crate) fn decide_of_bodies<K: Tables>(
    points: &[Point; 4],
    relative: &Relative,
    options: &Options,
) -> CurvedDecision {
    decide::<K>(Corners::of_bodies::<K>(points, relative), options)
}

/// The time at which points on Bézier curves touch, given their control points in order, if they touch only
/// where the volume of the corners vanishes between two times, where it has one root, and the sign of the
/// volume before that.
pub(crate) fn time_on_curves<K: Tables>(
    control: &[[Point; 4]],
    times: [f64; 2],
    before: Ordering,
) -> Option<ContactTime> {
    let corners = Corners::along::<K>(control.iter().copied())?;
    time::of_root::<K>(&OnCurves(control), &corners.curves, times, before)
}

/// The same of points of two bodies.
pub(crate) fn time_of_bodies<K: Tables>(
    points: &[Point; 4],
    relative: &Relative,
    times: [f64; 2],
    before: Ordering,
) -> Option<ContactTime> {
    let corners = Corners::of_bodies::<K>(points, relative)?;
    let chains = &relative.chains;
    time::of_root::<K>(&OfBodies { points, chains }, &corners.curves, times, before)
}

fn decide<K: Tables>(corners: Option<Corners>, options: &Options) -> CurvedDecision {
    let d = options.separation.get();
    match corners {
        Some(corners) if environment::is_default() && d <= LARGEST => {
            if options.separation.is_zero() {
                search::search::<K, _>(&corners, Touching, options.until)
            } else {
                search::search::<K, _>(&corners, Within(d), options.until)
            }
        }
        _ => CurvedDecision::Unknown,
    }
}
