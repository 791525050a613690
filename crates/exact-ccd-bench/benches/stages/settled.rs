//! Queries that a certain stage settles.

use exact_ccd::{CONTACT, Kind, Point, Query, Stage};
use fastrand::Rng;

/// The largest number of different queries.
const DIFFERENT: usize = 64;
/// The number of random queries from which the queries of a stage are selected.
const TRIES: usize = 20_000;

/// Queries whose contact is decided at `stage`.
pub(crate) fn decided<K: Kind<Points = [Point; 4]>>(stage: Stage) -> Vec<Query<K>> {
    found(|query: &Query<K>| query.decide(CONTACT).1 == stage)
}

/// Queries whose contact is decided at `stage`: colliding ones, if it decides any.
pub(crate) fn timed<K: Kind<Points = [Point; 4]>>(stage: Stage) -> Vec<Query<K>> {
    let colliding = found(|query: &Query<K>| {
        let (collision, decided) = query.decide(CONTACT);
        decided == stage && collision.is_some()
    });
    if colliding.is_empty() {
        decided(stage)
    } else {
        colliding
    }
}

/// Random queries that meet a condition. The seed is fixed, so that they are the same on every machine.
fn found<K: Kind<Points = [Point; 4]>>(is_wanted: impl Fn(&Query<K>) -> bool) -> Vec<Query<K>> {
    let mut random = Rng::with_seed(1);
    (0..TRIES)
        .map(|index| query(&mut random, FAMILIES[index % FAMILIES.len()]))
        .filter(is_wanted)
        .take(DIFFERENT)
        .collect()
}

type Points = [[Point; 4]; 2];

/// Families of random queries. Late stages settle few queries at arbitrary positions, but more at special
/// ones.
const FAMILIES: [fn(&mut Rng) -> Points; 4] = [anywhere, near, planar, integers];

fn query<K: Kind<Points = [Point; 4]>>(random: &mut Rng, family: fn(&mut Rng) -> Points) -> Query<K> {
    let [t0, t1] = family(random);
    Query::new(t0, t1).expect("all coordinates are finite")
}

fn points(mut coordinate: impl FnMut() -> f64) -> Points {
    [(); 2].map(|()| [(); 4].map(|()| [(); 3].map(|()| coordinate())))
}

/// A random number from −1 to 1.
fn centered(random: &mut Rng) -> f64 {
    2.0 * random.f64() - 1.0
}

fn anywhere(random: &mut Rng) -> Points {
    points(|| centered(random))
}

/// Displacements are small, as in a simulation.
fn near(random: &mut Rng) -> Points {
    let [t0, motion] = points(|| centered(random));
    let end = |i: usize, axis: usize| t0[i][axis] + 0.25 * motion[i][axis];
    let t1 = [0, 1, 2, 3].map(|i| [0, 1, 2].map(|axis| end(i, axis)));
    [t0, t1]
}

/// All points move in the plane z = 0.
fn planar(random: &mut Rng) -> Points {
    anywhere(random).map(|now| now.map(|[x, y, _]| [x, y, 0.0]))
}

/// Small integers, among which special positions are frequent.
fn integers(random: &mut Rng) -> Points {
    points(|| f64::from(random.i8(-2..=2)))
}
