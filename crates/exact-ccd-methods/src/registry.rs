//! All methods, and the method of a name.

use exact_ccd::{Ccd, Exact};

use crate::parity::RootParity;
use crate::{
    BernsteinSignClassification, BrochuRootParity, FloatingPointRootFinder, IntervalRootFinder,
    MinimumSeparationRootFinder, RationalRootParity, TightCcd, TightInclusion, UnivariateIntervalRootFinder,
};

/// All methods with their default parameters: the exact one, root parity, and then the others in
/// the order of the paper's table 1.
#[must_use]
pub fn all() -> Vec<Box<dyn Ccd>> {
    vec![
        Box::new(Exact),
        Box::new(RootParity::default()),
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

/// The names of [all methods](all), in the same order.
#[must_use]
pub fn names() -> Vec<String> {
    all().iter().map(|method| method.name().to_owned()).collect()
}

/// The method of a name, in upper or lower case, with its default parameters.
///
/// # Errors
/// [`UnknownMethod`] lists the names.
pub fn by_name(name: &str) -> Result<Box<dyn Ccd>, UnknownMethod> {
    let mut methods = all().into_iter();
    methods
        .find(|method| method.name().eq_ignore_ascii_case(name))
        .ok_or_else(|| UnknownMethod {
            name: name.to_owned(),
            known: names(),
        })
}

/// No method has this name.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no method {name}; there are {}", known.join(", "))]
pub struct UnknownMethod {
    /// The name.
    pub name: String,
    /// The names of the methods.
    pub known: Vec<String>,
}
