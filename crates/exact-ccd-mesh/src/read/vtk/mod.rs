//! VTK's XML files: unstructured grids, and collections of them.
//!
//! VTK documentation, *XML File Formats*.

mod array;
mod grid;

use roxmltree::{Document, Node};

use super::error::{Fault, ParseError, Place, quoted};
use super::text::parse;

pub(super) use grid::read as read_grid;

/// The root of a file of this type.
struct File<'a> {
    root: Node<'a, 'a>,
}

/// The text of a file as XML.
fn parse_xml(bytes: &[u8]) -> Result<Document<'_>, ParseError> {
    let text = std::str::from_utf8(bytes)
        .map_err(|error| Fault::expected("UTF-8", "other bytes").at(Place::Byte(error.valid_up_to())))?;
    Document::parse(text).map_err(|error| {
        let line = error.pos().row as usize;
        Fault::expected("XML", quoted(error.to_string().as_bytes())).at(Place::Line(line))
    })
}

impl<'a> File<'a> {
    fn new(document: &'a Document<'a>, kind: &str) -> Result<Self, ParseError> {
        let root = document.root_element();
        let file = Self { root };
        if !root.has_tag_name("VTKFile") {
            let found = quoted(root.tag_name().name().as_bytes());
            return Err(file.fault(root, "`VTKFile`", found));
        }
        let found = file.attribute(root, "type")?;
        if found != kind {
            return Err(file.fault(root, format!("type `{kind}`"), quoted(found.as_bytes())));
        }
        Ok(file)
    }

    /// The only child with this name.
    fn child(&self, parent: Node<'a, 'a>, name: &str) -> Result<Node<'a, 'a>, ParseError> {
        let children: Vec<_> = parent
            .children()
            .filter(|child| child.has_tag_name(name))
            .collect();
        match children[..] {
            [child] => Ok(child),
            _ => Err(self.fault(
                parent,
                format!("one element `{name}`"),
                children.len().to_string(),
            )),
        }
    }

    fn attribute(&self, node: Node<'a, 'a>, name: &str) -> Result<&'a str, ParseError> {
        node.attribute(name)
            .ok_or_else(|| self.fault(node, format!("an attribute `{name}`"), "none"))
    }

    /// The error that something is wrong with an element.
    fn fault(&self, node: Node<'a, 'a>, expected: impl Into<String>, found: impl Into<String>) -> ParseError {
        let line = self.root.document().text_pos_at(node.range().start).row;
        Fault::expected(expected, found).at(Place::Line(line as usize))
    }
}

/// The times and paths in a collection.
pub(super) fn read_collection(bytes: &[u8]) -> Result<Vec<(f64, String)>, ParseError> {
    let document = parse_xml(bytes)?;
    let file = File::new(&document, "Collection")?;
    let collection = file.child(file.root, "Collection")?;
    let entries = collection
        .children()
        .filter(|child| child.has_tag_name("DataSet"));
    let entry = |node| {
        let time = file.attribute(node, "timestep")?;
        let number =
            parse(time.as_bytes()).ok_or_else(|| file.fault(node, "a time", quoted(time.as_bytes())))?;
        Ok((number, file.attribute(node, "file")?.to_owned()))
    };
    entries.map(entry).collect()
}
