//! What a line search proposes.

use exact_ccd::{EdgeEdge, Query, VertexFace};
use exact_ccd_mesh::{Point, Step};
use rayon::prelude::*;

use crate::contact::{Pairs, Surface};

/// A step of the whole mesh, and the pairs that can touch in it.
#[derive(Clone, Copy, Debug)]
pub struct Increment<'a> {
    surface: &'a Surface,
    pairs: &'a Pairs,
    start: &'a [Point],
    end: &'a [Point],
}

impl<'a> Increment<'a> {
    /// The step from `start` to `end`. `pairs` holds at least all pairs that can touch in it, or on the way from `start` to
    /// positions between, as those of [`Pairs::near`] do.
    #[must_use]
    pub fn new(surface: &'a Surface, pairs: &'a Pairs, start: &'a [Point], end: &'a [Point]) -> Self {
        Self {
            surface,
            pairs,
            start,
            end,
        }
    }

    /// What moves.
    #[must_use]
    pub fn surface(&self) -> &'a Surface {
        self.surface
    }

    /// The pairs that can touch.
    #[must_use]
    pub fn pairs(&self) -> &'a Pairs {
        self.pairs
    }

    /// The positions at the start.
    #[must_use]
    pub fn start(&self) -> &'a [Point] {
        self.start
    }

    /// The positions at the end.
    #[must_use]
    pub fn end(&self) -> &'a [Point] {
        self.end
    }

    /// The same pairs in a step between other positions.
    #[must_use]
    pub fn between(&self, start: &'a [Point], end: &'a [Point]) -> Self {
        Self { start, end, ..*self }
    }

    /// The positions after a part of the step, rounded; the very end for 1.
    #[must_use]
    pub fn at(&self, fraction: f64) -> Vec<Point> {
        if fraction >= 1.0 {
            return self.end.to_vec();
        }
        let along = |(a, b): (&Point, &Point)| {
            core::array::from_fn(|axis| {
                // Rounding is monotone, but the difference is not exact: the clamp keeps to the box of the step.
                let x = a[axis] + fraction * (b[axis] - a[axis]);
                x.max(a[axis].min(b[axis])).min(a[axis].max(b[axis]))
            })
        };
        self.start.iter().zip(self.end).map(along).collect()
    }

    /// Whether no query of the step is decided to be a contact. Positions that are not finite are.
    #[must_use]
    pub fn is_free(
        &self,
        vertex_face: impl Fn(&Query<VertexFace>) -> bool + Sync,
        edge_edge: impl Fn(&Query<EdgeEdge>) -> bool + Sync,
    ) -> bool {
        let Ok(step) = Step::new(self.surface.mesh(), self.start, self.end) else {
            return false;
        };
        let faces = self.pairs.vertex_face.par_iter();
        let edges = self.pairs.edge_edge.par_iter();
        let hits = faces.any(|&[v, f]| step.vertex_face(v, f).is_some_and(|query| vertex_face(&query)))
            || edges.any(|&[a, b]| step.edge_edge(a, b).is_some_and(|query| edge_edge(&query)));
        !hits
    }

    /// The least of the times of all queries, or `None` if none has one.
    #[must_use]
    pub fn earliest(
        &self,
        vertex_face: impl Fn(&Query<VertexFace>) -> Option<f64> + Sync,
        edge_edge: impl Fn(&Query<EdgeEdge>) -> Option<f64> + Sync,
    ) -> Option<f64> {
        let Ok(step) = Step::new(self.surface.mesh(), self.start, self.end) else {
            return Some(0.0);
        };
        let faces = self.pairs.vertex_face.par_iter();
        let faces = faces.filter_map(|&[v, f]| step.vertex_face(v, f).and_then(|query| vertex_face(&query)));
        let edges = self.pairs.edge_edge.par_iter();
        let edges = edges.filter_map(|&[a, b]| step.edge_edge(a, b).and_then(|query| edge_edge(&query)));
        faces.chain(edges).reduce_with(f64::min)
    }
}
