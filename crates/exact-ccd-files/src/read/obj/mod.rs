//! Wavefront OBJ: the statements `v`, `f`, `l`, `p`, `o` and `g`. Those of free-form surfaces are named in a
//! note, and all others are skipped.
//!
//! The format counts from 1, and so do errors.

mod elements;

use exact_ccd_mesh::Point;

use super::budget::Budget;
use super::cells::Cells;
use super::group::Group;
use super::tokens::{Syntax, Tokens};
use crate::error::{Fault, ParseError, Place, quoted};
use crate::note::{Fact, Note};
use elements::Elements;

/// The number of the first vertex, and of the first element of a kind.
const FIRST: usize = 1;

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
