//! Twist of rods against theory.

use exact_ccd_sim::{
    Body, BodyKind, Integrator, Length, RodProperties, Script, ScriptedVertices, Settings, Simulation,
    System, shapes,
};

const EDGES: u32 = 20;

/// The twist is uniform between the midpoints of the end edges.
const LENGTH: f64 = 1.0 - 1.0 / EDGES as f64;

/// A rod of 1 m along x with a shear modulus.
fn rod(shear: f64) -> (Body, RodProperties) {
    let mut rod = shapes::line(EDGES as u16, 1.0);
    let BodyKind::Rod { material, .. } = &mut rod.kind else {
        panic!("a line is a rod")
    };
    material.shear = Some(shear);
    let material = *material;
    (rod, material)
}

/// A rotation about the x axis.
fn twisting(rate: f64, until: f64) -> Script {
    Script::Twisting {
        center: [0.0; 3],
        axis: [1.0, 0.0, 0.0],
        rate,
        until: Some(until),
    }
}

fn settings(gravity: f64) -> Settings {
    Settings {
        time_step: 0.1,
        gravity: [0.0, -gravity, 0.0],
        contact_distance: Length::Absolute(1e-4),
        tolerance: Length::Absolute(1e-7),
        ..Settings::default()
    }
}

/// The sum of the twists at all vertices.
fn twist(simulation: &Simulation) -> f64 {
    simulation.state().twists.values().sum()
}

/// The torque G J φ / L is the derivative of the energy ½ G J φ² / L by the angle φ between the ends, over
/// three turns. A simulation that is resumed continues with the same bits.
#[test]
fn a_twisted_rod_has_the_energy_of_the_theory() {
    let (body, material) = rod(1e4);
    let scripts = [
        twisting(-0.5, 10.0).on([0, 1]),
        twisting(1.5, 10.0).on([EDGES - 1, EDGES]),
    ];
    let system = || System::new(std::slice::from_ref(&body), &scripts).unwrap();
    let mut simulation = Simulation::new(system(), settings(0.0)).unwrap();
    let rigidity = material.torsional_rigidity().unwrap();
    assert!((rigidity / (1e4 * core::f64::consts::PI * 1e-8 / 2.0) - 1.0).abs() < 1e-12);
    let mut middle = None;
    for step in 1..=110 {
        let statistics = simulation.step().unwrap();
        let angle = 0.2 * f64::from(step.min(100));
        let expected = 0.5 * rigidity * angle * angle / LENGTH;
        let elastic = statistics.energies.elastic;
        assert!(
            statistics.converged && (elastic / expected - 1.0).abs() < 1e-9,
            "{elastic} {expected}"
        );
        assert!((twist(&simulation) - angle).abs() < 1e-9);
        if step == 55 {
            middle = Some(simulation.state().clone());
        }
    }
    let mut resumed = Simulation::resume(system(), settings(0.0), middle.unwrap()).unwrap();
    (0..55).for_each(|_| drop(resumed.step().unwrap()));
    assert_eq!(resumed.state(), simulation.state());
}

/// The acceleration of gravity in the test of buckling, in m/s².
const GRAVITY: f64 = 1e-4;

/// The deflection after 12 s of a rod with clamped ends. One end turns by an angle in the first 3 s.
fn deflection(angle: f64) -> f64 {
    // E I = G J.
    let (body, _) = rod(5e5);
    let scripts = [
        Script::Fixed.on([0, 1]),
        twisting(angle / 3.0, 3.0).on([EDGES - 1, EDGES]),
    ];
    let system = System::new(&[body], &scripts).unwrap();
    let mut simulation = Simulation::new(system, settings(GRAVITY)).unwrap();
    for _ in 0..120 {
        assert!(simulation.step().unwrap().converged);
    }
    let positions = simulation.state().positions.iter();
    positions.map(|x| x[1].hypot(x[2])).fold(0.0, f64::max)
}

/// A straight rod with clamped ends buckles at the torque M with M L / (E I) = 8.9868, twice the first
/// solution of tan x = x (A. G. Greenhill, 1883).
#[test]
fn a_twisted_rod_buckles_at_the_critical_torque() {
    let critical = 8.9868;
    let [free, below, above] = [0.0, 0.95, 1.05].map(|part| deflection(part * critical));
    // By its weight alone, the rod deflects by ρ A g L⁴ / (384 E I).
    let (_, material) = rod(5e5);
    let weight = material.density * material.area() * GRAVITY;
    let expected = weight * LENGTH.powi(4) / (384.0 * material.flexural_rigidity());
    assert!((free / expected - 1.0).abs() < 0.01, "{free} {expected}");
    assert!(
        below < 20.0 * free && above > 100.0 * free,
        "{free} {below} {above}"
    );
}

/// A bent rod that turns as a whole about an axis which is none of its directions is not twisted: the turns
/// of its ends and the holonomy of its directions cancel.
#[test]
fn a_rod_that_turns_as_a_whole_is_not_twisted() {
    let (body, _) = rod(4e5);
    let arc = body.placed(|[x, _, _]| {
        let (sin, cos) = (2.5 * x).sin_cos();
        [0.4 * sin, 0.1 * x, 0.4 * (1.0 - cos)]
    });
    let turn = Script::Twisting {
        center: [0.1, 0.2, 0.3],
        axis: [1.0, 2.0, -0.5],
        rate: 1.0,
        until: None,
    };
    let scripts = [turn.on([0, 1, EDGES - 1, EDGES])];
    let settings = Settings {
        integrator: Integrator::QuasiStatic,
        ..settings(0.0)
    };
    let mut simulation = Simulation::new(System::new(&[arc], &scripts).unwrap(), settings).unwrap();
    for _ in 0..30 {
        let statistics = simulation.step().unwrap();
        assert!(statistics.converged);
        let angle = twist(&simulation);
        assert!(angle.abs() < 1e-6, "{angle}");
    }
}

/// A script that begins within a time step replaces another one: both turn the end.
#[test]
fn the_turn_of_a_script_that_is_replaced_counts() {
    let (body, _) = rod(1e4);
    let scripts = [
        twisting(0.0, 10.0).on([0, 1]),
        twisting(1.0, 10.0).on([EDGES - 1, EDGES]),
        twisting(2.0, 10.0).on([EDGES - 1, EDGES]).from(0.15),
    ];
    let system = System::new(&[body], &scripts).unwrap();
    let mut simulation = Simulation::new(system, settings(0.0)).unwrap();
    for _ in 0..5 {
        assert!(simulation.step().unwrap().converged);
    }
    let angle = twist(&simulation);
    assert!((angle - (0.15 + 2.0 * 0.35)).abs() < 1e-9, "{angle}");
}

/// A wall stops an end that goes round: the end turns no further, however late its script is.
#[test]
fn an_obstructed_end_turns_as_far_as_it_moves() {
    let (body, material) = rod(1e4);
    let round = Script::Twisting {
        center: [0.0, -0.2, 0.0],
        axis: [1.0, 0.0, 0.0],
        rate: 1.0,
        until: None,
    };
    let scripts = [twisting(0.0, 10.0).on([0, 1]), round.on([EDGES - 1, EDGES])];
    let wall = Body::new(
        vec![[0.9, -0.5, 0.02], [1.1, -0.5, 0.02], [1.0, 0.5, 0.02]],
        BodyKind::Obstacle {
            faces: vec![[0, 1, 2]],
        },
    );
    let settings = Settings {
        integrator: Integrator::QuasiStatic,
        ..settings(0.0)
    };
    let system = System::new(&[body, wall], &scripts).unwrap();
    let mut simulation = Simulation::new(system, settings).unwrap();
    let rigidity = material.torsional_rigidity().unwrap();
    let mut before = None;
    // After half a turn, the way to the other side of the wall is free.
    for step in 0..25 {
        let statistics = simulation.step().unwrap();
        let angle = twist(&simulation);
        assert!(angle.abs() < 0.11, "{angle}");
        let of_twist = 0.5 * rigidity * angle * angle / LENGTH;
        assert!(statistics.energies.elastic >= of_twist);
        if step < 10 {
            continue;
        }
        let elastic = statistics.energies.elastic;
        let last: f64 = *before.get_or_insert(elastic);
        assert!((elastic / last - 1.0).abs() < 1e-2, "{elastic} {last}");
    }
}

/// Frames of opposite directions are defined.
#[test]
fn a_half_turn_across_an_end_is_a_number() {
    let (body, _) = rod(1e4);
    let over = Script::Twisting {
        center: [0.975, 0.0, 0.0],
        axis: [0.0, 0.0, 1.0],
        rate: core::f64::consts::PI / 0.1,
        until: Some(0.1),
    };
    let scripts = [twisting(0.0, 10.0).on([0, 1]), over.on([EDGES - 1, EDGES])];
    let system = System::new(&[body], &scripts).unwrap();
    let mut simulation = Simulation::new(system, settings(0.0)).unwrap();
    for _ in 0..3 {
        let statistics = simulation.step().unwrap();
        assert!(statistics.energies.elastic.is_finite());
        assert!(twist(&simulation).is_finite());
    }
}

/// A rod with at most one held edge turns freely: its twist is 0 for every shape, and it moves with the bits
/// of a rod without a shear modulus.
#[test]
fn a_rod_with_one_held_edge_has_no_twist() {
    let (body, _) = rod(1e4);
    let mut without = body.clone();
    if let BodyKind::Rod { material, .. } = &mut without.kind {
        material.shear = None;
    }
    let turning = [twisting(2.0, 10.0).on([0, 1])];
    for scripts in [&[][..], &turning] {
        let [with, without] = [&body, &without].map(|body| {
            let system = System::new(std::slice::from_ref(body), scripts).unwrap();
            let mut simulation = Simulation::new(system, settings(9.81)).unwrap();
            for _ in 0..5 {
                assert!(simulation.step().unwrap().converged);
            }
            simulation.state().clone()
        });
        assert!(with.twists.is_empty());
        assert_eq!(with, without);
    }
}

/// An end that is released turns back at once. Held again, it starts without twist.
#[test]
fn a_released_end_loses_its_twist() {
    let (body, _) = rod(1e4);
    let end = [EDGES - 1, EDGES];
    let scripts = [
        Script::Fixed.on([0, 1]),
        twisting(2.0, 10.0).on(end).until(0.5),
        twisting(1.0, 10.0).on(end).from(1.0),
    ];
    let mut simulation = Simulation::new(System::new(&[body], &scripts).unwrap(), settings(0.0)).unwrap();
    for step in 1..=15 {
        let elastic = simulation.step().unwrap().energies.elastic;
        let expected = match step {
            0..=5 => 0.2 * f64::from(step),
            6..=10 => 0.0,
            _ => 0.1 * f64::from(step - 10),
        };
        assert!((twist(&simulation) - expected).abs() < 1e-9, "{step}");
        assert_eq!(simulation.state().twists.is_empty(), expected == 0.0);
        assert!(expected > 0.0 || elastic < 1e-20, "{elastic}");
    }
}

/// A held edge in the middle is a clamp: each half has a twist of its own, and beyond the last held edge
/// there is none. Where the middle begins to be held, the halves share the twist. They join where it is
/// released.
#[test]
fn a_held_edge_divides_the_twist() {
    let (body, material) = rod(1e4);
    let rigidity = material.torsional_rigidity().unwrap();
    let half = 0.5 * LENGTH;
    let turning = || twisting(-1.0, 10.0).on([0, 1]);
    let middle = || Script::Fixed.on([EDGES / 2 - 1, EDGES / 2, EDGES / 2 + 1]);
    let held = Script::Fixed.on([EDGES - 1, EDGES]);
    let energy = |angle: f64, length: f64| 0.5 * rigidity * angle * angle / length;
    // Both edges of the middle vertex are held, at a distance of one edge.
    let part = half - 0.5 / f64::from(EDGES);
    let run = |scripts: &[ScriptedVertices], expected: &dyn Fn(f64) -> f64| {
        let system = System::new(std::slice::from_ref(&body), scripts).unwrap();
        let mut simulation = Simulation::new(system, settings(0.0)).unwrap();
        for step in 1..=30 {
            let elastic = simulation.step().unwrap().energies.elastic;
            let (angle, expected) = (0.1 * f64::from(step), expected(0.1 * f64::from(step)));
            assert!(
                (elastic / expected - 1.0).abs() < 1e-9,
                "{step}: {elastic} {expected}"
            );
            assert!((twist(&simulation) - angle).abs() < 1e-9);
        }
    };
    run(&[turning(), middle()], &|angle| energy(angle, part));
    run(&[turning(), middle(), held.clone()], &|angle| energy(angle, part));
    // The middle is held from 1 s to 2 s.
    let shared = [turning(), held, middle().from(1.0).until(2.0)];
    run(&shared, &|angle| {
        let before = angle.min(1.0);
        let turned = if angle > 2.05 { 0.0 } else { angle - before };
        let rest = angle - turned;
        energy(rest * part / LENGTH + turned, part) + energy(rest, LENGTH) * (1.0 - part / LENGTH)
    });
}
