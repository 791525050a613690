//! The candidate pairs of the broad phase, against all pairs of primitives.

use exact_ccd::{AnyKind, CONTACT, EdgeEdge, Query, VertexFace};
use exact_ccd_mesh::{
    Aabb, Bvh, CanCollide, CandidateOptions, Candidates, Pair, PairKind, Point, Step, TriangleMesh,
};
use exact_ccd_methods::parity::Displacement;
use fastrand::Rng;
use nalgebra::Vector3;

use crate::energies::distance::{edge_edge, point_triangle};

/// The number of pieces of a scene, with two triangles each. The first and the last are obstacles.
const PIECES: usize = 5;

struct Surroundings {
    mesh: TriangleMesh,
    can_collide: CanCollide,
    start: Vec<Point>,
    end: Vec<Point>,
    distance: f64,
}

/// Pieces of random shape and motion, with lengths between a nanometre and a metre, near the origin or far
/// from it.
fn random_scene(random: &mut Rng) -> Surroundings {
    let mut choose = |choices: &[f64]| choices[random.usize(..choices.len())];
    let scale = choose(&[1.0, 1e-3, 1e-9]);
    let offset = [0, 1, 2].map(|_| choose(&[0.0, 0.0, 1.0, -1e6]));
    let distance = scale * choose(&[0.0, 1e-3, 0.1, 0.4]);
    // Far from the origin, the smallest motion is below the spacing of coordinates.
    let motion = scale * choose(&[0.0, 1e-15, 1e-3, 0.3, 3.0]);
    // Points on a grid have many contacts at corners and along edges.
    let grid = choose(&[0.0, 0.25, 0.5]);
    let mut coordinate = |center: f64| {
        let x = center + random.f64() - 0.5;
        if grid > 0.0 { grid * (x / grid).round() } else { x }
    };

    let (mut start, mut end, mut faces) = (Vec::new(), Vec::new(), Vec::new());
    for piece in 0..PIECES as u32 {
        faces.extend([[0, 1, 2], [3, 2, 1]].map(|face| face.map(|corner| 4 * piece + corner)));
        let center = [0; 3].map(|_| 2.0 * coordinate(0.0));
        let drift = [0; 3].map(|_| coordinate(0.0));
        for _ in 0..4 {
            let at = center.map(&mut coordinate);
            let by = drift.map(|drift| drift + 0.2 * coordinate(0.0));
            start.push([0, 1, 2].map(|axis: usize| offset[axis] + scale * at[axis]));
            end.push([0, 1, 2].map(|axis: usize| offset[axis] + (scale * at[axis] + motion * by[axis])));
        }
    }
    let obstacle = (0..4 * PIECES).map(|vertex| [0, PIECES - 1].contains(&(vertex / 4)));
    let mesh = TriangleMesh::new(4 * PIECES, faces).unwrap();
    Surroundings {
        mesh,
        can_collide: CanCollide::not_two_obstacles(obstacle.collect()),
        start,
        end,
        distance,
    }
}

impl Surroundings {
    fn step(&self) -> Step<'_> {
        Step::new(&self.mesh, &self.start, &self.end).unwrap()
    }

    fn pairs(&self) -> Candidates {
        let options = CandidateOptions::default()
            .with_distance(self.distance)
            .with_can_collide(self.can_collide.clone());
        Candidates::with_options(self.step(), &Bvh, &options).unwrap()
    }

    /// All pairs without a common vertex that do not belong to two obstacles.
    fn all(&self) -> Candidates {
        let is_obstacle = |vertex: u32| [0, PIECES - 1].contains(&(vertex as usize / 4));
        let is_of_concern = |vertices: &[u32], first: usize| {
            let (a, b) = vertices.split_at(first);
            a.iter().all(|vertex| !b.contains(vertex)) && !vertices.iter().copied().all(is_obstacle)
        };
        let mesh = &self.mesh;
        let counts = [mesh.faces().len() as u32, mesh.edges().len() as u32];
        let faces = (0..4 * PIECES as u32)
            .flat_map(|vertex| (0..counts[0]).map(move |face| Pair::VertexFace { vertex, face }));
        let edges = (0..counts[1]).flat_map(|a| (a + 1..counts[1]).map(move |b| Pair::EdgeEdge { a, b }));
        faces
            .filter(|pair| is_of_concern(&pair.vertices(mesh).unwrap(), 1))
            .chain(edges.filter(|pair| is_of_concern(&pair.vertices(mesh).unwrap(), 2)))
            .collect()
    }

    /// All pairs with a property of their four vertices.
    fn filtered(
        &self,
        vertex_face: impl Fn([u32; 4]) -> bool,
        edge_edge: impl Fn([u32; 4]) -> bool,
    ) -> Candidates {
        let of_concern = |pair: &Pair| match *pair {
            Pair::VertexFace { vertex, face } => {
                vertex_face(VertexFace::vertices(&self.mesh, [vertex, face]).unwrap())
            }
            Pair::EdgeEdge { a, b } => edge_edge(EdgeEdge::vertices(&self.mesh, [a, b]).unwrap()),
            Pair::VertexEdge { .. } | Pair::VertexVertex { .. } => unreachable!("nothing is loose"),
        };
        self.all().pairs().filter(of_concern).collect()
    }

    /// The pairs that are closer than the distance.
    fn within(&self, points: &[Point]) -> Candidates {
        let at = |vertices: [u32; 4]| vertices.map(|vertex| Vector3::from(points[vertex as usize]));
        let limit = self.distance * self.distance;
        self.filtered(
            |vertices| {
                point_triangle(&at(vertices))
                    .shortest_vector(&at(vertices))
                    .squared()
                    < limit
            },
            |vertices| edge_edge(&at(vertices)).shortest_vector(&at(vertices)).squared() < limit,
        )
    }

    /// The pairs that collide, exactly.
    fn colliding(&self, start: &[Point], end: &[Point]) -> Candidates {
        let at = |points: &[Point], vertices: [u32; 4]| vertices.map(|vertex| points[vertex as usize]);
        self.filtered(
            |v| {
                Query::<VertexFace>::new(at(start, v), at(end, v))
                    .unwrap()
                    .collides(CONTACT)
            },
            |v| {
                Query::<EdgeEdge>::new(at(start, v), at(end, v))
                    .unwrap()
                    .collides(CONTACT)
            },
        )
    }
}

fn assert_has_all(pairs: &Candidates, expected: &Candidates, what: &str) {
    for pair in expected.of_kind(AnyKind::VertexFace) {
        let found = pairs.of_kind(AnyKind::VertexFace).binary_search(pair);
        assert!(found.is_ok(), "{what}: vertex and face {pair:?}");
    }
    for pair in expected.of_kind(AnyKind::EdgeEdge) {
        let found = pairs.of_kind(AnyKind::EdgeEdge).binary_search(pair);
        assert!(found.is_ok(), "{what}: edges {pair:?}");
    }
}

/// The candidate pairs contain all pairs that are near at any step size, and all pairs that collide on the
/// motion to it.
#[test]
fn candidates_contain_all_near_and_colliding_pairs_at_any_step_size() {
    let mut random = Rng::with_seed(7);
    let (mut apart, mut between, mut colliding) = (0, 0, 0);
    for case in 0..300 {
        let scene = random_scene(&mut random);
        let pairs = scene.pairs();
        assert_has_all(&scene.all(), &pairs, "of no concern");
        let ends = [scene.within(&scene.start), scene.within(&scene.end)];
        for fraction in [0.0, 1.0, random.f64(), 0.5 * random.f64(), 1e-9 * random.f64()] {
            let what = format!("case {case} at {fraction}");
            let at = scene.step().at(fraction);
            let near = scene.within(&at);
            assert_has_all(&pairs, &near, &what);
            let collisions = scene.colliding(&scene.start, &at);
            assert_has_all(&pairs, &collisions, &what);

            apart += usize::from(pairs.counts().total() < scene.all().counts().total());
            colliding += collisions.counts().total();
            let is_new = |pair: &&[u32; 2]| {
                ends.iter()
                    .all(|ends| !ends.of_kind(AnyKind::VertexFace).contains(pair))
            };
            between += near.of_kind(AnyKind::VertexFace).iter().filter(is_new).count();
        }
    }
    // The scenes must contain pairs of all kinds.
    assert!(
        apart > 500 && between > 50 && colliding > 5000,
        "{apart} {between} {colliding}"
    );
}

/// The candidate pairs also contain all pairs that collide after the shift and the rounding of the parity
/// filter, even if only rounding makes them collide. A distant obstacle makes the rounding as coarse as a
/// hundredth of a piece, or coarser.
#[test]
fn candidates_contain_all_pairs_that_collide_after_a_shift() {
    let mut random = Rng::with_seed(8);
    let mut by_rounding = 0;
    let mut apart = 0;
    for case in 0..300 {
        let mut scene = random_scene(&mut random);
        scene.distance = 0.0;
        let bounds: Aabb = scene.start.iter().copied().collect();
        let far = 2.0_f64.powi(random.i32(44..50)) * (bounds.upper[0] - bounds.lower[0]);
        for points in [&mut scene.start, &mut scene.end] {
            points[4 * (PIECES - 1)..]
                .iter_mut()
                .for_each(|point| *point = point.map(|x| x + far));
        }
        let bounds: Aabb = scene.start.iter().chain(&scene.end).copied().collect();
        let displacement = Displacement::of_box(bounds.lower, bounds.upper);
        let [start, end] = [&scene.start, &scene.end].map(|points| {
            points
                .iter()
                .map(|&point| displacement.apply(point))
                .collect::<Vec<_>>()
        });
        let shifted = scene.colliding(&start, &end);
        let pairs = scene.pairs();
        assert_has_all(&pairs, &shifted, &format!("case {case}"));
        let moving = scene.filtered(|v| v.iter().all(|&v| v < 16), |v| v.iter().all(|&v| v < 16));
        apart += usize::from(pairs.counts().total() < moving.counts().total());
        let before = scene.colliding(&scene.start, &scene.end);
        by_rounding += shifted.counts().total().saturating_sub(before.counts().total());
    }
    assert!(by_rounding > 20 && apart > 10, "{by_rounding} {apart}");
}
