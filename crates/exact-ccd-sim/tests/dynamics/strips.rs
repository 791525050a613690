//! Cantilever strips against the theory of plates, on three meshes.

use exact_ccd_mesh::Point;
use exact_ccd_sim::{Body, BodyKind, Length, Script, Settings, Simulation, System, shapes};

const CELLS: [u32; 2] = [40, 8];
const SIZE: [f64; 2] = [1.0, 0.2];

/// The deflection of the end of a strip of faces over these points, relative to that of plate theory. The
/// first two columns of vertices are clamped.
fn relative_deflection(points: Vec<Point>, faces: Vec<[u32; 3]>) -> f64 {
    let mut material = shapes::CLOTH;
    material.poisson = 0.0;
    let cell = SIZE[0] / f64::from(CELLS[0]);
    let clamped = (0..points.len() as u32)
        .filter(|&v| points[v as usize][0] < 1.01 * cell)
        .collect();
    let end: Vec<usize> = (0..points.len())
        .filter(|&v| points[v][0] > SIZE[0] - 1e-9)
        .collect();
    let gravity = 1e-5;
    let body = Body::new(points, BodyKind::Shell { faces, material });
    let system = System::new(&[body], &[(clamped, Script::Fixed)]).unwrap();
    let settings = Settings {
        time_step: 1e3,
        gravity: [0.0, -gravity, 0.0],
        contact_distance: Length::Absolute(1e-6),
        tolerance: Length::Absolute(1e-13),
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings).unwrap();
    for _ in 0..4 {
        simulation.step().unwrap();
    }
    let heights = end.iter().map(|&vertex| -simulation.state().positions[vertex][1]);
    let deflection = heights.sum::<f64>() / end.len() as f64;
    let rigidity = material.young * material.thickness.powi(3) / 12.0;
    // The hinges at the clamped edge stand for half of the cells beside them.
    let free = SIZE[0] - 0.5 * cell;
    deflection / (material.density * material.thickness * gravity * free.powi(4) / (8.0 * rigidity))
}

/// The strip as a grid, with a diagonal of each cell by its column and row.
fn grid(rises: impl Fn(u32, u32) -> bool) -> (Vec<Point>, Vec<[u32; 3]>) {
    let [nx, nz] = CELLS;
    let index = |i: u32, k: u32| i + (nx + 1) * k;
    let at = |i: u32, n: u32, size: f64| size * f64::from(i) / f64::from(n);
    let points = (0..=nz).flat_map(|k| (0..=nx).map(move |i| [at(i, nx, SIZE[0]), 0.0, at(k, nz, SIZE[1])]));
    let mut faces = Vec::new();
    for (k, i) in (0..nz).flat_map(|k| (0..nx).map(move |i| (k, i))) {
        let (a, b, c, d) = (index(i, k), index(i + 1, k), index(i + 1, k + 1), index(i, k + 1));
        faces.extend(if rises(i, k) {
            [[a, c, b], [a, d, c]]
        } else {
            [[a, d, b], [b, d, c]]
        });
    }
    (points.collect(), faces)
}

/// The strip deflects as plate theory predicts, whatever the arrangement of its triangles.
#[test]
fn cantilever_strips_deflect_as_plates() {
    let mut random = fastrand::Rng::with_seed(4);
    let diagonals: Vec<bool> = (0..CELLS[0] * CELLS[1]).map(|_| random.bool()).collect();
    let (mut points, faces) = grid(|i, k| diagonals[(i + CELLS[0] * k) as usize]);
    let irregular = relative_deflection(points.clone(), faces.clone());
    let cell = SIZE[0] / f64::from(CELLS[0]);
    for point in &mut points {
        let is_inside = |x: f64, lower: f64, size: f64| lower < x && x < size - 0.1 * cell;
        if is_inside(point[0], 1.5 * cell, SIZE[0]) && is_inside(point[2], 0.1 * cell, SIZE[1]) {
            point[0] += 0.3 * (random.f64() - 0.5) * cell;
            point[2] += 0.3 * (random.f64() - 0.5) * cell;
        }
    }
    let unstructured = relative_deflection(points, faces);
    let [alternating, parallel] = [grid(|i, k| (i + k) % 2 == 0), grid(|_, _| true)]
        .map(|(points, faces)| relative_deflection(points, faces));
    for (mesh, found) in [
        ("alternating diagonals", alternating),
        ("parallel diagonals", parallel),
        ("random diagonals", irregular),
        ("unstructured", unstructured),
    ] {
        assert!((found - 1.0).abs() < 0.03, "{mesh}: {found}");
    }
}
