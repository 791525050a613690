//! The faces, polylines or points of a file, by the indices of their corners.

use std::ops::Range;

use super::super::budget::Budget;
use super::super::tokens::{Number, Tokens};
use super::FIRST;
use crate::error::{Fault, ParseError, Place};

/// The elements of one kind.
pub(super) struct Elements {
    kind: &'static str,
    /// The line of each element.
    places: Vec<Place>,
    /// The corners of all elements, from 1, and their number up to the end of each.
    corners: Vec<i64>,
    ends: Vec<usize>,
}

impl Elements {
    pub(super) fn new(kind: &'static str) -> Self {
        Self {
            kind,
            places: Vec::new(),
            corners: Vec::new(),
            ends: Vec::new(),
        }
    }

    pub(super) fn count(&self) -> usize {
        self.ends.len()
    }

    /// Adds the element on the rest of a line. An index below 0 counts back from the latest of the vertices
    /// so far, which is −1.
    pub(super) fn add(&mut self, tokens: &mut Tokens, vertices_before: usize) -> Result<(), ParseError> {
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
    pub(super) fn move_last(&mut self, corners: usize, to: &mut Self) {
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
    pub(super) fn corners(&self, elements: Range<usize>) -> &[i64] {
        let end = |count: usize| if count == 0 { 0 } else { self.ends[count - 1] };
        &self.corners[end(elements.start)..end(elements.end)]
    }

    /// The line and the vertices of each element.
    pub(super) fn resolved(
        &self,
        vertex_count: usize,
    ) -> impl Iterator<Item = Result<(Place, Vec<u32>), ParseError>> {
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

    pub(super) fn charge(&self, budget: &Budget) {
        budget.hold::<(Place, usize)>(self.count());
        budget.hold::<i64>(self.corners.len());
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
