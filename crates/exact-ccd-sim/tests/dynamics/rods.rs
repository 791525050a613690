//! Rods against the theory of beams, and the motion of rods.

use exact_ccd_mesh::Point;
use exact_ccd_sim::{Body, BodyKind, Length, RodProperties, Script, Settings, Simulation, System, shapes};

const EDGES: u16 = 40;
const LENGTH: f64 = 1.0;

/// A rod with one of its ends at the origin, clamped at these vertices, at rest under gravity.
fn at_rest(clamped: &[u32], gravity: Point) -> (RodProperties, Vec<Point>) {
    let rod = shapes::line(EDGES, LENGTH);
    let BodyKind::Rod { material, .. } = rod.kind else {
        panic!("a line is a rod")
    };
    let system = System::new(&[rod], &[Script::Fixed.on(clamped.to_vec())]).unwrap();
    // With steps that are long against all periods, implicit Euler ends at rest.
    let settings = Settings {
        time_step: 1e3,
        gravity,
        contact_distance: Length::Absolute(1e-4),
        tolerance: Length::Absolute(1e-13),
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings).unwrap();
    for _ in 0..4 {
        simulation.step().unwrap();
    }
    (material, simulation.state().positions.clone())
}

/// A cantilever of length L under the load q deflects by q L⁴ / (8 E I) at its end.
#[test]
fn a_cantilever_deflects_as_a_beam() {
    let gravity = 1e-3;
    let (material, points) = at_rest(&[0, 1], [0.0, -gravity, 0.0]);
    let load = material.density * material.area() * gravity;
    // The first edge is clamped. Its end bends, and stands for half of each edge beside it.
    let free = LENGTH * (1.0 - 0.5 / f64::from(EDGES));
    let expected = load * free.powi(4) / (8.0 * material.flexural_rigidity());
    let deflection = -points[usize::from(EDGES)][1];
    assert!(deflection > 1e-3 && deflection < 0.01 * LENGTH, "{deflection}");
    assert!(
        (deflection / expected - 1.0).abs() < 0.01,
        "{deflection}, expected {expected}"
    );
    // And in any direction across the rod.
    let (_, aside) = at_rest(&[0, 1], [0.0, 0.6 * gravity, 0.8 * gravity]);
    let [_, y, z] = aside[usize::from(EDGES)];
    assert!((y.hypot(z) / deflection - 1.0).abs() < 1e-6 && (y / z - 0.75).abs() < 1e-6);
}

/// A hanging rod of length L is stretched by ρ g L² / (2 E).
#[test]
fn a_hanging_rod_stretches_as_a_bar() {
    let (material, points) = at_rest(&[0], [9.81, 0.0, 0.0]);
    let expected = material.density * 9.81 * LENGTH * LENGTH / (2.0 * material.young);
    let stretch = points[usize::from(EDGES)][0] - LENGTH;
    assert!(
        (stretch / expected - 1.0).abs() < 1e-4,
        "{stretch}, expected {expected}"
    );
}

/// A rod has the mass of its volume; vertices of its ends have half the mass of the others.
#[test]
fn a_rod_has_the_mass_of_its_volume() {
    let rod = shapes::line(10, 2.0);
    let system = System::new(&[rod, shapes::particles([2, 1, 3], [1.0; 3])], &[]).unwrap();
    let (rod, particles) = system.masses().split_at(11);
    let volume = 2.0 * core::f64::consts::PI * 1e-4;
    assert!((rod.iter().sum::<f64>() / (1e3 * volume) - 1.0).abs() < 1e-12);
    assert!((rod[0] / rod[5] - 0.5).abs() < 1e-12);
    let ball = 1e3 * 4.0 / 3.0 * core::f64::consts::PI * 1e-6;
    assert!(particles.len() == 6 && particles.iter().all(|mass| (mass / ball - 1.0).abs() < 1e-12));
    // Rods and particles are on the surface.
    let frame = system.surface_frame(system.start()).unwrap();
    assert_eq!((frame.positions.len(), frame.mesh.loose_edges().len()), (17, 10));
    assert_eq!(frame.mesh.loose_vertices().count(), 6);
}

/// The frame of a scene with a solid has rods and particles, but no vertices in the interior of the solid.
#[test]
fn the_surface_has_no_interior_vertices() {
    let bodies = [
        shapes::solid_box([2, 2, 2], [0.5; 3]),
        shapes::line(2, 1.0).placed(|[x, _, z]| [x, 2.0, z]),
        shapes::particles([1, 1, 1], [0.0; 3]).placed(|_| [0.0, 3.0, 0.0]),
    ];
    let system = System::new(&bodies, &[]).unwrap();
    let frame = system.surface_frame(system.start()).unwrap();
    assert_eq!(frame.positions.len(), 26 + 3 + 1);
    assert_eq!(frame.positions[29], [0.0, 3.0, 0.0]);
    assert_eq!(frame.mesh.loose_edges(), [[26, 27], [27, 28]]);
    assert_eq!(frame.mesh.loose_vertices().collect::<Vec<_>>(), [29]);
    assert_eq!(system.surface_offsets(), vec![0.0; 30]);
}

/// Rods bend where exactly two edges meet: three rods of a star are hinged, and fall together when held
/// only at the center.
#[test]
fn more_than_two_edges_are_hinged() {
    let star = |rays: u32| {
        let angle = |ray: u32| core::f64::consts::TAU * f64::from(ray) / f64::from(rays);
        let end = |ray: u32| [angle(ray).cos(), 0.0, angle(ray).sin()];
        let mut points = vec![[0.0; 3]];
        points.extend((0..rays).map(end));
        let edges = (1..=rays).map(|ray| [0, ray]).collect();
        let material = shapes::ROPE;
        let body = Body::new(points, BodyKind::Rod { edges, material });
        let system = System::new(&[body], &[Script::Fixed.on([0])]).unwrap();
        let settings = Settings {
            contact_distance: Length::Absolute(1e-4),
            ..Settings::default()
        };
        let mut simulation = Simulation::new(system, settings).unwrap();
        (0..5).for_each(|_| assert!(simulation.step().unwrap().converged));
        simulation.state().positions[1][1]
    };
    // Both halves of a rod that is held at its middle fall nearly as freely as the rays of a star: it is
    // thin.
    let fall = 0.5 * 9.81 * 0.05 * 0.06;
    assert!((star(3) / -fall - 1.0).abs() < 0.02, "{}", star(3));
    assert!(star(2) > star(3));
}

/// A ray of a star, without stiffness at its hinge, falls onto the ray below it. It is the end of a rod and
/// the edge before the last. They keep apart, and no offset, even one above their length, stops them
/// before.
#[test]
fn the_end_of_a_rod_does_not_pass_through_the_edge_before() {
    for offset in [0.0, 2.0] {
        let points = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.5, 0.3, 0.0], [-1.0, 0.0, 0.0]];
        let (edges, material) = (vec![[0, 1], [0, 2], [0, 3]], shapes::ROPE);
        let body = Body::new(points, BodyKind::Rod { edges, material }).with_offset(offset);
        let system = System::new(&[body], &[Script::Fixed.on([0, 1, 3])]).unwrap();
        let settings = Settings {
            contact_distance: Length::Absolute(1e-3),
            time_step: 0.02,
            ..Settings::default()
        };
        let mut simulation = Simulation::new(system, settings).unwrap();
        let mut lowest = f64::INFINITY;
        for _ in 0..20 {
            assert!(simulation.step().unwrap().converged);
            lowest = lowest.min(simulation.state().positions[2][1]);
        }
        // In 0.4 s, nothing but the edge keeps it above.
        assert!(lowest > 0.0 && lowest < 2e-3, "{lowest}");
    }
}
