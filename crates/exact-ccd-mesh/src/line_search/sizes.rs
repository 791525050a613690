//! The sizes of the steps of all vertices, from round to round.

use exact_ccd::Point;

use super::error::LineSearchError;
use super::precision::Precision;
use super::retreat::Retreats;
use super::watched::{Watch, watched};
use crate::pairs::{MinDistance, Pair};
use crate::search::CulledSearch;
use crate::steps::Step;

/// The sizes of the steps of all vertices.
pub(super) struct Sizes<'a> {
    step: Step<'a>,
    precision: Precision,
    /// The size of each vertex.
    pub(super) sizes: Vec<f64>,
    /// The positions at these sizes.
    pub(super) positions: Vec<Point>,
    /// The size below which no vertex falls.
    least: f64,
    /// True for vertices that are not pinned and have a size above the least.
    can_retreat: Vec<bool>,
    is_pinned: Vec<bool>,
    /// The vertices that have fallen since the search before; `None` if all pairs have to be searched.
    has_fallen: Option<Vec<bool>>,
}

impl<'a> Sizes<'a> {
    /// All vertices go all the way.
    pub(super) fn new(step: Step<'a>, pinned: &[u32], precision: Precision) -> Result<Self, LineSearchError> {
        let vertex_count = step.mesh().vertex_count();
        let mut is_pinned = vec![false; vertex_count];
        for &vertex in pinned {
            let place = is_pinned.get_mut(vertex as usize);
            *place.ok_or(LineSearchError::Pinned { vertex, vertex_count })? = true;
        }
        let [_, x1] = step.positions();
        Ok(Self {
            step,
            precision,
            sizes: vec![1.0; vertex_count],
            positions: precision.rounded(x1.to_vec()),
            least: 0.0,
            can_retreat: is_pinned.iter().map(|is_pinned| !is_pinned).collect(),
            is_pinned,
            has_fallen: None,
        })
    }

    /// The least size.
    pub(super) fn least(&self) -> f64 {
        self.least
    }

    /// Replaces the least size, below which no size is. All pairs are searched next.
    pub(super) fn set_least(&mut self, least: f64) {
        self.least = least;
        self.has_fallen = None;
        self.update_can_retreat();
    }

    /// Searches the step to the positions for contact: the result of [`Retreats::found`].
    pub(super) fn search(
        &self,
        search: &mut CulledSearch,
        min_distance: &MinDistance,
        watch: &Watch<'_>,
    ) -> Result<(Vec<f64>, Vec<Pair>), LineSearchError> {
        let [x0, _] = self.step.positions();
        let step = Step::new(self.step.mesh(), x0, &self.positions)?;
        let retreats = Retreats::new(step, &self.can_retreat);
        let retreats = watched(retreats, watch, |watched| match &self.has_fallen {
            Some(has_fallen) => search.run_marked(&step, min_distance, has_fallen, watched),
            None => search.run(&step, min_distance, watched),
        })?;
        Ok(retreats.found())
    }

    /// Holds vertices back: to `kept` times the time of the first contact that does, from the size before.
    pub(super) fn hold_back(&mut self, times: &[f64], kept: f64) {
        for (vertex, &time) in times.iter().enumerate().filter(|(_, time)| time.is_finite()) {
            let before = self.sizes[vertex];
            // Below the size before, even if nothing is lost to the time and to the factor.
            let size = (kept * time * before).min(before.next_down()).max(self.least);
            self.set(vertex, size);
        }
        let has_fallen = self.has_fallen.get_or_insert_default();
        has_fallen.clear();
        has_fallen.extend(times.iter().map(|time| time.is_finite()));
        self.update_can_retreat();
    }

    /// Holds all vertices back that are not pinned: to the least size.
    pub(super) fn hold_all_back(&mut self) {
        for vertex in 0..self.sizes.len() {
            if self.can_retreat[vertex] {
                self.set(vertex, self.least);
            }
        }
        self.has_fallen = Some(self.can_retreat.clone());
        self.update_can_retreat();
    }

    fn set(&mut self, vertex: usize, size: f64) {
        self.sizes[vertex] = size;
        self.positions[vertex] = self.precision.round(self.step.vertex_at(vertex, size));
    }

    fn update_can_retreat(&mut self) {
        let vertices = self.sizes.iter().zip(&self.is_pinned);
        self.can_retreat.clear();
        self.can_retreat
            .extend(vertices.map(|(&size, &is_pinned)| !is_pinned && size > self.least));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::TriangleMesh;

    #[test]
    fn all_but_the_pinned_vertices_go_to_the_least_size() {
        let mesh = TriangleMesh::new(3, Vec::new()).expect("there are no faces");
        let (x0, x1) = ([[0.0; 3]; 3], [[8.0; 3]; 3]);
        let step = Step::new(&mesh, &x0, &x1).expect("all positions are finite");
        let mut sizes = Sizes::new(step, &[1], Precision::Double).expect("the mesh has the vertex");
        sizes.set_least(0.25);
        sizes.hold_all_back();
        assert_eq!(sizes.sizes, [0.25, 1.0, 0.25]);
        assert_eq!(sizes.positions, [[2.0; 3], [8.0; 3], [2.0; 3]]);
        assert_eq!(sizes.has_fallen, Some(vec![true, false, true]));
        assert_eq!(sizes.can_retreat, [false; 3]);
        sizes.set_least(0.125);
        assert_eq!(sizes.has_fallen, None);
        assert_eq!(sizes.can_retreat, [true, false, true]);
    }
}
