//! Bisection of a step.

/// The width of the interval at which a bisection ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tolerance {
    /// In units of the full step.
    Absolute(f64),
    /// In units of the free part of the step, for at most 100 halvings. If nothing is free then, the step
    /// counts as blocked from the start.
    Relative(f64),
}

/// The number of halvings after which a bisection with relative tolerance ends.
const MOST_HALVINGS: usize = 100;

impl Tolerance {
    fn is_met(self, free: f64, blocked: f64, halvings: usize) -> bool {
        match self {
            Self::Absolute(tolerance) => blocked - free <= tolerance,
            Self::Relative(tolerance) => blocked - free <= tolerance * free || halvings >= MOST_HALVINGS,
        }
    }
}

/// A part of a step that is free of contact, from 0 to 1, found by bisection: algorithm 2 of B.
/// Wang, Z. Ferguson, X. Jiang, M. Attene, D. Panozzo and T. Schneider, *Fast and Exact Root Parity
/// for Continuous Collision Detection*, 2022.
///
/// `is_free` decides if the step is free of contact up to a part of it, for example by
/// [`Candidates::collides_by`](crate::Candidates::collides_by). If the full step is free, the result is 1.
/// Otherwise an interval whose lower end is free and whose upper end is not is halved until it is as narrow
/// as the tolerance, or until no f64 lies between its ends, or, for a relative tolerance, 100 times. The
/// lower end is the result. 0 counts as free and is not decided.
///
/// ```
/// use exact_ccd_mesh::{Tolerance, bisect};
///
/// assert_eq!(bisect(Tolerance::Absolute(0.125), |part| part < 0.7), 0.625);
/// assert_eq!(bisect(Tolerance::Absolute(0.125), |_| true), 1.0);
/// ```
pub fn bisect(tolerance: Tolerance, mut is_free: impl FnMut(f64) -> bool) -> f64 {
    if is_free(1.0) {
        return 1.0;
    }
    let (mut free, mut blocked) = (0.0, 1.0);
    let mut halvings = 0;
    while !tolerance.is_met(free, blocked, halvings) {
        let middle = free + 0.5 * (blocked - free);
        if middle <= free || middle >= blocked {
            break;
        }
        if is_free(middle) {
            free = middle;
        } else {
            blocked = middle;
        }
        halvings += 1;
    }
    free
}
