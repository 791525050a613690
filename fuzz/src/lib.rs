//! Inputs of the targets from bytes: values of a small alphabet of special cases, and raw bits.

use arbitrary::{Result, Unstructured};
use exact_ccd::Point;

use exact_ccd_testing::alphabet::ALPHABET;

/// A small integer, a number at which floating-point arithmetic goes wrong, or any f64, which may be
/// infinite or NaN.
pub fn coordinate(bytes: &mut Unstructured) -> Result<f64> {
    Ok(match bytes.arbitrary::<u8>()? {
        kind @ ..0x80 => f64::from(kind % 17) - 8.0,
        kind @ 0x80..0xff => ALPHABET[usize::from(kind) % ALPHABET.len()],
        0xff => f64::from_bits(bytes.arbitrary()?),
    })
}

/// The positions of vertices at t = 0 and at t = 1, with few values, so that many coordinates are equal.
pub fn positions(bytes: &mut Unstructured, vertices: usize) -> Result<[Vec<Point>; 2]> {
    let mut values = [0.0; 8];
    for value in &mut values {
        *value = coordinate(bytes)?;
    }
    let mut positions = [(); 2].map(|()| vec![Point::default(); vertices]);
    for x in positions.iter_mut().flat_map(|now| now.as_flattened_mut()) {
        *x = *bytes.choose(&values)?;
    }
    Ok(positions)
}

/// A file: words that mean something in its format, numbers as text and as bits, and raw bytes.
pub fn file(bytes: &mut Unstructured, words: &[&str]) -> Result<Vec<u8>> {
    let mut file = Vec::new();
    while !bytes.is_empty() {
        match bytes.arbitrary::<u8>()? {
            kind @ ..0x80 => file.extend(words[usize::from(kind) % words.len()].bytes()),
            0x80..0xa0 => file.extend(coordinate(bytes)?.to_string().bytes()),
            0xa0..0xb0 => file.extend(coordinate(bytes)?.to_le_bytes()),
            0xb0..0xc0 => file.extend((coordinate(bytes)? as f32).to_be_bytes()),
            kind @ 0xc0..0xe0 => file.extend(u32::from(kind % 8).to_le_bytes()),
            kind @ 0xe0..0xf0 => file.extend((kind % 16).to_string().bytes()),
            0xf0.. => file.push(bytes.arbitrary()?),
        }
    }
    Ok(file)
}
