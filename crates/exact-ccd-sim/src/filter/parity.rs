//! The paper's filter.

use exact_ccd::parity::RootParity;
use exact_ccd_mesh::{Aabb, Point};

use super::StepFilter;
use super::bisection::Bisection;
use super::increment::Increment;

/// [`Bisection`] with the parity of the number of contacts, of the whole mesh shifted and rounded at once (section 4.2 of
/// the paper), so that what two queries share stays the same point. Two contacts look like none.
pub struct Parity {
    bisection: Bisection,
    bounds: Aabb,
}

impl Parity {
    /// The filter for a scene that stays in a box: one shift serves for all of its steps.
    #[must_use]
    pub fn within(bounds: Aabb) -> Self {
        let bisection = Bisection::new("parity", Box::new(RootParity));
        Self { bisection, bounds }
    }

    /// The same positions, all shifted by what the scene and these need.
    fn shifted(&self, all: [&[Point]; 3]) -> [Vec<Point>; 3] {
        let bounds: Aabb = all.iter().copied().flatten().copied().collect();
        let displacement = self.bounds.union(&bounds).displacement();
        all.map(|points| points.iter().map(|&point| displacement.apply(point)).collect())
    }
}

impl StepFilter for Parity {
    fn name(&self) -> &str {
        self.bisection.name()
    }

    fn largest(&self, increment: &Increment<'_>) -> f64 {
        let [start, end, _] = self.shifted([increment.start(), increment.end(), &[]]);
        self.bisection.largest(&increment.between(&start, &end))
    }

    fn is_free(&self, increment: &Increment<'_>, end: &[Point]) -> bool {
        let [start, end, _] = self.shifted([increment.start(), end, &[]]);
        let step = increment.between(&start, &end);
        self.bisection.is_free(&step, &end)
    }
}
