//! Wavefront OBJ: the statements `v`, `f`, `l`, `p`, `o` and `g`. All others are skipped.

use exact_ccd_mesh::Point;

use super::cells::Cells;
use super::group::Group;
use super::text::{Line, Lines, Syntax, parse};
use crate::error::{Fault, ParseError, Place};

/// An element: its kind, its number among those of the same kind, and its place.
#[derive(Clone, Copy)]
struct Element {
    kind: &'static str,
    number: usize,
    place: Place,
}

impl Element {
    fn out_of_range(self, index: i64, vertex_count: usize) -> ParseError {
        Fault::Index {
            element: self.kind,
            number: self.number,
            index,
            first: 1,
            vertex_count: vertex_count as u64,
        }
        .at(self.place)
    }
}

/// Elements may come before their vertices, so indices, from 1, are resolved at the end.
#[derive(Default)]
struct Statements {
    positions: Vec<Point>,
    faces: Vec<Place>,
    /// The corners of all faces, and their number up to the end of each.
    corners: Vec<i64>,
    ends: Vec<usize>,
    polylines: Vec<(Place, Vec<i64>)>,
    points: Vec<(Place, Vec<i64>)>,
    groups: Vec<Begin>,
}

/// The beginning of a group: its name, and the numbers of faces, polylines and points before it.
struct Begin {
    name: String,
    before: [usize; 3],
}

pub(super) fn read(bytes: &[u8]) -> Result<Cells, ParseError> {
    let mut statements = Statements::default();
    let mut lines = Lines::new(bytes, Syntax::CommentsAndContinuation);
    for mut line in &mut lines {
        match line.word() {
            Some(b"v") => statements.positions.push(position(&mut line)?),
            Some(b"f") => statements.add_face(&mut line)?,
            Some(b"l") => statements.add_polyline(&mut line)?,
            Some(b"p") => statements.add_points(&mut line)?,
            Some(b"o" | b"g") => statements.begin_group(&mut line),
            _ => {}
        }
    }
    if statements.positions.is_empty() {
        return Err(Fault::ends("a statement `v`").at(lines.end()));
    }
    statements.into_cells()
}

/// The coordinates of a `v`. A weight or a colour may follow.
fn position(line: &mut Line) -> Result<Point, ParseError> {
    Ok([line.coordinate()?, line.coordinate()?, line.coordinate()?])
}

impl Statements {
    fn add_face(&mut self, line: &mut Line) -> Result<(), ParseError> {
        let mut corners = self.indices("face", self.faces.len(), line)?;
        self.faces.push(line.place());
        self.corners.append(&mut corners);
        self.ends.push(self.corners.len());
        Ok(())
    }

    fn add_polyline(&mut self, line: &mut Line) -> Result<(), ParseError> {
        let vertices = self.indices("polyline", self.polylines.len(), line)?;
        if vertices.len() < 2 {
            let expected = "at least two vertices of a polyline";
            return Err(Fault::expected(expected, vertices.len().to_string()).at(line.place()));
        }
        self.polylines.push((line.place(), vertices));
        Ok(())
    }

    fn add_points(&mut self, line: &mut Line) -> Result<(), ParseError> {
        let vertices = self.indices("point", self.points.len(), line)?;
        self.points.push((line.place(), vertices));
        Ok(())
    }

    fn begin_group(&mut self, line: &mut Line) {
        let words = std::iter::from_fn(|| line.word());
        let words: Vec<_> = words.map(String::from_utf8_lossy).collect();
        let before = self.counts();
        let name = words.join(" ");
        self.groups.push(Begin { name, before });
    }

    /// The numbers of faces, polylines and points.
    fn counts(&self) -> [usize; 3] {
        [self.faces.len(), self.polylines.len(), self.points.len()]
    }

    /// The group of each statement. All indices are in range.
    fn groups(&self) -> Vec<Group> {
        let group = |(number, begin): (usize, &Begin)| {
            let end = self
                .groups
                .get(number + 1)
                .map_or_else(|| self.counts(), |next| next.before);
            let of = |kind: usize| begin.before[kind]..end[kind];
            let corner = |face: usize| if face == 0 { 0 } else { self.ends[face - 1] };
            let corners = &self.corners[corner(begin.before[0])..corner(end[0])];
            let lines = self.polylines[of(1)].iter().chain(&self.points[of(2)]);
            let indices = corners.iter().chain(lines.flat_map(|(_, indices)| indices));
            let vertices = indices.map(|&index| (index - 1) as u32).collect();
            Group::named(begin.name.clone(), vertices)
        };
        self.groups.iter().enumerate().map(group).collect()
    }

    /// The indices on the rest of a line, from 1. An index below 0 counts back from the latest
    /// vertex, which is −1.
    fn indices(&self, kind: &'static str, number: usize, line: &mut Line) -> Result<Vec<i64>, ParseError> {
        let place = line.place();
        let vertices_before = self.positions.len();
        let mut indices = Vec::new();
        while let Some(word) = line.word() {
            let written =
                index(word).ok_or_else(|| line.unexpected("a corner such as 1, 1/2, 1/2/3 or 1//3", word))?;
            indices.push(match written {
                0.. => written,
                ..0 => {
                    let absolute = written.saturating_add(vertices_before as i64).saturating_add(1);
                    if absolute < 1 {
                        let element = Element { kind, number, place };
                        return Err(element.out_of_range(written, vertices_before));
                    }
                    absolute
                }
            });
        }
        Ok(indices)
    }

    fn into_cells(mut self) -> Result<Cells, ParseError> {
        let vertex_count = self.positions.len();
        let in_range = |&index: &u32| (index as usize) < vertex_count;
        let vertex = |element: Element, index: i64| {
            let from_zero = u32::try_from(index - 1).ok().filter(in_range);
            from_zero.ok_or_else(|| element.out_of_range(index, vertex_count))
        };
        let mut cells = Cells::default();
        let (mut start, mut face) = (0, Vec::new());
        for ((number, &place), &end) in self.faces.iter().enumerate().zip(&self.ends) {
            let element = Element {
                kind: "face",
                number,
                place,
            };
            face.clear();
            for &index in &self.corners[start..end] {
                face.push(vertex(element, index)?);
            }
            cells.faces.add(&face, || place)?;
            start = end;
        }
        for (number, (place, indices)) in self.polylines.iter().enumerate() {
            let element = Element {
                kind: "polyline",
                number,
                place: *place,
            };
            let vertices = indices.iter().map(|&index| vertex(element, index));
            cells.add_polyline(&vertices.collect::<Result<Vec<_>, _>>()?);
        }
        for (number, (place, indices)) in self.points.iter().enumerate() {
            let element = Element {
                kind: "point",
                number,
                place: *place,
            };
            for &index in indices {
                cells.points.push(vertex(element, index)?);
            }
        }
        cells.groups = self.groups();
        cells.positions = std::mem::take(&mut self.positions);
        Ok(cells)
    }
}

/// The index of the vertex in `vertex`, `vertex/texture`, `vertex/texture/normal` or `vertex//normal`.
fn index(corner: &[u8]) -> Option<i64> {
    let mut parts = corner.split(|&byte| byte == b'/');
    let vertex = parse(parts.next()?)?;
    let texture = parts.next();
    let normal = parts.next();
    let is_number = |part: &[u8]| parse::<i64>(part).is_some();
    let texture_fits = texture.is_none_or(|part| is_number(part) || (part.is_empty() && normal.is_some()));
    let fits = texture_fits && normal.is_none_or(is_number) && parts.next().is_none();
    fits.then_some(vertex)
}
