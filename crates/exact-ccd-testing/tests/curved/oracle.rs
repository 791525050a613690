//! The answers to generated queries agree with the definition.

use exact_ccd::motion::Chain;
use exact_ccd::{AnyKind, EdgeEdge, Kind, Options, Separation, VertexEdge, VertexFace, VertexVertex};
use fastrand::Rng;

use crate::cases::Case;
use crate::numbers::{Numbers, one_of, tangent};
use crate::places;
use exact_ccd_testing::definition::{self, found, moment};

/// The number of queries, about, unless `EXACT_CCD_ORACLE_QUERIES` is another one.
const COUNT: usize = 2_000;

/// The number of queries for one of a family with a share of 1 and small integers: the sum over all families,
/// kinds and numbers is 38.
fn count_of_a_share() -> usize {
    let count = std::env::var("EXACT_CCD_ORACLE_QUERIES").ok();
    let count = count.map_or(COUNT, |count| count.parse().expect("a number of queries"));
    count.div_ceil(38)
}

/// Compares all answers; returns true if the primitives touch.
fn assert_defined<K: Kind>(case: &Case<K>, d: f64) -> bool {
    let (points, distance) = places::common(&case.places, K::FIRST, d);
    let truth = definition::intervals_of(K::KIND, &points, &distance);
    let query = &case.query;
    let d = Separation::new(d).expect("a distance");
    assert_eq!(found(&query.intervals(d)), truth, "{d}: {query:?}");
    let first = truth.first().map(|(ends, _)| ends[0]);
    assert_eq!(
        query.time_of_impact(d),
        first.map(|first| first.0),
        "{d}: {query:?}"
    );
    assert_eq!(query.collides(d), first.is_some(), "{d}: {query:?}");
    if let Some((lower, is_exact)) = first {
        let until = |t: f64| query.collides(Options::within(d).until(t));
        assert_eq!(until(lower), is_exact, "{d}: {query:?}");
        assert!(until(lower.next_up()), "{d}: {query:?}");
        let impact = query.impact(d).expect("the primitives touch");
        assert_eq!(moment(impact.time), (lower, is_exact), "{d}: {query:?}");
    }
    first.is_some()
}

/// Compares the queries of a family with numbers of all sorts, for contact and within a distance. Fewer are
/// compared where the definition is slow: with many digits, and within a distance.
fn check<K: Kind>(share: usize, case: impl Fn(Numbers, &mut Rng) -> Case<K>) {
    let mut random = Rng::with_seed(1);
    let (mut touching, mut free) = (0, 0);
    // Vertices are seldom in contact.
    let every = match K::KIND {
        AnyKind::VertexFace | AnyKind::EdgeEdge => 8,
        AnyKind::VertexEdge | AnyKind::VertexVertex => 2,
    };
    for numbers in Numbers::ALL {
        let part = match numbers {
            Numbers::Lattice | Numbers::Planar => 1,
            Numbers::Uniform => 4,
            Numbers::Extreme => 16,
        };
        for i in 0..count_of_a_share().div_ceil(share * part) {
            let case = case(numbers, &mut random);
            let is_apart = i % every == every - 1 && numbers != Numbers::Extreme;
            let d = if is_apart {
                one_of(&mut random, &[0.5, 1.0])
            } else {
                0.0
            };
            if assert_defined(&case, d) {
                touching += 1;
            } else {
                free += 1;
            }
        }
    }
    assert!(free > 0 && (touching > 0 || share > 1), "{touching} {free}");
}

/// All families of a kind.
macro_rules! families {
    ($name:ident, $kind:ty) => {
        mod $name {
            use super::*;

            #[test]
            fn on_curves() {
                check::<$kind>(1, |numbers, random| {
                    let degree = one_of(random, &[1, 2, 2, 3]);
                    Case::of_curves(&numbers.curves::<$kind>(random, degree))
                });
            }

            #[test]
            fn of_a_body_and_one_at_rest() {
                check::<$kind>(1, |numbers, random| {
                    let motion = numbers.chain(random, 1);
                    let chains = if random.bool() {
                        [motion, Chain::default()]
                    } else {
                        [Chain::default(), motion]
                    };
                    Case::of_bodies(numbers.points::<$kind>(random), &chains[0], &chains[1])
                });
            }

            #[test]
            fn of_two_bodies() {
                check::<$kind>(2, |numbers, random| {
                    let chains = [(); 2].map(|()| numbers.chain(random, 1));
                    Case::of_bodies(numbers.points::<$kind>(random), &chains[0], &chains[1])
                });
            }

            #[test]
            fn of_chains() {
                check::<$kind>(8, |numbers, random| {
                    let lengths = one_of(random, &[[2, 0], [0, 2], [2, 1]]);
                    let chains = lengths.map(|length| numbers.chain(random, length));
                    Case::of_bodies(numbers.points::<$kind>(random), &chains[0], &chains[1])
                });
            }

            #[test]
            fn that_turn_about_one_axis() {
                check::<$kind>(8, |numbers, random| {
                    let lengths = one_of(random, &[[1, 1], [2, 0]]);
                    let chains = lengths.map(|length| numbers.coaxial(random, length));
                    Case::of_bodies(numbers.points::<$kind>(random), &chains[0], &chains[1])
                });
            }

            #[test]
            fn whose_turns_undo_each_other() {
                check::<$kind>(4, |numbers, random| {
                    let chains = [numbers.undone(random), Chain::default()];
                    Case::of_bodies(numbers.points::<$kind>(random), &chains[0], &chains[1])
                });
            }

            #[test]
            fn that_touch_without_crossing() {
                check::<$kind>(1, |_, random| {
                    let (points, chain) = tangent::<$kind>(random);
                    Case::of_bodies(points, &chain, &Chain::default())
                });
            }

            /// A common motion of both bodies, before the motion of each.
            #[test]
            fn of_bodies_that_move_together() {
                check::<$kind>(8, |numbers, random| {
                    let common = numbers.motion(random);
                    let chain = |random: &mut Rng| {
                        let own = random.bool().then(|| numbers.motion(random));
                        Chain::new([common.clone()].into_iter().chain(own)).expect("a short chain")
                    };
                    let chains = [chain(random), chain(random)];
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
