//! The weights of the terms of the convergent formulation.

use exact_ccd_mesh::{Point, TriangleMesh};
use nalgebra::Vector3;

use crate::energies::term::gather;

/// The sine of the angle between two faces up to which they count as coplanar.
const COPLANAR: f64 = 1e-9;

/// The connectivity and the areas of a surface, from which the weights of its collisions follow.
///
/// The convergent formulation differs from the sum of the barriers over all pairs of primitives:
///
/// - Each term has the area that its vertex or its edge stands for as a weight, so that the sum is an
///   integral over the surface. The terms of ends and edges of rods and of particles have no area; their
///   weight is 1.
/// - The barrier of a vertex acts on its distance from the surface; it is not a sum over all faces near it:
///   from the sum over faces, the terms of their common edges are subtracted, and the terms of their common
///   vertices added (the improved max approximator). Above a plane of triangles, this is exactly the barrier
///   of the height, without a force along the plane.
/// - Flat edges and vertices of obstacles have no terms. A body is nearest to a flat part of an obstacle with
///   a vertex against a face. The pairs that are left out would push the body along the plane.
///
/// Source of the first two: M. Li, Z. Ferguson, T. Schneider, T. Langlois, D. Zorin, D. Panozzo, C. Jiang, D.
/// Kaufman, *Convergent Incremental Potential Contact*, 2023. Weights here are relative to the mean area of
/// the vertices of all bodies with mass, because the stiffness of the barrier is adapted to the scene anyway.
/// Weights of obstacles are at most 1. In the paper, terms are also subtracted from the sum over pairs of
/// edges. Here they are not: where edges are shorter than the contact distance, that sum could become
/// negative.
#[derive(Clone, Debug, Default)]
pub(crate) struct Weights {
    /// The weight of each vertex.
    vertices: Vec<f64>,
    /// The weight of each edge.
    edges: Vec<f64>,
    /// Each edge of each face, with the opposite corner, sorted.
    sides: Vec<[u32; 2]>,
    /// True for vertices of faces that are not on a boundary of the surface.
    is_interior: Vec<bool>,
    is_flat_vertex: Vec<bool>,
    is_flat_edge: Vec<bool>,
}

/// The part of a vertex in a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    /// It belongs to a body with mass.
    Body,
    /// It belongs to an obstacle that moves as a whole.
    Obstacle {
        /// The number of the motion: 0 for obstacles that rest.
        motion: u32,
    },
    /// It belongs to an obstacle with parts that scripts move.
    DeformingObstacle,
}

impl Weights {
    /// The weights of a surface, from its positions at rest and the part of each vertex.
    pub(crate) fn new(mesh: &TriangleMesh, rest: &[Point], parts: &[Part]) -> Self {
        let mut vertices = vec![0.0; mesh.vertex_count()];
        let mut edges = vec![0.0; mesh.edges().len()];
        let mut sides = Vec::new();
        for face in mesh.faces() {
            let [a, b, c] = gather(rest, face);
            let share = (b - a).cross(&(c - a)).norm() / 6.0;
            for (corner, edge) in corners_and_edges(mesh, face) {
                vertices[corner as usize] += share;
                edges[edge as usize] += share;
                sides.push([edge, corner]);
            }
        }
        sides.sort_unstable();

        let is_body = |vertex: u32| parts.get(vertex as usize) == Some(&Part::Body);
        let areas = || {
            (0..)
                .zip(&vertices)
                .filter(|&(vertex, area)| *area > 0.0 && is_body(vertex))
        };
        let mean = areas().map(|(_, area)| area).sum::<f64>() / areas().count() as f64;
        // Points and rods have no area. The area of an obstacle can be arbitrarily large.
        let weight = |area: f64, is_body: bool| match area / mean {
            weight if weight > 0.0 && weight.is_finite() => {
                if is_body {
                    weight
                } else {
                    weight.min(1.0)
                }
            }
            _ => 1.0,
        };
        let vertices: Vec<f64> = (0..)
            .zip(vertices)
            .map(|(v, area)| weight(area, is_body(v)))
            .collect();
        let edges = mesh.edges().iter().zip(edges);
        let edges = edges.map(|(edge, area)| weight(area, is_body(edge[0]))).collect();

        let mut is_flat_edge = vec![false; mesh.edges().len()];
        let mut is_interior = vec![false; mesh.vertex_count()];
        mesh.faces()
            .as_flattened()
            .iter()
            .for_each(|&corner| is_interior[corner as usize] = true);
        let mut is_flat_vertex = is_interior.clone();
        for chunk in sides.chunk_by(|a, b| a[0] == b[0]) {
            let edge = chunk[0][0] as usize;
            let ends = mesh.edges()[edge];
            let is_rigid = matches!(parts.get(ends[0] as usize), Some(Part::Obstacle { .. }));
            if let [[_, c], [_, d]] = *chunk {
                is_flat_edge[edge] = is_rigid && is_flat(&gather(rest, &[ends[0], ends[1], c, d]));
            }
            for end in ends {
                is_interior[end as usize] &= chunk.len() > 1;
                is_flat_vertex[end as usize] &= is_flat_edge[edge];
            }
        }
        Self {
            vertices,
            edges,
            sides,
            is_interior,
            is_flat_vertex,
            is_flat_edge,
        }
    }

    /// The weight of the terms of a vertex. `None` for flat vertices of obstacles.
    pub(super) fn of_vertex(&self, vertex: u32) -> Option<f64> {
        let vertex = vertex as usize;
        (!self.is_flat_vertex[vertex]).then(|| self.vertices[vertex])
    }

    /// The weight of the term of two edges. `None` if one of them is a flat edge of an obstacle.
    pub(super) fn of_edges(&self, edges: [u32; 2]) -> Option<f64> {
        let [a, b] = edges.map(|edge| edge as usize);
        let is_flat = self.is_flat_edge[a] || self.is_flat_edge[b];
        (!is_flat).then(|| 0.5 * (self.edges[a] + self.edges[b]))
    }

    /// The terms that correct the sum over faces near a vertex: the edges and the vertices of these faces,
    /// with the number by which the term counts. `pairs` are the near pairs of a vertex and a face.
    pub(super) fn corrections(&self, mesh: &TriangleMesh, pairs: &[[u32; 2]]) -> Corrections {
        let faces = || {
            pairs
                .iter()
                .map(|&[vertex, face]| (vertex, &mesh.faces()[face as usize]))
        };
        let of_edges =
            faces().flat_map(|(vertex, face)| corners_and_edges(mesh, face).map(|(_, edge)| [vertex, edge]));
        let of_vertices = faces().flat_map(|(vertex, face)| face.map(|corner| [vertex, corner]));
        let edges = distinct(of_edges).into_iter().filter_map(|[vertex, edge]| {
            let start = self.sides.partition_point(|side| side[0] < edge);
            let sides = self.sides[start..].iter().take_while(|side| side[0] == edge);
            let count = sides.filter(|side| side[1] != vertex).count();
            (count > 1).then_some(([vertex, edge], 1.0 - count as f64))
        });
        let vertices = distinct(of_vertices).into_iter().filter(|&[vertex, corner]| {
            self.is_interior[corner as usize] && mesh.edge(vertex, corner).is_none()
        });
        Corrections {
            edges: edges.collect(),
            vertices: vertices.collect(),
        }
    }
}

/// The terms that correct a sum over faces.
pub(super) struct Corrections {
    /// Pairs of a vertex and an edge, each with the number, below 0, by which its term counts.
    pub(super) edges: Vec<([u32; 2], f64)>,
    /// Pairs of two vertices, whose terms count once, by the first of them.
    pub(super) vertices: Vec<[u32; 2]>,
}

fn distinct(pairs: impl Iterator<Item = [u32; 2]>) -> Vec<[u32; 2]> {
    let mut pairs: Vec<[u32; 2]> = pairs.collect();
    pairs.sort_unstable();
    pairs.dedup();
    pairs
}

/// The corners of a face, each with the opposite edge.
fn corners_and_edges(mesh: &TriangleMesh, &[a, b, c]: &[u32; 3]) -> [(u32, u32); 3] {
    // A face has all of its edges.
    [[a, b, c], [b, c, a], [c, a, b]].map(|[corner, p, q]| (corner, mesh.edge(p, q).unwrap_or_default()))
}

/// Returns true if the faces of an edge (the first two points) and two opposite corners are coplanar and on
/// different sides of the edge.
fn is_flat(&[a, b, c, d]: &[Vector3<f64>; 4]) -> bool {
    let edge = b - a;
    let (left, right) = (edge.cross(&(c - a)), (d - a).cross(&edge));
    left.dot(&right) > 0.0 && left.cross(&right).norm() <= COPLANAR * left.norm() * right.norm()
}
