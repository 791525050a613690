//! Displacements of rods, which are chains of edges without faces, out of the faces that they pierce.

use std::collections::BTreeMap;

use exact_ccd_mesh::vector::{dot, minus, unit};
use exact_ccd_mesh::{Intersection, Point, TriangleMesh};

/// The edges without faces at each vertex.
pub(crate) struct Rods {
    edges: BTreeMap<u32, Vec<u32>>,
    count: usize,
}

/// The places of crossings on each rod edge, from 0 at its first end to 1, in increasing order.
pub(crate) struct Pierced<'a> {
    mesh: &'a TriangleMesh,
    x: &'a [Point],
    rods: &'a Rods,
    places: BTreeMap<u32, Vec<f64>>,
}

impl Rods {
    pub(crate) fn new(mesh: &TriangleMesh) -> Self {
        let mut edges = BTreeMap::<u32, Vec<u32>>::new();
        for &[a, b] in mesh.loose_edges() {
            if let Some(edge) = mesh.edge(a, b) {
                edges.entry(a).or_default().push(edge);
                edges.entry(b).or_default().push(edge);
            }
        }
        Self {
            edges,
            count: mesh.loose_edges().len(),
        }
    }

    /// Returns true if there is no rod.
    pub(crate) fn is_empty(&self) -> bool {
        self.count == 0
    }
}

impl<'a> Pierced<'a> {
    pub(crate) fn new(
        mesh: &'a TriangleMesh,
        rods: &'a Rods,
        x: &'a [Point],
        intersections: &[Intersection],
        place: impl Fn(&Intersection) -> Option<f64>,
    ) -> Self {
        let mut places = BTreeMap::<u32, Vec<f64>>::new();
        if !rods.is_empty() {
            for pair in intersections {
                if let Some(place) = place(pair) {
                    places.entry(pair.edge).or_default().push(place);
                }
            }
        }
        places
            .values_mut()
            .for_each(|places| places.sort_unstable_by(f64::total_cmp));
        Self {
            mesh,
            x,
            rods,
            places,
        }
    }

    /// The end of an edge through which the shorter part of its rod goes from a place; `None` if neither part
    /// has an end.
    fn shorter_part(&self, edge: u32, place: f64) -> Option<u32> {
        let &[a, b] = self.mesh.edges().get(edge as usize)?;
        let [first, second] = [a, b].map(|end| self.length(edge, place, end));
        let shorter = if first <= second { a } else { b };
        Some(shorter).filter(|_| first.min(second).is_finite())
    }

    /// The displacement of a rod, relative to the face with the unit normal `normal` that its edge pierces at
    /// `place`, that makes the shorter of the two parts of the rod beside the face shorter fastest. A part
    /// ends at the end of the rod, or where the rod pierces the next face. If neither part has an end, there
    /// is no displacement.
    ///
    /// A part of length l begins at s, in the direction E to the face: l = (N · (p − s)) / (N · E), with p a
    /// point of the face. If the rod moves by m, l becomes longer by −(N · m) / (N · E), so that it becomes
    /// shorter fastest along N / (N · E).
    pub(crate) fn displacement(
        &self,
        edge: u32,
        place: f64,
        normal: Point,
        least_slope: f64,
    ) -> Option<Point> {
        let &[a, b] = self.mesh.edges().get(edge as usize)?;
        let from = self.shorter_part(edge, place)?;
        let to = if from == a { b } else { a };
        let along = unit(minus(self.x[to as usize], self.x[from as usize]))?;
        let slope = dot(along, normal);
        let slope = slope.abs().max(least_slope).copysign(slope);
        Some(normal.map(|part| part / slope))
    }

    /// The length of the part of a rod that goes from a place on an edge through one of its ends; infinite if
    /// it has no end.
    fn length(&self, edge: u32, place: f64, end: u32) -> f64 {
        let (mut edge, mut end, mut place) = (edge, end, Some(place));
        let mut sum = 0.0;
        for _ in 0..self.rods.count {
            let Some(&[a, b]) = self.mesh.edges().get(edge as usize) else {
                break;
            };
            let along = minus(self.x[b as usize], self.x[a as usize]);
            let length = dot(along, along).sqrt();
            // Places from the first end of the walk on this edge.
            let turned = |place: f64| if end == b { place } else { 1.0 - place };
            let start = place.take().map_or(0.0, turned);
            let others = self.places.get(&edge).into_iter().flatten().copied();
            let next = others
                .map(turned)
                .filter(|&other| other > start)
                .fold(f64::INFINITY, f64::min);
            if next.is_finite() {
                return sum + (next - start) * length;
            }
            sum += (1.0 - start) * length;
            let others: Vec<u32> = self.rods.edges.get(&end).map_or_else(Vec::new, |edges| {
                edges.iter().copied().filter(|&other| other != edge).collect()
            });
            match others[..] {
                [] => return sum,
                [next] => {
                    edge = next;
                    let [a, b] = self.mesh.edges()[next as usize];
                    end = if a == end { b } else { a };
                }
                _ => break,
            }
        }
        f64::INFINITY
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rod_is_pulled_out_by_its_shorter_part() {
        let edges = [[0, 1], [1, 2], [2, 3]];
        let mesh = TriangleMesh::with_edges(7, vec![[4, 5, 6]], &edges).expect("the indices are in range");
        let x = [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 2.0], [0.0, 0.0, 3.0]];
        let x = [&x[..], &[[-1.0, -1.0, 1.25], [2.0, 0.0, 1.25], [0.0, 2.0, 1.25]]].concat();
        let rods = Rods::new(&mesh);
        let edge = mesh.edge(1, 2).expect("it is an edge of the mesh");
        let pair = Intersection { edge, face: 0 };
        let pierced = Pierced::new(&mesh, &rods, &x, &[pair], |_| Some(0.25));
        assert_eq!([1, 2].map(|end| pierced.length(edge, 0.25, end)), [1.25, 1.75]);
        let up = Some([0.0, 0.0, 1.0]);
        for normal in [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]] {
            assert_eq!(pierced.displacement(edge, 0.25, normal, 1e-3), up);
        }
        let closed = TriangleMesh::with_edges(3, Vec::new(), &[[0, 1], [1, 2], [2, 0]]).expect("as before");
        let rods = Rods::new(&closed);
        let pierced = Pierced::new(&closed, &rods, &x[..3], &[], |_| None);
        assert_eq!(pierced.length(0, 0.5, 1), f64::INFINITY);
    }
}
