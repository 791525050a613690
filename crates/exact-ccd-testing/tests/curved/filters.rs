//! The answers with filters are those in integers.

use exact_ccd::motion::{BodyPair, Chain, CurvedQuery};
use exact_ccd::{CONTACT, EdgeEdge, Kind, Options, Point, Separation, VertexEdge, VertexFace, VertexVertex};
use fastrand::Rng;

use crate::cases::Case;
use crate::numbers::{Numbers, one_of};

const COUNT: usize = if cfg!(debug_assertions) { 40 } else { 1000 };

/// Contact and a distance, in all of the step and in a part.
fn options(random: &mut Rng) -> [Options; 4] {
    let d = Separation::new(one_of(random, &[0.125, 0.75, 1e-9, 1e200])).expect("a distance");
    let until = one_of(random, &[0.5, 0.3, 0.0, -1.0, f64::NAN]);
    [
        CONTACT,
        d.into(),
        CONTACT.until(until),
        Options::within(d).until(until),
    ]
}

/// Compares all answers. Returns whether the filters decide contact.
fn assert_same<K: Kind>(query: &CurvedQuery<K>, random: &mut Rng) -> bool {
    for options in options(random) {
        let exactly = query.exactly();
        let time = exactly.time_of_impact(options);
        assert_eq!(
            query.collides(options),
            exactly.collides(options),
            "{options:?} {query:?}"
        );
        assert_eq!(query.time_of_impact(options), time, "{options:?} {query:?}");
        match (query.bracket(options), time) {
            (None, _) => {}
            (Some([start, _]), None) => {
                // A first time that does not count may be in a part that begins before the last one that
                // does.
                let is_later = exactly
                    .time_of_impact(options.until(1.0))
                    .is_some_and(|time| start <= time);
                assert!(start == f64::INFINITY || is_later, "{options:?} {query:?}");
            }
            (Some([start, end]), Some(time)) => {
                assert!((start..=end).contains(&time), "{options:?} {query:?}");
            }
        }
    }
    query.bracket(CONTACT).is_some()
}

/// A family of queries with numbers of all sorts. Most of those with numbers between −1 and 1 are decided by
/// filters.
fn check<K: Kind>(case: impl Fn(Numbers, &mut Rng) -> Case<K>) {
    let mut random = Rng::with_seed(3);
    for numbers in Numbers::ALL {
        let count = if numbers == Numbers::Extreme {
            COUNT / 4
        } else {
            COUNT
        };
        let mut decided = 0;
        for _ in 0..count {
            let Case { query, .. } = case(numbers, &mut random);
            decided += usize::from(assert_same(&query, &mut random));
        }
        let least = match numbers {
            // Of the rest, most have quaternions that almost vanish in the step, or degrees above 8.
            Numbers::Uniform => count * 2 / 3,
            Numbers::Lattice => count / 4,
            Numbers::Planar | Numbers::Extreme => 0,
        };
        assert!(decided >= least, "{numbers:?}: {decided} of {count}");
    }
}

macro_rules! families {
    ($name:ident, $kind:ty) => {
        mod $name {
            use super::*;

            #[test]
            fn on_curves() {
                check::<$kind>(|numbers, random| {
                    let degree = one_of(random, &[1, 2, 3, 8]);
                    Case::of_curves(&numbers.curves::<$kind>(random, degree))
                });
            }

            #[test]
            fn of_bodies() {
                check::<$kind>(|numbers, random| {
                    let lengths = one_of(random, &[[1, 0], [0, 1], [1, 1], [0, 0]]);
                    let chains = lengths.map(|length| numbers.chain(random, length));
                    Case::of_bodies(numbers.points::<$kind>(random), &chains[0], &chains[1])
                });
            }

            /// A common motion, before motions of parts. The degrees of some are too large for the filters.
            #[test]
            fn of_chains() {
                check::<$kind>(|numbers, random| {
                    let common = numbers.motion(random);
                    let lengths = one_of(random, &[[1, 0], [1, 1], [2, 0], [2, 1]]);
                    let chains = lengths.map(|length| {
                        let own: Vec<_> = (0..length).map(|_| numbers.motion(random)).collect();
                        Chain::new([common.clone()].into_iter().chain(own)).expect("a short chain")
                    });
                    Case::of_bodies(numbers.points::<$kind>(random), &chains[0], &chains[1])
                });
            }
        }
    };
}

families!(vertex_face, VertexFace);
families!(edge_edge, EdgeEdge);
families!(vertex_edge, VertexEdge);
families!(vertex_vertex, VertexVertex);

/// The place of a point at many times, rounded, is in the box but for the rounding.
#[test]
fn paths_are_in_their_boxes() {
    let mut random = Rng::with_seed(4);
    let mut bounded = 0;
    for _ in 0..300 {
        let numbers = one_of(&mut random, &[Numbers::Lattice, Numbers::Uniform]);
        let chains = [1, 1].map(|length| numbers.chain(&mut random, length));
        let [first, second] = chains.clone();
        let pair = BodyPair::new(first, second);
        let point = numbers.point(&mut random);
        let [lower, upper] = pair.bounds(point);
        bounded += usize::from(lower[0].is_finite());
        for k in 0..=16 {
            let place = seen_from(
                &chains[1],
                f64::from(k) / 16.0,
                moved(&chains[0], f64::from(k) / 16.0, point),
            );
            for axis in 0..3 {
                let slack = 1e-6 * (1.0 + place[axis].abs());
                let range = lower[axis] - slack..=upper[axis] + slack;
                assert!(
                    place[axis].is_nan() || range.contains(&place[axis]),
                    "{pair:?} {point:?} {place:?}"
                );
            }
        }
    }
    assert!(bounded > 200, "{bounded}");
}

/// The rotation by a quaternion times the square of its length, and that square.
fn turned([a, b, c, d]: [f64; 4], [x, y, z]: Point) -> (Point, f64) {
    let [aa, bb, cc, dd] = [a * a, b * b, c * c, d * d];
    let place = [
        (aa + bb - cc - dd) * x + 2.0 * (b * c - a * d) * y + 2.0 * (b * d + a * c) * z,
        2.0 * (b * c + a * d) * x + (aa - bb + cc - dd) * y + 2.0 * (c * d - a * b) * z,
        2.0 * (b * d - a * c) * x + 2.0 * (c * d + a * b) * y + (aa - bb - cc + dd) * z,
    ];
    (place, aa + bb + cc + dd)
}

/// The quaternion and the place of a chain of one motion at a time.
fn at(chain: &Chain, t: f64) -> ([f64; 4], Point) {
    let motion = &chain.motions()[0];
    let [start, end] = motion.quaternions();
    let mut places = motion.places().to_vec();
    while places.len() > 1 {
        let pairs = places.windows(2);
        places = pairs
            .map(|pair| [0, 1, 2].map(|i: usize| (1.0 - t) * pair[0][i] + t * pair[1][i]))
            .collect();
    }
    (
        [0, 1, 2, 3].map(|i: usize| (1.0 - t) * start[i] + t * end[i]),
        places[0],
    )
}

fn moved(chain: &Chain, t: f64, point: Point) -> Point {
    let (rotation, origin) = at(chain, t);
    let (place, w) = turned(rotation, point);
    [0, 1, 2].map(|i: usize| origin[i] + place[i] / w)
}

fn seen_from(chain: &Chain, t: f64, place: Point) -> Point {
    let ([a, b, c, d], origin) = at(chain, t);
    let (point, w) = turned([a, -b, -c, -d], [0, 1, 2].map(|i: usize| place[i] - origin[i]));
    point.map(|x| x / w)
}
