//! Pictures and PNG files.

use std::io;

use crate::canvas::Canvas;
use crate::encoder::encoder;

/// The number of samples of a pixel along each axis.
pub(crate) const SAMPLES: usize = 2;

/// A picture with 24 bits per pixel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    size: [u16; 2],
    pixels: Vec<[u8; 3]>,
}

impl Picture {
    /// The mean of the samples of each pixel.
    pub(crate) fn downsampled(size: [u16; 2], canvas: &Canvas) -> Self {
        let [width, height] = size.map(usize::from);
        let mut pixels = Vec::with_capacity(width * height);
        for y in 0..height {
            for x in 0..width {
                let mut sum = [0; 3];
                for row in SAMPLES * y..SAMPLES * (y + 1) {
                    let start = row * width * SAMPLES + x * SAMPLES;
                    for sample in &canvas.colours[start..start + SAMPLES] {
                        sum = [0, 1, 2].map(|k: usize| sum[k] + usize::from(sample[k]));
                    }
                }
                pixels.push(sum.map(|sum| (sum / (SAMPLES * SAMPLES)) as u8));
            }
        }
        Self { size, pixels }
    }

    /// Width and height in pixels.
    #[must_use]
    pub fn size(&self) -> [u16; 2] {
        self.size
    }

    /// Red, green and blue of each pixel, row by row from the top.
    #[must_use]
    pub fn pixels(&self) -> &[[u8; 3]] {
        &self.pixels
    }

    /// Sets a pixel, unless it is outside of the picture.
    pub(crate) fn set(&mut self, x: usize, y: usize, colour: [u8; 3]) {
        let width = usize::from(self.size[0]);
        if let Some(pixel) = self.pixels.get_mut(y * width + x).filter(|_| x < width) {
            *pixel = colour;
        }
    }

    /// Writes a PNG file.
    ///
    /// # Errors
    /// The errors of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput) for a picture without
    /// pixels.
    pub fn write_png(&self, writer: impl io::Write) -> io::Result<()> {
        let mut writer = encoder(writer, self.size)?.write_header()?;
        writer.write_image_data(self.pixels.as_flattened())?;
        Ok(writer.finish()?)
    }
}
