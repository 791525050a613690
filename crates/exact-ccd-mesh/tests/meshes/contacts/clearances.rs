//! Clearances against all pairs: in fractions on a grid, and by the exact distances of others.

use std::sync::Arc;

use dashu_int::IBig;
use exact_ccd::{CONTACT, EdgeEdge, Separation, VertexEdge, VertexFace, VertexVertex};
use exact_ccd_mesh::{AllPairs, CanCollide, Detector, Pair, PairKind, Point, Step, TriangleMesh};
use fastrand::Rng;

use super::scene::{Scene, on_threads};

type Vector = [i128; 3];

fn minus(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|axis: usize| a[axis] - b[axis])
}

fn dot(a: Vector, b: Vector) -> i128 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [[1, 2], [2, 0], [0, 1]].map(|[i, j]: [usize; 2]| a[i] * b[j] - a[j] * b[i])
}

/// A squared distance: numerator and denominator.
#[derive(Clone, Copy, Debug)]
struct Fraction(i128, i128);

impl Fraction {
    fn min(self, other: Self) -> Self {
        if self.0 * other.1 <= other.0 * self.1 {
            self
        } else {
            other
        }
    }

    /// Returns true if x² is at most this: x = m 2ᵉ, which is a normal number.
    fn is_at_least_squared(self, x: f64) -> bool {
        let bits = x.to_bits();
        let (mantissa, exponent) = ((bits & ((1 << 52) - 1)) | 1 << 52, (bits >> 52) as i32 - 1075);
        let (square, own) = (IBig::from(mantissa).pow(2) * self.1, IBig::from(self.0));
        let shift = 2 * exponent.unsigned_abs() as usize;
        if exponent < 0 {
            square <= own << shift
        } else {
            square << shift <= own
        }
    }

    /// The largest f64 whose square is at most this.
    fn root(self) -> f64 {
        if self.0 == 0 {
            return 0.0;
        }
        let mut root = (self.0 as f64 / self.1 as f64).sqrt();
        while !self.is_at_least_squared(root) {
            root = root.next_down();
        }
        while self.is_at_least_squared(root.next_up()) {
            root = root.next_up();
        }
        root
    }
}

fn point_segment(p: Vector, [a, b]: [Vector; 2]) -> Fraction {
    let (x, e) = (minus(p, a), minus(b, a));
    let (along, length) = (dot(x, e), dot(e, e));
    if along <= 0 || length == 0 {
        Fraction(dot(x, x), 1)
    } else if along >= length {
        Fraction(dot(minus(p, b), minus(p, b)), 1)
    } else {
        Fraction(dot(x, x) * length - along * along, length)
    }
}

fn point_triangle(p: Vector, corners: [Vector; 3]) -> Fraction {
    let [a, b, c] = corners;
    let n = cross(minus(b, a), minus(c, a));
    let sides = [[a, b], [b, c], [c, a]];
    let is_inside = sides
        .iter()
        .all(|&[x, y]| dot(n, cross(minus(y, x), minus(p, x))) >= 0);
    if n != [0; 3] && is_inside {
        let volume = dot(n, minus(p, a));
        return Fraction(volume * volume, dot(n, n));
    }
    let distances = sides.map(|side| point_segment(p, side));
    distances[0].min(distances[1]).min(distances[2])
}

fn segment_segment([a, b]: [Vector; 2], [c, d]: [Vector; 2]) -> Fraction {
    let (e, f, w) = (minus(b, a), minus(d, c), minus(c, a));
    let n = cross(e, f);
    let (square, u, v) = (dot(n, n), dot(n, cross(w, f)), dot(n, cross(w, e)));
    let inside = 0..=square;
    if square > 0 && inside.contains(&u) && inside.contains(&v) {
        let volume = dot(n, w);
        return Fraction(volume * volume, square);
    }
    let ends = point_segment(a, [c, d]).min(point_segment(b, [c, d]));
    ends.min(point_segment(c, [a, b])).min(point_segment(d, [a, b]))
}

/// The clearance of each vertex, from a loop over all pairs; the distance of a pair by `distance`.
fn expected(
    scene: &Scene,
    cut_off: Separation,
    distance: impl Fn(Pair) -> f64,
    counts: impl Fn(&[u32]) -> bool,
) -> Vec<f64> {
    let mut expected = vec![cut_off.get(); scene.x0.len()];
    for pair in scene.pairs().pairs() {
        let vertices = pair.vertices(&scene.mesh).unwrap();
        if counts(&vertices) {
            let distance = distance(pair);
            for vertex in vertices {
                let least = &mut expected[vertex as usize];
                *least = least.min(distance);
            }
        }
    }
    expected
}

/// Vertices, rods and faces on a grid: touching, coplanar, parallel and flat primitives.
fn on_grid(random: &mut Rng) -> (Scene, Vec<Vector>) {
    let count = random.u32(4..16);
    let size = [2, 5, 40][random.usize(..3)];
    let flat = random.bool();
    let mut corners = |n: u32| -> Vec<u32> { (0..3).map(|_| random.u32(..count)).take(n as usize).collect() };
    let faces: Vec<[u32; 3]> = (0..4).map(|_| corners(3).try_into().unwrap()).collect();
    let rods: Vec<[u32; 2]> = (0..3).map(|_| corners(2).try_into().unwrap()).collect();
    let rods: Vec<_> = rods.into_iter().filter(|[a, b]| a != b).collect();
    let mesh = TriangleMesh::with_edges(count as usize, faces, &rods).unwrap();
    let place = |axis: usize, random: &mut Rng| {
        if flat && axis == 2 {
            0
        } else {
            random.i128(0..size)
        }
    };
    let places: Vec<Vector> = (0..count)
        .map(|_| [0, 1, 2].map(|axis| place(axis, random)))
        .collect();
    let x: Vec<Point> = places.iter().map(|place| place.map(|x| x as f64)).collect();
    let (x0, x1) = (x.clone(), x);
    (Scene { mesh, x0, x1 }, places)
}

#[test]
fn clearances_are_least_distances_in_fractions() {
    let mut random = Rng::with_seed(70);
    let (mut limited, mut irrational, mut touching) = (0, 0, 0);
    for _ in 0..400 {
        let (scene, places) = on_grid(&mut random);
        let cut_off = Separation::new([0.0, 1.5, 8.0, 100.0][random.usize(..4)]).unwrap();
        let distance = |pair: Pair| {
            let vertices = pair.vertices(&scene.mesh).unwrap();
            let at = |k: usize| places[vertices[k] as usize];
            let squared = match pair {
                Pair::VertexFace { .. } => point_triangle(at(0), [at(1), at(2), at(3)]),
                Pair::EdgeEdge { .. } => segment_segment([at(0), at(1)], [at(2), at(3)]),
                Pair::VertexEdge { .. } => point_segment(at(0), [at(1), at(2)]),
                Pair::VertexVertex { .. } => point_segment(at(0), [at(1), at(1)]),
            };
            squared.root()
        };
        let clearances = expected(&scene, cut_off, distance, |_| true);
        let mut detector = Detector::new(scene.mesh.clone());
        assert_eq!(detector.clearances(&scene.x0, cut_off), Ok(clearances.clone()));
        let count = |is: &dyn Fn(f64) -> bool| clearances.iter().filter(|&&c| is(c)).count();
        limited += count(&|c| c == cut_off.get() && c > 0.0);
        irrational += count(&|c| c.fract() != 0.0 && c != cut_off.get());
        touching += count(&|c| c == 0.0);
    }
    assert!(
        limited > 100 && irrational > 500 && touching > 500,
        "{limited} {irrational} {touching}"
    );
}

fn lower<K: PairKind>(step: Step<'_>, ids: [u32; 2]) -> f64 {
    step.query::<K>(ids).unwrap().distance_at(0.0).unwrap().lower
}

#[test]
fn clearances_do_not_depend_on_scale_threads_or_the_broad_phase() {
    let mut random = Rng::with_seed(71);
    for round in 0..60 {
        let (scene, scale) = match round % 3 {
            0 => Scene::pieces(&mut random),
            1 => Scene::mixed(&mut random),
            _ => (Scene::sheets(&mut random, 2, 1e9, 1.0), 1.0),
        };
        let step = scene.step();
        let distance = |pair: Pair| match pair {
            Pair::VertexFace { vertex, face } => lower::<VertexFace>(step, [vertex, face]),
            Pair::EdgeEdge { a, b } => lower::<EdgeEdge>(step, [a, b]),
            Pair::VertexEdge { vertex, edge } => lower::<VertexEdge>(step, [vertex, edge]),
            Pair::VertexVertex { a, b } => lower::<VertexVertex>(step, [a, b]),
        };
        let cut_off = Separation::new(scale * [0.2, 10.0][random.usize(..2)]).unwrap();
        let clearances = expected(&scene, cut_off, distance, |_| true);
        let mut detector = Detector::new(scene.mesh.clone());
        for threads in [1, 4] {
            let found = on_threads(threads, || detector.clearances(&scene.x0, cut_off));
            assert_eq!(found, Ok(clearances.clone()));
        }
        let mut detector = Detector::with_broad_phase(scene.mesh.clone(), Arc::new(AllPairs));
        assert_eq!(detector.clearances(&scene.x0, cut_off), Ok(clearances));

        let counts = |vertices: &[u32]| vertices.iter().sum::<u32>() % 2 == 0;
        let clearances = expected(&scene, cut_off, distance, counts);
        let can_collide = CanCollide::new(move |a, b| counts(&[a, b].concat()));
        let mut detector = Detector::new(scene.mesh.clone()).with_can_collide(can_collide);
        assert_eq!(detector.clearances(&scene.x0, cut_off), Ok(clearances));
    }
}

/// Each vertex moves by less than half of its clearance, in any direction: no pair touches.
#[test]
fn displacements_below_half_of_the_clearances_are_free() {
    let mut random = Rng::with_seed(72);
    let (mut moved, mut not_free) = (0, 0);
    for _ in 0..300 {
        let scene = Scene::sheets(&mut random, 2, 0.0, 0.0);
        let mut detector = Detector::new(scene.mesh.clone());
        let clearances = detector
            .clearances(&scene.x0, Separation::new(1.0).unwrap())
            .unwrap();
        let mut by = |part: f64| -> Vec<Point> {
            let displaced = |(x, clearance): (&Point, &f64)| {
                let direction = [0; 3].map(|_| random.f64() - 0.5);
                let length = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
                [0, 1, 2].map(|axis: usize| x[axis] + part * clearance / length * direction[axis])
            };
            scene.x0.iter().zip(&clearances).map(displaced).collect()
        };
        let (near, far) = (by(0.4999), by(1.5));
        assert_eq!(detector.collides(&scene.x0, &near, CONTACT), Ok(false));
        not_free += usize::from(detector.collides(&scene.x0, &far, CONTACT).unwrap());
        moved += usize::from(clearances.iter().all(|&clearance| clearance > 0.0));
    }
    assert!(moved > 200 && not_free > 20, "{moved} {not_free}");
}

/// Points above one face, in no order of their heights: each has its own.
#[test]
fn each_vertex_has_the_least_distance_of_its_own_pairs() {
    let heights = [1.0, 0.5, 1.5, 0.25, 3.0, 0.75];
    let floor = [[-9.0, -9.0, 0.0], [99.0, -9.0, 0.0], [-9.0, 99.0, 0.0]];
    let points = (0..6).map(|i| [5.0 * f64::from(i), 0.0, heights[i as usize]]);
    let x: Vec<Point> = floor.into_iter().chain(points).collect();
    let mesh = TriangleMesh::new(x.len(), vec![[0, 1, 2]]).unwrap();
    let found = Detector::new(mesh).clearances(&x, Separation::new(2.0).unwrap());
    assert_eq!(found.unwrap(), [0.25, 0.25, 0.25, 1.0, 0.5, 1.5, 0.25, 2.0, 0.75]);
}
