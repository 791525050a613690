//! How the charts of exact-ccd look, whatever they show: drawings by [`plotters`] as SVG, in one [`Frame`], with one
//! [palette](color()), and axes that go from one [power of ten](decades()) to another.
//!
//! What a chart shows is drawn with plotters itself, whose [`prelude`](plotters::prelude) is exported here.

mod axis;
mod frame;
mod palette;

pub use axis::{decades, logarithmic, number, seconds};
pub use frame::{Area, Axis, Chart, Drawn, Frame, svg, write};
pub use palette::{COLORS, color};
pub use plotters;
