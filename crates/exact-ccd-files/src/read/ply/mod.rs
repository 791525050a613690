//! The Stanford polygon format, as text and binary.

mod body;
mod header;
mod rows;

use super::binary::Bytes;
use super::budget::Budget;
use super::cells::Cells;
use super::text::{Lines, Syntax};
use crate::error::ParseError;
use header::{Encoding, Header};
use rows::{BinaryRows, TextRows};

pub(super) fn read(bytes: &[u8], budget: &Budget) -> Result<Cells, ParseError> {
    let mut lines = Lines::new(bytes, Syntax::Plain, budget);
    let header = Header::read(&mut lines, budget)?;
    match header.encoding {
        Encoding::Text => body::read(&header, TextRows::new(lines)),
        Encoding::Binary(order) => {
            let body = Bytes::new(bytes, bytes.len() - lines.rest().len(), budget);
            body::read(&header, BinaryRows::new(body, order))
        }
    }
}
