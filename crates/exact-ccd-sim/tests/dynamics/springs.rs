//! Springs: joints of affine bodies, stitches, and springs with a length.

use exact_ccd_sim::{
    Body, BodyKind, Checkpoint, Integrator, Length, Settings, Simulation, SimulationError, Spring, SpringEnd,
    SpringError, StepFilter, System, SystemError, shapes,
};
use nalgebra::Vector3;

use crate::affine::affine_box;
use crate::measure::center;

const GRAVITY: f64 = 9.81;

/// A ball joint at a place.
fn joint(bodies: [Option<usize>; 2], at: [f64; 3]) -> Spring {
    Spring {
        ends: bodies.map(|body| SpringEnd { body, at }),
        stiffness: 1e6,
        length: Some(0.0),
    }
}

/// The same affine body, with strains that are negligible here.
fn stiff(mut body: Body) -> Body {
    if let BodyKind::Affine { material, .. } = &mut body.kind {
        material.stiffness = 1e10;
    }
    body
}

/// A symmetric top on a ball joint, inclined by θ, that starts with its steady precession Ω: the solution
/// of I₁ Ω² cos θ − I₃ ω₃ Ω + m g r = 0, for the moments of inertia I₁ about an axis through the joint
/// across the top, and I₃ about its own axis, the component ω₃ of its angular velocity along that axis, and
/// the distance r of the joint from the center.
#[test]
fn a_spinning_top_precesses() {
    let (width, height, r, spin, tilt) = (0.2, 0.1, 0.15, 60.0, 0.5_f64);
    let mass = 1000.0 * width * width * height;
    let across = mass * ((width * width + height * height) / 12.0 + r * r);
    let along = mass * width * width / 6.0;
    let (linear, constant) = (along * spin, mass * GRAVITY * r);
    let quadratic = across * tilt.cos();
    let precession = (linear - (linear * linear - 4.0 * quadratic * constant).sqrt()) / (2.0 * quadratic);

    let axis = Vector3::new(tilt.sin(), tilt.cos(), 0.0);
    let middle = axis * r;
    // The axis y of the box turns to the axis of the top.
    let mut top = stiff(affine_box([width, height, width])).placed(|[x, y, z]| {
        let [x, y, z] = [x - width / 2.0, y - height / 2.0, z - width / 2.0];
        let (sin, cos) = tilt.sin_cos();
        (middle + Vector3::new(cos * x + sin * y, cos * y - sin * x, z)).into()
    });
    // Of the angular velocity Ω y + s a, the component along the axis a is Ω cos θ + s = ω₃.
    let angular = Vector3::y() * precession + axis * (spin - precession * tilt.cos());
    top.angular_velocity = angular.into();
    top.velocity = angular.cross(&middle).into();
    let system = System::new(&[top], &[]).unwrap();
    let system = system
        .with_springs(vec![joint([Some(0), None], [0.0; 3])])
        .unwrap();
    let settings = Settings {
        time_step: 5e-4,
        integrator: Integrator::Bdf2,
        tolerance: Length::Absolute(1e-6),
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings).unwrap();
    for _ in 0..500 {
        assert!(simulation.step().unwrap().converged);
    }
    let now = center(&simulation);
    let angle = (-now.z).atan2(now.x);
    let expected = precession * simulation.time();
    assert!(
        (angle / expected - 1.0).abs() < 0.01,
        "{angle}, expected {expected}"
    );
    let inclined = (now.y / now.norm()).acos();
    assert!((inclined - tilt).abs() < 0.01, "{inclined}");
    assert!((now.norm() - r).abs() < 1e-4);
}

/// Four boxes on ball joints, one below the other: each joint is open by the weight below it over k.
#[test]
fn joints_open_by_force_over_stiffness() {
    let boxes: Vec<Body> = (0..4)
        .map(|place| stiff(affine_box([0.1; 3])).placed(|[x, y, z]| [x, y - 0.15 * f64::from(place), z]))
        .collect();
    let at = |place: usize| [0.05, 0.125 - 0.15 * place as f64, 0.05];
    let springs = (0..4).map(|place| joint([Some(place), place.checked_sub(1)], at(place)));
    let system = System::new(&boxes, &[]).unwrap();
    let start = system.start().to_vec();
    let ranges = System::ranges(&boxes);
    let system = system.with_springs(springs.collect()).unwrap();
    let settings = Settings {
        integrator: Integrator::QuasiStatic,
        tolerance: Length::Absolute(1e-7),
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings).unwrap();
    assert!(simulation.step().unwrap().converged);
    let fall = |body: usize| {
        let vertex = ranges[body].start as usize;
        start[vertex][1] - simulation.state().positions[vertex][1]
    };
    let mut expected = 0.0;
    for body in 0..4 {
        expected += (4 - body) as f64 * GRAVITY * 1e-6;
        assert!(
            (fall(body) / expected - 1.0).abs() < 0.01,
            "{} {expected}",
            fall(body)
        );
    }
}

/// The lowest position of a particle after its fall on a spring of the angular frequency 20/s, and its
/// speed then, with damping in proportion to the stiffness. The particle turns after half a period.
fn fall_on_a_spring(stiffness_damping: f64) -> [f64; 2] {
    let bead = shapes::particles([1, 1, 1], [0.0; 3]);
    let system = System::new(&[bead], &[]).unwrap();
    let mass = system.masses()[0];
    let stiffness = mass * 400.0;
    let end = |body, y| SpringEnd {
        body,
        at: [0.0, y, 0.0],
    };
    let spring = Spring {
        ends: [end(Some(0), 0.0), end(None, 0.5)],
        stiffness,
        length: None,
    };
    let system = system.with_springs(vec![spring]).unwrap();
    let settings = Settings {
        time_step: 1e-3,
        integrator: Integrator::Bdf2,
        stiffness_damping,
        contact_distance: Length::Absolute(1e-3),
        tolerance: Length::Absolute(1e-8),
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings).unwrap();
    let ratio = 0.5 * stiffness_damping * 20.0;
    let frequency = 20.0 * (1.0 - ratio * ratio).sqrt();
    let steps = (core::f64::consts::PI / frequency / 1e-3).round() as u32;
    (0..steps).for_each(|_| assert!(simulation.step().unwrap().converged));
    [
        simulation.state().positions[0][1],
        simulation.state().velocities[0][1],
    ]
}

/// A particle on a spring swings with √(k / m), about the length of the spring that its weight extends.
#[test]
fn a_particle_on_a_spring_swings() {
    let [lowest, speed] = fall_on_a_spring(0.0);
    let expected = -2.0 * GRAVITY / 400.0;
    assert!(
        (lowest / expected - 1.0).abs() < 0.01,
        "{lowest}, expected {expected}"
    );
    assert!(speed.abs() < 0.02 * GRAVITY / 20.0, "{speed}");
}

/// With the damping ratio ζ = β ω / 2, the particle rises above its rest by exp(−π ζ / √(1 − ζ²)) less each
/// time.
#[test]
fn stiffness_damping_has_the_ratio_of_theory() {
    for damping in [0.01, 0.03] {
        let ratio = 0.5 * damping * 20.0_f64;
        let overshoot = (-core::f64::consts::PI * ratio / (1.0 - ratio * ratio).sqrt()).exp();
        let expected = -(1.0 + overshoot) * GRAVITY / 400.0;
        let [lowest, _] = fall_on_a_spring(damping);
        assert!(
            (lowest / expected - 1.0).abs() < 0.005,
            "{damping}: {lowest}, expected {expected}"
        );
    }
}

#[test]
fn springs_are_checked_and_are_part_of_checkpoints() {
    let bodies = || {
        [
            affine_box([0.1; 3]),
            shapes::cloth([1, 1], [1.0, 1.0]).placed(|[x, _, z]| [x, 0.5, z]),
        ]
    };
    let with = |spring: Spring| System::new(&bodies(), &[]).unwrap().with_springs(vec![spring]);
    let good = joint([Some(0), Some(1)], [1.0, 0.5, 1.0]);
    let mut soft = good.clone();
    soft.stiffness = -1.0;
    assert_eq!(
        with(soft.clone()).unwrap_err().to_string(),
        "spring 0: `stiffness` is -1, expected a positive number"
    );
    let end = |spring: Spring| match with(spring).unwrap_err() {
        SystemError::Spring { spring: 0, source } => source,
        error => panic!("{error}"),
    };
    let at = [0.9, 0.5, 1.0];
    assert!(
        matches!(end(joint([Some(0), Some(1)], at)), SpringError::End { body, nearest, .. }
            if body.place() == 1 && nearest == [1.0, 0.5, 1.0])
    );
    assert!(matches!(end(joint([Some(2), None], [0.0; 3])), SpringError::Body { body } if body.place() == 2));
    let simulation = Simulation::new(with(good.clone()).unwrap(), Settings::default()).unwrap();
    let resume = |system: System| {
        let checkpoint: Checkpoint = simulation.checkpoint();
        checkpoint
            .resume(system, Settings::default(), StepFilter::default())
            .err()
    };
    assert!(resume(with(good.clone()).unwrap()).is_none());
    soft.stiffness = 2.0 * good.stiffness;
    assert!(matches!(
        resume(with(soft).unwrap()),
        Some(SimulationError::OtherSystem { what: "springs" })
    ));
}
