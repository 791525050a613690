//! The Object File Format: a header, counts, vertices and faces, each beginning on its own line.

use super::budget::Budget;
use super::cells::{Cells, vertex_index};
use super::tokens::{Number, Syntax, Tokens};
use crate::error::ParseError;

pub(super) fn read(bytes: &[u8], budget: &Budget) -> Result<Cells, ParseError> {
    let mut tokens = Tokens::text(bytes, Syntax::Comments, budget);
    read_header(&mut tokens)?;
    let vertex_count = tokens.count("the number of vertices")?;
    let face_count = tokens.count("the number of faces")?;

    // The rest of the line after coordinates or corners is skipped: a normal, a colour or texture
    // coordinates.
    let mut cells = Cells::default();
    for vertex in 0..vertex_count {
        tokens.expect_line(|| format!("vertex {vertex} of {vertex_count}"))?;
        cells.positions.push(tokens.point()?);
    }
    let mut corners = Vec::new();
    for face in 0..face_count {
        tokens.expect_line(|| format!("face {face} of {face_count}"))?;
        corners.clear();
        for _ in 0..tokens.count("the number of corners")? {
            // The corners may be on several lines.
            if tokens.is_line_empty() {
                tokens.expect_line(|| "the index of a vertex".to_owned())?;
            }
            let index = tokens.parse("the index of a vertex")?;
            let of = ("face", cells.faces.count);
            corners.push(vertex_index(of, index, vertex_count, tokens.place())?);
        }
        cells.faces.add(&corners, || tokens.place())?;
    }
    tokens.expect_end().map(|()| cells)
}

/// Moves to the counts, after the header, which may be on the same line or missing.
fn read_header(tokens: &mut Tokens) -> Result<(), ParseError> {
    tokens.expect_line(|| "`OFF`".to_owned())?;
    let mut after = tokens.clone();
    let header = after.expect_word("`OFF`")?;
    if u64::parse(header).is_some() {
        return Ok(());
    }
    if !is_header(header) {
        return Err(tokens.unexpected("`OFF`", header));
    }
    *tokens = after;
    match tokens.is_line_empty() {
        true => tokens.expect_line(|| "the numbers of vertices and faces".to_owned()),
        false => Ok(()),
    }
}

/// Returns true for OFF with prefixes that add columns after the coordinates: texture, colour, normal.
fn is_header(word: &[u8]) -> bool {
    let without = |word, prefix| <[u8]>::strip_prefix(word, prefix).unwrap_or(word);
    [b"ST".as_slice(), b"C", b"N"].into_iter().fold(word, without) == b"OFF"
}
