//! Laws: other descriptions of one motion have the same answers, bit for bit.

use exact_ccd::motion::{Bezier, Chain, CurvedQuery, RigidMotion};
use exact_ccd::{
    CONTACT, EdgeEdge, Intervals, Kind, Options, Point, Query, Separation, VertexEdge, VertexFace,
    VertexVertex,
};
use fastrand::Rng;

use crate::numbers::{Numbers, one_of};

const COUNT: usize = if cfg!(debug_assertions) { 60 } else { 1000 };

/// The numbers whose sums and products here are exact.
const EXACT: [Numbers; 2] = [Numbers::Lattice, Numbers::Planar];

/// Contact, and a distance.
fn options() -> [Options; 2] {
    [CONTACT, Separation::new(0.75).expect("a distance").into()]
}

fn curves<K: Kind>(control: &[K::Points]) -> CurvedQuery<K> {
    Bezier::new(control).expect("finite points").into()
}

fn bodies<K: Kind>(points: K::Points, first: &Chain, second: &Chain) -> CurvedQuery<K> {
    CurvedQuery::of_bodies(points, first.clone(), second.clone()).expect("finite points")
}

/// The sum of multiples of sets of points.
fn sum<K: Kind>(terms: &[(f64, K::Points)]) -> K::Points {
    let mut sum = K::Points::default();
    for (factor, points) in terms {
        let coordinates = sum.as_mut().as_flattened_mut().iter_mut();
        for (target, x) in coordinates.zip(points.as_ref().as_flattened()) {
            *target += factor * x;
        }
    }
    sum
}

/// Calls a test with numbers and a source of random ones: enough of its queries come within the distance.
fn collisions(mut test: impl FnMut(Numbers, &mut Rng) -> bool) {
    let mut random = Rng::with_seed(2);
    let cases = EXACT.iter().flat_map(|numbers| [*numbers; COUNT]);
    let count = cases.filter(|&numbers| test(numbers, &mut random)).count();
    assert!(count > COUNT / 20, "{count}");
}

fn straight_motion_is_straight<K: Kind>() {
    collisions(|numbers, random| {
        let [start, end] = [(); 2].map(|()| numbers.points::<K>(random));
        let straight = Query::<K>::new(start, end).expect("finite points");
        // 2 (t s) (start + end) / 2 + …
        let middle = sum::<K>(&[(0.5, start), (0.5, end)]);
        let queries = [curves::<K>(&[start, end]), curves::<K>(&[start, middle, end])];
        for options in options() {
            for query in &queries {
                assert_eq!(query.collides(options), straight.collides(options), "{query:?}");
                assert_eq!(query.intervals(options), straight.intervals(options), "{query:?}");
                let exact = straight.exactly().impact(options);
                assert_eq!(query.impact(options), exact, "{query:?}");
            }
        }
        straight.collides(options()[1])
    });
}

/// Bodies with quaternions that are multiples of one at rest. In one of four queries the places are at rest
/// too.
fn motion_without_turn_is_straight<K: Kind>() {
    collisions(|numbers, random| {
        let points = numbers.points::<K>(random);
        let rests = random.u32(..4) == 0;
        let places = [(); 2].map(|()| {
            let start = numbers.point(random);
            [start, if rests { start } else { numbers.point(random) }]
        });
        let chains = places.map(|places| {
            let quaternions = [[2.0, 0.0, 0.0, 0.0], [0.7, 0.0, 0.0, 0.0]];
            Chain::from(RigidMotion::new(quaternions, &places).expect("a motion"))
        });
        let at = |time: usize| {
            let mut moved = points;
            for (i, point) in moved.as_mut().iter_mut().enumerate() {
                let place = places[usize::from(i >= K::FIRST)][time];
                *point = [0, 1, 2].map(|axis: usize| point[axis] + place[axis]);
            }
            moved
        };
        let straight = Query::<K>::new(at(0), at(1)).expect("finite points");
        let query = bodies::<K>(points, &chains[0], &chains[1]);
        for options in options() {
            assert_eq!(query.intervals(options), straight.intervals(options), "{query:?}");
            let exact = straight.exactly().impact(options);
            assert_eq!(query.impact(options), exact, "{query:?}");
        }
        straight.collides(options()[1])
    });
}

/// In degree p + 1, the control points are (k cₖ₋₁ + (p + 1 − k) cₖ) / (p + 1). They are exact, because the
/// given control points are multiples of p + 1.
fn degree_elevation_changes_nothing<K: Kind>() {
    collisions(|numbers, random| {
        let degree = random.usize(1..=3);
        let control = numbers.curves::<K>(random, degree);
        let most = (degree + 1) as f64;
        let given: Vec<_> = control.iter().map(|set| sum::<K>(&[(most, *set)])).collect();
        let at = |k: usize| {
            let before = k.checked_sub(1).map(|k| control[k]).unwrap_or_default();
            let after = control.get(k).copied().unwrap_or_default();
            sum::<K>(&[(k as f64, before), (most - k as f64, after)])
        };
        let elevated: Vec<_> = (0..=degree + 1).map(at).collect();
        let [query, other] = [curves::<K>(&given), curves::<K>(&elevated)];
        for options in options() {
            assert_eq!(query.intervals(options), other.intervals(options), "{query:?}");
            assert_eq!(query.impact(options), other.impact(options), "{query:?}");
        }
        query.collides(options()[1])
    });
}

/// The intervals, reversed, begin where the others end, up to the rounding of both.
fn assert_reversed(forward: &Intervals, backward: &Intervals, query: &impl core::fmt::Debug) {
    assert_eq!(forward.len(), backward.len(), "{query:?}");
    for (one, other) in forward.iter().zip(backward.iter().rev()) {
        assert_eq!(one.is_moment, other.is_moment, "{query:?}");
        for [a, b] in [[one.start, other.end], [one.end, other.start]] {
            assert!((a.lower() + b.lower() - 1.0).abs() < 1e-15, "{query:?}");
        }
    }
}

fn reversed_motion_has_reversed_times<K: Kind>() {
    collisions(|numbers, random| {
        let mut control = numbers.curves::<K>(random, 2);
        let query = curves::<K>(&control);
        control.reverse();
        let reversed = curves::<K>(&control);
        for options in options() {
            assert_reversed(&query.intervals(options), &reversed.intervals(options), &query);
        }
        query.collides(options()[1])
    });
}

fn reversed(chain: &Chain) -> Chain {
    let motions = chain.motions().iter().map(|motion| {
        let [start, end] = motion.quaternions();
        let places: Vec<Point> = motion.places().iter().rev().copied().collect();
        RigidMotion::new([end, start], &places).expect("a motion")
    });
    Chain::new(motions).expect("as many motions")
}

fn reversed_bodies_have_reversed_times<K: Kind>() {
    collisions(|numbers, random| {
        let points = numbers.points::<K>(random);
        let chains = [(); 2].map(|()| numbers.chain(random, 1));
        let query = bodies::<K>(points, &chains[0], &chains[1]);
        let other = bodies::<K>(points, &reversed(&chains[0]), &reversed(&chains[1]));
        for options in options() {
            assert_reversed(&query.intervals(options), &other.intervals(options), &query);
        }
        query.collides(options()[1])
    });
}

/// Quaternions times a number are the same rotations.
fn the_length_of_a_quaternion_does_not_matter<K: Kind>() {
    collisions(|numbers, random| {
        let points = numbers.points::<K>(random);
        let chains = [(); 2].map(|()| numbers.chain(random, 1));
        let factor = one_of(random, &[-1.0, 3.0, 0.5, -f64::from_bits(123 << 52)]);
        let scaled = |chain: &Chain| {
            let motions = chain.motions().iter().map(|motion| {
                let quaternions = motion.quaternions().map(|q| q.map(|x| factor * x));
                // Almost opposite quaternions have more digits than others.
                let is_exact = |x: &f64| factor.mul_add(*x, -(factor * x)) == 0.0;
                let is_exact = motion.quaternions().as_flattened().iter().all(is_exact);
                is_exact.then(|| RigidMotion::new(quaternions, motion.places()).expect("a motion"))
            });
            Chain::new(motions.collect::<Option<Vec<_>>>()?).ok()
        };
        let query = bodies::<K>(points, &chains[0], &chains[1]);
        let Some(first) = scaled(&chains[0]) else {
            return false;
        };
        let other = bodies::<K>(points, &first, &chains[1]);
        for options in options() {
            assert_eq!(query.intervals(options), other.intervals(options), "{query:?}");
            assert_eq!(query.impact(options), other.impact(options), "{query:?}");
        }
        query.collides(options()[1])
    });
}

/// A motion of both bodies, as the first of both chains.
fn a_common_motion_changes_no_time<K: Kind>() {
    collisions(|numbers, random| {
        let points = numbers.points::<K>(random);
        let chains = [(); 2].map(|()| numbers.chain(random, 1));
        let common = numbers.motion(random);
        let moved = |chain: &Chain| {
            let motions = [&common].into_iter().chain(chain.motions());
            Chain::new(motions.cloned()).expect("a short chain")
        };
        let query = bodies::<K>(points, &chains[0], &chains[1]);
        let other = bodies::<K>(points, &moved(&chains[0]), &moved(&chains[1]));
        for options in options() {
            assert_eq!(query.intervals(options), other.intervals(options), "{query:?}");
        }
        query.collides(options()[1])
    });
}

/// Two bodies with equal motions touch always or never.
fn equal_motions_are_at_rest<K: Kind>() {
    collisions(|numbers, random| {
        let points = numbers.points::<K>(random);
        let motion = numbers.motion(random);
        // The same motion in another description, so that the chains are not compared as equal.
        let quaternions = motion.quaternions().map(|q| q.map(|x| 2.0 * x));
        let other = RigidMotion::new(quaternions, motion.places()).expect("a motion");
        let query = bodies::<K>(points, &motion.into(), &other.into());
        let rest = Query::<K>::new(points, points).expect("finite points");
        // Vertices at rest are rarely nearer.
        let far = Separation::new(3.0).expect("a distance").into();
        for options in options().into_iter().chain([far]) {
            assert_eq!(query.intervals(options), rest.intervals(options), "{query:?}");
        }
        query.collides(far)
    });
}

/// A step is divided at t = 1/2. Its first time is half the first time t of the first half, if there is one,
/// and otherwise (1 + t) / 2 for the second half.
fn assert_divided<K: Kind>([whole, first, second]: [&CurvedQuery<K>; 3]) {
    for options in options() {
        let time = |query: &CurvedQuery<K>| query.time_of_impact(options);
        match (time(first), time(second)) {
            (Some(t), _) => assert_eq!(time(whole), Some(t / 2.0), "{whole:?}"),
            (None, Some(t)) => {
                let found = time(whole).expect("the second half collides");
                assert!((found - 0.5 - t / 2.0).abs() <= f64::EPSILON / 2.0, "{whole:?}");
            }
            (None, None) => assert_eq!(time(whole), None, "{whole:?}"),
        }
    }
}

/// The control points of both halves, by de Casteljau's scheme.
fn halves<K: Kind>(control: &[K::Points]) -> [Vec<K::Points>; 2] {
    let mut row = control.to_vec();
    let mut halves = [Vec::new(), Vec::new()];
    while let (Some(&first), Some(&last)) = (row.first(), row.last()) {
        halves[0].push(first);
        halves[1].push(last);
        let pairs = row.windows(2);
        row = pairs
            .map(|pair| sum::<K>(&[(0.5, pair[0]), (0.5, pair[1])]))
            .collect();
    }
    halves[1].reverse();
    halves
}

fn a_divided_step_is_the_same_motion<K: Kind>() {
    collisions(|numbers, random| {
        let degree = random.usize(1..=3);
        let control = numbers.curves::<K>(random, degree);
        let [first, second] = halves::<K>(&control).map(|half| curves::<K>(&half));
        let whole = curves::<K>(&control);
        assert_divided([&whole, &first, &second]);
        whole.collides(options()[1])
    });
}

fn a_divided_turn_is_the_same_motion<K: Kind>() {
    collisions(|numbers, random| {
        let points = numbers.points::<K>(random);
        let chains = [(); 2].map(|()| numbers.chain(random, 1));
        let parts = [0, 1].map(|half: usize| {
            let [first, second] = [0, 1].map(|body: usize| {
                let motions = chains[body].motions().iter().map(|motion| {
                    let [start, end] = motion.quaternions();
                    let middle = [0, 1, 2, 3].map(|i: usize| (start[i] + end[i]) / 2.0);
                    let quaternions = [[start, middle], [middle, end]][half];
                    let places: Vec<_> = motion.places().iter().map(|&place| [place; 2]).collect();
                    let places = halves::<VertexVertex>(&places)[half].clone();
                    let places: Vec<_> = places.iter().map(|places| places[0]).collect();
                    RigidMotion::new(quaternions, &places).expect("a motion")
                });
                Chain::new(motions).expect("one motion")
            });
            bodies::<K>(points, &first, &second)
        });
        let whole = bodies::<K>(points, &chains[0], &chains[1]);
        // Sums of almost opposite quaternions are exact: they are tiny.
        assert_divided([&whole, &parts[0], &parts[1]]);
        whole.collides(options()[1])
    });
}

/// Bodies that are exchanged, and vertices in another order.
#[test]
fn renumbered_edges_touch_at_the_same_times() {
    collisions(|numbers, random| {
        let [a, b, c, d] = numbers.points::<EdgeEdge>(random);
        let [first, second] = [(); 2].map(|()| numbers.chain(random, 1));
        let query = bodies::<EdgeEdge>([a, b, c, d], &first, &second);
        let others = [
            bodies::<EdgeEdge>([c, d, a, b], &second, &first),
            bodies::<EdgeEdge>([b, a, c, d], &first, &second),
            bodies::<EdgeEdge>([a, b, d, c], &first, &second),
        ];
        for options in options() {
            for other in &others {
                assert_eq!(query.intervals(options), other.intervals(options), "{query:?}");
            }
        }
        query.collides(options()[1])
    });
}

#[test]
fn a_renumbered_face_is_touched_at_the_same_times() {
    collisions(|numbers, random| {
        let [p, a, b, c] = numbers.points::<VertexFace>(random);
        let [first, second] = [(); 2].map(|()| numbers.chain(random, 1));
        let query = bodies::<VertexFace>([p, a, b, c], &first, &second);
        for points in [[p, b, c, a], [p, b, a, c]] {
            let other = bodies::<VertexFace>(points, &first, &second);
            for options in options() {
                assert_eq!(query.intervals(options), other.intervals(options), "{query:?}");
            }
        }
        query.collides(options()[1])
    });
}

/// Each law for each kind.
macro_rules! laws {
    ($($law:ident)*) => {
        mod vertex_face {
            $(#[test] fn $law() { super::$law::<super::VertexFace>(); })*
        }
        mod edge_edge {
            $(#[test] fn $law() { super::$law::<super::EdgeEdge>(); })*
        }
        mod vertex_edge {
            $(#[test] fn $law() { super::$law::<super::VertexEdge>(); })*
        }
        mod vertex_vertex {
            $(#[test] fn $law() { super::$law::<super::VertexVertex>(); })*
        }
    };
}

laws! {
    straight_motion_is_straight
    motion_without_turn_is_straight
    degree_elevation_changes_nothing
    reversed_motion_has_reversed_times
    reversed_bodies_have_reversed_times
    the_length_of_a_quaternion_does_not_matter
    a_common_motion_changes_no_time
    equal_motions_are_at_rest
    a_divided_step_is_the_same_motion
    a_divided_turn_is_the_same_motion
}
