//! The gradient of the length of the intersection contour (Volino and Magnenat-Thalmann 2006).

use exact_ccd_mesh::vector::{cross, dot, minus, unit};
use exact_ccd_mesh::{Intersection, Point, TriangleMesh};

use crate::rods::{Pierced, Rods};

/// The surroundings of each edge.
pub(crate) struct Surroundings {
    wings: Wings,
    rods: Rods,
}

impl Surroundings {
    pub(crate) fn new(mesh: &TriangleMesh) -> Self {
        Self {
            wings: Wings::new(mesh),
            rods: Rods::new(mesh),
        }
    }
}

/// The faces beside each edge.
struct Wings {
    /// The first wing of each edge in `wings`, and the number of all wings.
    first: Vec<u32>,
    /// A face, and its corner that is not on the edge.
    wings: Vec<(u32, u32)>,
}

impl Wings {
    fn new(mesh: &TriangleMesh) -> Self {
        let mut of_edges = Vec::with_capacity(3 * mesh.faces().len());
        for (face, &[a, b, c]) in (0..).zip(mesh.faces()) {
            for [from, to, opposite] in [[a, b, c], [b, c, a], [c, a, b]] {
                if let Some(edge) = mesh.edge(from, to) {
                    of_edges.push((edge, (face, opposite)));
                }
            }
        }
        of_edges.sort_unstable();
        let first_of = |edge: u32| of_edges.partition_point(|&(other, _)| other < edge) as u32;
        Self {
            first: (0..=mesh.edges().len() as u32).map(first_of).collect(),
            wings: of_edges.into_iter().map(|(_, wing)| wing).collect(),
        }
    }

    /// Returns true if an edge has no face.
    fn is_rod(&self, edge: u32) -> bool {
        self.of(edge).is_empty()
    }

    /// The faces beside an edge, each with its corner that is not on the edge.
    fn of(&self, edge: u32) -> &[(u32, u32)] {
        let [from, to] = [edge, edge + 1].map(|edge| self.first[edge as usize] as usize);
        &self.wings[from..to]
    }
}

/// Below this sine of the angle between an edge and a face, the edge counts as inclined by this much.
const LEAST_SLOPE: f64 = 1e-3;

/// The weight of the displacement along the normal of the pierced face.
const NORMAL_WEIGHT: f64 = 2.0;

/// Below this sine of their angle, two faces count as parallel, and have no line of intersection.
const LEAST_ANGLE: f64 = 1e-9;

/// For each vertex, a displacement that shortens the contour in which the mesh intersects itself, of a length
/// about the number of intersections nearby.
///
/// An edge with direction E pierces a face with normal N at one point of the contour. In each face beside the
/// edge, the contour goes on from there in the direction R of the line in which that face meets the pierced
/// one. If the edge moves relative to the pierced face by a vector m, the point moves in the plane of the
/// pierced face by m − (N · m / N · E) E, and each of these parts of the contour becomes longer by −R times
/// this. So the contour becomes shorter fastest along Σ R − (E · R / E · N) N, the sum over the faces beside
/// the edge. The second term frees an edge along the normal of the face; the authors take it twice, and so
/// does this function. An edge of no face has no contour: see [`Pierced::displacement`].
pub(crate) fn contour_gradient(
    mesh: &TriangleMesh,
    Surroundings { wings, rods }: &Surroundings,
    x: &[Point],
    intersections: &[Intersection],
) -> Vec<Point> {
    let at = |vertex: u32| x[vertex as usize];
    let normal = |face: u32| {
        let [a, b, c] = mesh.faces()[face as usize].map(at);
        unit(cross(minus(b, a), minus(c, a)))
    };
    // From 0 at the first end of the edge to 1.
    let place_of = |pair: &Intersection| {
        let ([a, b], [corner, ..]) = pair.vertices(mesh)?;
        let pierced = normal(pair.face)?;
        let place = dot(minus(at(corner), at(a)), pierced) / dot(minus(at(b), at(a)), pierced);
        Some(if place.is_finite() {
            place.clamp(0.0, 1.0)
        } else {
            0.5
        })
    };
    let on_rods = Pierced::new(mesh, rods, x, intersections, place_of);
    let mut sum = vec![[0.0; 3]; x.len()];
    for pair in intersections {
        let Some(([a, b], corners)) = pair.vertices(mesh) else {
            continue;
        };
        let edge = minus(at(b), at(a));
        let (Some(along), Some(pierced), Some(place)) = (unit(edge), normal(pair.face), place_of(pair))
        else {
            continue;
        };
        let slope = dot(along, pierced);
        let slope = slope.abs().max(LEAST_SLOPE).copysign(slope);
        let rod = || on_rods.displacement(pair.edge, place, pierced, LEAST_SLOPE);
        let mut displacement = wings.is_rod(pair.edge).then(rod).flatten().unwrap_or_default();
        for &(wing, corner) in wings.of(pair.edge) {
            let Some(line) = normal(wing).map(|normal| cross(normal, pierced)) else {
                continue;
            };
            let Some(line) = unit(line).filter(|_| dot(line, line) > LEAST_ANGLE * LEAST_ANGLE) else {
                continue;
            };
            let towards = minus(at(corner), at(a));
            let inward = minus(towards, along.map(|x| x * dot(towards, along)));
            let line = line.map(|x| x * 1.0_f64.copysign(dot(line, inward)));
            let turn = NORMAL_WEIGHT * dot(along, line) / slope;
            displacement =
                [0, 1, 2].map(|axis: usize| displacement[axis] + line[axis] - turn * pierced[axis]);
        }
        let length = dot(displacement, displacement).sqrt().max(1.0);
        let mut add = |vertex: u32, weight: f64| {
            for (sum, part) in sum[vertex as usize].iter_mut().zip(displacement) {
                *sum += weight * part / length;
            }
        };
        add(a, 1.0 - place);
        add(b, place);
        corners.into_iter().for_each(|corner| add(corner, -1.0 / 3.0));
    }
    sum
}

#[cfg(test)]
mod tests {
    use exact_ccd_mesh::{Bvh, IntersectionOptions, intersections};

    use super::*;

    /// A large face in the plane z = 0, and two smaller ones beside the edge 3 4, which pierces it at the
    /// origin.
    fn pierced(x: &[Point]) -> (TriangleMesh, Vec<Intersection>) {
        let faces = vec![[0, 1, 2], [3, 4, 5], [4, 3, 6]];
        let mesh = TriangleMesh::new(7, faces).expect("the indices are in range");
        let found =
            intersections(&mesh, x, &Bvh, &IntersectionOptions::default()).expect("the positions fit");
        (mesh, found)
    }

    const X: [Point; 7] = [
        [-8.0, -8.0, 0.0],
        [8.0, -8.0, 0.0],
        [0.0, 8.0, 0.0],
        [0.2, 0.0, -1.0],
        [-0.2, 0.0, 1.0],
        [1.0, 0.5, -0.5],
        [-0.25, 1.0, 0.5],
    ];

    /// The length of the contour, from the places where the edges pierce the face 0.
    fn contour_length(x: &[Point]) -> f64 {
        let (mesh, found) = pierced(x);
        let place = |edge: [u32; 2]| {
            let [a, b] = edge.map(|vertex| x[vertex as usize]);
            let t = a[2] / (a[2] - b[2]);
            [0, 1, 2].map(|axis: usize| a[axis] + t * (b[axis] - a[axis]))
        };
        let shared = place([3, 4]);
        let edges = found
            .iter()
            .filter(|pair| pair.face == 0)
            .map(|pair| mesh.edges()[pair.edge as usize]);
        let others = edges.filter(|edge| *edge != [3, 4]).map(place);
        others
            .map(|end| dot(minus(end, shared), minus(end, shared)).sqrt())
            .sum()
    }

    #[test]
    fn the_contour_becomes_shorter() {
        let (mesh, found) = pierced(&X);
        assert_eq!(
            found.len(),
            3,
            "the common edge and another side of each small face"
        );
        let gradient = contour_gradient(&mesh, &Surroundings::new(&mesh), &X, &found);
        let moved: Vec<Point> = X
            .iter()
            .zip(&gradient)
            .map(|(x, d)| [0, 1, 2].map(|axis: usize| x[axis] + 1e-3 * d[axis]))
            .collect();
        let [before, after] = [contour_length(&X), contour_length(&moved)];
        assert!(before > 0.0 && after < before - 1e-5, "{before} {after}");
    }

    #[test]
    fn the_sum_of_all_displacements_is_zero() {
        let (mesh, found) = pierced(&X);
        let gradient = contour_gradient(&mesh, &Surroundings::new(&mesh), &X, &found);
        for axis in 0..3 {
            let sum: f64 = gradient.iter().map(|d| d[axis]).sum();
            assert!(sum.abs() < 1e-12, "{sum}");
        }
    }
}
