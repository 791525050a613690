//! All methods, their names and guarantees, and the method of a name.

use exact_ccd::{Ccd, Exact, Guarantees, TimeGuarantee};

use crate::parity::RootParity;
use crate::{
    BernsteinSignClassification, BrochuRootParity, FloatingPointRootFinder, IntervalRootFinder,
    MinimumSeparationRootFinder, RationalRootParity, TightCcd, TightInclusion, UnivariateIntervalRootFinder,
};

/// A row for each method: its name, whether false negatives and false positives are possible, and the
/// meaning of its times.
macro_rules! methods {
    ($($method:ty: $name:literal, $false_negatives:literal, $false_positives:literal, $time:ident;)*) => {
        $(impl Ccd for $method {
            fn name(&self) -> &'static str {
                $name
            }

            fn guarantees(&self) -> Guarantees {
                Guarantees {
                    false_negatives: $false_negatives,
                    false_positives: $false_positives,
                    time: TimeGuarantee::$time,
                }
            }
        })*

        /// All methods with their default parameters: the exact one, root parity, and then the others in
        /// the order of the paper's table 1.
        #[must_use]
        pub fn all() -> Vec<Box<dyn Ccd>> {
            vec![Box::new(Exact), $(Box::<$method>::default()),*]
        }
    };
}

methods! {
    RootParity: "parity", true, true, Absent;
    IntervalRootFinder: "IRF", false, true, Conservative;
    UnivariateIntervalRootFinder: "UIRF", false, true, Conservative;
    FloatingPointRootFinder: "FPRF", true, true, Approximate;
    TightCcd: "TCCD", false, true, Absent;
    BrochuRootParity: "RP", true, true, Absent;
    RationalRootParity: "RRP", true, false, Absent;
    BernsteinSignClassification: "BSC", true, true, Absent;
    MinimumSeparationRootFinder: "MSRF", true, true, Approximate;
    TightInclusion: "TI", false, true, Conservative;
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
