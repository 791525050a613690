//! The data that VTK appends to the XML.

use std::borrow::Cow;

use super::super::budget::Budget;

/// A file in two parts: XML, and the data after it.
pub(super) struct Parts<'a> {
    /// XML without the appended data.
    pub(super) xml: Cow<'a, [u8]>,
    /// The data after the `_` that begins them, if there are any. Their end is not known: the tags
    /// that close the document follow.
    pub(super) appended: Option<&'a [u8]>,
}

/// Cuts the data out of the element `AppendedData`, the last one of a file. Raw data are not XML.
pub(super) fn split<'a>(bytes: &'a [u8], budget: &Budget) -> Parts<'a> {
    budget.step(bytes.len() as u64);
    const TAG: &[u8] = b"<AppendedData";
    let whole = || Parts {
        xml: Cow::Borrowed(bytes),
        appended: None,
    };
    let Some(tag) = bytes.windows(TAG.len()).position(|window| window == TAG) else {
        return whole();
    };
    let Some(end) = bytes[tag..].iter().position(|&byte| byte == b'>') else {
        return whole();
    };
    let (xml, rest) = bytes.split_at(tag + end + 1);
    let Some(appended) = rest.trim_ascii_start().strip_prefix(b"_") else {
        return whole();
    };
    Parts {
        xml: Cow::Owned([xml, b"</AppendedData></VTKFile>"].concat()),
        appended: Some(appended),
    }
}
