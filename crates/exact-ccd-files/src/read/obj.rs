//! Wavefront OBJ: the statements `v`, `f`, `l`, `p`, `o` and `g`. Those of free-form surfaces are named in a
//! note, and all others are skipped.
//!
//! The format counts from 1, and so do errors.

use std::ops::Range;

use exact_ccd_mesh::Point;

use super::budget::Budget;
use super::cells::Cells;
use super::group::Group;
use super::tokens::{Number, Syntax, Tokens};
use crate::error::{Fault, ParseError, Place, quoted};
use crate::note::{Fact, Note};

/// The number of the first vertex, and of the first element of a kind.
const FIRST: usize = 1;

/// The elements of one kind.
struct Elements {
    kind: &'static str,
    /// The line of each element.
    places: Vec<Place>,
    /// The corners of all elements, from 1, and their number up to the end of each.
    corners: Vec<i64>,
    ends: Vec<usize>,
}

impl Elements {
    fn new(kind: &'static str) -> Self {
        Self {
            kind,
            places: Vec::new(),
            corners: Vec::new(),
            ends: Vec::new(),
        }
    }

    fn count(&self) -> usize {
        self.ends.len()
    }

    /// Adds the element on the rest of a line. An index below 0 counts back from the latest of the vertices
    /// so far, which is −1.
    fn add(&mut self, tokens: &mut Tokens, vertices_before: usize) -> Result<(), ParseError> {
        self.places.push(tokens.place());
        while let Some(word) = tokens.word() {
            let written = index(word)
                .ok_or_else(|| tokens.unexpected("a corner such as 1, 1/2, 1/2/3 or 1//3", word))?;
            let absolute = match written {
                0.. => written,
                ..0 => written.saturating_add(vertices_before as i64).saturating_add(1),
            };
            if written < 0 && absolute < 1 {
                return Err(self.out_of_range(self.count(), written, vertices_before));
            }
            self.corners.push(absolute);
        }
        self.ends.push(self.corners.len());
        Ok(())
    }

    /// Removes the last element and appends it to others, if it has this number of corners.
    fn move_last(&mut self, corners: usize, to: &mut Self) {
        let Some(last) = self.count().checked_sub(1) else {
            return;
        };
        let first = self.corners.len() - self.corners(last..last + 1).len();
        if self.corners.len() - first == corners {
            self.ends.pop();
            to.places.extend(self.places.pop());
            to.corners.extend(self.corners.drain(first..));
            to.ends.push(to.corners.len());
        }
    }

    /// The corners of these elements, from 1.
    fn corners(&self, elements: Range<usize>) -> &[i64] {
        let end = |count: usize| if count == 0 { 0 } else { self.ends[count - 1] };
        &self.corners[end(elements.start)..end(elements.end)]
    }

    /// The line and the vertices of each element.
    fn resolved(&self, vertex_count: usize) -> impl Iterator<Item = Result<(Place, Vec<u32>), ParseError>> {
        let in_range = move |&index: &u32| (index as usize) < vertex_count;
        (0..self.count()).map(move |element| {
            let corners = self.corners(element..element + 1).iter();
            let vertex = |&index: &i64| {
                let from_zero = u32::try_from(index - 1).ok().filter(in_range);
                from_zero.ok_or_else(|| self.out_of_range(element, index, vertex_count))
            };
            let vertices = corners.map(vertex).collect::<Result<_, _>>()?;
            Ok((self.places[element], vertices))
        })
    }

    fn out_of_range(&self, number: usize, index: i64, vertex_count: usize) -> ParseError {
        Fault::Index {
            element: self.kind,
            number: FIRST + number,
            index,
            first: FIRST as i64,
            vertex_count: vertex_count as u64,
        }
        .at(self.places[number])
    }

    fn charge(&self, budget: &Budget) {
        budget.hold::<(Place, usize)>(self.count());
        budget.hold::<i64>(self.corners.len());
    }
}

/// Elements may come before their vertices, so indices, from 1, are resolved at the end.
struct Statements<'a> {
    positions: Vec<Point>,
    /// The place of the first vertex with two coordinates, and the number of such vertices.
    planar: Option<(Place, usize)>,
    /// The first statement of each kind that is not read.
    notes: Vec<Note>,
    faces: Elements,
    polylines: Elements,
    points: Elements,
    groups: Vec<Begin<'a>>,
}

/// The beginning of a group: the words of its name, and the numbers of faces, polylines and points before it.
struct Begin<'a> {
    name: &'a [u8],
    before: [usize; 3],
}

pub(super) fn read(bytes: &[u8], budget: &Budget) -> Result<Cells, ParseError> {
    // Of a line, the first statement is read. CR CR LF is the end of one line.
    let is_alone = |pair: &[u8]| pair[0] == b'\r' && !matches!(pair[1], b'\r' | b'\n');
    if bytes.windows(2).any(is_alone) {
        let fault = Fault::Contents {
            found: "text with lines that end in CR alone",
            expected: "lines that end in LF, or in CR and LF",
            advice: "convert the ends of its lines".to_owned(),
        };
        return Err(fault.at(Place::File));
    }
    let mut statements = Statements {
        positions: Vec::new(),
        planar: None,
        notes: Vec::new(),
        faces: Elements::new("face"),
        polylines: Elements::new("polyline"),
        points: Elements::new("point"),
        groups: Vec::new(),
    };
    let mut tokens = Tokens::text(bytes, Syntax::CommentsAndContinuation, budget);
    while tokens.next_line() {
        let vertices = statements.positions.len();
        match tokens.word() {
            // A weight or a colour may follow.
            Some(b"v") => statements.add_vertex(&mut tokens)?,
            Some(b"f") => {
                let Statements { faces, polylines, .. } = &mut statements;
                faces.add(&mut tokens, vertices)?;
                // A face of two corners is a line.
                faces.move_last(2, polylines);
            }
            Some(b"l") => statements.add_polyline(&mut tokens)?,
            Some(b"p") => statements.points.add(&mut tokens, vertices)?,
            Some(b"o" | b"g") => statements.begin_group(tokens.rest_of_line().trim_ascii()),
            Some(word) => statements.note_unread(word, tokens.place()),
            None => {}
        }
    }
    if statements.positions.is_empty() {
        return Err(tokens.ends("a statement `v`"));
    }
    statements.charge(budget);
    statements.into_cells()
}

/// Statements with geometry that is not read, and the remedy.
const UNREAD: &[(&[u8], &str)] = {
    const MESH: &str = "convert free-form curves and surfaces to a mesh before export";
    &[
        (b"curv", MESH),
        (b"curv2", MESH),
        (b"surf", MESH),
        (b"call", "join the files"),
    ]
};

impl<'a> Statements<'a> {
    /// Reads a vertex: three coordinates, or two. A weight or a colour may follow three.
    fn add_vertex(&mut self, tokens: &mut Tokens) -> Result<(), ParseError> {
        let (x, y) = (tokens.coordinate()?, tokens.coordinate()?);
        let z = if tokens.is_line_empty() {
            self.planar.get_or_insert((tokens.place(), 0)).1 += 1;
            0.0
        } else {
            tokens.coordinate()?
        };
        self.positions.push([x, y, z]);
        Ok(())
    }

    fn note_unread(&mut self, word: &[u8], place: Place) {
        let Some((name, remedy)) = UNREAD.iter().find(|(name, _)| *name == word) else {
            return;
        };
        let note = Fact::not_read(format!("the statement {}", quoted(name)), *remedy).at(place);
        if self.notes.iter().all(|other| other.fact != note.fact) {
            self.notes.push(note);
        }
    }

    fn add_polyline(&mut self, tokens: &mut Tokens) -> Result<(), ParseError> {
        let number = self.polylines.count();
        self.polylines.add(tokens, self.positions.len())?;
        let vertices = self.polylines.corners(number..number + 1).len();
        if vertices < 2 {
            let expected = "at least two vertices of a polyline";
            return Err(Fault::expected(expected, vertices.to_string()).at(tokens.place()));
        }
        Ok(())
    }

    /// Begins a group in the place of one without elements.
    fn begin_group(&mut self, name: &'a [u8]) {
        let before = self.counts();
        if self.groups.last().is_some_and(|last| last.before == before) {
            self.groups.pop();
        }
        self.groups.push(Begin { name, before });
    }

    /// The numbers of faces, polylines and points.
    fn counts(&self) -> [usize; 3] {
        [&self.faces, &self.polylines, &self.points].map(Elements::count)
    }

    fn charge(&self, budget: &Budget) {
        budget.hold::<Begin>(self.groups.len());
        for elements in [&self.faces, &self.polylines, &self.points] {
            elements.charge(budget);
        }
    }

    /// The groups with names. All indices are in range.
    fn groups(&self) -> Vec<Group> {
        let ends = self.groups.iter().skip(1).map(|next| next.before);
        let ends = ends.chain([self.counts()]);
        let group = |(begin, end): (&Begin, [usize; 3])| {
            let name = begin.name();
            if name.is_empty() {
                return None;
            }
            let kinds = [&self.faces, &self.polylines, &self.points]
                .into_iter()
                .enumerate();
            let corners = kinds.flat_map(|(kind, elements)| elements.corners(begin.before[kind]..end[kind]));
            Some(Group::named(
                name,
                corners.map(|&index| (index - 1) as u32).collect(),
            ))
        };
        self.groups.iter().zip(ends).filter_map(group).collect()
    }

    fn into_cells(mut self) -> Result<Cells, ParseError> {
        let vertex_count = self.positions.len();
        if let Some((place, count)) = self.planar {
            if count < vertex_count {
                let expected = "three coordinates, as other vertices have";
                return Err(Fault::expected(expected, "two").at(place));
            }
            self.notes.push(Fact::TwoCoordinates.at(place));
        }
        let mut cells = Cells {
            notes: std::mem::take(&mut self.notes),
            ..Cells::default()
        };
        cells.faces.first = FIRST;
        for face in self.faces.resolved(vertex_count) {
            let (place, vertices) = face?;
            cells.faces.add(&vertices, || place)?;
        }
        for polyline in self.polylines.resolved(vertex_count) {
            cells.add_polyline(&polyline?.1);
        }
        for points in self.points.resolved(vertex_count) {
            cells.points.extend(points?.1);
        }
        cells.groups = self.groups();
        cells.positions = std::mem::take(&mut self.positions);
        Ok(cells)
    }
}

impl Begin<'_> {
    /// The words, with one space between two of them.
    fn name(&self) -> String {
        let is_blank = |byte: &u8| byte.is_ascii_whitespace() || *byte == b'\\';
        let words = self.name.split(is_blank).filter(|word| !word.is_empty());
        words.map(String::from_utf8_lossy).collect::<Vec<_>>().join(" ")
    }
}

/// The index of the vertex in `vertex`, `vertex/texture`, `vertex/texture/normal` or `vertex//normal`. Some
/// programs leave out numbers after a slash.
fn index(corner: &[u8]) -> Option<i64> {
    let mut parts = corner.split(|&byte| byte == b'/');
    let vertex = i64::parse(parts.next()?)?;
    let fits = |part: &[u8]| part.is_empty() || i64::parse(part).is_some();
    (parts.by_ref().take(2).all(fits) && parts.next().is_none()).then_some(vertex)
}
