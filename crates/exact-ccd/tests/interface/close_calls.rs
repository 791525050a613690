//! The filters for distances, for tiny distances, and for roots that are almost multiple, compared with the
//! integers.

use exact_ccd::{EdgeEdge, Impact, Kind, Point, Query, Separation, Stage, VertexFace};

/// A generator of pseudorandom numbers: Marsaglia's xorshift.
struct Random(u64);

impl Random {
    /// A number in [0, 1).
    fn number(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A point of the cube from −1 to 1, on a grid of this size if it is not 0.
    fn point(&mut self, grid: f64) -> Point {
        let coordinate = |x: f64| if grid > 0.0 { (x / grid).round() * grid } else { x };
        [(); 3].map(|()| coordinate(2.0 * self.number() - 1.0))
    }
}

type Four = [Point; 4];

/// Primitives that pass near each other, at random or on a coarse grid, where closest features change.
fn passing<K: Kind<Points = Four>>(random: &mut Random) -> Query<K> {
    let grid = if random.number() < 0.25 { 0.25 } else { 0.0 };
    let start = [(); 4].map(|()| random.point(grid));
    // Some move as a whole, so that edges keep their directions.
    let shift = random.point(grid);
    let end = if random.number() < 0.3 {
        let mut end = start;
        for point in end.iter_mut().take(K::FIRST) {
            *point = [0, 1, 2].map(|axis: usize| point[axis] + 2.0 * shift[axis]);
        }
        end
    } else {
        start.map(|_| random.point(grid))
    };
    Query::new(start, end).unwrap()
}

/// Points at random.
fn general<K: Kind<Points = Four>>(random: &mut Random) -> Query<K> {
    let mut points = || [(); 4].map(|()| random.point(0.0));
    Query::new(points(), points()).unwrap()
}

/// A mesh scaled through a point: all coordinates times −k, rounded.
fn imploding<K: Kind<Points = Four>>(random: &mut Random) -> Query<K> {
    let k = 0.1 + 3.0 * random.number();
    let center = random.point(0.0);
    let start = [(); 4].map(|()| {
        let offset = random.point(0.0);
        [0, 1, 2].map(|axis: usize| center[axis] + 0.03 * offset[axis])
    });
    Query::new(start, start.map(|point| point.map(|x| -k * x))).unwrap()
}

/// Compares all answers; the stage that decided.
fn compare<K: Kind<Points = Four>>(query: &Query<K>, d: Separation) -> Stage {
    let (collision, stage) = query.decide(d);
    assert_eq!(
        collision
            .map(|collision| collision.intervals())
            .unwrap_or_default(),
        query.exactly().intervals(d),
        "{d:?}: {query:?}"
    );
    assert_eq!(
        query.time_of_impact(d),
        query.exactly().time_of_impact(d),
        "{d:?}: {query:?}"
    );
    let impacts = [query.impact(d), query.exactly().impact(d)];
    match impacts {
        [Some(one), Some(other)] => assert_near(&one, &other, &format!("{d:?}: {query:?}")),
        _ => assert_eq!(impacts, [None; 2], "{d:?}: {query:?}"),
    }
    stage
}

/// Checks that two impacts differ by at most twice the documented error.
fn assert_near(one: &Impact, other: &Impact, context: &str) {
    const TOLERANCE: f64 = 2.0 / (1_u64 << 32) as f64;
    let are_near = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(x, y)| (x - y).abs() <= TOLERANCE);
    assert_eq!(one.time, other.time, "{context}");
    assert!(
        are_near(&one.parameters, &other.parameters),
        "{one:?} {other:?} {context}"
    );
    match [one.normal, other.normal] {
        [Some(a), Some(b)] => assert!(are_near(&a, &b), "{one:?} {other:?} {context}"),
        normals => assert_eq!(normals, [None; 2], "{context}"),
    }
}

/// The share of the colliding queries that the filters do not decide.
fn undecided<K: Kind<Points = Four>>(
    count: usize,
    generate: fn(&mut Random) -> Query<K>,
    distance: fn(&mut Random) -> f64,
) -> f64 {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let (mut near, mut exact) = (0, 0);
    for _ in 0..count {
        let query = generate(&mut random);
        let d = Separation::new(distance(&mut random)).unwrap();
        let stage = compare(&query, d);
        if query.collides(d) {
            near += 1;
            exact += usize::from(stage == Stage::Exact);
        }
    }
    assert!(near > count / 50, "{near} of {count} collide");
    f64::from(u32::try_from(exact).unwrap()) / f64::from(u32::try_from(near).unwrap())
}

const COUNT: usize = if cfg!(debug_assertions) { 600 } else { 6_000 };

#[test]
fn within_a_distance() {
    let distance = |random: &mut Random| 0.5 * random.number() * random.number();
    undecided::<VertexFace>(COUNT, passing, distance);
    undecided::<EdgeEdge>(COUNT, passing, distance);
}

#[test]
fn within_a_small_distance() {
    let distance = |random: &mut Random| 2.0f64.powi(-(80.0 * random.number()) as i32);
    undecided::<VertexFace>(COUNT, passing, distance);
    undecided::<EdgeEdge>(COUNT, passing, distance);
}

#[test]
fn filters_decide_most_tiny_distances() {
    let distance = |random: &mut Random| 2.0f64.powi(-(100.0 + 974.0 * random.number()) as i32);
    assert!(undecided::<VertexFace>(COUNT / 2, general, distance) < 0.07);
    assert!(undecided::<EdgeEdge>(COUNT / 2, general, distance) < 0.07);
}

#[test]
fn filters_decide_most_implosions() {
    let contact = |_: &mut Random| 0.0;
    assert!(undecided::<VertexFace>(COUNT / 2, imploding, contact) < 0.05);
    assert!(undecided::<EdgeEdge>(COUNT / 2, imploding, contact) < 0.05);
}
