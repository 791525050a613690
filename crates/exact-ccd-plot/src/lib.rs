//! The style of the charts of exact-ccd: SVG drawings by [`plotters`] in one [`Frame`], with one
//! [palette](color()) and logarithmic [axes](decades()) with marks at powers of ten.
//!
//! Series are drawn with plotters itself, which this crate re-exports.

mod axis;
mod frame;
mod palette;

pub use axis::{GREATEST, decades, logarithmic, number, seconds};
pub use frame::{Area, Axis, Chart, Drawn, Frame, svg, write};
pub use palette::{COLOR_COUNT, color};
pub use plotters;

/// The examples in the README of this crate, as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
