//! The Object File Format: a header, counts, vertices and faces, each on its own line.

use super::budget::Budget;
use super::cells::{Cells, vertex_index};
use super::text::{Line, Lines, Syntax, parse};
use crate::error::ParseError;

pub(super) fn read(bytes: &[u8], budget: &Budget) -> Result<Cells, ParseError> {
    let mut lines = Lines::new(bytes, Syntax::Comments, budget);
    let mut line = counts_line(&mut lines)?;
    let vertex_count = line.count("the number of vertices")?;
    let face_count = line.count("the number of faces")?;

    // The rest of the line after coordinates or corners is skipped: a normal, a colour or texture
    // coordinates.
    let mut cells = Cells::default();
    for vertex in 0..vertex_count {
        let mut line = lines.expect(|| format!("vertex {vertex} of {vertex_count}"))?;
        let position = [line.coordinate()?, line.coordinate()?, line.coordinate()?];
        cells.positions.push(position);
    }
    let mut corners = Vec::new();
    for face in 0..face_count {
        let mut line = lines.expect(|| format!("face {face} of {face_count}"))?;
        corners.clear();
        for _ in 0..line.count("the number of corners")? {
            let index = line.integer("the index of a vertex")?;
            let of = ("face", cells.faces.count);
            corners.push(vertex_index(of, index, vertex_count, line.place())?);
        }
        cells.faces.add(&corners, || line.place())?;
    }
    lines.expect_end()?;
    Ok(cells)
}

/// The line with the counts, after the header, which may be on the same line or missing.
fn counts_line<'a>(lines: &mut Lines<'a>) -> Result<Line<'a>, ParseError> {
    let mut line = lines.expect(|| "`OFF`".to_owned())?;
    let header = line.clone().expect_word("`OFF`")?;
    if parse::<u64>(header).is_some() {
        return Ok(line);
    }
    if !is_header(header) {
        return Err(line.unexpected("`OFF`", header));
    }
    line.word();
    if line.is_empty() {
        lines.expect(|| "the numbers of vertices and faces".to_owned())
    } else {
        Ok(line)
    }
}

/// Returns true for OFF with prefixes that add columns after the coordinates: texture, colour, normal.
fn is_header(word: &[u8]) -> bool {
    let without = |word, prefix| <[u8]>::strip_prefix(word, prefix).unwrap_or(word);
    [b"ST".as_slice(), b"C", b"N"].into_iter().fold(word, without) == b"OFF"
}
