//! The encoder of PNG files, and its errors.

use std::io;

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

/// The error of an argument that no file can be made of.
pub(crate) fn invalid(message: &str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, message)
}
