//! Every broad phase finds exactly the pairs of boxes that overlap, in order.

use ccd_mesh::{AllPairs, Bounds, BroadPhase, Bvh, Point};
use proptest::prelude::*;

/// The pairs of overlapping boxes, by definition.
fn between(a: &[Bounds], b: &[Bounds], keep: impl Fn(u32, u32) -> bool) -> Vec<[u32; 2]> {
    let meet = |p: &Bounds, q: &Bounds| {
        (0..3).all(|k| f64::max(p.lower[k], q.lower[k]) <= f64::min(p.upper[k], q.upper[k]))
    };
    let mut pairs = Vec::new();
    for (i, p) in a.iter().enumerate() {
        for (j, q) in b.iter().enumerate() {
            if meet(p, q) && keep(i as u32, j as u32) {
                pairs.push([i as u32, j as u32]);
            }
        }
    }
    pairs
}

/// Keeps two pairs in three, without any order.
fn keep(i: u32, j: u32) -> bool {
    !(5 * i + 7 * j).is_multiple_of(3)
}

fn assert_finds_all(broad_phase: &impl BroadPhase, a: &[Bounds], b: &[Bounds]) {
    assert_eq!(broad_phase.between(a, b, |_, _| true), between(a, b, |_, _| true));
    assert_eq!(broad_phase.between(a, b, keep), between(a, b, keep));
    let once = |i, j| i < j && keep(i, j);
    assert_eq!(broad_phase.within(a, keep), between(a, a, once));
}

fn assert_all_find_all(a: &[Bounds], b: &[Bounds]) {
    assert_finds_all(&AllPairs, a, b);
    assert_finds_all(&Bvh, a, b);
    assert_finds_all(&Bvh, b, a);
}

fn around(p: Point, q: Point) -> Bounds {
    Bounds::of(p).union(&Bounds::of(q))
}

/// Whole numbers, so that boxes touch and coincide, and numbers out of all proportion.
fn coordinate() -> impl Strategy<Value = f64> {
    let extreme = [f64::MAX, f64::MIN, 1e-300, -1e-300, 5e-324, -5e-324, -0.0, 0.5];
    prop_oneof![
        4 => (-3..=3).prop_map(f64::from),
        1 => prop::sample::select(extreme.to_vec()),
    ]
}

fn point() -> impl Strategy<Value = Point> {
    prop::array::uniform3(coordinate())
}

fn bounds() -> impl Strategy<Value = Bounds> {
    prop_oneof![
        20 => (point(), point()).prop_map(|(p, q)| around(p, q)),
        20 => (point(), prop::array::uniform3(0.0..0.5))
            .prop_map(|(p, size)| around(p, std::array::from_fn(|axis| p[axis] + size[axis]))),
        20 => point().prop_map(Bounds::of),
        1 => Just(Bounds::EMPTY),
    ]
}

proptest! {
    #[test]
    fn random_boxes(
        a in prop::collection::vec(bounds(), 0..150),
        b in prop::collection::vec(bounds(), 0..150),
    ) {
        assert_all_find_all(&a, &b);
    }
}

#[test]
fn no_boxes() {
    let one = [Bounds::of([0.0; 3])];
    assert_all_find_all(&[], &[]);
    assert_all_find_all(&one, &[]);
    assert_all_find_all(&[], &one);
}

#[test]
fn boxes_that_touch_in_a_face_an_edge_a_corner() {
    let unit = around([0.0; 3], [1.0; 3]);
    let touching =
        [[1.0, 0.0, 0.0], [1.0, -1.0, 0.5], [-1.0, 1.0, 1.0]].map(|p| around(p, p.map(|x| x + 1.0)));
    let apart = around([1.0_f64.next_up(), 0.0, 0.0], [2.0; 3]);
    let others = [touching[0], touching[1], apart, touching[2]];
    for pairs in [
        Bvh.between(&[unit], &others, |_, _| true),
        AllPairs.between(&[unit], &others, |_, _| true),
    ] {
        assert_eq!(pairs, [[0, 0], [0, 1], [0, 3]]);
    }
}

#[test]
fn both_zeros_are_one_point() {
    let zeros = [[-0.0, 0.0, -0.0], [0.0, -0.0, 0.0]].map(Bounds::of);
    assert_eq!(Bvh.within(&zeros, |_, _| true), [[0, 1]]);
    assert_eq!(AllPairs.within(&zeros, |_, _| true), [[0, 1]]);
}

#[test]
fn identical_boxes_all_overlap() {
    let boxes = vec![around([1.0, -2.0, 0.1], [1.0, 5.0, 0.1]); 300];
    assert_eq!(Bvh.within(&boxes, |_, _| true).len(), 300 * 299 / 2);
    assert_all_find_all(&boxes, &boxes);
}

#[test]
fn boxes_of_all_sizes() {
    let size = |exponent: i32| 2.0_f64.powi(exponent);
    let nested = (-1000..1000).step_by(7).map(|e| around([0.0; 3], [size(e); 3]));
    let apart = (-1000..1000)
        .step_by(7)
        .map(|e| around([size(e); 3], [1.5 * size(e); 3]));
    let (nested, apart): (Vec<_>, Vec<_>) = (nested.collect(), apart.collect());
    assert_all_find_all(&nested, &apart);
    assert_eq!(Bvh.within(&apart, |_, _| true), Vec::<[u32; 2]>::new());
}

#[test]
fn the_pairs_are_the_same_on_any_number_of_threads() {
    // A lattice of boxes that overlap their neighbours.
    let lattice = |i: u32| [i % 11, i / 11 % 11, i / 121].map(f64::from);
    let boxes: Vec<Bounds> = (0..1331)
        .map(|i| around(lattice(i), lattice(i).map(|x| x + 1.25)))
        .collect();
    let expected = between(&boxes, &boxes, keep);
    for threads in [1, 2, 5] {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        assert_eq!(pool.install(|| Bvh.between(&boxes, &boxes, keep)), expected);
        assert_eq!(pool.install(|| AllPairs.between(&boxes, &boxes, keep)), expected);
    }
}
