//! Steps of two rigid bodies, an icosphere of 5,120 faces and a torus of 9,216 faces, and the audit of a
//! recording.
//!
//! `cargo bench -p exact-ccd-bench --bench bodies`, on all threads. Times are in milliseconds.

#![expect(clippy::print_stdout, reason = "this is its output")]

mod recording;

use std::f64::consts::TAU;
use std::fs;
use std::hint::black_box;
use std::path::Path;

use exact_ccd::motion::{Chain, RigidMotion};
use exact_ccd::{CONTACT, Point};
use exact_ccd_bench::fastest;
use exact_ccd_mesh::{Bodies, Frame, TriangleMesh};

const RUNS: usize = 5;

/// A motion of both bodies: the quaternions, the scalar first, and the places.
struct Case {
    name: &'static str,
    quaternions: [[[f64; 4]; 2]; 2],
    places: [[Point; 2]; 2],
}

/// The torus turns by about 73°, the sphere by 49° or more.
const CASES: [Case; 4] = [
    Case {
        name: "meet",
        quaternions: [
            [[1.0, 0.0, 0.0, 0.0], [0.91, 0.2, -0.3, 0.2]],
            [[1.0, 0.1, 0.0, 0.0], [0.8, 0.3, 0.5, 0.2]],
        ],
        places: [[[0.0; 3], [1.0, 0.2, -0.1]], [[4.0, 0.5, 0.2], [1.5, 0.2, 0.0]]],
    },
    Case {
        name: "pass by each other",
        quaternions: [
            [[1.0, 0.0, 0.0, 0.0], [0.91, 0.2, -0.3, 0.2]],
            [[1.0, 0.1, 0.0, 0.0], [0.8, 0.3, 0.5, 0.2]],
        ],
        places: [[[0.0; 3], [1.5, 0.2, -0.1]], [[3.0, 2.4, 0.2], [-0.5, 2.9, 0.0]]],
    },
    Case {
        name: "through the hole",
        quaternions: [
            [[1.0, 0.0, 0.0, 0.0], [0.7, 0.0, 0.0, 0.7]],
            [[1.0, 0.0, 0.0, 0.0], [0.8, 0.0, 0.0, 0.6]],
        ],
        places: [[[0.0, 0.0, -1.5], [0.0, 0.0, 1.5]], [[0.0; 3]; 2]],
    },
    Case {
        name: "meet in the hole",
        quaternions: [
            [[1.0, 0.0, 0.0, 0.0], [0.7, 0.0, 0.0, 0.7]],
            [[1.0, 0.0, 0.0, 0.0], [0.8, 0.1, 0.3, 0.6]],
        ],
        places: [[[0.0, 0.0, -1.5], [0.0, 0.0, 1.5]], [[0.0; 3], [0.3, 0.0, 0.0]]],
    },
];

/// A case, prepared.
struct Prepared {
    frames: [Frame; 2],
    bodies: Bodies,
    motions: [Chain; 2],
}

impl Prepared {
    fn new(case: &Case) -> Self {
        // In the hole of the torus there is room for a smaller sphere.
        let radius = if case.name.contains("hole") { 0.55 } else { 1.0 };
        let frames = [sphere(4, radius), torus([96, 48])];
        let motion = |i: usize| -> Chain {
            let motion = RigidMotion::new(case.quaternions[i], &case.places[i]);
            motion.expect("a motion").into()
        };
        Self {
            bodies: Bodies::new(frames.clone()).expect("meshes"),
            frames,
            motions: [motion(0), motion(1)],
        }
    }

    /// The time of the earliest contact.
    fn earliest(&self) -> Option<f64> {
        let contact = self
            .bodies
            .collision(&self.motions, CONTACT)
            .expect("two motions");
        contact.map(|contact| contact.impact.time.lower())
    }

    fn any(&self) -> bool {
        self.bodies.collides(&self.motions, CONTACT).expect("two motions")
    }
}

/// Prints a row for each case; with `EXACT_CCD_BODIES`, [answers](answer) instead.
fn main() {
    let cases: Vec<_> = CASES.iter().map(Prepared::new).collect();
    if let Some(folder) = std::env::var_os("EXACT_CCD_BODIES") {
        answer(&cases, Path::new(&folder));
        return;
    }
    println!(
        "| sphere of 5,120 and torus of 9,216 faces | contact at | earliest contact, ms | decision, ms |"
    );
    println!("|---|{}", "---:|".repeat(3));
    for (case, prepared) in CASES.iter().zip(&cases) {
        let [first, any] = [
            1e3 * fastest(RUNS, || black_box(prepared.earliest())),
            1e3 * fastest(RUNS, || black_box(prepared.any())),
        ];
        let time = prepared.earliest();
        let at = time.map_or_else(|| "free".to_owned(), |time| time.to_string());
        println!("| that {} | {at} | {first:.2} | {any:.2} |", case.name);
    }
    recording::print();
}

/// Writes the cases to a file of this folder. Then, for each line of the standard input, which is the number
/// of a case, computes its earliest contact and prints the milliseconds that it took: so another program can
/// take turns with this one.
fn answer(cases: &[Prepared], folder: &Path) {
    let cases_of_file = CASES.iter().zip(cases).map(|(case, prepared)| {
        let meshes = prepared.frames.each_ref();
        let meshes = meshes.map(|frame| (&frame.positions, frame.mesh.faces()));
        serde_json::json!({
            "name": case.name, "time": prepared.earliest(), "meshes": meshes,
            "quaternions": case.quaternions, "places": case.places,
        })
    });
    let all: serde_json::Value = cases_of_file.collect();
    fs::write(folder.join("bodies.json"), all.to_string()).expect("a folder that can be written to");
    println!("ready");
    for line in std::io::stdin().lines() {
        let line = line.expect("a line of text");
        let case = &cases[line.parse::<usize>().expect("the number of a case")];
        println!("{}", 1e3 * fastest(1, || black_box(case.earliest())));
    }
}

/// A sphere: each face of an icosahedron, divided into four as often as `levels`.
fn sphere(levels: u32, radius: f64) -> Frame {
    let golden = 0.5 + 1.25_f64.sqrt();
    let (mut points, mut faces): (Vec<Point>, Vec<[u32; 3]>) = (Vec::new(), Vec::new());
    for [a, b] in [[1.0, golden], [-1.0, golden], [1.0, -golden], [-1.0, -golden]] {
        points.extend([[0.0, a, b], [a, b, 0.0], [b, 0.0, a]]);
    }
    for [i, j, k] in
        (0..12_u32).flat_map(|i| (i + 1..12).flat_map(move |j| (j + 1..12).map(move |k| [i, j, k])))
    {
        let near = |a: u32, b: u32| distance(points[a as usize], points[b as usize]) < 2.1;
        if near(i, j) && near(j, k) && near(i, k) {
            faces.push([i, j, k]);
        }
    }
    for _ in 0..levels {
        let mesh = TriangleMesh::new(points.len(), faces.clone()).expect("a mesh");
        let first = points.len() as u32;
        let middle = |a: u32, b: u32| first + mesh.edge(a, b).expect("an edge of the mesh");
        let divided = faces.iter().flat_map(|&[a, b, c]| {
            let [x, y, z] = [middle(b, c), middle(c, a), middle(a, b)];
            [[a, z, y], [b, x, z], [c, y, x], [x, y, z]]
        });
        faces = divided.collect();
        for &[a, b] in mesh.edges() {
            points.push(
                [0, 1, 2].map(|axis: usize| 0.5 * (points[a as usize][axis] + points[b as usize][axis])),
            );
        }
        for point in &mut points {
            let length = distance(*point, [0.0; 3]);
            *point = point.map(|x| x / length);
        }
    }
    let points = points.iter().map(|point| point.map(|x| radius * x));
    Frame::new(points.collect(), faces).expect("a mesh")
}

fn distance(a: Point, b: Point) -> f64 {
    let squares = [0, 1, 2].map(|axis: usize| (a[axis] - b[axis]).powi(2));
    squares.iter().sum::<f64>().sqrt()
}

/// A torus with a radius of 1 and a tube of 0.4.
fn torus([m, n]: [u32; 2]) -> Frame {
    let point = |i: u32, j: u32| {
        let [a, b] = [(i, m), (j, n)].map(|(i, m)| TAU * f64::from(i) / f64::from(m));
        let radius = 1.0 + 0.4 * b.cos();
        [radius * a.cos(), radius * a.sin(), 0.4 * b.sin()]
    };
    let places = (0..m).flat_map(|i| (0..n).map(move |j| (i, j)));
    let faces = places.clone().flat_map(|(i, j)| {
        let at = |i: u32, j: u32| i % m * n + j % n;
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    Frame::new(places.map(|(i, j)| point(i, j)).collect(), faces.collect()).expect("a mesh")
}
