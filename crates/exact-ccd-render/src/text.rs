//! Text in a picture.

use std::convert::Infallible;

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{OriginDimensions, Point, Size};
use embedded_graphics::mono_font::MonoTextStyle;
use embedded_graphics::mono_font::ascii::FONT_10X20;
use embedded_graphics::pixelcolor::BinaryColor;
use embedded_graphics::text::{Baseline, Text};
use embedded_graphics::{Drawable, Pixel};

use crate::picture::Picture;

const COLOUR: [u8; 3] = [40, 45, 55];

/// The height of a picture above which letters are enlarged, by whole factors, in pixels.
const HEIGHT: u16 = 900;

impl Picture {
    /// Writes a line of ASCII text into the top left corner. Other letters are question marks.
    pub fn write(&mut self, text: &str) {
        let factor = 1 + self.size()[1] / HEIGHT;
        let mut letters = Letters {
            factor: usize::from(factor),
            picture: self,
        };
        let style = MonoTextStyle::new(&FONT_10X20, BinaryColor::On);
        let text = Text::with_baseline(text, Point::new(8, 5), style, Baseline::Top);
        let Ok(_) = text.draw(&mut letters);
    }
}

/// A picture on which each pixel of a letter covers a square.
struct Letters<'a> {
    picture: &'a mut Picture,
    /// The side of the square.
    factor: usize,
}

impl OriginDimensions for Letters<'_> {
    fn size(&self) -> Size {
        let [width, height] = self.picture.size().map(u32::from);
        Size::new(width, height) / self.factor as u32
    }
}

impl DrawTarget for Letters<'_> {
    type Color = BinaryColor;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<BinaryColor>>,
    {
        for Pixel(Point { x, y }, colour) in pixels {
            let (Ok(x), Ok(y), BinaryColor::On) = (usize::try_from(x), usize::try_from(y), colour) else {
                continue;
            };
            for row in self.factor * y..self.factor * (y + 1) {
                for column in self.factor * x..self.factor * (x + 1) {
                    self.picture.set(column, row, COLOUR);
                }
            }
        }
        Ok(())
    }
}
