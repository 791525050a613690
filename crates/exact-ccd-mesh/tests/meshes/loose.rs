//! Loose edges (rods) and loose vertices (points) of a mesh.

use std::collections::BTreeSet;

use exact_ccd_mesh::{Frame, MeshError, Motion, TriangleMesh};
use proptest::prelude::*;

const VERTICES: u32 = 12;

fn faces() -> impl Strategy<Value = Vec<[u32; 3]>> {
    prop::collection::vec(prop::array::uniform3(0..VERTICES), 0..6)
}

fn edges() -> impl Strategy<Value = Vec<[u32; 2]>> {
    prop::collection::vec(prop::array::uniform2(0..VERTICES), 0..20)
}

fn mesh(faces: &[[u32; 3]], edges: &[[u32; 2]]) -> TriangleMesh {
    TriangleMesh::with_edges(VERTICES as usize, faces.to_vec(), edges).unwrap()
}

proptest! {
    #[test]
    fn edges_of_faces_keep_their_indices_and_loose_edges_follow(faces in faces(), edges in edges()) {
        let mesh = mesh(&faces, &edges);
        let plain = TriangleMesh::new(VERTICES as usize, faces.clone()).unwrap();
        prop_assert_eq!(mesh.edges(), [plain.edges(), mesh.loose_edges()].concat());
        prop_assert_eq!(mesh.faces(), faces);
        let of_faces: BTreeSet<_> = plain.edges().iter().copied().collect();
        let given = edges.iter().filter(|[a, b]| a != b).map(|&[a, b]| [a.min(b), a.max(b)]);
        let loose: BTreeSet<[u32; 2]> = given.filter(|edge| !of_faces.contains(edge)).collect();
        let mut sorted: Vec<_> = loose.into_iter().collect();
        sorted.sort_by_key(|&[i, j]| (j, i));
        prop_assert_eq!(mesh.loose_edges(), sorted);
    }

    #[test]
    fn components_are_what_edges_connect(faces in faces(), edges in edges()) {
        let mesh = mesh(&faces, &edges);
        let mut least: Vec<u32> = (0..VERTICES).collect();
        for _ in 0..VERTICES {
            for &[a, b] in mesh.edges() {
                let both = least[a as usize].min(least[b as usize]);
                (least[a as usize], least[b as usize]) = (both, both);
            }
        }
        prop_assert_eq!(mesh.components(), &least[..]);
        let mut all = least;
        all.sort_unstable();
        all.dedup();
        prop_assert_eq!(mesh.component_count(), all.len());
    }

    #[test]
    fn a_vertex_is_loose_if_it_has_no_edge(faces in faces(), edges in edges()) {
        let mesh = mesh(&faces, &edges);
        let named = |vertex: &u32| mesh.edges().as_flattened().contains(vertex);
        let loose: Vec<u32> = (0..VERTICES).filter(|vertex| !named(vertex)).collect();
        prop_assert_eq!(mesh.loose_vertices().collect::<Vec<_>>(), loose);
    }

    #[test]
    fn without_unused_vertices_it_is_the_same_mesh(faces in faces(), edges in edges()) {
        let mesh = mesh(&faces, &edges);
        let (compact, vertices) = mesh.without_unused_vertices();
        prop_assert_eq!(compact.vertex_count(), vertices.len());
        let is_used = |vertex: &u32| {
            compact.faces().as_flattened().contains(vertex) || compact.edges().as_flattened().contains(vertex)
        };
        prop_assert!((0..vertices.len() as u32).all(|vertex| is_used(&vertex)));
        let original = |vertex: u32| vertices[vertex as usize];
        let faces: Vec<_> = compact.faces().iter().map(|face| face.map(original)).collect();
        let loose: Vec<_> = compact.loose_edges().iter().map(|edge| edge.map(original)).collect();
        prop_assert_eq!(mesh.faces(), faces);
        prop_assert_eq!(mesh.loose_edges(), loose);
        prop_assert_eq!(compact.edges().len(), mesh.edges().len());
    }
}

#[test]
fn errors_name_the_face_the_edge_or_the_count() {
    let error = |faces: &[[u32; 3]], edges: &[[u32; 2]]| {
        let error = TriangleMesh::with_edges(3, faces.to_vec(), edges).unwrap_err();
        error.to_string()
    };
    assert_eq!(
        error(&[[0, 1, 2], [0, 1, 3]], &[[3, 0]]),
        "face 1 names vertex 3, but there are only 3 vertices"
    );
    assert_eq!(
        error(&[[0, 1, 2]], &[[1, 0], [0, 4]]),
        "edge 1 names vertex 4, but there are only 3 vertices"
    );
    let frame = Frame::with_edges(vec![[0.0; 3]], vec![], &[[0, 1]]).unwrap_err();
    assert_eq!(
        frame.to_string(),
        "edge 0 names vertex 1, but there are only 1 vertices"
    );
}

#[test]
#[cfg(target_pointer_width = "64")]
fn meshes_of_very_many_vertices_take_no_memory() {
    let (most, last) = (u32::MAX as usize, u32::MAX - 1);
    let mesh = TriangleMesh::with_edges(most, vec![[0, 2, last]], &[[7, 2]]).unwrap();
    assert_eq!(mesh.loose_vertices().take(4).collect::<Vec<_>>(), [1, 3, 4, 5]);
    let (compact, vertices) = mesh.without_unused_vertices();
    assert_eq!(vertices, [0, 2, 7, last]);
    assert_eq!(
        (compact.faces(), compact.loose_edges()),
        (&[[0, 1, 3]][..], &[[1, 2]][..])
    );
    for vertex_count in [most + 1, usize::MAX] {
        let error = TriangleMesh::new(vertex_count, vec![]).unwrap_err();
        assert_eq!(error, MeshError::TooManyVertices { vertex_count });
    }
}

#[test]
fn loose_edges_that_differ_are_no_motion() {
    let frame = |edges: &[[u32; 2]]| Frame::with_edges(vec![[0.0; 3]; 4], vec![[0, 1, 2]], edges).unwrap();
    let error = |end: &[[u32; 2]]| {
        let error = Motion::new(frame(&[[2, 3]]), frame(end)).unwrap_err();
        error.to_string()
    };
    assert!(Motion::new(frame(&[[2, 3]]), frame(&[[3, 2], [0, 1]])).is_ok());
    assert_eq!(
        error(&[[1, 3]]),
        "loose edge 0 is [2, 3] at the start and [1, 3] at the end, expected the same mesh"
    );
    assert_eq!(
        error(&[]),
        "1 loose edges at the start, 0 at the end, expected the same mesh"
    );
}

#[test]
fn rods_are_welded() {
    let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]];
    let rod = Frame::with_edges(positions, vec![], &[[0, 1], [2, 3]]).unwrap();
    let motion = Motion::weld(rod.clone(), rod).unwrap();
    assert_eq!(motion.mesh.loose_edges(), [[0, 1], [1, 2]]);
}
