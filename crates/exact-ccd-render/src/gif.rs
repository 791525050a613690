//! Animated GIF files.

use std::io;

use gif::{DisposalMethod, Encoder, EncodingError, Frame, Repeat};

use crate::encoder::invalid;
use crate::picture::Picture;

/// The shortest time for which programs show a picture, in s, less the rounding of sums of times. Shorter
/// ones are shown longer.
const SHORTEST: f64 = 0.02 - 1e-6;

/// The thoroughness of the choice of colours, from 1 to 30; 1 is the slowest.
const SPEED: i32 = 10;

/// An animated GIF file, written picture by picture, which plays in a loop. Each picture has 256 colours, the
/// most that the format has, chosen for it.
pub struct Gif<W: io::Write> {
    encoder: Encoder<W>,
    size: [u16; 2],
    /// The picture that is not written yet, and the time at which it begins.
    pending: Option<(Picture, f64)>,
    time: f64,
}

impl<W: io::Write> Gif<W> {
    /// Begins a file of pictures with this width and height in pixels.
    ///
    /// # Errors
    /// The errors of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput) if there are no pixels.
    pub fn new(writer: W, size: [u16; 2]) -> io::Result<Self> {
        if size.contains(&0) {
            return Err(invalid("the picture has no pixels"));
        }
        let mut encoder = Encoder::new(writer, size[0], size[1], &[]).map_err(failed)?;
        encoder.set_repeat(Repeat::Infinite).map_err(failed)?;
        let (pending, time) = (None, 0.0);
        Ok(Self {
            encoder,
            size,
            pending,
            time,
        })
    }

    /// Adds the next picture, which is shown for a time in s. The time has a resolution of 0.01 s, and its
    /// rounding errors do not add up. A picture that begins less than 0.02 s after another one is left out,
    /// because programs would show both too long.
    ///
    /// # Errors
    /// The errors of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput) if the picture has another
    /// size.
    pub fn add(&mut self, picture: &Picture, seconds: f64) -> io::Result<()> {
        if picture.size() != self.size {
            return Err(invalid("the pictures are not of the same size"));
        }
        let is_late = |begin: f64| self.time - begin >= SHORTEST;
        if self.pending.as_ref().is_none_or(|(_, begin)| is_late(*begin)) {
            self.write_pending()?;
            self.pending = Some((picture.clone(), self.time));
        }
        self.time += seconds;
        Ok(())
    }

    /// Completes the file.
    ///
    /// # Errors
    /// The errors of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput) if there are no pictures.
    pub fn finish(mut self) -> io::Result<()> {
        if self.pending.is_none() {
            return Err(invalid("there are no pictures"));
        }
        self.write_pending()?;
        self.encoder.into_inner().map_err(failed)?.flush()
    }

    fn write_pending(&mut self) -> io::Result<()> {
        let Some((picture, begin)) = self.pending.take() else {
            return Ok(());
        };
        let [width, height] = self.size;
        let mut frame = Frame::from_rgb_speed(width, height, picture.pixels().as_flattened(), SPEED);
        frame.dispose = DisposalMethod::Keep;
        // The conversion saturates.
        let hundredths = |time: f64| (100.0 * time).round();
        frame.delay = (hundredths(self.time) - hundredths(begin)).max(1.0) as u16;
        self.encoder.write_frame(&frame).map_err(failed)
    }
}

fn failed(error: EncodingError) -> io::Error {
    match error {
        EncodingError::Io(error) => error,
        other => io::Error::other(other),
    }
}
