//! The style of the charts of exact-ccd: SVG drawings by [`plotters`] in one [`Frame`], with one
//! [palette](color()) and logarithmic [axes](decades()) with marks at powers of ten.
//!
//! Series are drawn with plotters itself, which this crate re-exports.

mod axis;
mod frame;
mod palette;
mod unit;

pub use axis::{GREATEST, decades, linear, logarithmic, seconds};
pub use frame::{Area, Axis, Chart, Drawn, Frame, svg, write};
pub use palette::{COLOR_COUNT, color};
pub use plotters;
pub use unit::{Scale, power};

/// The examples in the README of this crate, as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
