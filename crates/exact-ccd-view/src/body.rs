//! The bodies of a page.

use std::ops::Range;

use serde::Serialize;

/// A part of the mesh with a name, a colour and a row in the list of bodies.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Body {
    /// Its name.
    pub name: String,
    /// Its kind, for the reader: `shell`, `obstacle`. Empty for none.
    pub kind: String,
    /// Its vertices in the mesh of the page.
    pub vertices: Range<u32>,
}

impl Body {
    /// The body of a name and a kind with these vertices.
    #[must_use]
    pub fn new(name: impl Into<String>, kind: impl Into<String>, vertices: Range<u32>) -> Self {
        let (name, kind) = (name.into(), kind.into());
        Self { name, kind, vertices }
    }
}
