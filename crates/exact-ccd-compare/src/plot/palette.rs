//! Colours.

use plotters::style::RGBColor;

/// The number of colours.
pub const COLOR_COUNT: usize = 7;

/// The colour of a line or symbol. The first is black, and the colours repeat after [`COLOR_COUNT`].
///
/// The colours are distinct also for colour-blind readers: B. Wong, *Points of view: Color
/// blindness*, Nature Methods 8, 2011, without its yellow and with a darker orange, for white
/// paper.
#[must_use]
pub fn color(index: usize) -> RGBColor {
    const PALETTE: [(u8, u8, u8); COLOR_COUNT] = [
        (0, 0, 0),
        (0, 114, 178),
        (213, 94, 0),
        (0, 158, 115),
        (204, 121, 167),
        (150, 120, 0),
        (86, 180, 233),
    ];
    let (r, g, b) = PALETTE[index % COLOR_COUNT];
    RGBColor(r, g, b)
}
