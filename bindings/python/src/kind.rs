//! The kinds of queries by their numbers.

use exact_ccd::AnyKind;
use pyo3::PyResult;

use crate::error::refused;

/// The names of the kinds in Python, and the numbers of points of a query. The place of a kind is its number.
pub(crate) const KINDS: [(&str, usize); AnyKind::ALL.len()] = {
    let mut kinds = [("", 0); AnyKind::ALL.len()];
    let mut number = 0;
    while number < kinds.len() {
        let kind = AnyKind::ALL[number];
        kinds[number] = (kind.short(), kind.point_names().len());
        number += 1;
    }
    kinds
};

/// The kind of a number.
pub(crate) fn kind_of(number: u8) -> PyResult<AnyKind> {
    let kind = AnyKind::ALL.get(usize::from(number)).copied();
    kind.ok_or_else(|| refused(format_args!("there is no kind {number}")))
}
