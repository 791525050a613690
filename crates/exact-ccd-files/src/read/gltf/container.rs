//! The container of binary glTF (GLB): JSON, and one buffer.

use super::super::budget::Budget;
use super::super::tokens::Tokens;
use crate::error::{Fault, ParseError};

/// The JSON of a file, and its binary part, if it has one.
pub(super) fn split<'a>(
    file: &'a [u8],
    budget: &'a Budget,
) -> Result<(&'a [u8], Option<&'a [u8]>), ParseError> {
    if !file.starts_with(b"glTF") {
        return Ok((file, None));
    }
    let mut tokens = Tokens::binary(file, 4, budget);
    let version = u32::from_le_bytes(tokens.array(|| "a version".to_owned())?);
    if version != 2 {
        return Err(Fault::expected("version 2", version.to_string()).at(tokens.place()));
    }
    tokens.bytes(4, || "the length of the file".to_owned())?;
    let json = chunk(&mut tokens, *b"JSON")?;
    match tokens.is_at_end() {
        true => Ok((json, None)),
        false => Ok((json, Some(chunk(&mut tokens, *b"BIN\0")?))),
    }
}

/// The next chunk, of this type.
fn chunk<'a>(tokens: &mut Tokens<'a>, kind: [u8; 4]) -> Result<&'a [u8], ParseError> {
    let name = || format!("a chunk `{}`", kind.escape_ascii());
    let length = u32::from_le_bytes(tokens.array(name)?);
    let found: [u8; 4] = tokens.array(name)?;
    if found != kind {
        return Err(Fault::expected(name(), format!("`{}`", found.escape_ascii())).at(tokens.place()));
    }
    tokens.bytes(length.into(), || format!("{length} bytes of {}", name()))
}
