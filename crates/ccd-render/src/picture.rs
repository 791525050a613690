//! Pictures, and PNG files of them.

use std::io;

use crate::canvas::Canvas;
use crate::scene::SAMPLES;

/// A picture in 24 bits a pixel.
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

    /// Writes a PNG file.
    ///
    /// # Errors
    /// Those of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput) for a picture without pixels.
    pub fn write_png(&self, writer: impl io::Write) -> io::Result<()> {
        write(writer, std::slice::from_ref(self), None)
    }
}

/// Writes an animated PNG file, which browsers play, over and over. Programs that do not know it show the first picture.
///
/// `delay` is the time of each picture in milliseconds.
///
/// # Errors
/// Those of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput) if there are no pictures, or no pixels, or if not
/// all are of the same size.
pub fn write_apng(writer: impl io::Write, pictures: &[Picture], delay: u16) -> io::Result<()> {
    write(writer, pictures, Some(delay))
}

fn write(writer: impl io::Write, pictures: &[Picture], delay: Option<u16>) -> io::Result<()> {
    let invalid = |what: &str| io::Error::new(io::ErrorKind::InvalidInput, what);
    let first = pictures.first().ok_or_else(|| invalid("there are no pictures"))?;
    if first.pixels.is_empty() {
        return Err(invalid("the picture has no pixels"));
    }
    if pictures.iter().any(|picture| picture.size != first.size) {
        return Err(invalid("the pictures are not of the same size"));
    }
    let [width, height] = first.size.map(u32::from);
    let mut encoder = png::Encoder::new(writer, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    if let Some(delay) = delay {
        let count = u32::try_from(pictures.len()).map_err(|_| invalid("there are too many pictures"))?;
        encoder.set_animated(count, 0)?;
        encoder.set_frame_delay(delay, 1000)?;
    }
    let mut writer = encoder.write_header()?;
    for picture in pictures {
        writer.write_image_data(picture.pixels.as_flattened())?;
    }
    writer.finish()?;
    Ok(())
}
