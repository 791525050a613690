//! Animated PNG files.

use std::io;

use crate::picture::Picture;

/// An animated PNG file, written picture by picture. Browsers play it in a loop; programs without
/// support for animations show the first picture.
pub struct Animation<W: io::Write> {
    writer: png::Writer<W>,
    size: [u16; 2],
    /// The number of pictures that have not been added.
    missing: u32,
}

impl<W: io::Write> Animation<W> {
    /// Begins a file of `count` pictures with this width and height in pixels, each shown for
    /// `delay` milliseconds.
    ///
    /// # Errors
    /// Those of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput) if there are no
    /// pictures or no pixels.
    pub fn new(writer: W, size: [u16; 2], count: u32, delay: u16) -> io::Result<Self> {
        if count == 0 {
            return Err(invalid("there are no pictures"));
        }
        let mut encoder = encoder(writer, size)?;
        encoder.set_animated(count, 0)?;
        encoder.set_frame_delay(delay, 1000)?;
        let writer = encoder.write_header()?;
        let missing = count;
        Ok(Self {
            writer,
            size,
            missing,
        })
    }

    /// Adds the next picture.
    ///
    /// # Errors
    /// Those of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput) if the picture has
    /// another size, or exceeds the number of pictures.
    pub fn add(&mut self, picture: &Picture) -> io::Result<()> {
        if picture.size() != self.size {
            return Err(invalid("the pictures are not of the same size"));
        }
        let missing = self.missing.checked_sub(1);
        self.missing = missing.ok_or_else(|| invalid("there is one picture too many"))?;
        Ok(self.writer.write_image_data(picture.pixels().as_flattened())?)
    }

    /// Completes the file.
    ///
    /// # Errors
    /// Those of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput) if pictures are missing.
    pub fn finish(self) -> io::Result<()> {
        if self.missing > 0 {
            return Err(invalid("pictures are missing"));
        }
        Ok(self.writer.finish()?)
    }
}

/// Writes pictures as an [`Animation`].
///
/// `delay` is the duration of each picture in milliseconds.
///
/// # Errors
/// Those of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput) if there are no pictures
/// or no pixels, or if the sizes differ.
pub fn write_apng(writer: impl io::Write, pictures: &[Picture], delay: u16) -> io::Result<()> {
    let size = pictures.first().map_or([1, 1], Picture::size);
    let count = u32::try_from(pictures.len()).map_err(|_| invalid("there are too many pictures"))?;
    let mut animation = Animation::new(writer, size, count, delay)?;
    for picture in pictures {
        animation.add(picture)?;
    }
    animation.finish()
}

/// An encoder of PNG files with this width and height.
pub(crate) fn encoder<'a, W: io::Write>(writer: W, size: [u16; 2]) -> io::Result<png::Encoder<'a, W>> {
    if size.contains(&0) {
        return Err(invalid("the picture has no pixels"));
    }
    let [width, height] = size.map(u32::from);
    let mut encoder = png::Encoder::new(writer, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    Ok(encoder)
}

fn invalid(message: &str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, message)
}
