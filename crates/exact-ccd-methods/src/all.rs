//! The list of the methods.

use crate::{
    BernsteinSignClassification, BrochuRootParity, Exact, FloatingPointRootFinder, IntervalRootFinder,
    Method, MinimumSeparationRootFinder, RationalRootParity, RootParity, TightCcd, TightInclusion,
    UnivariateIntervalRootFinder,
};

/// All methods of this crate, with their default parameters: the exact one, the paper's, and then the others in the order of
/// its table.
#[must_use]
pub fn all() -> Vec<Box<dyn Method>> {
    vec![
        Box::new(Exact),
        Box::new(RootParity),
        Box::new(IntervalRootFinder::default()),
        Box::new(UnivariateIntervalRootFinder::default()),
        Box::new(FloatingPointRootFinder::default()),
        Box::new(TightCcd),
        Box::new(BrochuRootParity::default()),
        Box::new(RationalRootParity),
        Box::new(BernsteinSignClassification::default()),
        Box::new(MinimumSeparationRootFinder::default()),
        Box::new(TightInclusion::default()),
    ]
}
