//! Every broad phase finds exactly the pairs of boxes that meet.

use std::ops::ControlFlow;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use exact_ccd_mesh::{Aabb, AllPairs, BoxPairs, Boxes, Bvh, Point, Sweep};
use proptest::prelude::*;

use crate::contacts::scene::on_threads;

/// A box at both ends of a step.
type Moving = [Aabb; 2];

/// True if no axis separates two boxes in the same order at all times, by definition.
fn meet<const T: usize>(p: &[Aabb; T], q: &[Aabb; T]) -> bool {
    let before = |a: &[Aabb; T], b: &[Aabb; T], k: usize| (0..T).all(|t| a[t].upper[k] < b[t].lower[k]);
    !(0..3).any(|k| before(p, q, k) || before(q, p, k))
}

/// The boxes by their indices.
fn by_index<const T: usize>(boxes: &Boxes<T>) -> Vec<[Aabb; T]> {
    let mut sorted: Vec<_> = boxes.iter().collect();
    sorted.sort_by_key(|(id, _)| *id);
    assert!(sorted.iter().enumerate().all(|(i, (id, _))| i == *id as usize));
    sorted.into_iter().map(|(_, places)| places).collect()
}

/// The pairs of boxes that meet, by definition.
fn pairs<const T: usize>(a: &[[Aabb; T]], b: &[[Aabb; T]]) -> Vec<[u32; 2]> {
    let ids = |boxes: &[[Aabb; T]]| 0..boxes.len() as u32;
    ids(a)
        .flat_map(|i| ids(b).map(move |j| [i, j]))
        .filter(|&[i, j]| meet(&a[i as usize], &b[j as usize]))
        .collect()
}

/// The pairs of two boxes of one slice.
fn pairs_once<const T: usize>(boxes: &[[Aabb; T]]) -> Vec<[u32; 2]> {
    let all = pairs(boxes, boxes).into_iter();
    all.filter(|[i, j]| i < j).collect()
}

fn sorted(
    find: impl Fn(&(dyn Fn(&[[u32; 2]]) -> ControlFlow<()> + Sync)) -> ControlFlow<()>,
) -> Vec<[u32; 2]> {
    let found = Mutex::new(Vec::new());
    let flow = find(&|pairs| {
        found.lock().unwrap().extend_from_slice(pairs);
        ControlFlow::Continue(())
    });
    assert!(flow.is_continue());
    let mut found = found.into_inner().unwrap();
    found.sort_unstable();
    found
}

#[test]
fn boxes_have_their_indices_and_places() {
    let cubes: Vec<[Aabb; 1]> = (0..11)
        .map(|i| [Aabb::of([f64::from(i % 4), 0.125 * f64::from(i), 0.0]).union(&Aabb::of([0.125; 3]))])
        .collect();
    let boxes = Boxes::new(&cubes).unwrap();
    assert!(boxes.len() == 11 && !boxes.is_empty());
    // Numbers of single precision are not rounded.
    assert_eq!(by_index(&boxes), cubes);
    let none = Boxes::<2>::new(&[]).unwrap();
    assert!(none.is_empty() && none.iter().next().is_none());
}

fn between<const T: usize>(broad_phase: &impl BoxPairs<T>, a: &Boxes<T>, b: &Boxes<T>) -> Vec<[u32; 2]> {
    sorted(|visit| broad_phase.between(a, b, visit))
}

fn within<const T: usize>(broad_phase: &impl BoxPairs<T>, boxes: &Boxes<T>) -> Vec<[u32; 2]> {
    sorted(|visit| broad_phase.within(boxes, visit))
}

fn assert_finds_all<const T: usize>(broad_phase: &impl BoxPairs<T>, a: &[[Aabb; T]], b: &[[Aabb; T]]) {
    let [coarse_a, coarse_b] = [a, b].map(|boxes| Boxes::new(boxes).unwrap());
    let [rounded_a, rounded_b] = [&coarse_a, &coarse_b].map(by_index);
    let found = between(broad_phase, &coarse_a, &coarse_b);
    assert_eq!(found, pairs(&rounded_a, &rounded_b));
    // Rounding loses no pair.
    assert!(pairs(a, b).iter().all(|pair| found.binary_search(pair).is_ok()));
    assert_eq!(within(broad_phase, &coarse_a), pairs_once(&rounded_a));
}

fn assert_all_find_all(a: &[Moving], b: &[Moving]) {
    assert_each_finds_all(a, b);
    // The boxes of the start, at rest.
    let [a, b] = [a, b].map(|boxes| boxes.iter().map(|&[start, _]| [start]).collect::<Vec<_>>());
    assert_each_finds_all(&a, &b);
}

fn assert_each_finds_all<const T: usize>(a: &[[Aabb; T]], b: &[[Aabb; T]])
where
    Bvh: BoxPairs<T>,
{
    assert_finds_all(&AllPairs, a, b);
    assert_finds_all(&Bvh, a, b);
    assert_finds_all(&Bvh, b, a);
    assert_finds_all(&Sweep, a, b);
    assert_finds_all(&Sweep, b, a);
}

fn at_rest(bounds: Aabb) -> Moving {
    [bounds, bounds]
}

fn around(p: Point, q: Point) -> Aabb {
    Aabb::of(p).union(&Aabb::of(q))
}

/// Whole numbers, so that boxes touch and coincide, and extreme numbers.
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

fn bounds() -> impl Strategy<Value = Aabb> {
    prop_oneof![
        20 => (point(), point()).prop_map(|(p, q)| around(p, q)),
        20 => (point(), prop::array::uniform3(0.0..0.5))
            .prop_map(|(p, size)| around(p, std::array::from_fn(|axis| p[axis] + size[axis]))),
        20 => point().prop_map(Aabb::of),
        1 => Just(Aabb::EMPTY),
    ]
}

fn moving() -> impl Strategy<Value = Moving> {
    prop_oneof![
        bounds().prop_map(at_rest),
        (bounds(), bounds()).prop_map(|(start, end)| [start, end]),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_boxes(
        a in prop::collection::vec(moving(), 0..150),
        b in prop::collection::vec(moving(), 0..150),
    ) {
        assert_all_find_all(&a, &b);
    }
}

#[test]
fn no_boxes() {
    let one = [at_rest(Aabb::of([0.0; 3]))];
    assert_all_find_all(&[], &[]);
    assert_all_find_all(&one, &[]);
    assert_all_find_all(&[], &one);
}

#[test]
fn boxes_that_touch_in_a_face_an_edge_a_corner() {
    let unit = around([0.0; 3], [1.0; 3]);
    let touching =
        [[1.0, 0.0, 0.0], [1.0, -1.0, 0.5], [-1.0, 1.0, 1.0]].map(|p| around(p, p.map(|x| x + 1.0)));
    let apart = around([1.0 + 1e-6, 0.0, 0.0], [2.0; 3]);
    let unit = Boxes::new(&[[unit]]).unwrap();
    let others = Boxes::new(&[touching[0], touching[1], apart, touching[2]].map(|at| [at])).unwrap();
    for found in [between(&Bvh, &unit, &others), between(&AllPairs, &unit, &others)] {
        assert_eq!(found, [[0, 0], [0, 1], [0, 3]]);
    }
}

/// Of boxes that are smaller than the units of single precision at their place.
#[test]
fn boxes_relative_to_an_origin_near_them_meet_as_near_zero() {
    let row = |first: f64| (0..100).map(move |i| first + 0.375 * f64::from(i));
    let boxes = |first: f64, second: f64| -> Vec<Moving> {
        let cubes = row(first).zip(row(second));
        let cube = |x: f64| around([x; 3], [x + 0.5; 3]);
        cubes.map(|(x0, x1)| [cube(x0), cube(x1)]).collect()
    };
    let far = boxes(1e9, -1e12);
    let near = Boxes::relative_to(&far, &[[1e9; 3], [-1e12; 3]]).unwrap();
    assert_eq!(by_index(&near), boxes(0.0, 0.0));
    assert_eq!(within(&Bvh, &near), pairs_once(&far));
    assert!(within(&Bvh, &Boxes::new(&far).unwrap()).len() > 1000);
    let relative = Boxes::relative_to(&far, &[[f64::NAN; 3], [f64::INFINITY; 3]]).unwrap();
    assert_eq!(by_index(&relative), by_index(&Boxes::new(&far).unwrap()));
    // Any origin loses no pair.
    for origin in [f64::NAN, f64::INFINITY, f64::MAX] {
        let found = within(&Bvh, &Boxes::relative_to(&far, &[[origin; 3]; 2]).unwrap());
        assert!(pairs_once(&far).iter().all(|pair| found.contains(pair)));
    }
}

#[test]
fn boxes_that_pass_each_other_may_meet_and_boxes_with_equal_motion_do_not() {
    let at = |x: f64| around([x, 0.0, 0.0], [x + 1.0, 1.0, 1.0]);
    let swaps = Boxes::new(&[[at(0.0), at(5.0)], [at(5.0), at(0.0)]]).unwrap();
    let follows = Boxes::new(&[[at(0.0), at(5.0)], [at(2.0), at(7.0)]]).unwrap();
    assert_eq!(within(&Bvh, &swaps), [[0, 1]]);
    assert_eq!(within(&Bvh, &follows), Vec::<[u32; 2]>::new());
}

#[test]
fn both_zeros_are_one_point() {
    let zeros = Boxes::new(&[[-0.0, 0.0, -0.0], [0.0, -0.0, 0.0]].map(|at| [Aabb::of(at)])).unwrap();
    assert_eq!(within(&Bvh, &zeros), [[0, 1]]);
    assert_eq!(within(&Sweep, &zeros), [[0, 1]]);
    assert_eq!(within(&AllPairs, &zeros), [[0, 1]]);
}

#[test]
fn sides_that_are_not_numbers_are_unbounded() {
    let mut boxes: Vec<[Aabb; 1]> = (0..100)
        .map(|i| {
            [around(
                [2.0 * f64::from(i), 0.0, 0.0],
                [2.0 * f64::from(i) + 1.0, 1.0, 1.0],
            )]
        })
        .collect();
    boxes[40][0].lower[0] = f64::NAN;
    boxes[70][0].upper[0] = f64::NAN;
    let expected: Vec<[u32; 2]> = (0..40)
        .map(|i| [i, 40])
        .chain((71..100).map(|i| [70, i]))
        .collect();
    let boxes = Boxes::new(&boxes).unwrap();
    assert_eq!(within(&AllPairs, &boxes), expected);
    assert_eq!(within(&Bvh, &boxes), expected);
    assert_eq!(within(&Sweep, &boxes), expected);
}

#[test]
fn identical_boxes_all_overlap() {
    let boxes = vec![at_rest(around([1.0, -2.0, 0.1], [1.0, 5.0, 0.1])); 300];
    assert_eq!(within(&Bvh, &Boxes::new(&boxes).unwrap()).len(), 300 * 299 / 2);
    assert_all_find_all(&boxes, &boxes);
}

#[test]
fn boxes_of_all_sizes() {
    let size = |exponent: i32| 2.0_f64.powi(exponent);
    let nested = (-1000..1000)
        .step_by(7)
        .map(|e| at_rest(around([0.0; 3], [size(e); 3])));
    let apart = (-1000..1000)
        .step_by(7)
        .map(|e| at_rest(around([size(e); 3], [1.5 * size(e); 3])));
    let (nested, apart): (Vec<_>, Vec<_>) = (nested.collect(), apart.collect());
    assert_all_find_all(&nested, &apart);
}

/// A lattice of boxes that overlap their neighbours.
fn lattice() -> Vec<Moving> {
    let lattice = |i: u32| [i % 11, i / 11 % 11, i / 121].map(f64::from);
    (0..1331)
        .map(|i| at_rest(around(lattice(i), lattice(i).map(|x| x + 1.25))))
        .collect()
}

#[test]
fn the_pairs_are_the_same_on_any_number_of_threads() {
    let moving = lattice();
    let expected = pairs(&moving, &moving);
    for threads in [1, 2, 5] {
        let found = on_threads(threads, || {
            let boxes = Boxes::new(&moving).unwrap();
            [between(&Bvh, &boxes, &boxes), between(&Sweep, &boxes, &boxes)]
        });
        assert_eq!(found, [expected.clone(), expected.clone()]);
    }
}

#[test]
fn a_break_ends_the_search() {
    let boxes = Boxes::new(&lattice()).unwrap();
    fn calls(find: impl Fn(&(dyn Fn(&[[u32; 2]]) -> ControlFlow<()> + Sync)) -> ControlFlow<()>) -> usize {
        let calls = AtomicUsize::new(0);
        let flow = find(&|_| {
            calls.fetch_add(1, Ordering::Relaxed);
            ControlFlow::Break(())
        });
        assert!(flow.is_break());
        calls.into_inner()
    }
    // Each thread may be in one call.
    let threads = rayon::current_num_threads();
    assert!(calls(|visit| Bvh.within(&boxes, visit)) <= threads);
    assert!(calls(|visit| Bvh.between(&boxes, &boxes, visit)) <= threads);
    assert!(calls(|visit| Sweep.within(&boxes, visit)) <= threads);
    assert_eq!(calls(|visit| AllPairs.within(&boxes, visit)), 1);
}

/// The places of a block or of a node that have no box do not meet it, though nothing is beyond its sides.
#[test]
fn a_box_without_bounds_meets_all_others() {
    let mut boxes: Vec<Moving> = (0..100)
        .map(|i| at_rest(Aabb::of([f64::from(i), 0.0, 0.0])))
        .collect();
    boxes[40] = at_rest(around([f64::MIN; 3], [f64::MAX; 3]));
    assert_all_find_all(&boxes, &boxes);
}

#[test]
fn an_empty_box_meets_no_box() {
    let unit = around([0.0; 3], [1.0; 3]);
    let boxes: Vec<Moving> = (0..20)
        .map(|i| at_rest(if i % 3 == 0 { Aabb::EMPTY } else { unit }))
        .collect();
    assert_all_find_all(&boxes, &boxes);
}
