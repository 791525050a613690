//! Stereolithography, as text and binary. A triangle soup: no two faces share a vertex.

use exact_ccd_mesh::Point;

use super::budget::Budget;
use super::cells::Cells;
use super::polygons::Faces;
use super::tokens::{Syntax, Tokens, is};
use crate::error::{Fault, ParseError, Place};

/// The length of the header of a binary file in bytes. The number of triangles and the triangles follow.
const HEADER: usize = 80;
/// The length of a triangle in bytes: a normal and three corners of 32-bit floats, then two bytes
/// without meaning.
const TRIANGLE: u64 = 50;

pub(super) fn read(bytes: &[u8], budget: &Budget) -> Result<Cells, ParseError> {
    let positions = if is_text(bytes) {
        read_text(bytes, budget)?
    } else {
        read_binary(bytes, budget)?
    };
    let vertex_count = u32::try_from(positions.len()).map_err(|_| Fault::TooManyVertices.at(Place::File))?;
    let faces = (0..vertex_count / 3).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]);
    Ok(Cells {
        positions,
        faces: Faces::of(faces.collect()),
        ..Cells::default()
    })
}

/// Returns true for text, which begins with `solid`. Some binary files do as well; their length
/// agrees with their count.
fn is_text(bytes: &[u8]) -> bool {
    let count = bytes.get(HEADER..).and_then(<[u8]>::first_chunk);
    let binary_length = count.map(|&count| 84 + TRIANGLE * u64::from(u32::from_le_bytes(count)));
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let word = text.trim_ascii_start().get(..5);
    word.is_some_and(|word| is(word, "solid")) && binary_length != Some(bytes.len() as u64)
}

fn read_binary(bytes: &[u8], budget: &Budget) -> Result<Vec<Point>, ParseError> {
    let mut tokens = Tokens::binary(bytes, 0, budget);
    tokens.bytes(HEADER as u64, || {
        "`solid`, or 80 bytes and the number of triangles".to_owned()
    })?;
    let count = u32::from_le_bytes(tokens.array(|| "the number of triangles".to_owned())?);
    let mut positions = Vec::new();
    for triangle in 0..count {
        let triangle = tokens.bytes(TRIANGLE, || format!("triangle {triangle} of {count}"))?;
        let (numbers, _) = triangle.as_chunks::<4>();
        let (vectors, _) = numbers.as_chunks::<3>();
        let corners = vectors.iter().skip(1);
        positions.extend(corners.map(|corner| corner.map(|number| f64::from(f32::from_le_bytes(number)))));
    }
    tokens.expect_end()?;
    Ok(positions)
}

fn read_text(bytes: &[u8], budget: &Budget) -> Result<Vec<Point>, ParseError> {
    let mut tokens = Tokens::text(bytes, Syntax::Free, budget);
    let mut positions = Vec::new();
    loop {
        tokens.keyword("solid")?;
        // The name of the solid.
        tokens.rest_of_line();
        while is_first(&mut tokens, ["facet", "endsolid"])? {
            read_facet(&mut tokens, &mut positions)?;
        }
        tokens.rest_of_line();
        if !tokens.next_line() {
            return Ok(positions);
        }
    }
}

/// Reads the rest of a facet after the word `facet`.
fn read_facet(tokens: &mut Tokens, positions: &mut Vec<Point>) -> Result<(), ParseError> {
    let face = positions.len() / 3;
    tokens.keyword("normal")?;
    for _ in 0..3 {
        tokens.expect_word("a normal")?;
    }
    tokens.keyword("outer")?;
    tokens.keyword("loop")?;
    let mut corners = 0;
    while is_first(tokens, ["vertex", "endloop"])? {
        positions.push(tokens.point()?);
        corners += 1;
    }
    if corners != 3 {
        let found = corners.to_string();
        return Err(Fault::expected(format!("3 corners of face {face}"), found).at(tokens.place()));
    }
    match tokens.word() {
        Some(word) if is_end(tokens, word, "endfacet") => Ok(()),
        Some(word) => Err(tokens.unexpected("`endfacet`", word)),
        None => Err(tokens.ends("`endfacet`")),
    }
}

/// Returns true if a word is this keyword, which begins with `end`, or if the next one is the rest of it:
/// `end facet`. That one is read, then.
fn is_end(tokens: &mut Tokens, word: &[u8], keyword: &str) -> bool {
    is(word, keyword) || is(word, "end") && tokens.next_is(&keyword["end".len()..])
}

/// Reads the next word, which must be a keyword, or the end of a block. Returns true for the first one.
fn is_first(tokens: &mut Tokens, [first, end]: [&str; 2]) -> Result<bool, ParseError> {
    let expected = || format!("`{first}` or `{end}`");
    match tokens.word() {
        Some(word) if is(word, first) => Ok(true),
        Some(word) if is_end(tokens, word, end) => Ok(false),
        Some(word) => Err(tokens.unexpected(expected(), word)),
        None => Err(tokens.ends(expected())),
    }
}
