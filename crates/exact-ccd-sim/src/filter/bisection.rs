//! Filters that only decide.

use exact_ccd_mesh::{Decision, ExactDecision, Point};

use super::StepFilter;
use super::increment::Increment;

/// Halves the step until a method decides that it is free, then goes as far as it says: B. Wang, Z. Ferguson, X. Jiang,
/// M. Attene, D. Panozzo, T. Schneider, *Fast and Exact Root Parity for Continuous Collision Detection*, 2022, algorithm 2.
pub struct Bisection {
    name: String,
    decision: Box<dyn Decision + Send>,
}

/// The width of the interval at which to stop, relative to the free part of the step.
const TOLERANCE: f64 = 0.125;

/// How often a step is halved before it counts as blocked from the start.
const HALVINGS: usize = 100;

impl Bisection {
    /// The bisection with a decision.
    #[must_use]
    pub fn new(name: &str, decision: Box<dyn Decision + Send>) -> Self {
        let name = name.to_owned();
        Self { name, decision }
    }

    /// The bisection with the exact decision.
    #[must_use]
    pub fn exact() -> Self {
        Self::new("bisection", Box::new(ExactDecision))
    }

    fn decide(&self, step: &Increment<'_>) -> bool {
        step.is_free(
            |query| self.decision.vertex_face(query),
            |query| self.decision.edge_edge(query),
        )
    }
}

impl StepFilter for Bisection {
    fn name(&self) -> &str {
        &self.name
    }

    fn largest(&self, increment: &Increment<'_>) -> f64 {
        if self.decide(increment) {
            return 1.0;
        }
        let (mut free, mut blocked) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            if blocked - free <= TOLERANCE * free {
                break;
            }
            let middle = free + 0.5 * (blocked - free);
            if self.is_free(increment, &increment.at(middle)) {
                free = middle;
            } else {
                blocked = middle;
            }
        }
        free
    }

    fn is_free(&self, increment: &Increment<'_>, end: &[Point]) -> bool {
        self.decide(&increment.between(increment.start(), end))
    }
}
