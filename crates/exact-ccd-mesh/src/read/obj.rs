//! Wavefront OBJ: the statements `v` and `f`. All others are skipped.

use exact_ccd::Point;

use super::Contents;
use super::error::{Fault, ParseError, Place};
use super::text::{Line, Lines, Syntax, parse};

pub(super) fn read(bytes: &[u8]) -> Result<Contents, ParseError> {
    let mut positions = Vec::new();
    let mut faces = Vec::new();
    let mut lines = Lines::new(bytes, Syntax::CommentsAndContinuation);
    for mut line in &mut lines {
        match line.word() {
            Some(b"v") => positions.push(position(&mut line)?),
            Some(b"f") => faces.push(corners(faces.len(), positions.len(), &mut line)?),
            _ => {}
        }
    }
    if positions.is_empty() {
        return Err(Fault::ends("a statement `v`").at(lines.end()));
    }
    let number = |(face, (corners, place)): (usize, ([i64; 3], Place))| {
        let [a, b, c] = corners.map(|index| vertex(face, index, positions.len(), place));
        Ok([a?, b?, c?])
    };
    let faces = faces
        .into_iter()
        .enumerate()
        .map(number)
        .collect::<Result<_, ParseError>>()?;
    Ok((positions, faces))
}

/// The coordinates of a `v`. What may follow is a weight or a colour.
fn position(line: &mut Line) -> Result<Point, ParseError> {
    Ok([line.coordinate()?, line.coordinate()?, line.coordinate()?])
}

/// The three indices of an `f`, from 1. A face may come before its vertices, unless it counts back from the latest.
fn corners(face: usize, vertices_so_far: usize, line: &mut Line) -> Result<([i64; 3], Place), ParseError> {
    let mut corners = [0; 3];
    let mut count = 0;
    while let Some(word) = line.word() {
        let written =
            index(word).ok_or_else(|| line.unexpected("a corner such as 1, 1/2, 1/2/3 or 1//3", word))?;
        if let Some(corner) = corners.get_mut(count) {
            *corner = match written {
                ..0 => absolute(face, written, vertices_so_far, line.place())?,
                0.. => written,
            };
        }
        count += 1;
    }
    if count != 3 {
        let corners = count as i64;
        return Err(Fault::Corners { face, corners }.at(line.place()));
    }
    Ok((corners, line.place()))
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

/// The index from 1 of the vertex that stands at a negative index: −1 is the latest.
fn absolute(face: usize, index: i64, vertices_so_far: usize, place: Place) -> Result<i64, ParseError> {
    let absolute = index.saturating_add(vertices_so_far as i64).saturating_add(1);
    if absolute >= 1 {
        return Ok(absolute);
    }
    Err(out_of_range(face, index, vertices_so_far).at(place))
}

/// The index from 0 of the vertex at an index from 1.
fn vertex(face: usize, index: i64, vertex_count: usize, place: Place) -> Result<u32, ParseError> {
    let in_range = |&index: &u32| (index as usize) < vertex_count;
    u32::try_from(index - 1)
        .ok()
        .filter(in_range)
        .ok_or_else(|| out_of_range(face, index, vertex_count).at(place))
}

fn out_of_range(face: usize, index: i64, vertex_count: usize) -> Fault {
    Fault::Index {
        face,
        index,
        first: 1,
        vertex_count: vertex_count as u64,
    }
}
