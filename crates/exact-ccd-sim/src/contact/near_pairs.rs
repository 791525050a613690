//! The pairs of primitives that come near each other in a step.

use std::sync::Arc;

use exact_ccd::batch::Trajectories;
use exact_ccd::separation::{Separation, Separations, Thickness};
use exact_ccd::{EdgeEdge, Kind, VertexEdge, VertexFace, VertexVertex};
use exact_ccd_mesh::{Aabb, Boxes, BroadPhase, Bvh, Candidates, PairCollector, PairKind, Step};
use rayon::prelude::*;

use super::apart::Apart;

/// Pairs of primitives that come near each other in a step, and the distance that they keep.
///
/// Beside the pairs of a vertex and a face and of two edges, they are those of a particle and a rod's edge and
/// of two particles, which no other pair covers.
#[derive(Clone, Debug, Default)]
pub struct NearPairs {
    candidates: Candidates,
    vertex_edge: Vec<[u32; 3]>,
    vertex_vertex: Vec<[u32; 2]>,
    /// The offsets of the vertices, if there are any.
    thickness: Option<Arc<Thickness>>,
}

/// The number of pairs that a thread examines at a time.
const GRAIN: usize = 256;

impl From<Candidates> for NearPairs {
    /// The pairs of surfaces without offsets, without particles.
    fn from(candidates: Candidates) -> Self {
        Self {
            candidates,
            ..Self::default()
        }
    }
}

impl NearPairs {
    /// The pairs among the candidates of a step, and among particles, loose edges and particles, whose surfaces
    /// come within a distance `reach` (in m). `thickness` has the offsets of the vertices, if there are any;
    /// the candidates must be those within `reach` and the greatest sum of two offsets.
    #[must_use]
    pub fn new(
        candidates: Candidates,
        step: Step<'_>,
        particles: &[u32],
        reach: f64,
        thickness: Option<Arc<Thickness>>,
    ) -> Self {
        let (candidates, greatest) = match &thickness {
            None => (candidates, 0.0),
            Some(thickness) => {
                let apart = Apart::new(step, thickness, reach);
                let kept = Candidates::from_ids(
                    apart.kept::<VertexFace>(candidates.vertex_face()),
                    apart.kept::<EdgeEdge>(candidates.edge_edge()),
                );
                (kept, apart.greatest)
            }
        };
        let (vertex_edge, vertex_vertex) = of_particles(step, particles, reach + greatest);
        Self {
            candidates,
            vertex_edge,
            vertex_vertex,
            thickness,
        }
    }

    /// The pairs of a vertex and a face, and of two edges.
    #[must_use]
    pub fn candidates(&self) -> &Candidates {
        &self.candidates
    }

    /// The pairs of a particle and an edge, by their vertices.
    #[must_use]
    pub fn vertex_edge(&self) -> &[[u32; 3]] {
        &self.vertex_edge
    }

    /// The pairs of two particles.
    #[must_use]
    pub fn vertex_vertex(&self) -> &[[u32; 2]] {
        &self.vertex_vertex
    }

    /// True if surfaces have offsets.
    #[must_use]
    pub fn is_thick(&self) -> bool {
        self.thickness.is_some()
    }

    /// The time, rounded down, at which the first pair comes within the distance that it keeps; exactly, and
    /// `None` if none does. Without offsets, the pairs of particles only: a method decides all others.
    pub(crate) fn earliest_time(&self, step: Step<'_>) -> Option<f64> {
        let [x0, x1] = step.positions();
        // The positions of a step are finite.
        let trajectories = Trajectories::new(x0, x1).ok()?;
        let separations = self.separations();
        let (faces, edges) = self.covered(step);
        [
            earliest::<VertexFace>(&trajectories, &faces, separations),
            earliest::<EdgeEdge>(&trajectories, &edges, separations),
            earliest::<VertexEdge>(&trajectories, &self.vertex_edge, separations),
            earliest::<VertexVertex>(&trajectories, &self.vertex_vertex, separations),
        ]
        .into_iter()
        .flatten()
        .reduce(f64::min)
    }

    /// The vertices of the first pair that is within the distance that it keeps, at a step without motion, split
    /// into its two primitives.
    pub(crate) fn first_within(&self, step: Step<'_>) -> Option<[Vec<u32>; 2]> {
        let [x0, x1] = step.positions();
        let trajectories = Trajectories::new(x0, x1).ok()?;
        let separations = self.separations();
        let (faces, edges) = self.covered(step);
        first::<VertexFace>(&trajectories, &faces, separations)
            .or_else(|| first::<EdgeEdge>(&trajectories, &edges, separations))
            .or_else(|| first::<VertexEdge>(&trajectories, &self.vertex_edge, separations))
            .or_else(|| first::<VertexVertex>(&trajectories, &self.vertex_vertex, separations))
    }

    fn separations(&self) -> Separations<'_> {
        match &self.thickness {
            Some(thickness) => Separations::Thickness(thickness),
            None => Separations::Uniform(Separation::default()),
        }
    }

    /// The vertices of the pairs of a vertex and a face and of two edges, if surfaces have offsets.
    fn covered(&self, step: Step<'_>) -> (Vec<[u32; 4]>, Vec<[u32; 4]>) {
        if !self.is_thick() {
            return (Vec::new(), Vec::new());
        }
        let mesh = step.mesh();
        let faces = self.candidates.vertex_face().iter();
        let edges = self.candidates.edge_edge().iter();
        (
            faces
                .filter_map(|&pair| VertexFace::vertices(mesh, pair))
                .collect(),
            edges.filter_map(|&pair| EdgeEdge::vertices(mesh, pair)).collect(),
        )
    }
}

/// The earliest time at which a query comes within its separation.
fn earliest<K: Kind>(
    trajectories: &Trajectories,
    queries: &[K::Vertices],
    separations: Separations<'_>,
) -> Option<f64> {
    let of_chunk = |queries: &[K::Vertices]| {
        let mut earliest: Option<f64> = None;
        let outcome = trajectories.collisions_within::<K>(queries, separations, |_, collision| {
            let time = collision.time_of_impact();
            earliest = Some(earliest.map_or(time, |earliest| earliest.min(time)));
        });
        // All vertices exist; a query that cannot be decided would not be free.
        outcome.map_or(Some(0.0), |()| earliest)
    };
    queries
        .par_chunks(GRAIN)
        .filter_map(of_chunk)
        .reduce_with(f64::min)
}

/// The first query that comes within its separation, by the vertices of both primitives.
fn first<K: Kind>(
    trajectories: &Trajectories,
    queries: &[K::Vertices],
    separations: Separations<'_>,
) -> Option<[Vec<u32>; 2]> {
    let mut first = None;
    let _ = trajectories.collisions_within::<K>(queries, separations, |index, _| {
        first.get_or_insert(index);
    });
    let (a, b) = queries[first?].as_ref().split_at(K::FIRST);
    Some([a.to_vec(), b.to_vec()])
}

/// The pairs of a particle and a loose edge, and of two particles, that come within a distance in a step.
fn of_particles(step: Step<'_>, particles: &[u32], distance: f64) -> (Vec<[u32; 3]>, Vec<[u32; 2]>) {
    if particles.is_empty() {
        return (Vec::new(), Vec::new());
    }
    let edges = step.mesh().loose_edges();
    let [x0, x1] = step.positions();
    let around = |vertices: &[u32]| {
        let points = vertices.iter().flat_map(|&v| [x0[v as usize], x1[v as usize]]);
        let path: Aabb = points.collect();
        // Each side moves by the distance, twice as far as needed, so that rounding does not matter.
        [Aabb {
            lower: path.lower.map(|x| x - distance),
            upper: path.upper.map(|x| x + distance),
        }]
    };
    let of_particles = particles.iter().map(|&vertex| around(&[vertex]));
    let boxes: Vec<[Aabb; 1]> = of_particles
        .chain(edges.iter().map(|ends| around(ends)))
        .collect();
    let Ok(boxes) = Boxes::new(&boxes) else {
        return (Vec::new(), Vec::new());
    };
    let found = PairCollector::default();
    let is_of_particle = |&[a, _]: &[u32; 2]| (a as usize) < particles.len();
    let _ = Bvh.within(&boxes, &|pairs| {
        found.add(pairs.iter().copied().filter(is_of_particle))
    });
    let (mut vertex_edge, mut vertex_vertex) = (Vec::new(), Vec::new());
    for [a, b] in found.into_sorted() {
        let vertex = particles[a as usize];
        match (b as usize).checked_sub(particles.len()) {
            Some(edge) => vertex_edge.push([vertex, edges[edge][0], edges[edge][1]]),
            None => vertex_vertex.push([vertex, particles[b as usize]]),
        }
    }
    (vertex_edge, vertex_vertex)
}
