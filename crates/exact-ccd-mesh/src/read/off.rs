//! The Object File Format: a header, counts, vertices, then faces, each on its line.

use super::error::{Fault, ParseError};
use super::text::{Line, Lines, Syntax, parse};
use super::{Contents, vertex_index};

pub(super) fn read(bytes: &[u8]) -> Result<Contents, ParseError> {
    let mut lines = Lines::new(bytes, Syntax::Comments);
    let mut line = counts_line(&mut lines)?;
    let vertex_count = line.count("the number of vertices")?;
    let face_count = line.count("the number of faces")?;

    // What follows the coordinates or the corners on a line is a normal, a colour or a place in a texture.
    let mut positions = Vec::new();
    for vertex in 0..vertex_count {
        let mut line = lines.expect(|| format!("vertex {vertex} of {vertex_count}"))?;
        positions.push([line.coordinate()?, line.coordinate()?, line.coordinate()?]);
    }
    let mut faces = Vec::new();
    for _ in 0..face_count {
        let face = faces.len();
        let mut line = lines.expect(|| format!("face {face} of {face_count}"))?;
        let corners = line.integer("the number of corners")?;
        if corners != 3 {
            return Err(Fault::Corners { face, corners }.at(line.place()));
        }
        let mut corner = || {
            let index = line.integer("the index of a vertex")?;
            vertex_index(face, index, vertex_count, line.place())
        };
        faces.push([corner()?, corner()?, corner()?]);
    }
    lines.expect_end()?;
    Ok((positions, faces))
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

/// Whether this is OFF with prefixes that put more columns behind the three coordinates: texture, colour, normal.
fn is_header(word: &[u8]) -> bool {
    let without = |word, prefix| <[u8]>::strip_prefix(word, prefix).unwrap_or(word);
    [b"ST".as_slice(), b"C", b"N"].into_iter().fold(word, without) == b"OFF"
}
