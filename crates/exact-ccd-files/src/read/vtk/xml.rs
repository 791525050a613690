//! XML documents as VTK writes them.

use roxmltree::{Document, Node};

use super::super::budget::Budget;
use crate::error::{Fault, ParseError, Place, quoted};

/// A file of VTK by its root element.
pub(super) struct File<'a> {
    pub(super) root: Node<'a, 'a>,
}

/// The most attributes of an element, and the most declarations of namespaces in a document.
///
/// The parser compares each attribute with all others of its element, and copies the namespaces of an element
/// to the elements within it.
const MOST_ATTRIBUTES: usize = 256;
const MOST_NAMESPACES: usize = 16;

/// The memory of an element, of a text between two of them or of an attribute, in words.
const NODE: usize = 10;

/// The contents of a file as XML.
pub(super) fn parse_xml<'a>(bytes: &'a [u8], budget: &Budget) -> Result<Document<'a>, ParseError> {
    let text = std::str::from_utf8(bytes)
        .map_err(|error| Fault::expected("UTF-8", "other bytes").at(Place::Byte(error.valid_up_to())))?;
    check_numbers(text, budget)?;
    Document::parse(text).map_err(|error| {
        let line = error.pos().row as usize;
        Fault::expected("XML", quoted(error.to_string().as_bytes())).at(Place::Line(line))
    })
}

/// Refuses elements with many attributes, and documents with many namespaces.
///
/// A value in quotes after `=` counts as an attribute wherever it is: between one `<` and the next, which a
/// value cannot have, there is one element at most.
fn check_numbers(text: &str, budget: &Budget) -> Result<(), ParseError> {
    budget.step(text.len() as u64);
    let (mut nodes, mut end) = (0, 0);
    for piece in text.split('<') {
        let is_value = |after: &&str| after.trim_ascii_start().starts_with(['"', '\'']);
        let attributes = piece.split('=').skip(1).filter(is_value).count();
        end += piece.len() + 1;
        // A piece begins with an element, or with the end of one, and text may follow.
        let has_text = piece.split_once('>').is_none_or(|(_, text)| !text.is_empty());
        nodes += usize::from(!piece.starts_with('/')) + usize::from(has_text) + attributes;
        if attributes > MOST_ATTRIBUTES {
            let expected = format!("at most {MOST_ATTRIBUTES} attributes of an element");
            let place = Place::Byte(end - 1 - piece.len());
            return Err(Fault::expected(expected, attributes.to_string()).at(place));
        }
    }
    budget.hold::<[usize; NODE]>(nodes);
    let namespaces = text.matches("xmlns").count();
    if namespaces > MOST_NAMESPACES {
        let expected = format!("at most {MOST_NAMESPACES} namespaces");
        return Err(Fault::expected(expected, namespaces.to_string()).at(Place::File));
    }
    Ok(())
}

impl<'a> File<'a> {
    /// The root of the document, which must have this type.
    pub(super) fn new(document: &'a Document<'a>, kind: &str) -> Result<Self, ParseError> {
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

    /// The child with this name, which must be the only one.
    pub(super) fn child(&self, parent: Node<'a, 'a>, name: &str) -> Result<Node<'a, 'a>, ParseError> {
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

    pub(super) fn attribute(&self, node: Node<'a, 'a>, name: &str) -> Result<&'a str, ParseError> {
        node.attribute(name)
            .ok_or_else(|| self.fault(node, format!("an attribute `{name}`"), "none"))
    }

    /// The error at the line of an element that one thing is in the place of another.
    pub(super) fn fault(
        &self,
        node: Node<'a, 'a>,
        expected: impl Into<String>,
        found: impl Into<String>,
    ) -> ParseError {
        self.at(node, Fault::expected(expected, found))
    }

    /// An error at the line of an element.
    pub(super) fn at(&self, node: Node<'a, 'a>, fault: Fault) -> ParseError {
        fault.at(self.place(node))
    }

    /// The line of an element.
    pub(super) fn place(&self, node: Node<'a, 'a>) -> Place {
        let line = self.root.document().text_pos_at(node.range().start).row;
        Place::Line(line as usize)
    }
}
