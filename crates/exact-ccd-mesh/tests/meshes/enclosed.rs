//! Components inside of closed ones.

use exact_ccd_mesh::{CanCollide, Enclosed, Point, TriangleMesh, enclosed};

/// The faces of a box with the corners x + 2 y + 4 z.
const BOX: [[u32; 3]; 12] = [
    [0, 2, 1],
    [1, 2, 3],
    [4, 5, 6],
    [5, 7, 6],
    [0, 1, 4],
    [1, 5, 4],
    [2, 6, 3],
    [3, 6, 7],
    [0, 4, 2],
    [2, 4, 6],
    [1, 3, 5],
    [3, 7, 5],
];

/// Meshes one after the other.
#[derive(Clone, Default)]
struct Shapes {
    positions: Vec<Point>,
    faces: Vec<[u32; 3]>,
    edges: Vec<[u32; 2]>,
}

impl Shapes {
    fn with(mut self, positions: &[Point], faces: &[[u32; 3]]) -> Self {
        let first = self.positions.len() as u32;
        self.positions.extend(positions);
        self.faces
            .extend(faces.iter().map(|face| face.map(|v| v + first)));
        self
    }

    /// The box from a corner to the opposite one.
    fn with_box(self, lower: Point, upper: Point) -> Self {
        let ends = [lower, upper];
        let corner = |k: usize| [ends[k & 1][0], ends[k >> 1 & 1][1], ends[k >> 2][2]];
        self.with(&[0, 1, 2, 3, 4, 5, 6, 7].map(corner), &BOX)
    }

    /// The square tube around the axis of x with the sides 2 `inner` and 2 `outer`: a torus.
    fn with_tube(self, inner: f64, outer: f64) -> Self {
        let ring = |x: f64, r: f64| [[x, -r, -r], [x, r, -r], [x, r, r], [x, -r, r]];
        let rings = [
            ring(-1.0, outer),
            ring(1.0, outer),
            ring(1.0, inner),
            ring(-1.0, inner),
        ];
        let quads = (0..4_u32).flat_map(|r| (0..4_u32).map(move |k| (r, k)));
        let faces = quads.flat_map(|(r, k)| {
            let at = |r: u32, k: u32| 4 * (r % 4) + k % 4;
            let [a, b, c, d] = [at(r, k), at(r, k + 1), at(r + 1, k + 1), at(r + 1, k)];
            [[a, b, c], [a, c, d]]
        });
        self.with(&rings.concat(), &faces.collect::<Vec<_>>())
    }

    fn found(&self) -> Vec<[u32; 2]> {
        self.found_among(&CanCollide::all())
    }

    fn found_among(&self, can_collide: &CanCollide) -> Vec<[u32; 2]> {
        let mesh = TriangleMesh::with_edges(self.positions.len(), self.faces.clone(), &self.edges).unwrap();
        let found = enclosed(&mesh, &self.positions, can_collide).unwrap();
        found
            .into_iter()
            .map(|Enclosed { inner, outer }| [inner, outer])
            .collect()
    }
}

/// Rays pass through corners, edges and diagonals of the outer boxes, and along their faces.
#[test]
fn boxes_in_boxes() {
    let outer = Shapes::default().with_box([-4.0; 3], [4.0; 3]);
    let inner = |lower: Point| outer.clone().with_box(lower, lower.map(|x| x + 1.0)).found();
    for (x, y) in (-3..3).flat_map(|x| (-3..3).map(move |y| (x, y))) {
        for z in -3..3 {
            assert_eq!(inner([x, y, z].map(f64::from)), [[8, 0]], "{x} {y} {z}");
        }
        for z in [-9.0, -6.0, 5.0] {
            let [x, y] = [x, y].map(f64::from);
            assert_eq!(inner([x, y, z]), [[0; 2]; 0], "{x} {y} {z}");
            assert_eq!(inner([z, x, y]), [[0; 2]; 0], "{x} {y} {z}");
        }
    }
    // Beside the box, with a ray in the plane of a side.
    assert_eq!(inner([-6.0, -4.0, -4.0]), [[0; 2]; 0]);
    assert_eq!(inner([-6.0, 4.0, 4.0]), [[0; 2]; 0]);
    let three = outer
        .clone()
        .with_box([-2.0; 3], [2.0; 3])
        .with_box([-1.0; 3], [1.0; 3]);
    assert_eq!(three.found(), [[8, 0], [16, 0], [16, 8]]);
    // The orientation of faces has no effect.
    let mut turned = three.clone();
    turned
        .faces
        .iter_mut()
        .step_by(3)
        .for_each(|face| face.swap(0, 1));
    assert_eq!(turned.found(), three.found());
}

#[test]
fn a_vertex_that_touches_is_a_contact() {
    let outer = Shapes::default().with_box([-4.0; 3], [4.0; 3]);
    for lower in [[-4.0, -1.0, -2.0], [-4.0, -4.0, 0.0], [-4.0; 3], [4.0, 0.0, 0.0]] {
        assert_eq!(
            outer.clone().with_box(lower, lower.map(|x| x + 1.0)).found(),
            [[0; 2]; 0],
            "{lower:?}"
        );
    }
}

#[test]
fn the_hole_of_a_torus_is_outside() {
    let torus = Shapes::default().with_tube(1.0, 3.0);
    let through = torus.clone().with_box([-2.0, -0.5, -0.5], [2.0, 0.5, 0.5]);
    assert_eq!(through.found(), [[0; 2]; 0]);
    let within = torus.with_box([-0.5, 1.5, 1.5], [0.5, 2.0, 2.0]);
    assert_eq!(within.found(), [[16, 0]]);
}

#[test]
fn open_components_and_rods_are_inside_of_closed_ones_only() {
    let mut shapes = Shapes::default().with_box([-4.0; 3], [4.0; 3]);
    shapes = shapes.with(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], &[[0, 1, 2]]);
    shapes = shapes.with(&[[1.0; 3], [2.0; 3], [3.0; 3]], &[]);
    shapes.edges.push([11, 12]);
    // Vertex 13 is a point.
    assert_eq!(shapes.found(), [[8, 0], [11, 0]]);
    shapes.faces.remove(0);
    assert_eq!(shapes.found(), [[0; 2]; 0]);
}

#[test]
fn pairs_that_cannot_collide_are_left_out() {
    let shapes = Shapes::default()
        .with_box([-4.0; 3], [4.0; 3])
        .with_box([-1.0; 3], [1.0; 3]);
    assert_eq!(shapes.found(), [[8, 0]]);
    let rule = CanCollide::different_groups(vec![0; 16]);
    assert_eq!(shapes.found_among(&rule), [[0; 2]; 0]);
}
