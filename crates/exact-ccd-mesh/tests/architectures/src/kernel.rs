//! The answers of the kernel: to single queries, by the filters and by integers, and to batches with every
//! set of vector instructions of this processor.

use exact_ccd::batch::{Instructions, Queries};
use exact_ccd::predicates::{EdgeFace, orient3d};
use exact_ccd::{
    DistanceBounds, EdgeEdge, Gradient, Intervals, Kind, NotDifferentiable, Options, Point, Query,
    Separation, VertexEdge, VertexFace, VertexVertex,
};

use exact_ccd_testing::hard_cases::digest::Digest;
use exact_ccd_testing::hard_cases::hard::Hard;
use exact_ccd_testing::hard_cases::{Case, cases};

/// The number of queries of each family, for contact and within a distance.
const COUNT: usize = 4;

pub(crate) fn digest() -> u64 {
    let mut digest = Digest::default();
    add_kind::<VertexFace>(&mut digest);
    add_kind::<EdgeEdge>(&mut digest);
    add_kind::<VertexEdge>(&mut digest);
    add_kind::<VertexVertex>(&mut digest);
    digest.0
}

/// The digest of the stages that decide the queries: the filters compute the same bits.
pub(crate) fn stages() -> u64 {
    let mut digest = Digest::default();
    add_stages::<VertexFace>(&mut digest);
    add_stages::<EdgeEdge>(&mut digest);
    add_stages::<VertexEdge>(&mut digest);
    add_stages::<VertexVertex>(&mut digest);
    digest.0
}

fn add_stages<K: Hard>(digest: &mut Digest) {
    for Case { query, distance, .. } in cases::<K>(COUNT) {
        add_stage(digest, &query, distance);
    }
}

/// The stage that decides a query.
pub(crate) fn add_stage<K: Kind>(digest: &mut Digest, query: &Query<K>, d: Separation) {
    let (_, stage) = query.decide(d);
    format!("{stage:?}")
        .bytes()
        .for_each(|byte| digest.add(byte.into()));
}

fn add_kind<K: Hard>(digest: &mut Digest) {
    let cases: Vec<Case<K>> = cases(COUNT).collect();
    for (index, Case { query, distance, .. }) in cases.iter().enumerate() {
        add_answers(digest, query, *distance);
        if index % 4 == 0 {
            digest.add_exact_answers(query, *distance);
        }
        add_predicates(digest, query);
    }
    let queries: Vec<_> = cases.iter().map(|case| *case.query.points()).collect();
    for d in [0.0, 5e-324, 0.25] {
        let d = Separation::new(d).unwrap_or(Separation::ZERO);
        let batches: Vec<u64> = Instructions::available()
            .map(|instructions| of_batch::<K>(&queries, instructions, d))
            .collect();
        // All sets of instructions have the same answers, so that one of them counts.
        let same = batches.iter().all(|batch| *batch == batches[0]);
        digest.add(if same { batches[0] } else { u64::MAX });
    }
}

/// All answers to a query.
pub(crate) fn add_answers<K: Kind>(digest: &mut Digest, query: &Query<K>, d: Separation) {
    let (collision, _) = query.decide(d);
    digest.add(collision.is_some().into());
    if let Some(collision) = collision {
        digest.add_time(collision.time());
        add_intervals(digest, &collision.intervals());
        digest.add_impact(Some(collision.impact()));
        add_bounds(digest, collision.distance());
    }
    digest.add(query.collides(Options::within(d).until(0.5)).into());
    add_gradient(digest, query.time_gradient(d));
    add_gradient(digest, query.distance_gradient(0.375));
    if let Ok(bounds) = query.distance_at(0.375) {
        add_bounds(digest, bounds);
    }
    add_intervals(digest, &query.exactly().intervals(d));
}

fn add_bounds(digest: &mut Digest, bounds: DistanceBounds) {
    digest.add_number(bounds.lower);
    digest.add_number(bounds.upper);
}

fn add_intervals(digest: &mut Digest, intervals: &Intervals) {
    digest.add(intervals.len() as u64);
    for interval in intervals.iter() {
        digest.add_time(interval.start);
        digest.add_time(interval.end);
        digest.add(interval.is_moment.into());
    }
}

fn add_gradient<K: Kind>(digest: &mut Digest, gradient: Result<Gradient<K>, NotDifferentiable>) {
    match gradient {
        Ok(gradient) => (gradient.points.iter())
            .flat_map(|now| now.as_ref().as_flattened())
            .for_each(|&x| digest.add_number(x)),
        Err(reason) => format!("{reason:?}")
            .bytes()
            .for_each(|byte| digest.add(byte.into())),
    }
}

fn add_predicates<K: Hard>(digest: &mut Digest, query: &Query<K>) {
    let [start, end] = query.points().map(|now| now.as_ref().to_vec());
    let points: Vec<Point> = start.into_iter().chain(end).collect();
    let [a, b, c, d] = [0, 1, points.len() - 2, points.len() - 1].map(|index: usize| points[index]);
    let volume = orient3d([a, b, c, d]).map_or(2, |ordering| ordering as i64);
    digest.add(volume as u64);
    let meets = EdgeFace::new([a, b], [c, d, points[points.len() / 2]]).map(|query| query.intersects());
    digest.add(meets.map_or(2, u64::from));
}

fn of_batch<K: Kind>(points: &[[K::Points; 2]], instructions: Instructions, d: Separation) -> u64 {
    let mut digest = Digest::default();
    let batch = Queries::<K>::new(points).with_instructions(instructions);
    let done = batch.collisions(d, |index, collision| {
        digest.add(index as u64);
        digest.add_time(collision.time());
        digest.add_impact(Some(collision.impact()));
    });
    digest.add(done.is_ok().into());
    digest.0
}
