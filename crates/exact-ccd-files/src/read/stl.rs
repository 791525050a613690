//! Stereolithography, as text and binary. A triangle soup: no two faces share a vertex.

use exact_ccd_mesh::Point;

use super::binary::Bytes;
use super::budget::Budget;
use super::cells::Cells;
use super::polygons::Faces;
use super::text::{Line, Lines, Syntax};
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
    let word = bytes.trim_ascii_start().get(..5);
    word.is_some_and(|word| is(word, "solid")) && binary_length != Some(bytes.len() as u64)
}

fn read_binary(bytes: &[u8], budget: &Budget) -> Result<Vec<Point>, ParseError> {
    let mut bytes = Bytes::new(bytes, 0, budget);
    bytes.take(HEADER as u64, || {
        "`solid`, or 80 bytes and the number of triangles".to_owned()
    })?;
    let count = u32::from_le_bytes(bytes.array(|| "the number of triangles".to_owned())?);
    let mut positions = Vec::new();
    for triangle in 0..count {
        let triangle = bytes.take(TRIANGLE, || format!("triangle {triangle} of {count}"))?;
        let (numbers, _) = triangle.as_chunks::<4>();
        let (vectors, _) = numbers.as_chunks::<3>();
        let corners = vectors.iter().skip(1);
        positions.extend(corners.map(|corner| corner.map(|number| f64::from(f32::from_le_bytes(number)))));
    }
    bytes.expect_end()?;
    Ok(positions)
}

fn read_text(bytes: &[u8], budget: &Budget) -> Result<Vec<Point>, ParseError> {
    let mut words = Words::new(Lines::new(bytes, Syntax::Plain, budget));
    let mut positions = Vec::new();
    while !words.at_end() {
        words.expect("solid")?;
        words.skip_line();
        while words.expect_one_of("`facet` or `endsolid`", &["facet", "endsolid"])? == 0 {
            read_facet(&mut words, &mut positions)?;
        }
        words.skip_line();
    }
    Ok(positions)
}

/// Reads the rest of a facet after the word `facet`.
fn read_facet(words: &mut Words, positions: &mut Vec<Point>) -> Result<(), ParseError> {
    let face = positions.len() / 3;
    words.expect("normal")?;
    for _ in 0..3 {
        words.line("a normal")?.word();
    }
    words.expect("outer")?;
    words.expect("loop")?;
    let mut corners = 0;
    while words.expect_one_of("`vertex` or `endloop`", &["vertex", "endloop"])? == 0 {
        let mut coordinate = || words.line("a number")?.coordinate();
        positions.push([coordinate()?, coordinate()?, coordinate()?]);
        corners += 1;
    }
    if corners != 3 {
        let found = corners.to_string();
        return Err(Fault::expected(format!("3 corners of face {face}"), found).at(words.line.place()));
    }
    words.expect("endfacet")
}

/// The words of a text, independent of its lines.
struct Words<'a> {
    lines: Lines<'a>,
    line: Line<'a>,
}

impl<'a> Words<'a> {
    fn new(lines: Lines<'a>) -> Self {
        let line = Line::default();
        Self { lines, line }
    }

    /// The line with the next word. `expected` describes that word in the error at the end of the file.
    fn line(&mut self, expected: &str) -> Result<&mut Line<'a>, ParseError> {
        if self.line.is_empty() {
            self.line = self.lines.expect(|| expected.to_owned())?;
        }
        Ok(&mut self.line)
    }

    fn at_end(&mut self) -> bool {
        self.line("").is_err()
    }

    /// Skips the rest of the line: the name of a solid.
    fn skip_line(&mut self) {
        self.line = Line::default();
    }

    fn expect(&mut self, keyword: &str) -> Result<(), ParseError> {
        self.expect_one_of(&format!("`{keyword}`"), &[keyword]).map(drop)
    }

    /// Reads the next word, which must be one of `keywords`, and returns its index in them.
    fn expect_one_of(&mut self, expected: &str, keywords: &[&str]) -> Result<usize, ParseError> {
        let line = self.line(expected)?;
        let word = line.expect_word(expected)?;
        let found = keywords.iter().position(|keyword| is(word, keyword));
        found.ok_or_else(|| line.unexpected(expected, word))
    }
}

fn is(word: &[u8], keyword: &str) -> bool {
    word.eq_ignore_ascii_case(keyword.as_bytes())
}
