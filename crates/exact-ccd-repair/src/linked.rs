//! Pinned loops through surfaces with a pinned border, which have no free positions.

use std::collections::{BTreeMap, BTreeSet};

use exact_ccd_mesh::{Intersection, TriangleMesh};

/// A pinned edge and a face, if the edge closes a loop of pinned edges that passes an odd number of times
/// through the surface of the face, whose border is pinned.
///
/// A *surface* is here a set of faces that common edges connect, and its *border* the edges with an odd
/// number of its faces. A closed curve passes through two surfaces with the same border equally often modulo
/// 2, since both together are a closed surface, through which it passes an even number of times. So if
/// neither the loop nor the border moves, the loop meets the surface in all its positions. `crossings` are
/// the edges that pass through faces, and `touching` all edges and faces with a common point: a surface that
/// a pinned edge meets in another way is not decided.
pub(crate) fn linked(
    mesh: &TriangleMesh,
    is_pinned: impl Fn(u32) -> bool,
    crossings: &[Intersection],
    touching: &[Intersection],
) -> Option<(u32, u32)> {
    let is_pinned_edge = |edge: u32| {
        mesh.edges()[edge as usize]
            .iter()
            .all(|&vertex| is_pinned(vertex))
    };
    let by_pinned = |pairs: &[Intersection]| -> Vec<Intersection> {
        let pairs = pairs.iter().copied();
        pairs.filter(|pair| is_pinned_edge(pair.edge)).collect()
    };
    let crossings = by_pinned(crossings);
    if crossings.is_empty() {
        return None;
    }
    let crossed: BTreeSet<Intersection> = crossings.iter().copied().collect();
    let touching = by_pinned(touching);
    let surface_of = surfaces(mesh);
    let pierced: BTreeSet<u32> = crossings
        .iter()
        .map(|pair| surface_of[pair.face as usize])
        .collect();
    pierced.into_iter().find_map(|surface| {
        let is_of = |face: u32| surface_of[face as usize] == surface;
        let faces = (0..).zip(mesh.faces()).filter(|(face, _)| is_of(*face));
        let mut sides = BTreeMap::<[u32; 2], bool>::new();
        let mut vertices = BTreeSet::new();
        for (_, &[a, b, c]) in faces {
            vertices.extend([a, b, c]);
            for [a, b] in [[a, b], [b, c], [c, a]] {
                let is_odd = sides.entry([a.min(b), a.max(b)]).or_default();
                *is_odd = !*is_odd;
            }
        }
        let mut border = sides.iter().filter(|(_, is_odd)| **is_odd).peekable();
        let is_decided = border.peek().is_some()
            && border.all(|(side, _)| side.iter().all(|&vertex| is_pinned(vertex)))
            && touching
                .iter()
                .all(|pair| !is_of(pair.face) || crossed.contains(pair));
        if !is_decided {
            return None;
        }
        let mut odd = BTreeMap::<u32, (bool, u32)>::new();
        for pair in crossings.iter().filter(|pair| is_of(pair.face)) {
            let (is_odd, _) = odd.entry(pair.edge).or_insert((false, pair.face));
            *is_odd = !*is_odd;
        }
        let face = odd.values().next()?.1;
        let mut loops = Parities::new(mesh.vertex_count());
        let edges = (0..mesh.edges().len() as u32).filter(|&edge| is_pinned_edge(edge));
        for edge in edges {
            let [a, b] = mesh.edges()[edge as usize];
            let is_odd = odd.get(&edge).is_some_and(|(is_odd, _)| *is_odd);
            if !vertices.contains(&a) && !vertices.contains(&b) && loops.closes_odd(a, b, is_odd) {
                return Some((edge, face));
            }
        }
        None
    })
}

/// For each face, the number of its surface.
fn surfaces(mesh: &TriangleMesh) -> Vec<u32> {
    let mut faces = Parities::new(mesh.faces().len());
    let mut first = BTreeMap::new();
    for (face, &[a, b, c]) in (0..).zip(mesh.faces()) {
        for [a, b] in [[a, b], [b, c], [c, a]] {
            let other = *first.entry([a.min(b), a.max(b)]).or_insert(face);
            faces.closes_odd(face, other, false);
        }
    }
    (0..mesh.faces().len() as u32)
        .map(|face| faces.root(face).0)
        .collect()
}

/// Disjoint sets of numbers, with the parity of the way from each number to the root of its set.
struct Parities(Vec<(u32, bool)>);

impl Parities {
    fn new(count: usize) -> Self {
        Self((0..count as u32).map(|number| (number, false)).collect())
    }

    /// The root of the set of a number, and the parity of the way.
    fn root(&mut self, number: u32) -> (u32, bool) {
        let (mut at, mut parity) = (number, false);
        loop {
            let (next, odd) = self.0[at as usize];
            if next == at {
                break;
            }
            // Halves the way for later questions.
            let (second, further) = self.0[next as usize];
            self.0[at as usize] = (second, odd ^ further);
            (at, parity) = (second, parity ^ odd ^ further);
        }
        (at, parity)
    }

    /// Joins the sets of two numbers by a way; returns true if it closes a loop of odd parity.
    fn closes_odd(&mut self, a: u32, b: u32, is_odd: bool) -> bool {
        let ((a, first), (b, second)) = (self.root(a), self.root(b));
        let parity = first ^ second ^ is_odd;
        if a == b {
            return parity;
        }
        self.0[b as usize] = (a, parity);
        false
    }
}

#[cfg(test)]
mod tests {
    use exact_ccd_mesh::{Bvh, IntersectionOptions, Meeting, Point, intersections};

    use super::*;

    /// A sheet of two faces with a pinned border, and a triangle of edges that passes `times` through it.
    fn found(loop_of: [Point; 3], is_pinned: impl Fn(u32) -> bool) -> bool {
        let sheet = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0], [0.0, 4.0, 0.0]];
        let x = [&sheet[..], &loop_of].concat();
        let edges = [[4, 5], [5, 6], [6, 4]];
        let mesh = TriangleMesh::with_edges(7, vec![[0, 1, 2], [0, 2, 3]], &edges)
            .expect("the indices are in range");
        let options = IntersectionOptions::default();
        let meet = |meeting| intersections(&mesh, &x, &Bvh, &options.clone().with_meeting(meeting));
        let [crossings, touching] =
            [Meeting::Crossing, Meeting::Touching].map(|meeting| meet(meeting).expect("the positions fit"));
        linked(&mesh, is_pinned, &crossings, &touching).is_some()
    }

    #[test]
    fn a_pinned_loop_through_a_pinned_border_is_found() {
        let through = [[3.0, 1.0, -1.0], [3.0, 1.0, 1.0], [9.0, 9.0, 0.0]];
        assert!(found(through, |_| true));
        assert!(
            !found(through, |vertex| vertex != 3),
            "the border is free to move"
        );
        assert!(!found(through, |vertex| vertex != 6), "the loop is free to move");
        let twice = [[3.0, 1.0, -1.0], [3.0, 1.0, 1.0], [1.0, 3.0, -0.5]];
        assert!(!found(twice, |_| true), "it goes back through the sheet");
        let touching = [[3.0, 1.0, 0.0], [3.0, 1.0, 1.0], [9.0, 9.0, 0.5]];
        assert!(!found(touching, |_| true), "it touches the sheet");
    }
}
