//! Names of the parts of a mesh.

use std::fmt;
use std::ops::Range;

/// Consecutive vertices of a mesh with a name, such as the vertices of one body.
///
/// PLY files have them as comments: `comment part FIRST END NAME`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NamedPart {
    /// The name, not empty, without control characters. Several parts may share it.
    pub name: String,
    /// The vertices, from the first one to the one after the last.
    pub vertices: Range<u32>,
}

impl fmt::Display for NamedPart {
    /// The text of the comment.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, vertices } = self;
        write!(f, "part {} {} {name}", vertices.start, vertices.end)
    }
}

impl NamedPart {
    /// The part in the text of a comment, if it is one. The name has all its blanks.
    pub(crate) fn parse(comment: &[u8]) -> Option<Self> {
        let text = str::from_utf8(comment).ok()?.trim_end_matches('\r');
        let text = text.trim_start().strip_prefix("part ")?;
        let (start, rest) = text.split_once(' ')?;
        let (end, name) = rest.split_once(' ')?;
        Some(Self {
            name: name.to_owned(),
            vertices: start.parse().ok()?..end.parse().ok()?,
        })
    }

    /// Returns true if parts, in their order, cover vertices from 0 to this count.
    pub(crate) fn cover(parts: &[Self], count: usize) -> bool {
        let end = parts.iter().try_fold(0, |end, part| {
            (part.vertices.start == end && end <= part.vertices.end).then_some(part.vertices.end)
        });
        end.is_some_and(|end| end as usize == count)
    }
}
