//! The bytes of an array, one piece after the other: raw, or in base64.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::super::budget::Budget;
use crate::error::Fault;

/// The bytes of an array that have not been read.
pub(super) enum Stream<'a> {
    Raw(&'a [u8]),
    /// Several texts in base64 may follow each other: VTK encodes the header apart from the data.
    Base64 {
        text: &'a [u8],
        /// Bytes that are decoded and not read.
        decoded: Vec<u8>,
    },
}

impl<'a> Stream<'a> {
    pub(super) fn base64(text: &'a [u8]) -> Self {
        let decoded = Vec::new();
        Self::Base64 { text, decoded }
    }

    /// The next bytes.
    pub(super) fn take(&mut self, count: u64, budget: &Budget) -> Result<Vec<u8>, Fault> {
        let missing = |left: usize| Fault::expected(format!("{count} bytes"), left.to_string());
        let wanted = usize::try_from(count).unwrap_or(usize::MAX);
        match self {
            Self::Raw(bytes) => {
                let left = bytes.len();
                let taken = bytes.split_off(..wanted).ok_or_else(|| missing(left))?;
                budget.step(count);
                Ok(taken.to_vec())
            }
            Self::Base64 { text, decoded } => {
                while decoded.len() < wanted {
                    let piece = next_piece(text, wanted - decoded.len());
                    if piece.is_empty() {
                        return Err(missing(decoded.len()));
                    }
                    let bytes = STANDARD.decode(piece);
                    let bytes = bytes.map_err(|error| Fault::expected("base64", error.to_string()))?;
                    budget.step(piece.len() as u64);
                    decoded.extend(bytes);
                }
                let rest = decoded.split_off(wanted);
                Ok(std::mem::replace(decoded, rest))
            }
        }
    }

    /// Returns true if nothing is left.
    pub(super) fn is_empty(&self) -> bool {
        match self {
            Self::Raw(bytes) => bytes.is_empty(),
            Self::Base64 { text, decoded } => text.is_empty() && decoded.is_empty(),
        }
    }
}

/// Removes and returns the text of the next bytes, of at least one group of four characters, up to
/// the end of one text in base64, which padding marks.
fn next_piece<'a>(text: &mut &'a [u8], bytes: usize) -> &'a [u8] {
    let characters = bytes.div_ceil(3).saturating_mul(4).min(text.len());
    let padding = text[..characters].iter().position(|&byte| byte == b'=');
    let length = padding.map_or(characters, |at| ((at / 4 + 1) * 4).min(characters));
    text.split_off(..length).unwrap_or_default()
}
