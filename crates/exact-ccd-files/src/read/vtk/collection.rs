//! Collections: times and the files that belong to them.

use super::super::budget::Budget;
use super::xml::{File, parse_xml};
use crate::error::{ParseError, quoted};

/// The times, which are finite, and paths in a collection.
pub(in super::super) fn read(bytes: &[u8], budget: &Budget) -> Result<Vec<(f64, String)>, ParseError> {
    let document = parse_xml(bytes, budget)?;
    let file = File::new(&document, "Collection")?;
    let collection = file.child(file.root, "Collection")?;
    let entries = collection
        .children()
        .filter(|child| child.has_tag_name("DataSet"));
    let entry = |node| {
        let time = file.attribute(node, "timestep")?;
        let number = time.parse().ok().filter(|time: &f64| time.is_finite());
        let number =
            number.ok_or_else(|| file.fault(node, "a time, a finite number", quoted(time.as_bytes())))?;
        Ok((number, file.attribute(node, "file")?.to_owned()))
    };
    entries.map(entry).collect()
}
