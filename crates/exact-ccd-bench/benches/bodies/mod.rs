//! Steps of two bodies: an icosphere of 5,120 faces and a torus of 9,216 faces.

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

/// Prints a row for each case; with `EXACT_CCD_BODIES`, writes meshes and motions to a file in this folder.
pub(super) fn print() {
    println!(
        "\n| sphere of 5,120 and torus of 9,216 faces | contact at | earliest contact, ms | decision, ms |"
    );
    println!("|---|{}", "---:|".repeat(3));
    let frames = |case: &Case| {
        // In the hole of the torus there is room for a smaller sphere.
        let radius = if case.name.contains("hole") { 0.55 } else { 1.0 };
        [sphere(4, radius), torus([96, 48])]
    };
    let mut lines = Vec::new();
    for case in &CASES {
        let frames = frames(case);
        let bodies = Bodies::new(frames.clone()).expect("meshes");
        let motion = |i: usize| -> Chain {
            let motion = RigidMotion::new(case.quaternions[i], &case.places[i]);
            motion.expect("a motion").into()
        };
        let motions = [motion(0), motion(1)];
        let earliest = || bodies.collision(&motions, CONTACT).expect("two motions");
        let time = earliest().map(|contact| contact.impact.time.lower());
        let milliseconds = |answer: &dyn Fn() -> bool| 1e3 * fastest(RUNS, || black_box(answer()));
        let [first, any] = [
            milliseconds(&|| earliest().is_some()),
            milliseconds(&|| bodies.collides(&motions, CONTACT).expect("two motions")),
        ];
        let at = time.map_or_else(|| "free".to_owned(), |time| time.to_string());
        println!("| that {} | {at} | {first:.2} | {any:.2} |", case.name);
        let meshes = frames
            .each_ref()
            .map(|frame| (&frame.positions, frame.mesh.faces()));
        lines.push(serde_json::json!({
            "name": case.name, "time": time, "milliseconds": first, "meshes": meshes,
            "quaternions": case.quaternions, "places": case.places,
        }));
    }
    if let Some(folder) = std::env::var_os("EXACT_CCD_BODIES") {
        let path = Path::new(&folder).join("bodies.json");
        fs::write(&path, serde_json::Value::from(lines).to_string())
            .expect("a folder that can be written to");
    }
    recording::print();
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
