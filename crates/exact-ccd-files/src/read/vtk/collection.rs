//! Collections: times and the files that belong to them.

use super::super::budget::Budget;
use super::xml::{File, parse_xml};
use crate::error::{ParseError, quoted};

/// A file in a collection.
pub(in super::super) struct CollectionEntry {
    /// The time, which is finite.
    pub(in super::super) time: f64,
    /// The part of the frame that the file has: the group, the part or both.
    pub(in super::super) part: String,
    pub(in super::super) file: String,
}

/// The files in a collection.
pub(in super::super) fn read(bytes: &[u8], budget: &Budget) -> Result<Vec<CollectionEntry>, ParseError> {
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
        let names = ["group", "part"].map(|name| node.attribute(name).unwrap_or_default());
        Ok(CollectionEntry {
            time: number,
            part: names.join("-").trim_matches('-').to_owned(),
            file: file.attribute(node, "file")?.to_owned(),
        })
    };
    entries.map(entry).collect()
}
