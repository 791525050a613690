//! The Stanford polygon format, as text and binary.

mod body;
mod header;
mod rows;

use super::Contents;
use super::binary::Bytes;
use super::error::ParseError;
use super::text::{Lines, Syntax};
use header::{Encoding, Header};
use rows::{BinaryRows, TextRows};

pub(super) fn read(bytes: &[u8]) -> Result<Contents, ParseError> {
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
