//! The end of Newton's method at rounding errors.

/// The progress of Newton's method below the rounding errors of the potential.
///
/// Where the predicted decrease of the potential is smaller than its rounding error, the line search cannot
/// tell a step that decreases it. Near a minimum, Newton's directions nevertheless become shorter in each
/// iteration, until rounding errors of the gradient are all that is left of it. From there on, they have the
/// same size.
#[derive(Debug, Default)]
pub(super) struct Stagnation {
    /// The least size of a direction so far, in m.
    least: Option<f64>,
    /// The number of iterations since then whose decrease was lost.
    idle: usize,
}

/// The number of iterations without progress after which Newton's method stops.
const IDLE: usize = 20;

/// The size of a direction, relative to the least one before, that counts as progress.
const SHORTER: f64 = 0.5;

impl Stagnation {
    /// Adds an iteration with a direction of this size in m. `is_lost` is true if the predicted decrease of
    /// the potential is at most its rounding error. Returns true if no progress is left.
    pub(super) fn is_reached(&mut self, size: f64, is_lost: bool) -> bool {
        if self.least.is_none_or(|least| size <= SHORTER * least) {
            self.least = Some(size);
            self.idle = 0;
        } else if is_lost {
            self.idle += 1;
        } else {
            self.idle = 0;
        }
        self.idle >= IDLE
    }
}
