//! How the charts of exact-ccd look, whatever they show: drawings by [`plotters`] as SVG, in one [`Frame`], with one
//! [palette](color()), and logarithmic [axes](decades()) with marks at powers of ten.
//!
//! What a chart shows is drawn with plotters itself, which is exported here.

mod axis;
mod frame;
mod palette;

pub use axis::{GREATEST, decades, logarithmic, number, seconds};
pub use frame::{Area, Axis, Chart, Drawn, Frame, svg, write};
pub use palette::{COLOR_COUNT, color};
pub use plotters;
