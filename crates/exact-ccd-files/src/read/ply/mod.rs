//! The Stanford polygon format, as text and binary.

mod body;
mod header;
mod rows;

use super::binary::Bytes;
use super::cells::Cells;
use super::text::{Lines, Syntax};
use crate::error::ParseError;
use header::{Encoding, Header};
use rows::{BinaryRows, TextRows};

pub(super) fn read(bytes: &[u8]) -> Result<Cells, ParseError> {
    let mut lines = Lines::new(bytes, Syntax::Plain);
    let header = Header::read(&mut lines)?;
    match header.encoding {
        Encoding::Text => body::read(&header, TextRows::new(lines)),
        Encoding::Binary(order) => {
            let body = Bytes::new(bytes, bytes.len() - lines.rest().len());
            body::read(&header, BinaryRows::new(body, order))
        }
    }
}
