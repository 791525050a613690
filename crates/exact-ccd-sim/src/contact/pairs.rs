//! The broad phase: the one place where this crate asks [`exact_ccd_mesh`] which primitives are near each other.

use exact_ccd_mesh::{Aabb, Boxes, BroadPhase, Bvh, PairCollector, Point};
use rayon::prelude::*;

use super::surface::Surface;

/// How far rounding moves a point at most, in units of the largest coordinate: on its way, or when the whole scene is shifted for
/// parity.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Pairs of primitives without a common vertex, not both of obstacles; sorted.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Pairs {
    /// Pairs of a vertex and a face.
    pub vertex_face: Vec<[u32; 2]>,
    /// Pairs of edges, the smaller index first.
    pub edge_edge: Vec<[u32; 2]>,
}

impl Pairs {
    /// All pairs that come within a distance of each other while the vertices move in straight lines from `start` to `end`,
    /// or from `start` to rounded positions on the way; and some more, those whose boxes do.
    ///
    /// # Panics
    /// If a vertex of the surface has no position.
    #[must_use]
    pub fn near(surface: &Surface, start: &[Point], end: &[Point], distance: f64) -> Self {
        let (faces, edges) = (surface.mesh().faces(), surface.mesh().edges());
        // Half on either side, and what rounding may take.
        let bounds: Aabb = start.iter().chain(end).copied().collect();
        let farthest = bounds
            .lower
            .iter()
            .chain(&bounds.upper)
            .fold(0.0_f64, |far, x| far.max(x.abs()));
        let margin = 0.5 * distance * (1.0 + 1e-9) + ROUNDING * farthest;
        let boxes: Vec<[Aabb; 2]> = (start, end)
            .into_par_iter()
            .map(|(&a, &b)| [grown(a, margin), grown(b, margin)])
            .collect();
        let around = |vertices: &[u32]| {
            let boxes = vertices.iter().map(|&vertex| &boxes[vertex as usize]);
            boxes.fold([Aabb::EMPTY; 2], |all, bounds| {
                [all[0].union(&bounds[0]), all[1].union(&bounds[1])]
            })
        };

        let vertex_boxes: Vec<_> = surface
            .vertices()
            .par_iter()
            .map(|&v| boxes[v as usize])
            .collect();
        let face_boxes: Vec<_> = faces.par_iter().map(|face| around(face)).collect();
        let edge_boxes: Vec<_> = edges.par_iter().map(|edge| around(edge)).collect();
        let [vertex_boxes, face_boxes, edge_boxes] = [vertex_boxes, face_boxes, edge_boxes]
            .map(|boxes| Boxes::new(&boxes).expect("a system has fewer than 2³² primitives"));

        let [vertex_face, edge_edge] = [PairCollector::default(), PairCollector::default()];
        let _ = Bvh.between(&vertex_boxes, &face_boxes, &|pairs| {
            let pairs = pairs
                .iter()
                .map(|&[place, face]| [surface.vertices()[place as usize], face]);
            vertex_face
                .add(pairs.filter(|&[vertex, face]| surface.is_of_concern(&[vertex], &faces[face as usize])))
        });
        let _ = Bvh.within(&edge_boxes, &|pairs| {
            edge_edge.add(pairs.iter().copied().filter(|pair| {
                let [a, b] = pair.map(|edge| edges[edge as usize]);
                surface.is_of_concern(&a, &b)
            }))
        });
        Self {
            vertex_face: vertex_face.into_sorted(),
            edge_edge: edge_edge.into_sorted(),
        }
    }

    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.vertex_face.len() + self.edge_edge.len()
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

fn grown(point: Point, margin: f64) -> Aabb {
    Aabb {
        lower: point.map(|x| x - margin),
        upper: point.map(|x| x + margin),
    }
}
