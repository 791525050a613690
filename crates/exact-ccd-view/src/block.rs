//! Arrays of 32-bit numbers as text.
//!
//! The bytes of little-endian words are sorted by their significance, so that bytes which vary little are
//! next to each other; then deflated (RFC 1951), and written in base64.

use std::io::Write;

use base64::prelude::{BASE64_STANDARD, Engine};
use flate2::Compression;
use flate2::write::DeflateEncoder;

/// The text of these words.
pub(crate) fn encode(words: &[u32]) -> String {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::fast());
    let written = (0..4).try_for_each(|plane| {
        let bytes: Vec<u8> = words.iter().map(|word| (word >> (8 * plane)) as u8).collect();
        encoder.write_all(&bytes)
    });
    let deflated = written.and_then(|()| encoder.finish());
    BASE64_STANDARD.encode(deflated.expect("memory accepts all bytes"))
}

/// The text of the vertices of elements: differences, modulo 2³², to the element before, which are
/// small in most meshes.
pub(crate) fn encode_elements<const N: usize>(elements: &[[u32; N]]) -> String {
    let mut last = [0; N];
    let mut differences = Vec::with_capacity(N * elements.len());
    for element in elements {
        differences.extend((0..N).map(|corner| element[corner].wrapping_sub(last[corner])));
        last = *element;
    }
    encode(&differences)
}

/// The text of single-precision numbers.
pub(crate) fn encode_floats(numbers: impl Iterator<Item = f32>) -> String {
    encode(&numbers.map(f32::to_bits).collect::<Vec<_>>())
}
