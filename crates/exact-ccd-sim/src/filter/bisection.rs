//! Filters that only decide.

use exact_ccd::{Ccd, Exact};
use exact_ccd_mesh::{Point, Tolerance, bisect};

use super::StepFilter;
use super::increment::Increment;

/// Halves the step until a method decides that it is free, then goes as far as it says: B. Wang, Z. Ferguson, X. Jiang,
/// M. Attene, D. Panozzo, T. Schneider, *Fast and Exact Root Parity for Continuous Collision Detection*, 2022, algorithm 2.
pub struct Bisection {
    name: String,
    method: Box<dyn Ccd>,
}

/// The width of the interval at which to stop, relative to the free part of the step.
const TOLERANCE: Tolerance = Tolerance::Relative(0.125);

impl Bisection {
    /// The bisection with a method.
    #[must_use]
    pub fn new(name: &str, method: Box<dyn Ccd>) -> Self {
        let name = name.to_owned();
        Self { name, method }
    }

    /// The bisection with the exact decision.
    #[must_use]
    pub fn exact() -> Self {
        Self::new("bisection", Box::new(Exact))
    }

    fn decide(&self, step: &Increment<'_>) -> bool {
        step.is_free(
            |query| self.method.collides(query),
            |query| self.method.collides(query),
        )
    }
}

impl StepFilter for Bisection {
    fn name(&self) -> &str {
        &self.name
    }

    fn largest(&self, increment: &Increment<'_>) -> f64 {
        bisect(TOLERANCE, |part| self.is_free(increment, &increment.at(part)))
    }

    fn is_free(&self, increment: &Increment<'_>, end: &[Point]) -> bool {
        self.decide(&increment.between(increment.start(), end))
    }
}
