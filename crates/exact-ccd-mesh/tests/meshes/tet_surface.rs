//! The surface of a mesh of tetrahedra is closed, points outward and encloses the volume.

use exact_ccd_mesh::{Point, TetFaces, TetMesh, TetMeshError};
use proptest::prelude::*;

/// A block of cubes, each cut into six tetrahedra along its diagonal. `turn` reverses the
/// orientation of a tetrahedron.
fn block([l, m, n]: [u32; 3], turn: impl Fn(usize) -> bool) -> TetMesh {
    let index = |[x, y, z]: [u32; 3]| x + (l + 1) * (y + (m + 1) * z);
    let mut positions = Vec::new();
    let mut tetrahedra = Vec::new();
    for z in 0..=n {
        for y in 0..=m {
            for x in 0..=l {
                positions.push([x, y, z].map(f64::from));
                if x == l || y == m || z == n {
                    continue;
                }
                for axes in [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]] {
                    let mut corner = [x, y, z];
                    let mut corners = [index(corner); 4];
                    for (k, axis) in axes.into_iter().enumerate() {
                        corner[axis] += 1;
                        corners[k + 1] = index(corner);
                    }
                    if turn(tetrahedra.len()) {
                        corners.swap(1, 3);
                    }
                    tetrahedra.push(corners);
                }
            }
        }
    }
    TetMesh::new(positions, tetrahedra).unwrap()
}

/// Six times the volume of the tetrahedron that a triangle spans with the origin.
fn six_volumes([a, b, c]: [Point; 3]) -> f64 {
    let minor = |i: usize, j: usize| b[i] * c[j] - b[j] * c[i];
    a[0] * minor(1, 2) + a[1] * minor(2, 0) + a[2] * minor(0, 1)
}

fn surface_volume(mesh: &TetMesh) -> f64 {
    let triangle = |face: &[u32; 3]| six_volumes(face.map(|vertex| mesh.positions()[vertex as usize]));
    mesh.surface().iter().map(triangle).sum::<f64>() / 6.0
}

proptest! {
    #[test]
    fn the_surface_of_a_block_is_closed_and_outward(
        size in prop::array::uniform3(1..4_u32),
        turns in prop::collection::vec(any::<bool>(), 6 * 27),
    ) {
        let mesh = block(size, |tetrahedron| turns[tetrahedron]);
        let [l, m, n] = size;
        // All coordinates are integers, so the divergence theorem holds exactly.
        prop_assert_eq!(surface_volume(&mesh), f64::from(l * m * n));
        prop_assert_eq!(mesh.surface().len() as u32, 4 * (l * m + m * n + n * l));
        // Each directed side of a triangle occurs in reverse in another one.
        let mut sides: Vec<[u32; 2]> =
            mesh.surface().iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
        sides.sort_unstable();
        for &[a, b] in &sides {
            prop_assert!(sides.binary_search(&[b, a]).is_ok());
        }
        sides.dedup();
        prop_assert_eq!(sides.len(), 3 * mesh.surface().len());

        let (frame, vertices) = mesh.surface_frame();
        let inside = l.saturating_sub(1) * m.saturating_sub(1) * n.saturating_sub(1);
        prop_assert_eq!(frame.positions.len() as u32, (l + 1) * (m + 1) * (n + 1) - inside);
        for (face, expected) in frame.mesh.faces().iter().zip(mesh.surface()) {
            prop_assert_eq!(&face.map(|vertex| vertices[vertex as usize]), expected);
        }
        for (position, vertex) in frame.positions.iter().zip(vertices) {
            prop_assert_eq!(*position, mesh.positions()[vertex as usize]);
        }
    }
}

#[test]
fn invalid_meshes_are_errors() {
    let corners = [
        [0.0; 3],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.0, 0.0, 2.0],
    ];
    let error = |tetrahedra: &[[u32; 4]]| TetMesh::new(corners.to_vec(), tetrahedra.to_vec()).unwrap_err();
    let index = TetMeshError::Index {
        tetrahedron: 1,
        vertex: 5,
        vertex_count: 5,
    };
    assert_eq!(error(&[[0, 1, 2, 3], [0, 1, 2, 5]]), index);
    assert_eq!(
        error(&[[0, 1, 2, 3], [0, 1, 3, 4]]),
        TetMeshError::Flat { tetrahedron: 1 }
    );
    assert_eq!(error(&[[0, 1, 2, 2]]), TetMeshError::Flat { tetrahedron: 0 });
    let overlap = TetMeshError::Overlap {
        first: 0,
        second: 1,
        face: [0, 1, 2],
    };
    assert_eq!(error(&[[0, 1, 2, 3], [2, 1, 0, 4]]), overlap);
    let mut positions = corners.to_vec();
    positions[3][1] = f64::NAN;
    let message = TetMesh::new(positions, vec![]).unwrap_err().to_string();
    assert_eq!(message, "vertex 3 has y = NaN, expected a finite number");
}

#[test]
fn faces_of_tetrahedra_are_found_wherever_they_are_in_the_order() {
    // The common face is the last one.
    let overlap = TetMeshError::Overlap {
        first: 0,
        second: 1,
        face: [2, 3, 4],
    };
    assert_eq!(TetFaces::of([[0, 2, 3, 4], [1, 2, 3, 4]]).check(), Err(overlap));
    let faces = TetFaces::of([[1, 2, 3, 4], [0, 1, 2, 3]]);
    assert_eq!(faces.check(), Ok(()));
    let expected = [[1, 2, 4], [1, 4, 3], [2, 3, 4], [0, 2, 1], [0, 1, 3], [0, 3, 2]];
    assert_eq!(faces.boundary(), expected);
    assert!(faces.contains([3, 2, 1]) && faces.contains([4, 2, 3]) && !faces.contains([0, 1, 4]));
}
