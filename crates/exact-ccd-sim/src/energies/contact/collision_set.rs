//! The constraint set: all collisions of one configuration.

use std::ops::Range;

use exact_ccd::{AnyKind, EdgeEdge, VertexEdge, VertexFace};
use exact_ccd_mesh::{Candidates, PairKind, Point};
use nalgebra::Vector3;
use rayon::prelude::*;

use super::barrier::Barrier;
use super::collision::Collision;
use super::surface::Surface;
use super::weights::Corrections;
use crate::energies::distance::{Feature, Mollifier, edge_edge, point_edge, point_triangle};
use crate::energies::term::{Energy, gather};
use crate::half_space::Plane;

/// The constraint set of one configuration: all pairs of features within the activation distance.
#[derive(Clone, Debug)]
pub(crate) struct CollisionSet {
    collisions: Vec<Collision>,
    minimum: f64,
}

impl CollisionSet {
    /// The collisions among the candidate pairs of a surface, with the vertices at `points`. `barrier` is the
    /// barrier of surfaces without thickness.
    ///
    /// Two edges that are nearly parallel have a mollified barrier, which vanishes for parallel edges. On
    /// surfaces of faces, the pairs of a vertex and a face remain. Rods have no faces: where one of two
    /// edges is loose, each end of one and the other edge are a pair of their own, and so is the end of a
    /// rod with the edge before the last. With [weights](Surface::weights), the sum is the
    /// convergent formulation.
    ///
    /// # Panics
    /// If a vertex of a pair has no position.
    pub(crate) fn new(
        surface: Surface<'_>,
        candidates: &Candidates,
        points: &[Point],
        barrier: Barrier,
    ) -> Self {
        let all = near(surface, candidates, points, barrier);
        let minimum = all.iter().fold(f64::INFINITY, |least, (gap, _)| least.min(*gap));
        let mut collisions: Vec<Collision> = all.into_iter().map(|(_, collision)| collision).collect();
        // The sort is stable, so that the order does not depend on threads.
        collisions.sort_by(|a, b| a.vertices().cmp(b.vertices()));
        collisions.dedup_by(|next, kept| {
            let same = next.is_same(kept);
            if same {
                kept.merge(next);
            }
            same
        });
        collisions.retain(|collision| !collision.is_cancelled());
        Self { collisions, minimum }
    }

    /// The collision with the least distance between two surfaces, and that distance in m. `None` if there is
    /// none. The arguments are as for [`CollisionSet::new`].
    pub(crate) fn nearest(
        surface: Surface<'_>,
        candidates: &Candidates,
        points: &[Point],
        barrier: Barrier,
    ) -> Option<(f64, Collision)> {
        let all = near(surface, candidates, points, barrier);
        all.into_iter().min_by(|(a, _), (b, _)| a.total_cmp(b))
    }

    /// The distinct collisions, sorted by their vertices.
    pub(crate) fn as_slice(&self) -> &[Collision] {
        &self.collisions
    }

    /// The number of collisions that do not only correct the sum of others.
    pub(crate) fn count(&self) -> usize {
        let repulsive = self
            .collisions
            .iter()
            .filter(|collision| collision.is_repulsive());
        repulsive.count()
    }

    /// The least distance between two surfaces, in m: the distance of primitives minus their thickness.
    /// Infinite if there is no collision.
    pub(crate) fn minimal_distance(&self) -> f64 {
        self.minimum
    }
}

/// All near pairs of primitives, with the distances between their surfaces, in an order that does not depend
/// on threads.
fn near(
    surface: Surface<'_>,
    candidates: &Candidates,
    points: &[Point],
    barrier: Barrier,
) -> Vec<(f64, Collision)> {
    let mesh = surface.mesh;
    let near = Near {
        surface,
        points,
        barrier,
    };
    let faces = candidates
        .of_kind(AnyKind::VertexFace)
        .par_iter()
        .filter_map(|&pair| {
            let vertices = VertexFace::vertices(mesh, pair)?;
            let weight = surface.weight_of_vertex(pair[0])?;
            let (gap, collision) = near.collision(vertices, 1..4, point_triangle, None)?;
            Some((pair, (gap, collision.weighted(weight))))
        });
    let edges = candidates
        .of_kind(AnyKind::EdgeEdge)
        .par_iter()
        .filter_map(|&pair| {
            let vertices = EdgeEdge::vertices(mesh, pair)?;
            let weight = surface.weight_of_edges(pair)?;
            let (gap, collision) =
                near.collision(vertices, 2..4, edge_edge, Some(&|| near.mollifier(vertices)))?;
            Some((gap, collision.weighted(weight)))
        });
    let ends = ends_and_edges(surface, candidates);
    let ends = ends
        .par_iter()
        .filter_map(|&[vertex, a, b]| near.vertex_and_edge(vertex, [a, b]));
    let rods = candidates
        .of_kind(AnyKind::VertexEdge)
        .par_iter()
        .filter_map(|&pair| {
            let vertices = VertexEdge::vertices(mesh, pair)?;
            near.vertex_and_rod(vertices)
        });
    let (pairs, mut all): (Vec<[u32; 2]>, Vec<(f64, Collision)>) = faces.unzip();
    all.par_extend(edges);
    all.par_extend(ends);
    all.par_extend(rods);
    let points = candidates.of_kind(AnyKind::VertexVertex).par_iter();
    all.par_extend(points.filter_map(|&pair| near.two_vertices(pair)));
    all.extend(near.corrections(&pairs));
    for (half_space, plane) in (0..).zip(surface.half_spaces.iter().map(Plane::of)) {
        all.par_extend(
            surface
                .grounded
                .par_iter()
                .filter_map(|&vertex| near.ground(vertex, half_space, plane)),
        );
    }
    all
}

/// The test of one pair of primitives.
struct Near<'a> {
    surface: Surface<'a>,
    points: &'a [Point],
    barrier: Barrier,
}

impl Near<'_> {
    /// The collision of two primitives, with the distance between their surfaces, if they are within the
    /// activation distance. The first primitive has the vertices before `second`.
    fn collision(
        &self,
        vertices: [u32; 4],
        second: Range<usize>,
        feature: impl FnOnce(&[Vector3<f64>; 4]) -> Feature,
        mollifier: Option<&dyn Fn() -> Mollifier>,
    ) -> Option<(f64, Collision)> {
        let [a, b] = [0..second.start, second.clone()].map(|range| &vertices[range]);
        let thickness = self.surface.thickness(a, b);
        self.collision_within(thickness, vertices, second, feature, mollifier)
    }

    /// The same for primitives with another thickness.
    fn collision_within(
        &self,
        thickness: f64,
        vertices: [u32; 4],
        second: Range<usize>,
        feature: impl FnOnce(&[Vector3<f64>; 4]) -> Feature,
        mollifier: Option<&dyn Fn() -> Mollifier>,
    ) -> Option<(f64, Collision)> {
        let corners = gather(self.points, &vertices);
        let first = 0..second.start;
        let farthest = thickness + self.barrier.activation_distance();
        let [a, b] = [&corners[first], &corners[second]];
        if are_apart(a, b, farthest) || are_apart_between_centers(a, b, farthest) {
            return None;
        }
        let feature = feature(&corners);
        let squared = feature.shortest_vector(&corners).squared();
        let barrier = self.barrier.with_thickness(thickness);
        barrier.is_active(squared).then(|| {
            let mollifier = mollifier
                .map(|mollifier| mollifier())
                .filter(|mollifier| mollifier.is_active(&corners));
            let collision = match mollifier {
                Some(mollifier) => Collision::mollified(vertices, feature, mollifier, barrier),
                None => Collision::new(vertices, feature, barrier),
            };
            (
                barrier.gap(squared),
                collision.with_fixed(|vertex| self.surface.is_fixed(vertex)),
            )
        })
    }

    /// The collision of a vertex and an edge.
    fn vertex_and_edge(&self, vertex: u32, [a, b]: [u32; 2]) -> Option<(f64, Collision)> {
        let feature = |points: &[Vector3<f64>; 4]| point_edge(points, 0, 1, 2);
        self.collision([vertex, a, b, vertex], 1..3, feature, None)
    }

    /// The collision of a vertex and an edge of a rod that are a pair of their own. If an edge connects them,
    /// the rod has no thickness there: its filter keeps the distance 0.
    fn vertex_and_rod(&self, vertices: [u32; 3]) -> Option<(f64, Collision)> {
        let [vertex, a, b] = vertices;
        if !VertexEdge::are_connected(self.surface.mesh, &vertices) {
            return self.vertex_and_edge(vertex, [a, b]);
        }
        let feature = |points: &[Vector3<f64>; 4]| point_edge(points, 0, 1, 2);
        self.collision_within(0.0, [vertex, a, b, vertex], 1..3, feature, None)
    }

    /// The collision of two vertices.
    fn two_vertices(&self, [a, b]: [u32; 2]) -> Option<(f64, Collision)> {
        self.collision([a, b, a, a], 1..2, |_| Feature::point_point(0, 1), None)
    }

    /// The collisions that correct the sum over these near pairs of a vertex and a face, in the convergent
    /// formulation.
    fn corrections(&self, pairs: &[[u32; 2]]) -> Vec<(f64, Collision)> {
        let (mesh, Some(weights)) = (self.surface.mesh, self.surface.weights) else {
            return Vec::new();
        };
        let Corrections { edges, vertices } = weights.corrections(mesh, pairs);
        let edges = edges.par_iter().filter_map(|&([vertex, edge], count)| {
            let (gap, collision) = self.vertex_and_edge(vertex, mesh.edges()[edge as usize])?;
            Some((gap, collision.weighted(count * weights.of_vertex(vertex)?)))
        });
        let vertices = vertices.par_iter().filter_map(|&pair| {
            let (gap, collision) = self.two_vertices(pair)?;
            Some((gap, collision.weighted(weights.of_vertex(pair[0])?)))
        });
        let mut all: Vec<(f64, Collision)> = edges.collect();
        all.par_extend(vertices);
        all
    }

    /// The collision of a vertex and a half space, with the distance between their surfaces.
    fn ground(&self, vertex: u32, half_space: u32, plane: Plane) -> Option<(f64, Collision)> {
        let thickness = self.surface.thickness(&[vertex], &[]);
        let barrier = self.barrier.with_thickness(thickness);
        let height = plane
            .height(&Vector3::from(self.points[vertex as usize]))
            .max(0.0);
        let squared = height * height;
        barrier.is_active(squared).then(|| {
            let weight = self.surface.weight_of_vertex(vertex).unwrap_or(1.0);
            let collision = Collision::with_half_space(vertex, half_space, plane, barrier);
            (barrier.gap(squared), collision.weighted(weight))
        })
    }

    fn mollifier(&self, edges: [u32; 4]) -> Mollifier {
        let [a, b, c, d] = gather(self.surface.rest, &edges);
        Mollifier::new([(b - a).norm_squared(), (d - c).norm_squared()])
    }
}

/// For each pair of edges with a loose one, the pairs of an end of one edge and the other edge, by their
/// vertices. Each occurs once.
fn ends_and_edges(surface: Surface<'_>, candidates: &Candidates) -> Vec<[u32; 3]> {
    let mesh = surface.mesh;
    let first_loose = (mesh.edges().len() - mesh.loose_edges().len()) as u32;
    let mut pairs: Vec<[u32; 3]> = Vec::new();
    for &[a, b] in candidates.of_kind(AnyKind::EdgeEdge) {
        if a.max(b) >= first_loose
            && surface.weight_of_edges([a, b]).is_some()
            && let Some([p, q, r, s]) = EdgeEdge::vertices(mesh, [a, b])
        {
            pairs.extend([[p, r, s], [q, r, s], [r, p, q], [s, p, q]]);
        }
    }
    pairs.sort_unstable();
    pairs.dedup();
    pairs
}

/// Returns true if the bounding boxes of two sets of points are more than a distance apart along an axis.
/// This cheap test rejects most pairs.
#[inline]
fn are_apart(a: &[Vector3<f64>], b: &[Vector3<f64>], distance: f64) -> bool {
    (0..3).any(|axis| {
        let range = |points: &[Vector3<f64>]| {
            points
                .iter()
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(lower, upper), point| {
                    (lower.min(point[axis]), upper.max(point[axis]))
                })
        };
        let ((a_lower, a_upper), (b_lower, b_upper)) = (range(a), range(b));
        b_lower - a_upper > distance || a_lower - b_upper > distance
    })
}

/// Returns true if two sets of points are more than a distance apart, up to rounding, along the line between
/// their centers. This test rejects most neighbours in a mesh, whose boxes meet.
#[inline]
fn are_apart_between_centers(a: &[Vector3<f64>], b: &[Vector3<f64>], distance: f64) -> bool {
    let origin = a[0];
    let center = |points: &[Vector3<f64>]| {
        let sum: Vector3<f64> = points.iter().map(|point| point - origin).sum();
        sum / points.len() as f64
    };
    let axis = center(b) - center(a);
    let along = |point: &Vector3<f64>| axis.dot(&(point - origin));
    let last = a.iter().map(along).fold(f64::NEG_INFINITY, f64::max);
    let first = b.iter().map(along).fold(f64::INFINITY, f64::min);
    let gap = first - last;
    gap > 0.0 && gap * gap > distance * distance * axis.norm_squared()
}
