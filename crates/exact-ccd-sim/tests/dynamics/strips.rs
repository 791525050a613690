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
    let clamped: Vec<u32> = (0..points.len() as u32)
        .filter(|&v| points[v as usize][0] < 1.01 * cell)
        .collect();
    let end: Vec<usize> = (0..points.len())
        .filter(|&v| points[v][0] > SIZE[0] - 1e-9)
        .collect();
    let gravity = 1e-5;
    let body = Body::new(points, BodyKind::Shell { faces, material });
    let system = System::new(&[body], &[Script::Fixed.on(clamped)]).unwrap();
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

/// The points of a grid.
fn points() -> Vec<Point> {
    let [nx, nz] = CELLS;
    let at = |i: u32, n: u32, size: f64| size * f64::from(i) / f64::from(n);
    let row = |k: u32| (0..=nx).map(move |i| [at(i, nx, SIZE[0]), 0.0, at(k, nz, SIZE[1])]);
    (0..=nz).flat_map(row).collect()
}

/// The faces of a grid. The diagonal of a cell joins its first and its third corner if `is_first` is true for
/// the corners.
fn faces(mut is_first: impl FnMut([u32; 4]) -> bool) -> Vec<[u32; 3]> {
    let [nx, nz] = CELLS;
    let index = |i: u32, k: u32| i + (nx + 1) * k;
    let cells = (0..nz).flat_map(|k| (0..nx).map(move |i| (i, k)));
    let corners = cells.map(|(i, k)| [index(i, k), index(i + 1, k), index(i + 1, k + 1), index(i, k + 1)]);
    let cut = |[a, b, c, d]: [u32; 4]| {
        if is_first([a, b, c, d]) {
            [[a, c, b], [a, d, c]]
        } else {
            [[a, d, b], [b, d, c]]
        }
    };
    corners.flat_map(cut).collect()
}

/// The points of a grid, of which those inside are shifted at random, by less than a third of a cell.
fn shifted(random: &mut fastrand::Rng) -> Vec<Point> {
    let cell = SIZE[0] / f64::from(CELLS[0]);
    let mut points = points();
    for point in &mut points {
        let is_inside = |x: f64, lower: f64, size: f64| lower < x && x < size - 0.1 * cell;
        if is_inside(point[0], 1.5 * cell, SIZE[0]) && is_inside(point[2], 0.1 * cell, SIZE[1]) {
            point[0] += 0.6 * (random.f64() - 0.5) * cell;
            point[2] += 0.6 * (random.f64() - 0.5) * cell;
        }
    }
    points
}

/// The strip deflects as plate theory predicts, whatever the arrangement of its triangles.
#[test]
fn cantilever_strips_deflect_as_plates() {
    let mut random = fastrand::Rng::with_seed(4);
    let shifted = shifted(&mut random);
    let length = |a: u32, b: u32| {
        let [a, b] = [a, b].map(|vertex| nalgebra::Vector3::from(shifted[vertex as usize]));
        (b - a).norm()
    };
    let unstructured = faces(|[a, b, c, d]| length(a, c) < length(b, d));
    let is_even = |vertex: u32| (vertex % (CELLS[0] + 1) + vertex / (CELLS[0] + 1)).is_multiple_of(2);
    for (mesh, points, faces) in [
        ("alternating diagonals", points(), faces(|[a, ..]| is_even(a))),
        ("parallel diagonals", points(), faces(|_| true)),
        ("random diagonals", points(), faces(|_| random.bool())),
        (
            "unstructured, with the shorter diagonals",
            shifted.clone(),
            unstructured,
        ),
    ] {
        let found = relative_deflection(points, faces);
        assert!((found - 1.0).abs() < 0.03, "{mesh}: {found}");
    }
}
