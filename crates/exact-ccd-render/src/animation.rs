//! Animated PNG files.

use std::io;

use crate::encoder::{encoder, invalid};
use crate::picture::Picture;

/// An animated PNG file, written picture by picture. Browsers play it in a loop; programs without
/// support for animations show the first picture.
pub struct Animation<W: io::Write> {
    writer: png::Writer<W>,
    size: [u16; 2],
    /// The number of pictures that have not been added.
    missing: u32,
    /// The time at which the next picture begins, in s.
    time: f64,
}

impl<W: io::Write> Animation<W> {
    /// Begins a file of `count` pictures with this width and height in pixels.
    ///
    /// # Errors
    /// The errors of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput) if there are no
    /// pictures or no pixels.
    pub fn new(writer: W, size: [u16; 2], count: u32) -> io::Result<Self> {
        if count == 0 {
            return Err(invalid("there are no pictures"));
        }
        let mut encoder = encoder(writer, size)?;
        encoder.set_animated(count, 0)?;
        let writer = encoder.write_header()?;
        Ok(Self {
            writer,
            size,
            missing: count,
            time: 0.0,
        })
    }

    /// Adds the next picture, which is shown for a time in s. The time has a resolution of a millisecond,
    /// and its rounding errors do not add up.
    ///
    /// # Errors
    /// The errors of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput) if the picture has
    /// another size, or exceeds the number of pictures.
    pub fn add(&mut self, picture: &Picture, seconds: f64) -> io::Result<()> {
        if picture.size() != self.size {
            return Err(invalid("the pictures are not of the same size"));
        }
        let missing = self.missing.checked_sub(1);
        self.missing = missing.ok_or_else(|| invalid("there is one picture too many"))?;
        let begin = self.time;
        self.time += seconds;
        // The conversion saturates.
        let milliseconds = |time: f64| (1000.0 * time).round();
        let delay = (milliseconds(self.time) - milliseconds(begin)).max(1.0) as u16;
        self.writer.set_frame_delay(delay, 1000)?;
        Ok(self.writer.write_image_data(picture.pixels().as_flattened())?)
    }

    /// Completes the file.
    ///
    /// # Errors
    /// The errors of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput) if pictures are missing.
    pub fn finish(self) -> io::Result<()> {
        if self.missing > 0 {
            return Err(invalid("pictures are missing"));
        }
        Ok(self.writer.finish()?)
    }
}

/// Writes pictures as an [`Animation`].
///
/// `seconds` is the duration of each picture.
///
/// # Errors
/// The errors of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput) if there are no pictures
/// or no pixels, or if the sizes differ.
pub fn write_apng(writer: impl io::Write, pictures: &[Picture], seconds: f64) -> io::Result<()> {
    let size = pictures.first().map_or([1, 1], Picture::size);
    let count = u32::try_from(pictures.len()).map_err(|_| invalid("there are too many pictures"))?;
    let mut animation = Animation::new(writer, size, count)?;
    for picture in pictures {
        animation.add(picture, seconds)?;
    }
    animation.finish()
}
