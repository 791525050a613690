//! Affine bodies: conservation laws, theory, contact, reproducibility.

use exact_ccd_mesh::Audit;
use exact_ccd_sim::{
    AffineProperties, Body, BodyError, BodyKind, Friction, Integrator, Length, Script, Settings, Simulation,
    SimulationError, State, System, SystemError, shapes,
};
use nalgebra::{Matrix3, Vector3};

use crate::measure::{angular_momentum, center, momentum};

const MATERIAL: AffineProperties = AffineProperties {
    density: 1000.0,
    stiffness: 1e8,
};

/// An affine body with the surface of a box.
pub(crate) fn affine_box(size: [f64; 3]) -> Body {
    let faces = System::new(&[shapes::solid_box([1; 3], size)], &[]).unwrap();
    let kind = BodyKind::Affine {
        faces: faces.surface().faces().to_vec(),
        material: MATERIAL,
    };
    Body::new(faces.start().to_vec(), kind)
}

/// Settings without gravity that stop Newton's method far below its default.
fn precise(integrator: Integrator) -> Settings {
    Settings {
        gravity: [0.0; 3],
        integrator,
        tolerance: Length::Absolute(1e-9),
        ..Settings::default()
    }
}

/// The nodes have the mass, the center and the moments of inertia of a box.
#[test]
fn the_nodes_have_the_inertia_of_the_body() {
    let [a, b, c] = [0.3, 0.5, 0.7];
    let body = affine_box([a, b, c]).placed(|[x, y, z]| [x + 2.0, y - 1.0, z + 5.0]);
    let system = System::new(&[body], &[]).unwrap();
    let mass = 1000.0 * a * b * c;
    let (mut sum, mut moment, mut second) = (0.0, Vector3::zeros(), Matrix3::zeros());
    let middle = Vector3::new(2.0 + a / 2.0, -1.0 + b / 2.0, 5.0 + c / 2.0);
    for (m, x) in system.masses().iter().zip(system.start()) {
        let x = Vector3::from(*x) - middle;
        sum += m;
        moment += x * *m;
        second += x * x.transpose() * *m;
    }
    let expected = Matrix3::from_diagonal(&(Vector3::new(a * a, b * b, c * c) * (mass / 12.0)));
    assert!((sum / mass - 1.0).abs() < 1e-13);
    assert!(moment.norm() < 1e-13 * mass);
    assert!((second - expected).norm() < 1e-12 * mass, "{second}");
    assert_eq!(system.masses().iter().filter(|&&mass| mass > 0.0).count(), 4);
}

/// A subdivided sphere has the moments of its polyhedron, for both orientations of its faces.
#[test]
fn both_orientations_are_the_same_body() {
    let BodyKind::Obstacle { faces } = shapes::sphere(1, 0.5).kind else {
        panic!("a sphere is an obstacle");
    };
    let body = |faces: Vec<[u32; 3]>| {
        let material = MATERIAL;
        Body::new(
            shapes::sphere(1, 0.5).points,
            BodyKind::Affine { faces, material },
        )
    };
    let flipped = faces.iter().map(|&[a, b, c]| [a, c, b]).collect();
    let [one, other] = [faces, flipped].map(|faces| System::new(&[body(faces)], &[]).unwrap());
    let pairs = one.masses().iter().zip(other.masses());
    assert!(pairs.into_iter().all(|(a, b)| (a - b).abs() <= 1e-14 * a));
    let pairs = one.start().iter().zip(other.start());
    assert!(
        pairs
            .into_iter()
            .all(|(a, b)| (0..3).all(|axis| (a[axis] - b[axis]).abs() < 1e-15))
    );
}

#[test]
fn momentum_is_conserved() {
    for integrator in [Integrator::ImplicitEuler, Integrator::Bdf2] {
        let mut left = affine_box([0.2, 0.3, 0.25]);
        left.velocity = [1.0, 0.1, 0.0];
        left.angular_velocity = [0.5, -1.0, 2.0];
        let right = affine_box([0.3; 3]).placed(|[x, y, z]| [x + 0.21, y + 0.05, z + 0.1]);
        let system = System::new(&[left, right], &[]).unwrap();
        let mut simulation = Simulation::new(system, precise(integrator)).unwrap();
        let before = momentum(&simulation);
        let mut contacts = 0;
        for _ in 0..20 {
            let statistics = simulation.step().unwrap();
            contacts += statistics.contacts;
        }
        let after = momentum(&simulation);
        assert!(contacts > 0);
        assert!(
            (after - before).norm() < 1e-10 * before.norm(),
            "{integrator:?}: {before} {after}"
        );
    }
}

/// Under implicit Euler, ω(t) = ω₀ / √(1 + 2 ω₀² h t) up to terms of higher order in h; BDF2 keeps ω.
#[test]
fn angular_momentum_decays_as_the_integrator_promises() {
    let spin = |integrator: Integrator| {
        let mut body = affine_box([0.3; 3]);
        body.angular_velocity = [0.0, 0.0, 5.0];
        let settings = Settings {
            time_step: 0.002,
            ..precise(integrator)
        };
        let mut simulation = Simulation::new(System::new(&[body], &[]).unwrap(), settings).unwrap();
        let before = angular_momentum(&simulation).norm();
        (0..250).for_each(|_| assert!(simulation.step().unwrap().converged));
        angular_momentum(&simulation).norm() / before
    };
    let expected = 1.0 / (1.0 + 2.0 * 25.0 * 0.002 * 0.5_f64).sqrt();
    let euler = spin(Integrator::ImplicitEuler);
    assert!(
        (euler / expected - 1.0).abs() < 2e-3,
        "{euler}, expected {expected}"
    );
    let bdf2 = spin(Integrator::Bdf2);
    assert!((bdf2 - 1.0).abs() < 1e-3, "{bdf2}");
}

/// Free fall of the center, and a shape that stays rigid within ρ ω² r² / κ.
#[test]
fn a_thrown_body_falls_and_stays_rigid() {
    let mut body = affine_box([0.4, 0.1, 0.2]);
    body.velocity = [1.0, 2.0, 0.0];
    body.angular_velocity = [3.0, 1.0, -2.0];
    let settings = Settings {
        gravity: [0.0, -9.81, 0.0],
        ..precise(Integrator::ImplicitEuler)
    };
    let mut simulation = Simulation::new(System::new(&[body], &[]).unwrap(), settings).unwrap();
    let start = center(&simulation);
    let edges = |simulation: &Simulation| {
        let points: Vec<Vector3<f64>> = simulation.state().positions.iter().map(|&x| x.into()).collect();
        let edges = simulation.system().surface().edges().iter();
        edges
            .map(|&[a, b]| (points[a as usize] - points[b as usize]).norm())
            .collect::<Vec<f64>>()
    };
    let lengths = edges(&simulation);
    for _ in 0..30 {
        simulation.step().unwrap();
    }
    // Implicit Euler: n steps fall by g h² n (n + 1) / 2.
    let expected = start + Vector3::new(0.3, 0.6 - 9.81 * 1e-4 * 15.0 * 31.0, 0.0);
    assert!((center(&simulation) - expected).norm() < 1e-9);
    for (now, before) in edges(&simulation).iter().zip(lengths) {
        assert!((now / before - 1.0).abs() < 1e-5);
    }
}

/// Two boxes with thickness fall onto each other and onto a floor. The whole path is free of contact, the
/// offsets are kept, and a resumed run has the same bits.
#[test]
fn a_pile_is_free_and_resumes() {
    let system = || {
        let lower = affine_box([0.3, 0.1, 0.3]).placed(|[x, y, z]| [x + 0.3, y + 0.03, z + 0.3]);
        let mut upper = affine_box([0.2; 3]).placed(|[x, y, z]| [x + 0.45, y + 0.18, z + 0.35]);
        upper.angular_velocity = [1.0, 0.0, 4.0];
        let bodies = [lower, upper, shapes::floor([1, 1], [1.0, 1.1])].map(|body| body.with_offset(0.004));
        System::new(&bodies, &[]).unwrap()
    };
    let settings = || Settings {
        integrator: Integrator::Bdf2,
        friction: Friction {
            coefficient: 0.4,
            ..Friction::default()
        },
        ..Settings::default()
    };
    let mut whole = Simulation::new(system(), settings()).unwrap();
    let mut audit = Audit::default();
    let mut saved = Vec::new();
    let (mut contacts, mut least) = (0, f64::INFINITY);
    for _ in 0..25 {
        saved.push(serde_json::to_string(whole.state()).unwrap());
        let mut frames = vec![whole.state().positions.clone()];
        let statistics = whole.step_along(&mut |x| frames.push(x.to_vec())).unwrap();
        contacts += statistics.contacts;
        least = statistics
            .minimal_distance
            .map_or(least, |distance| least.min(distance));
        for frame in frames {
            let frame = whole.system().surface_frame(&frame).unwrap();
            assert!(audit.examine(frame).unwrap().is_none());
        }
    }
    assert!(contacts > 0 && least > 0.0);
    let text = |simulation: &Simulation| serde_json::to_string(simulation.state()).unwrap();
    for step in [0, 11, 20] {
        let state: State = serde_json::from_str(&saved[step]).unwrap();
        let mut resumed = Simulation::resume(system(), settings(), state).unwrap();
        (step..25).for_each(|_| drop(resumed.step().unwrap()));
        assert_eq!(text(&whole), text(&resumed), "from step {step}");
    }
}

/// A scripted affine body moves as a whole and stays rigid.
#[test]
fn scripts_move_affine_bodies() {
    let turn = Script::Twisting {
        center: [0.0; 3],
        axis: [0.0, 1.0, 0.0],
        rate: 2.0,
        until: None,
    };
    let body = affine_box([0.3, 0.2, 0.4]);
    let system = System::new(&[body], &[turn.on(0..8)]).unwrap();
    let start = system.start().to_vec();
    let mut simulation = Simulation::new(system, Settings::default()).unwrap();
    (0..10).for_each(|_| drop(simulation.step().unwrap()));
    let (sin, cos) = 0.2_f64.sin_cos();
    for (now, before) in simulation.state().positions.iter().zip(start) {
        let [x, y, z] = before;
        let expected = Vector3::new(cos * x + sin * z, y, cos * z - sin * x);
        assert!((Vector3::from(*now) - expected).norm() < 1e-14);
    }
}

#[test]
fn errors_name_the_body() {
    let message = |body: Body, script: &[u32]| {
        let bodies = [affine_box([0.1; 3]).placed(|[x, y, z]| [x - 5.0, y, z]), body];
        let scripts = [Script::Fixed.on(script.iter().copied())];
        let error = System::new(&bodies, if script.is_empty() { &[] } else { &scripts }).unwrap_err();
        let SystemError::Body { body, source } = &error else {
            panic!("{error}")
        };
        assert_eq!(body.place(), 1);
        (source.clone(), error.to_string())
    };
    let mut open = affine_box([0.1; 3]);
    if let BodyKind::Affine { faces, .. } = &mut open.kind {
        faces.pop();
    }
    assert_eq!(message(open, &[]).0, BodyError::Open);
    let flat = affine_box([0.1; 3]).placed(|[x, y, _]| [x, y, 0.0]);
    assert!(matches!(message(flat, &[]).0, BodyError::NoVolume));
    let mut soft = affine_box([0.1; 3]);
    if let BodyKind::Affine { material, .. } = &mut soft.kind {
        material.stiffness = f64::NAN;
    }
    assert_eq!(
        message(soft, &[]).1,
        "body[1]: `stiffness` is NaN, expected a positive number"
    );
    let partly = message(affine_box([0.1; 3]).named("brick"), &[12, 13, 14]);
    assert_eq!(
        partly.1,
        "body `brick`: script 0 selects 3 of the 8 vertices, expected none or all: an affine body moves as a whole"
    );
    let settings = Settings {
        line_search: exact_ccd_sim::LineSearch::Vertex,
        ..Settings::default()
    };
    let system = System::new(&[affine_box([0.1; 3]).named("brick")], &[]).unwrap();
    let error = Simulation::new(system, settings).err().unwrap();
    assert!(matches!(&error, SimulationError::AffineByVertex { body } if body.name() == "brick"));
}
