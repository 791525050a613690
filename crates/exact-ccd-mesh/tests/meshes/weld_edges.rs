//! Welding along edges against its definition, pair by pair.

use exact_ccd_mesh::{Point, TriangleMesh, Welding};
use proptest::prelude::*;

/// The class of each vertex: edges that coincide weld their ends, as often as necessary.
fn classes(mesh: &TriangleMesh, frames: &[Vec<Point>]) -> Vec<usize> {
    let coincide = |a: u32, b: u32| frames.iter().all(|x| x[a as usize] == x[b as usize]);
    let mut class: Vec<usize> = (0..mesh.vertex_count()).collect();
    for &[a, b] in mesh.edges() {
        for &[c, d] in mesh.edges() {
            for [c, d] in [[c, d], [d, c]] {
                // An edge from a place to itself has no direction.
                if coincide(a, c) && coincide(b, d) && !coincide(a, b) {
                    for (x, y) in [(a, c), (b, d)] {
                        let (from, to) = (class[x as usize], class[y as usize]);
                        class
                            .iter_mut()
                            .filter(|class| **class == from)
                            .for_each(|class| *class = to);
                    }
                }
            }
        }
    }
    class
}

proptest! {
    #[test]
    fn vertices_are_welded_as_the_definition_says(
        faces in prop::collection::vec(prop::array::uniform3(0..9u32), 0..6),
        edges in prop::collection::vec(prop::array::uniform2(0..9u32), 0..3),
        frames in prop::collection::vec(prop::collection::vec(prop::array::uniform3(0..2u8), 9), 1..3),
    ) {
        let mesh = TriangleMesh::with_edges(9, faces, &edges).unwrap();
        let position = |point: &[u8; 3]| [f64::from(point[0]), f64::from(point[1] / 2), 0.0];
        let frames: Vec<Vec<Point>> = frames.iter().map(|frame| frame.iter().map(position).collect()).collect();
        let mut welding = Welding::default();
        frames.iter().for_each(|x| welding.restrict(x));
        let welding = welding.along_edges(&mesh);
        let class = classes(&mesh, &frames);

        // The numbers of the vertices themselves as positions: the first vertex of each class is kept.
        let numbers: Vec<Point> = (0..9).map(|vertex| [f64::from(vertex), 0.0, 0.0]).collect();
        let first: Vec<Point> = (0..9usize)
            .filter(|&vertex| class[..vertex].iter().all(|&other| other != class[vertex]))
            .map(|vertex| numbers[vertex])
            .collect();
        prop_assert_eq!(welding.positions(&numbers), first.clone());
        let welded = welding.mesh(&mesh).unwrap();
        prop_assert_eq!(welded.vertex_count(), first.len());
        for (face, old) in welded.faces().iter().zip(mesh.faces()) {
            for (corner, &vertex) in face.iter().zip(old) {
                let kept = first[*corner as usize][0] as usize;
                prop_assert_eq!(class[kept], class[vertex as usize]);
            }
        }
    }
}
