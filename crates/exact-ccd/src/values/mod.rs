//! The values that queries ask with and that answers consist of.

mod axis;
mod distance;
mod impact;
mod interval;
mod non_negative;
mod options;
mod stage;
mod thickness;
mod time;

pub use axis::Axis;
pub use distance::{DistanceBounds, InvalidSeparation, Separation, TimeOutOfStep};
pub use impact::Impact;
pub(crate) use impact::unit;
pub use interval::{Interval, Intervals};
#[cfg(test)]
pub(crate) use non_negative::NonNegative;
pub use options::{CONTACT, Options};
pub use stage::Stage;
pub use thickness::{InvalidThickness, Separations, Thickness};
pub use time::ContactTime;
