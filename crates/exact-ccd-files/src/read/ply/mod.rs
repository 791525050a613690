//! The Stanford polygon format, as text and binary.

mod body;
mod header;

use super::budget::Budget;
use super::cells::Cells;
use super::tokens::{Syntax, Tokens};
use crate::error::ParseError;
use header::Header;

pub(super) fn read(bytes: &[u8], budget: &Budget) -> Result<Cells, ParseError> {
    let mut tokens = Tokens::text(bytes, Syntax::Lines, budget);
    let header = Header::read(&mut tokens)?;
    tokens.set_encoding(header.encoding);
    body::read(&header, tokens)
}
