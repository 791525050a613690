//! The answers to a batch within a separation are those to single queries.

use std::cell::RefCell;

use exact_ccd::batch::{self, Instructions, Trajectories, VertexOutOfRange};
use exact_ccd::separation::{Separation, Separations, Thickness};
use exact_ccd::{Collision, ContactTime, Impact, Kind, Point, Query, VertexEdge};
use proptest::prelude::*;

use crate::families::{cases, ordinary};
use crate::kinds::{FromFour, for_each_kind};
use crate::laws::{Bits, bits, time_bits};
use crate::primitives::Points;
use crate::runner::for_all;

/// All answers about a query that comes within its separation, to the last bit.
#[derive(Debug, PartialEq)]
struct Answers {
    index: usize,
    points: Points,
    first: Bits,
    intervals: Vec<[Bits; 2]>,
    impact: Impact,
}

impl Answers {
    fn of_query<K: Kind>(index: usize, query: &Query<K>, d: Separation) -> Option<Self> {
        Some(Self {
            index,
            points: *query.points(),
            first: time_bits(query.first_within(d)?),
            intervals: bits(&query.intervals_within(d)),
            impact: query.impact_within(d).unwrap(),
        })
    }

    fn of_collision<K: Kind>(index: usize, collision: &Collision<'_, K>, d: Separation) -> Self {
        assert_eq!(collision.separation(), d);
        assert_eq!(
            collision.contact_times().first(),
            Some(collision.first_contact_time())
        );
        assert_eq!(collision.time_of_impact(), collision.first_contact_time().lower());
        Self {
            index,
            points: *collision.query().points(),
            first: time_bits(collision.first_contact_time()),
            intervals: bits(&collision.intervals()),
            impact: collision.impact(),
        }
    }
}

/// Queries, and a thickness for each of their points.
fn queries() -> Vec<(Points, [f64; 4])> {
    let queries = RefCell::new(Vec::new());
    let thickness = prop_oneof![
        Just([0.0; 4]),
        prop::array::uniform4(prop::sample::select(vec![0.0, 0.125, 0.5, 1.0])),
        prop::array::uniform4(0.0..0.5),
    ];
    for_all(cases(2_000), (ordinary(), thickness), |query| {
        queries.borrow_mut().push(query);
    });
    queries.into_inner()
}

/// The indices of the points of all queries, in order.
fn vertices<K: Kind>(count: usize) -> Vec<K::Vertices> {
    let mut next = 0..;
    let mut vertices = vec![K::Vertices::default(); count];
    for vertex in vertices.iter_mut().flat_map(AsMut::as_mut) {
        *vertex = next.next().unwrap();
    }
    vertices
}

fn expected<K: FromFour>(
    queries: &[(Points, [f64; 4])],
    separation: impl Fn(usize) -> Separation,
) -> Vec<Answers> {
    let of_query = |(index, (points, _)): (usize, &(Points, _))| {
        Answers::of_query(index, &K::query(points), separation(index))
    };
    queries.iter().enumerate().filter_map(of_query).collect()
}

fn answers_as_single_queries<K: FromFour>() {
    let queries = queries();
    let points: Vec<[K::Points; 2]> = queries.iter().map(|(points, _)| K::points(points)).collect();
    let at = |time: usize| -> Vec<Point> {
        let now = points.iter().flat_map(|ends| ends[time].as_ref());
        now.copied().collect()
    };
    let vertices = vertices::<K>(queries.len());
    let each = vertices[0].as_ref().len();
    let values: Vec<f64> = queries
        .iter()
        .flat_map(|(_, thickness)| &thickness[..each])
        .copied()
        .collect();
    let thickness = Thickness::new(&values).unwrap();

    for instructions in Instructions::available() {
        let trajectories = Trajectories::new(&at(0), &at(1))
            .unwrap()
            .with_instructions(instructions);
        let within = |separations: Separations<'_>| {
            let separation = |index: usize| {
                let (a, b) = vertices[index].as_ref().split_at(K::FIRST);
                separations.between(a, b)
            };
            let expected = expected::<K>(&queries, separation);
            let mut found = Vec::new();
            trajectories
                .collisions_within::<K>(&vertices, separations, |index, collision| {
                    found.push(Answers::of_collision(index, &collision, separation(index)));
                })
                .unwrap();
            assert!(found == expected, "{instructions:?}, {separations:?}");
            expected
        };
        assert!((1..queries.len()).contains(&within((&thickness).into()).len()));
        for d in [0.0, 0.25, 1.0] {
            let d = Separation::new(d).unwrap();
            let expected = within(d.into());
            let mut found = Vec::new();
            let queries = batch::Queries::<K>::new(&points).with_instructions(instructions);
            queries
                .collisions_within(d, |index, collision| {
                    found.push(Answers::of_collision(index, &collision, d));
                })
                .unwrap();
            assert!(found == expected, "{instructions:?}, {d:?}");
        }
    }
}

/// Times at which a search may end: both ends of the step, beyond them, the least one above 0, and the
/// first times themselves, from below and from above.
fn ends(firsts: &[(usize, ContactTime)]) -> Vec<f64> {
    let mut ends = vec![f64::NAN, -1.0, -0.0, 0.0, f64::from_bits(1), 0.5, 1.0, 2.0];
    let some = firsts.iter().step_by(firsts.len().div_ceil(16));
    ends.extend(some.flat_map(|(_, first)| [first.lower().next_down(), first.lower(), first.upper()]));
    ends
}

fn answers_until_a_time<K: FromFour>() {
    let points: Vec<Points> = queries().into_iter().map(|(points, _)| points).collect();
    let vertices = vertices::<K>(points.len());
    let at = |time: usize| -> Vec<Point> {
        let now = points.iter().map(|points| K::points(points)[time]);
        now.flat_map(|points| points.as_ref().to_vec()).collect()
    };
    let trajectories = Trajectories::new(&at(0), &at(1)).unwrap();
    for d in [0.0, 0.25, 1.0] {
        let d = Separation::new(d).unwrap();
        let first = |points: &Points| K::query(points).first_within(d);
        let firsts = points.iter().map(first).enumerate();
        let firsts: Vec<_> = firsts
            .filter_map(|(index, first)| Some((index, first?)))
            .collect();
        for until in ends(&firsts) {
            let in_time = firsts.iter().filter(|(_, first)| first.is_at_most(until));
            let expected: Vec<(usize, Bits)> =
                in_time.map(|&(index, first)| (index, time_bits(first))).collect();
            let mut found = Vec::new();
            trajectories
                .collisions_until::<K>(&vertices, d.into(), until, |index, collision| {
                    found.push((index, time_bits(collision.first_contact_time())));
                })
                .unwrap();
            assert!(found == expected, "until {until:e} within {d:?}");
        }
    }
}

for_each_kind! {
    batches_answer_as_single_queries => answers_as_single_queries;
    batches_until_a_time_have_the_queries_until_then => answers_until_a_time;
}

#[test]
fn errors_name_the_vertex() {
    let trajectories = Trajectories::new(&[[0.0; 3]; 5], &[[0.0; 3]; 5]).unwrap();
    let nothing = |_, _: Collision<'_, VertexEdge>| unreachable!("nothing is found");
    let queries = [[0, 1, 2], [4, 0, 7]];
    let within =
        trajectories.collisions_within::<VertexEdge>(&queries, Separation::default().into(), nothing);
    let expected = VertexOutOfRange {
        query: 1,
        vertex: 7,
        vertex_count: 5,
    };
    assert_eq!(within, Err(expected));
}
