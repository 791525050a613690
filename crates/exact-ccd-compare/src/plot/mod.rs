//! The style of all charts: SVG drawings by [`plotters`] in one [`Frame`], with one
//! [palette](color()) and logarithmic [axes](decades()) with marks at powers of ten.
//!
//! Series are drawn with plotters itself, which this module re-exports.

mod axis;
mod frame;
mod palette;
mod unit;

pub use axis::{GREATEST, decades, linear, logarithmic, seconds};
pub use frame::{Area, Axis, Chart, Drawn, Frame, svg, write};
pub use palette::{COLOR_COUNT, color};
pub use plotters;
pub use unit::{Scale, power};
