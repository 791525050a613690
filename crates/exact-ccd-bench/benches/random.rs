//! The share of random queries that the filters leave to integers, and the time of a decision.
//!
//! `cargo bench -p exact-ccd-bench --bench random [-- QUERIES]`, on one thread; 100,000 queries of each row
//! if no number is given. The seed is fixed. A direction of a search may be huge: all of a body then passes
//! through one point, at a time at which the cubic has a triple root but for roundings.

#![expect(clippy::print_stdout, reason = "this is its output")]

use std::hint::black_box;
use std::time::Instant;

use exact_ccd::{CONTACT, EdgeEdge, Kind, Point, Query, Stage, VertexFace};
use fastrand::Rng;

type Four = [Point; 4];
type Family = fn(&mut Rng) -> [Four; 2];

const FAMILIES: [(&str, Family); 4] = [
    ("points in a cube", in_cube),
    ("a shell thrown through its centre", thrown),
    ("a body turned inside out", inverted),
    ("imploding spheres", imploding),
];

fn main() {
    let argument = |argument: String| argument.parse().ok();
    let count = std::env::args().skip(1).find_map(argument).unwrap_or(100_000);
    println!("| queries | collide, % | fixed width, % | exact, % | mean ns | worst µs |");
    println!("|---|{}", "---:|".repeat(5));
    for (name, family) in FAMILIES {
        print_row::<VertexFace>(&format!("{name}, vf"), family, count);
        print_row::<EdgeEdge>(&format!("{name}, ee"), family, count);
    }
}

fn print_row<K: Kind<Points = Four>>(name: &str, family: Family, count: usize) {
    let mut random = Rng::with_seed(1);
    let (mut colliding, mut settled) = (0, [0; Stage::ALL.len()]);
    let (mut sum, mut worst) = (0.0, 0.0_f64);
    for _ in 0..count {
        let [start, end] = family(&mut random);
        let query = Query::<K>::new(start, end).expect("all coordinates are finite");
        let clock = Instant::now();
        let (collision, stage) = black_box(&query).decide(CONTACT);
        let seconds = clock.elapsed().as_secs_f64();
        sum += seconds;
        worst = worst.max(seconds);
        colliding += usize::from(collision.is_some());
        settled[stage as usize] += 1;
    }
    let share = |queries: usize| 100.0 * queries as f64 / count as f64;
    println!(
        "| {name} | {:.2} | {:.3} | {:.3} | {:.0} | {:.0} |",
        share(colliding),
        share(settled[Stage::FixedWidth as usize]),
        share(settled[Stage::Exact as usize]),
        1e9 * sum / count as f64,
        1e6 * worst
    );
}

/// A point of the cube from −1 to 1.
fn point(random: &mut Rng) -> Point {
    [(); 3].map(|()| 2.0 * random.f64() - 1.0)
}

fn in_cube(random: &mut Rng) -> [Four; 2] {
    [(); 2].map(|()| [(); 4].map(|()| point(random)))
}

/// Four points of the unit sphere near one point, as of primitives that are near each other.
fn on_sphere(random: &mut Rng) -> Four {
    let centre = point(random);
    [(); 4].map(|()| {
        let offset = point(random);
        let near = [0, 1, 2].map(|axis: usize| centre[axis] + 0.1 * offset[axis]);
        let length = near.iter().map(|x| x * x).sum::<f64>().sqrt();
        near.map(|x| x / length)
    })
}

/// x₁ = −k x₀.
fn thrown(random: &mut Rng) -> [Four; 2] {
    let start = on_sphere(random);
    let k = 0.1 + 10.0 * random.f64();
    [start, start.map(|x| x.map(|x| -k * x))]
}

/// x₁ = 2 c − x₀, through a centre c of which no coordinate is 0.
fn inverted(random: &mut Rng) -> [Four; 2] {
    let centre = point(random);
    let start = on_sphere(random).map(|x| [0, 1, 2].map(|axis: usize| centre[axis] + x[axis]));
    [
        start,
        start.map(|x| [0, 1, 2].map(|axis: usize| 2.0 * centre[axis] - x[axis])),
    ]
}

/// x₁ = c − k (x₀ − c): primitives of two spheres of one centre.
fn imploding(random: &mut Rng) -> [Four; 2] {
    let centre = point(random);
    let k = 0.1 + 10.0 * random.f64();
    let mut start = on_sphere(random);
    for x in &mut start[2..] {
        *x = x.map(|x| 0.9 * x);
    }
    let at = |scale: f64| start.map(|x| [0, 1, 2].map(|axis: usize| centre[axis] + scale * x[axis]));
    [at(1.0), at(-k)]
}
