//! Quantities over the time of a motion, drawn beside it.

use serde::Serialize;

/// Charts over the time of a motion, with a cursor at the time of the picture.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct History {
    /// The time of each frame in s, in the order in which the frames were added.
    pub times: Vec<f64>,
    /// The charts, from top to bottom.
    pub charts: Vec<Chart>,
}

/// A chart of quantities with the same unit.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Chart {
    /// Its title.
    pub title: String,
    /// The unit of all values. Empty for a number of things.
    pub unit: String,
    /// True for powers of ten at equal distances. Values that are not positive are left out then.
    pub logarithmic: bool,
    /// The quantities.
    pub curves: Vec<Curve>,
}

/// A quantity over time.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Curve {
    /// Its name.
    pub name: String,
    /// A value for each frame, or none. Infinity and NaN are none.
    pub values: Vec<Option<f64>>,
}
