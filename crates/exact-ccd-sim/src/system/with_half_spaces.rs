//! The half spaces of a system.

use exact_ccd_mesh::{Point, Separation, Step};

use super::geometry::Geometry;
use super::{Designation, System, SystemError};
use crate::half_space::{HalfSpace, Plane};

impl System {
    /// The same system with these half spaces as obstacles, in place of its own.
    ///
    /// # Errors
    /// [`SystemError::HalfSpace`] names the first one without a finite point or a normal.
    pub fn with_half_spaces(mut self, half_spaces: Vec<HalfSpace>) -> Result<Self, SystemError> {
        self.geometry.half_spaces = half_spaces;
        for (number, half_space) in self.geometry.half_spaces.iter().enumerate() {
            half_space.check().map_err(|source| SystemError::HalfSpace {
                half_space: self.geometry.half_space_designation(number),
                source,
            })?;
        }
        Ok(self)
    }

    /// The half spaces.
    #[must_use]
    pub fn half_spaces(&self) -> &[HalfSpace] {
        &self.geometry.half_spaces
    }

    /// The first vertex that is not apart from a half space, exactly, with the number of this half space.
    /// A linear motion is free of contact with half spaces if there is none at both of its ends.
    #[must_use]
    pub fn first_grounded(&self, positions: &[Point]) -> Option<(u32, usize)> {
        self.geometry.first_grounded(positions)
    }
}

impl Geometry {
    /// The half space at a place, in messages.
    pub(super) fn half_space_designation(&self, place: usize) -> Designation {
        let half_space = self.half_spaces.get(place);
        Designation::of_half_space(place, half_space.map_or("", |half_space| &half_space.name))
    }

    /// The first vertex that is not apart from a half space, with the number of this half space.
    pub(crate) fn first_grounded(&self, positions: &[Point]) -> Option<(u32, usize)> {
        let touches = |half_space: &HalfSpace, vertex: u32| {
            let (at, offset) = (positions.get(vertex as usize), self.offsets[vertex as usize]);
            let is_apart = |&at: &Point| Separation::new(offset).is_ok_and(|d| half_space.is_apart(at, d));
            at.is_some_and(|at| !is_apart(at))
        };
        let numbered = self.half_spaces.iter().enumerate();
        numbered.into_iter().find_map(|(number, half_space)| {
            let vertex = self
                .grounded
                .iter()
                .find(|&&vertex| touches(half_space, vertex))?;
            Some((*vertex, number))
        })
    }

    /// The vertices that enter a half space in a step, with the parts of the step in which they stay apart.
    pub(crate) fn held_back_by_half_spaces(&self, step: Step<'_>) -> impl Iterator<Item = (u32, f64)> {
        let [before, after] = step.positions();
        let planes: Vec<Plane> = self.half_spaces.iter().map(Plane::of).collect();
        let part = move |&vertex: &u32| {
            let at = vertex as usize;
            let parts = planes
                .iter()
                .map(|plane| plane.free_part([before[at], after[at]], self.offsets[at]));
            (vertex, parts.fold(1.0, f64::min))
        };
        let parts = self.grounded.iter().map(part);
        parts.filter(|(_, part)| *part < 1.0)
    }

    /// The part of a step that is free of contact with half spaces. It is 1 only if all of the step is free;
    /// a smaller part is not certified.
    pub(crate) fn free_of_half_spaces(&self, step: Step<'_>) -> f64 {
        let [_, after] = step.positions();
        if self.first_grounded(after).is_none() {
            return 1.0;
        }
        let parts = self.held_back_by_half_spaces(step).map(|(_, part)| part);
        parts.fold(1.0_f64.next_down(), f64::min).max(f64::EPSILON)
    }
}
