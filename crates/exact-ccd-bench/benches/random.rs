//! The share of random queries that the filters leave to integers, and the time of a decision; and the step
//! sizes of meshes along huge directions, by the exact search and by bisection. The last queries are
//! published data.
//!
//! `cargo bench -p exact-ccd-bench --bench random [-- QUERIES]`, on one thread; 100,000 queries of each row
//! if no number is given. The seed is fixed. A direction of a search may be huge: all of a body then passes
//! through one point, at a time at which the cubic has a triple root but for roundings. Times of meshes are
//! medians of turns.

#![expect(clippy::print_stdout, reason = "this is its output")]

use std::collections::HashMap;
use std::fs;
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

use exact_ccd::{CONTACT, EdgeEdge, Exact, Kind, Point, Query, Stage, VertexFace};
use exact_ccd_bench::median;
use exact_ccd_data::DataFolder;
use exact_ccd_mesh::{
    Bvh, Candidates, Detector, FreeStepOptions, LineSearchError, Step, Tolerance, TriangleMesh, advance,
    bisect,
};
use fastrand::Rng;
use rayon::ThreadPoolBuilder;

const REPOSITORY: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

type Four = [Point; 4];
type Family = fn(&mut Rng) -> [Four; 2];

const FAMILIES: [(&str, Family); 4] = [
    ("points in a cube", in_cube),
    ("a shell thrown through its center", thrown),
    ("a body turned inside out", inverted),
    ("imploding spheres", imploding),
];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    ThreadPoolBuilder::new().num_threads(1).build_global()?;
    let argument = |argument: String| argument.parse().ok();
    let count = std::env::args().skip(1).find_map(argument).unwrap_or(100_000);
    println!("| queries | collide, % | fixed width, % | exact, % | mean ns | worst µs |");
    println!("|---|{}", "---:|".repeat(5));
    for (name, family) in FAMILIES {
        print_row::<VertexFace>(&format!("{name}, vf"), &generated(family, count));
        print_row::<EdgeEdge>(&format!("{name}, ee"), &generated(family, count));
    }
    for file in DataFolder::find(Path::new(REPOSITORY))?.implosion()? {
        let queries = array(&fs::read(&file)?);
        if file.ends_with("vf.npy") {
            print_row::<VertexFace>("a shell thrown through its center by a simulation, vf", &queries);
        } else {
            print_row::<EdgeEdge>("a shell thrown through its center by a simulation, ee", &queries);
        }
    }
    println!("\n| mesh | step | by bisection | exact ms | bisection ms |");
    println!("|---|{}", "---:|".repeat(4));
    for (name, body) in [
        ("a sphere of 162 vertices", icosphere(2)),
        ("the same, turned", turned(icosphere(2))),
        ("a cloth of 121 vertices", cloth(11)),
    ] {
        for k in [2.0, 3.3, 1000.3] {
            print_mesh(name, &body, k)?;
        }
    }
    Ok(())
}

/// Vertices and faces.
type Body = (Vec<Point>, Vec<[u32; 3]>);

/// The largest free step of a body that is scaled through the origin of its coordinates, x₁ = −k x₀.
fn print_mesh(name: &str, (points, faces): &Body, k: f64) -> Result<(), Box<dyn std::error::Error>> {
    const TURNS: usize = 3;
    let mesh = TriangleMesh::new(points.len(), faces.clone())?;
    let direction: Vec<Point> = points.iter().map(|x| x.map(|x| -k * x - x)).collect();
    let mut times = [(); 2].map(|()| Vec::new());
    let mut sizes = [0.0; 2];
    for _ in 0..TURNS {
        for (index, search) in [exact_step as Search, bisected_step].into_iter().enumerate() {
            let clock = Instant::now();
            sizes[index] = search(&mesh, points, &direction)?;
            times[index].push(1e3 * clock.elapsed().as_secs_f64());
        }
    }
    let [exact, bisection] = times.map(|times| median(&times));
    println!(
        "| {name}, k = {k} | {:.5} | {:.5} | {exact:.0} | {bisection:.0} |",
        sizes[0], sizes[1]
    );
    Ok(())
}

type Search = fn(&TriangleMesh, &[Point], &[Point]) -> Result<f64, LineSearchError>;

/// The size of the exact step along a direction.
fn exact_step(mesh: &TriangleMesh, start: &[Point], direction: &[Point]) -> Result<f64, LineSearchError> {
    let options = FreeStepOptions::default().with_keep(1.0);
    let taken = Detector::new(mesh.clone()).free_step_along(start, direction, &options)?;
    Ok(taken.size)
}

/// The size of a step along a direction by bisection, with the candidates of the full step.
fn bisected_step(mesh: &TriangleMesh, start: &[Point], direction: &[Point]) -> Result<f64, LineSearchError> {
    let full = advance(start, direction, 1.0);
    let candidates = Candidates::new(Step::new(mesh, start, &full)?, &Bvh);
    Ok(bisect(Tolerance::Absolute(1e-3), |size| {
        let end = advance(start, direction, size);
        Step::new(mesh, start, &end).is_ok_and(|step| !candidates.collides_by(step, &Exact))
    }))
}

/// An icosahedron whose edges are halved some times, on the unit sphere. It has many equal coordinates.
fn icosphere(levels: u32) -> Body {
    let golden = 0.5 * (1.0 + 5.0_f64.sqrt());
    let mut points = Vec::new();
    for axis in 0..3 {
        for (long, short) in [(golden, 1.0), (golden, -1.0), (-golden, 1.0), (-golden, -1.0)] {
            let mut point = [0.0; 3];
            (point[axis], point[(axis + 1) % 3]) = (short, long);
            points.push(unit(point));
        }
    }
    let are_near = |a: usize, b: usize| {
        let squares = [0, 1, 2].map(|axis: usize| (points[a][axis] - points[b][axis]).powi(2));
        squares.iter().sum::<f64>() < 1.2
    };
    let corners = (0..12).flat_map(|a| (a + 1..12).flat_map(move |b| (b + 1..12).map(move |c| [a, b, c])));
    let mut faces: Vec<[u32; 3]> = corners
        .filter(|&[a, b, c]| are_near(a, b) && are_near(b, c) && are_near(c, a))
        .map(|face| face.map(|vertex| vertex as u32))
        .collect();
    for _ in 0..levels {
        let mut middles = HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                let [a, b] = [a, b].map(|vertex| points[vertex as usize]);
                points.push(unit([0, 1, 2].map(|axis: usize| a[axis] + b[axis])));
                points.len() as u32 - 1
            })
        };
        let quarters = |[a, b, c]: [u32; 3]| {
            let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
            [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
        };
        faces = faces.into_iter().flat_map(quarters).collect();
    }
    (points, faces)
}

/// The same body, turned about two axes: equal coordinates differ then.
fn turned((points, faces): Body) -> Body {
    let (sine, cosine) = 0.3_f64.sin_cos();
    let turn = |[x, y, z]: Point| {
        let [x, y] = [cosine * x - sine * y, sine * x + cosine * y];
        [cosine * x - sine * z, y, sine * x + cosine * z]
    };
    (points.into_iter().map(turn).collect(), faces)
}

/// A wavy square of n × n vertices, which collapses.
fn cloth(n: u32) -> Body {
    let places = (0..n).flat_map(|i| (0..n).map(move |j| [i, j]));
    let points = places.map(|place| {
        let [x, y] = place.map(|k| 2.0 * f64::from(k) / f64::from(n - 1) - 1.0);
        [x, y, 0.5 + 0.2 * (3.0 * x).sin() * (2.0 * y).cos()]
    });
    let faces = (0..n - 1).flat_map(|i| {
        (0..n - 1).flat_map(move |j| {
            let [a, b, c, d] = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].map(|[i, j]| n * i + j);
            [[a, b, c], [a, c, d]]
        })
    });
    (points.collect(), faces.collect())
}

fn unit(x: Point) -> Point {
    let length = x.iter().map(|x| x * x).sum::<f64>().sqrt();
    x.map(|x| x / length)
}

/// Queries of a family.
fn generated(family: Family, count: usize) -> Vec<[Four; 2]> {
    let mut random = Rng::with_seed(1);
    std::iter::repeat_with(|| family(&mut random))
        .take(count)
        .collect()
}

/// Queries in an array of numpy, of the shape (n, 8, 3), after its header.
fn array(bytes: &[u8]) -> Vec<[Four; 2]> {
    let header = 10 + usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
    let numbers = bytes[header..]
        .as_chunks()
        .0
        .iter()
        .map(|&bytes| f64::from_le_bytes(bytes));
    let numbers: Vec<f64> = numbers.collect();
    let queries = numbers.as_chunks::<3>().0.as_chunks::<4>().0.as_chunks::<2>().0;
    queries.to_vec()
}

fn print_row<K: Kind<Points = Four>>(name: &str, queries: &[[Four; 2]]) {
    let (mut colliding, mut settled) = (0, [0; Stage::ALL.len()]);
    let (mut sum, mut worst) = (0.0, 0.0_f64);
    for &[start, end] in queries {
        let query = Query::<K>::new(start, end).expect("all coordinates are finite");
        let clock = Instant::now();
        let (collision, stage) = black_box(&query).decide(CONTACT);
        let seconds = clock.elapsed().as_secs_f64();
        sum += seconds;
        worst = worst.max(seconds);
        colliding += usize::from(collision.is_some());
        settled[stage as usize] += 1;
    }
    let count = queries.len() as f64;
    let share = |queries: usize| 100.0 * queries as f64 / count;
    println!(
        "| {name} | {:.2} | {:.3} | {:.3} | {:.0} | {:.0} |",
        share(colliding),
        share(settled[Stage::FixedWidth as usize]),
        share(settled[Stage::Exact as usize]),
        1e9 * sum / count,
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
    let center = point(random);
    [(); 4].map(|()| {
        let offset = point(random);
        let near = [0, 1, 2].map(|axis: usize| center[axis] + 0.1 * offset[axis]);
        unit(near)
    })
}

/// x₁ = −k x₀.
fn thrown(random: &mut Rng) -> [Four; 2] {
    let start = on_sphere(random);
    let k = 0.1 + 10.0 * random.f64();
    [start, start.map(|x| x.map(|x| -k * x))]
}

/// x₁ = 2 c − x₀, through a center c without a coordinate that is 0.
fn inverted(random: &mut Rng) -> [Four; 2] {
    let center = point(random);
    let start = on_sphere(random).map(|x| [0, 1, 2].map(|axis: usize| center[axis] + x[axis]));
    [
        start,
        start.map(|x| [0, 1, 2].map(|axis: usize| 2.0 * center[axis] - x[axis])),
    ]
}

/// x₁ = c − k (x₀ − c): primitives of two spheres of one center.
fn imploding(random: &mut Rng) -> [Four; 2] {
    let center = point(random);
    let k = 0.1 + 10.0 * random.f64();
    let mut start = on_sphere(random);
    for x in &mut start[2..] {
        *x = x.map(|x| 0.9 * x);
    }
    let at = |scale: f64| start.map(|x| [0, 1, 2].map(|axis: usize| center[axis] + scale * x[axis]));
    [at(1.0), at(-k)]
}
