//! Flat worlds with the coordinates that files from tools have: all 53 bits, rounded zeros, single precision.

use std::f64::consts::PI;

use exact_ccd::Point;

use super::flat::Scene;

/// All scenes, with cells and segments fewer by a factor.
pub fn general_scenes(size: usize) -> Vec<Scene> {
    const SLIDE: Point = [0.02, 0.01, 0.0];
    const FALL: Point = [0.0, 0.0, -0.02];
    let n = 50 / size;
    let sheets = |height| Sheets::new(n, 0.02, 0.96 * 0.02, [0.006, 0.008, height]);
    let about_vertical = |[x, y, z]: Point| {
        let (sin, cos) = 0.3_f64.sin_cos();
        [cos * x - sin * y, sin * x + cos * y, z]
    };
    let single = |x: Point| x.map(|coordinate| f64::from(coordinate as f32));
    let far = |x: Point| x.map(|coordinate| coordinate + 1000.0);
    let hexagonal = |[x, y, z]: Point| [x + 0.5 * y, 0.75_f64.sqrt() * y, z];
    let mut random = fastrand::Rng::with_seed(1);
    let mut shaken = |[x, y, z]: Point| {
        let mut shift = || 0.006 * (random.f64() - 0.5);
        [x + shift(), y + shift(), z]
    };
    let thirds = Sheets::new(n, 1.0 / 3.0, 0.1, [0.05, 1.0 / 30.0, 0.0]);
    vec![
        sheets(0.0).scene("cloth in the plane of a floor", SLIDE, |x| x),
        sheets(0.01).scene("cloth that lands on the floor", FALL, |x| x),
        sheets(0.0).scene("in the plane, turned about the vertical", SLIDE, about_vertical),
        sheets(0.0).scene("in the plane, 1,000 away", SLIDE, far),
        sheets(0.0).scene("in the plane, in single precision", SLIDE, single),
        sheets(0.0).scene("in the plane, equilateral triangles", SLIDE, hexagonal),
        sheets(0.0).scene("in the plane, irregular triangles", SLIDE, &mut shaken),
        sheets(0.01).scene("landing, irregular triangles", FALL, &mut shaken),
        thirds.scene(
            "in the plane, cells of 1/3 and 1/10",
            [0.1, 0.1 / 3.0, 0.0],
            |x| x,
        ),
        implosion(16 / size.min(2)),
    ]
}

/// A floor of square cells, and a smaller cloth above it or in its plane.
struct Sheets {
    /// The cells along each side.
    n: usize,
    floor: Vec<Point>,
    cloth: Vec<Point>,
}

impl Sheets {
    fn new(n: usize, of_floor: f64, of_cloth: f64, shift: Point) -> Self {
        let sheet = |spacing: f64, [x, y, z]: Point| -> Vec<Point> {
            let place = |i: usize| {
                let [column, row] = [i % (n + 1), i / (n + 1)].map(|i| i as f64 * spacing);
                [column + x, row + y, z]
            };
            (0..(n + 1) * (n + 1)).map(place).collect()
        };
        Self {
            n,
            floor: sheet(of_floor, [0.0; 3]),
            cloth: sheet(of_cloth, shift),
        }
    }

    /// The scene in which the cloth moves, all points mapped.
    fn scene(self, name: &str, by: Point, mut map: impl FnMut(Point) -> Point) -> Scene {
        let row = self.n as u32 + 1;
        let cells = (0..row * row).filter(|i| i % row < row - 1 && i / row < row - 1);
        let faces: Vec<_> = cells
            .flat_map(|i| [[i, i + 1, i + row + 1], [i, i + row + 1, i + row]])
            .collect();
        let of_cloth = faces.iter().map(|face| face.map(|i| row * row + i));
        let start: Vec<Point> = self.floor.iter().chain(&self.cloth).map(|&x| map(x)).collect();
        let origin = map([0.0; 3]);
        let turned = map(by);
        let by = [0, 1, 2].map(|axis: usize| turned[axis] - origin[axis]);
        let moved = start.iter().enumerate().map(|(i, &x)| {
            if i < self.floor.len() {
                x
            } else {
                [0, 1, 2].map(|axis: usize| x[axis] + by[axis])
            }
        });
        Scene {
            name: name.into(),
            ends: [start.clone(), moved.collect()],
            faces: faces.iter().copied().chain(of_cloth).collect(),
        }
    }
}

/// A sphere about the origin of some rings and segments, thrown through its centre. The sines of multiples
/// of π are rounded, so that many coordinates are a small fraction of their last digit beside zero.
fn implosion(n: usize) -> Scene {
    let point = |ring: usize, segment: usize| {
        // Without the poles.
        let parts = [
            (ring + 1) as f64 / (n + 2) as f64,
            2.0 * segment as f64 / n as f64,
        ];
        let [theta, phi] = parts.map(|part| part * PI);
        [theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos()]
    };
    let index = |ring: usize, segment: usize| (ring * n + segment % n) as u32;
    let start: Vec<Point> = (0..(n + 1) * n).map(|i| point(i / n, i % n)).collect();
    let cells = (0..n * n).map(|i| (i / n, i % n));
    let faces = cells.flat_map(|(ring, segment)| {
        let corners = [(0, 0), (0, 1), (1, 1), (1, 0)].map(|(i, j)| index(ring + i, segment + j));
        let [a, b, c, d] = corners;
        [[a, b, c], [a, c, d]]
    });
    let faces = faces.collect();
    // No two points pass through the centre at the same time, except for opposite ones.
    let end = start.iter().enumerate().map(|(i, x)| {
        let depth = 0.75 + 0.5 * ((i * 7919) % 1009) as f64 / 1009.0;
        x.map(|coordinate| -depth * coordinate)
    });
    Scene {
        name: "sphere thrown through its centre".into(),
        ends: [start.clone(), end.collect()],
        faces,
    }
}
