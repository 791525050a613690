//! Files compressed by gzip.

use flate2::read::MultiGzDecoder;

use super::budget::Budget;
use crate::error::{Fault, ParseError, Place};

/// The contents of a gzip file, which may have several members.
pub(super) fn gunzip(bytes: &[u8], budget: &Budget) -> Result<Vec<u8>, ParseError> {
    if !bytes.starts_with(b"\x1f\x8b") {
        let fault = Fault::Contents {
            found: if bytes.is_empty() {
                "empty"
            } else {
                "not compressed"
            },
            expected: "data compressed by gzip",
            advice: "remove .gz from the name of the file, or compress it".to_owned(),
        };
        return Err(fault.at(Place::File));
    }
    let data = budget.read_all(MultiGzDecoder::new(bytes), "data compressed by gzip", u64::MAX);
    data.map_err(|fault| fault.at(Place::File))
}
