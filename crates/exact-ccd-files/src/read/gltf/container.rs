//! The container of binary glTF (GLB): JSON, and one buffer.

use super::super::binary::Bytes;
use super::super::budget::Budget;
use crate::error::{Fault, ParseError};

/// The JSON of a file, and its binary part, if it has one.
pub(super) fn split<'a>(
    file: &'a [u8],
    budget: &'a Budget,
) -> Result<(&'a [u8], Option<&'a [u8]>), ParseError> {
    if !file.starts_with(b"glTF") {
        return Ok((file, None));
    }
    let mut bytes = Bytes::new(file, 4, budget);
    let version = u32::from_le_bytes(bytes.array(|| "a version".to_owned())?);
    if version != 2 {
        return Err(Fault::expected("version 2", version.to_string()).at(bytes.place()));
    }
    bytes.take(4, || "the length of the file".to_owned())?;
    let json = chunk(&mut bytes, *b"JSON")?;
    match bytes.is_empty() {
        true => Ok((json, None)),
        false => Ok((json, Some(chunk(&mut bytes, *b"BIN\0")?))),
    }
}

/// The next chunk, of this type.
fn chunk<'a>(bytes: &mut Bytes<'a>, kind: [u8; 4]) -> Result<&'a [u8], ParseError> {
    let name = || format!("a chunk `{}`", kind.escape_ascii());
    let length = u32::from_le_bytes(bytes.array(name)?);
    let place = bytes.place();
    let found: [u8; 4] = bytes.array(name)?;
    if found != kind {
        return Err(Fault::expected(name(), format!("`{}`", found.escape_ascii())).at(place));
    }
    bytes.take(length.into(), || format!("{length} bytes of {}", name()))
}
