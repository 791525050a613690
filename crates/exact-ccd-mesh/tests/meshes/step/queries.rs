//! The queries of pairs of primitives.

use exact_ccd::{EdgeEdge, VertexFace};
use exact_ccd_mesh::{Pair, Step, TriangleMesh};

use super::motions::falling_sheet;

#[test]
fn primitives_that_a_mesh_does_not_have_have_no_query() {
    let motion = falling_sheet();
    let step = motion.step().unwrap();
    let [vertices, faces, edges] = [
        motion.mesh.vertex_count(),
        motion.mesh.faces().len(),
        motion.mesh.edges().len(),
    ]
    .map(|count| count as u32);
    assert!(step.query::<VertexFace>([vertices - 1, faces - 1]).is_some());
    assert_eq!(step.query::<VertexFace>([vertices, faces - 1]), None);
    assert_eq!(step.query::<VertexFace>([vertices - 1, faces]), None);
    assert!(step.query::<EdgeEdge>([edges - 1, 0]).is_some());
    assert_eq!(step.query::<EdgeEdge>([edges, 0]), None);
    assert_eq!(step.query::<EdgeEdge>([0, u32::MAX]), None);
}

#[test]
fn a_query_has_its_points_in_the_order_of_its_primitives() {
    let x0 = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [3.0, 0.0, 0.0]];
    let x1 = x0.map(|[x, _, _]| [x, 1.0, 0.0]);
    let mesh = TriangleMesh::new(4, vec![[3, 1, 0], [2, 1, 3]]).unwrap();
    let step = Step::new(&mesh, &x0, &x1).unwrap();
    let query = step.query::<VertexFace>([2, 0]).unwrap();
    assert_eq!(*query.points(), [x0, x1].map(|x| [x[2], x[3], x[1], x[0]]));
    // The edges are 01, 12, 03, 13, 23.
    let query = step.query::<EdgeEdge>([1, 2]).unwrap();
    assert_eq!(*query.points(), [x0, x1].map(|x| [x[1], x[2], x[0], x[3]]));
}

#[test]
fn a_pair_has_the_vertices_of_its_first_primitive_first() {
    let mesh = TriangleMesh::with_edges(8, vec![[0, 1, 2]], &[[3, 4]]).unwrap();
    // The edges are 01, 02, 12, 34.
    for (pair, vertices, first) in [
        (Pair::VertexFace { vertex: 5, face: 0 }, vec![5, 0, 1, 2], 1),
        (Pair::EdgeEdge { a: 1, b: 3 }, vec![0, 2, 3, 4], 2),
        (Pair::VertexEdge { vertex: 5, edge: 3 }, vec![5, 3, 4], 1),
        (Pair::VertexVertex { a: 5, b: 6 }, vec![5, 6], 1),
    ] {
        assert_eq!(
            (pair.vertices(&mesh), pair.kind().sizes()[0]),
            (Some(vertices), first)
        );
    }
    assert_eq!(Pair::VertexVertex { a: 5, b: 8 }.vertices(&mesh), None);
}
