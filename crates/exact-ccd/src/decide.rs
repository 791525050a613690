//! Decisions: floating-point filters first, then the exact path.

use crate::decided::Decided;
use crate::environment;
use crate::exact::First;
use crate::filter::{self, Decision};
use crate::tables::{Points, Tables};
use crate::values::{Options, Stage};

/// Returns true if the primitives touch at some time of the whole step.
#[inline(always)]
pub(crate) fn collides<K: Tables>(points: &Points<f64>, options: &Options) -> bool {
    match filtered::<K>(points, options) {
        Decision::Free(_) => false,
        Decision::Collision(_) => true,
        Decision::Unknown => First::<K>::exists(points, options.separation),
    }
}

/// The decision that the primitives touch; the stage that decided if they do not.
#[inline(always)]
pub(crate) fn decide<K: Tables>(points: &Points<f64>, options: &Options) -> Result<Decided<K>, Stage> {
    let decided = match filtered::<K>(points, options) {
        // Most queries, without a call.
        Decision::Free(stage) => return Err(stage),
        decision => Decided::from_filters(points, options.separation, decision)?,
    };
    let stage = decided.stage();
    decided.until(points, options.until).ok_or(stage)
}

/// The decision of the filters, which need the default environment.
#[inline(always)]
fn filtered<K: Tables>(points: &Points<f64>, options: &Options) -> Decision {
    if environment::is_default() {
        filter::decide::<K>(points, options)
    } else {
        Decision::Unknown
    }
}
