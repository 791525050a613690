//! Lists of cells.

use std::ops::Range;

use super::super::cells::Cells;
use super::cell;
use crate::error::{Fault, ParseError, Place, quoted};

/// Cells as VTK stores them: the corners of all cells, their number up to the end of each cell, and
/// the type of each.
pub(super) struct CellList<'a> {
    pub(super) corners: &'a [i64],
    pub(super) ends: &'a [i64],
    pub(super) types: &'a [i64],
    /// The place of the list in the file.
    pub(super) place: &'a dyn Fn() -> Place,
}

impl CellList<'_> {
    /// Appends the cells. Their corners are counted from the first of these points.
    pub(super) fn add_to(&self, cells: &mut Cells, points: Range<usize>) -> Result<(), ParseError> {
        let fault = |expected: String, found: String| Fault::expected(expected, found).at((self.place)());
        if self.ends.len() != self.types.len() {
            let found = format!("{} offsets and {} types", self.ends.len(), self.types.len());
            return Err(fault("as many offsets as types".to_owned(), found));
        }
        let vertex = |corner: i64| {
            let corner = usize::try_from(corner).ok()?.checked_add(points.start)?;
            u32::try_from(corner).ok().filter(|_| corner < points.end)
        };
        let mut rest = self.corners;
        let (mut start, mut numbered) = (0, Vec::new());
        for (number, (&end, &kind)) in self.ends.iter().zip(self.types).enumerate() {
            let corners = usize::try_from(end.saturating_sub(start))
                .ok()
                .and_then(|count| rest.split_off(..count))
                .ok_or_else(|| fault(format!("the end of cell {number}"), format!("offset {end}")))?;
            start = end;
            numbered.clear();
            numbered.extend(corners.iter().map_while(|&corner| vertex(corner)));
            if numbered.len() < corners.len() {
                let expected = format!("corners of cell {number} among the {} points", points.len());
                return Err(fault(expected, quoted(format!("{corners:?}").as_bytes())));
            }
            cell::add(cells, number, kind, &numbered, self.place)?;
        }
        match rest {
            [] => Ok(()),
            _ => Err(fault(format!("{start} corners"), self.corners.len().to_string())),
        }
    }
}
