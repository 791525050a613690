//! The kinds of pairs cover all contacts and distances, except where the documentation of [`Pair`] says so.

use exact_ccd_mesh::{Bvh, CanCollide, CandidateOptions, Candidates, Pair, Step, TriangleMesh};
use proptest::prelude::*;

const VERTICES: u32 = 9;

/// The vertices of both primitives of each pair among the primitives that take part, and true if the pair
/// keeps a distance.
fn pairs(mesh: &TriangleMesh, takes_part: &[bool]) -> Vec<([Vec<u32>; 2], bool)> {
    let x = vec![[0.0; 3]; VERTICES as usize];
    let step = Step::new(mesh, &x, &x).unwrap();
    // All boxes meet.
    let options = CandidateOptions::default().with_can_collide(CanCollide::all().among(takes_part.to_vec()));
    let all = Candidates::with_options(step, &Bvh, &options).unwrap();
    let both = |pair: Pair| {
        let vertices = pair.vertices(mesh).unwrap();
        let (a, b) = vertices.split_at(pair.kind().sizes()[0]);
        let connects = |edge: &[u32; 2]| a.len() == 1 && meet(edge, a) && b.len() == 2 && meet(edge, b);
        let keeps_distance = !mesh.edges().iter().any(connects);
        ([a.to_vec(), b.to_vec()], keeps_distance)
    };
    all.pairs().map(both).collect()
}

fn contains(all: &[u32], some: &[u32]) -> bool {
    some.iter().all(|vertex| all.contains(vertex))
}

fn meet(a: &[u32], b: &[u32]) -> bool {
    a.iter().any(|vertex| b.contains(vertex))
}

/// The documented exceptions, among the edges and faces that take part: the pairs that are never compared.
fn is_no_contact(faces: &[[u32; 3]], edges: &[[u32; 2]], p: u32, other: &[u32]) -> bool {
    let is_loose = |edge: &[u32; 2]| !faces.iter().any(|face| contains(face, edge));
    let ends_of_loose = edges.iter().filter(|edge| is_loose(edge));
    is_no_distance(faces, edges, p, other)
        && match *other {
            [a, b] => !is_loose(&[a, b]),
            [q] => ends_of_loose
                .filter(|edge| edge.contains(&p) || edge.contains(&q))
                .all(|edge| contains(edge, &[p, q])),
            _ => unreachable!("an edge or a vertex"),
        }
}

/// The documented exceptions for distances above 0.
fn is_no_distance(faces: &[[u32; 3]], edges: &[[u32; 2]], p: u32, other: &[u32]) -> bool {
    let edges_of = |q: u32| edges.iter().filter(move |edge| edge.contains(&q));
    let faces_of = |q: u32| faces.iter().filter(move |face| face.contains(&q));
    match *other {
        [a, b] => {
            edges_of(p).count() > 0
                && edges_of(p).all(|edge| meet(edge, other))
                && faces_of(a)
                    .filter(|face| face.contains(&b))
                    .all(|face| face.contains(&p))
        }
        [q] => {
            edges_of(p).count() > 0
                && edges_of(q).count() > 0
                && edges_of(p).all(|edge| edges_of(q).all(|other| meet(edge, other)))
                && faces_of(p).all(|face| face.contains(&q))
                && faces_of(q).all(|face| face.contains(&p))
        }
        _ => unreachable!("an edge or a vertex"),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn vertices_are_compared_with_edges_and_vertices_but_for_the_exceptions(
        faces in prop::collection::vec(prop::array::uniform3(0..VERTICES), 0..4),
        edges in prop::collection::vec(prop::array::uniform2(0..VERTICES), 0..8),
        takes_part in prop::collection::vec(prop::bool::weighted(0.8), VERTICES as usize),
    ) {
        let mesh = TriangleMesh::with_edges(VERTICES as usize, faces, &edges).unwrap();
        let pairs = pairs(&mesh, &takes_part);
        let covers = |[a, b]: &[Vec<u32>; 2], p: u32, other: &[u32]| {
            a.contains(&p) && contains(b, other) || b.contains(&p) && contains(a, other)
        };
        let is_in = |vertices: &[u32]| vertices.iter().all(|&vertex| takes_part[vertex as usize]);
        prop_assert!(pairs.iter().flat_map(|(pair, _)| pair).all(|vertices| is_in(vertices)));

        let faces: Vec<_> = mesh.faces().iter().copied().filter(|face| is_in(face)).collect();
        let edges: Vec<_> = mesh.edges().iter().copied().filter(|edge| is_in(edge)).collect();
        let vertices: Vec<u32> = (0..VERTICES).filter(|&vertex| is_in(&[vertex])).collect();
        let points = vertices.iter().map(|&vertex| vec![vertex]);
        let others: Vec<Vec<u32>> = points.chain(edges.iter().map(|edge| edge.to_vec())).collect();
        for &p in &vertices {
            for other in others.iter().filter(|other| !other.contains(&p)) {
                let contact = pairs.iter().any(|(pair, _)| covers(pair, p, other));
                let expected = !is_no_contact(&faces, &edges, p, other);
                prop_assert_eq!(contact, expected, "{} {:?}", p, other);
                let distance = pairs.iter().any(|(pair, keeps)| *keeps && covers(pair, p, other));
                let expected = !is_no_distance(&faces, &edges, p, other);
                prop_assert_eq!(distance, expected, "{} {:?}", p, other);
            }
        }
    }
}
