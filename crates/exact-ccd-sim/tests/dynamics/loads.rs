//! Loads, key frames, rotation at the start, damping and equilibria.

use exact_ccd_sim::{
    Body, BodyKind, Force, Integrator, KeyFrame, Length, Load, Script, Settings, Simulation, System,
    SystemError, shapes,
};
use nalgebra::Vector3;

use crate::measure::{angular_momentum, center, momentum};

/// Young's modulus of rubber, in Pa.
const YOUNG: f64 = 1e6;

/// A column of rubber without lateral contraction, 1 m high.
fn column() -> Body {
    let mut column = shapes::solid_box([1, 4, 1], [0.25, 1.0, 0.25]);
    if let BodyKind::Solid { material, .. } = &mut column.kind {
        material.poisson = 0.0;
    }
    column
}

fn on(body: &Body, force: Force, is_loaded: impl Fn([f64; 3]) -> bool) -> Load {
    let points = (0..).zip(&body.points);
    let vertices = points
        .filter(|(_, point)| is_loaded(**point))
        .map(|(vertex, _)| vertex)
        .collect();
    Load {
        vertices,
        force,
        from: 0.0,
        until: None,
    }
}

/// A quasi-static step ends in equilibrium, whatever its duration: a soft cantilever hangs as far after a
/// step of 1 ms as after one of 1000 s.
#[test]
fn quasi_static_steps_end_in_equilibrium() {
    let deflection = |time_step: f64| {
        let mut beam = shapes::solid_box([8, 1, 1], [1.0, 0.1, 0.1]);
        if let BodyKind::Solid { material, .. } = &mut beam.kind {
            material.young = 1e5;
        }
        let held = |&vertex: &u32| beam.points[vertex as usize][0] == 0.0;
        let held: Vec<u32> = (0..beam.points.len() as u32).filter(held).collect();
        let system = System::new(&[beam], &[Script::Fixed.on(held)]).unwrap();
        let settings = Settings {
            time_step,
            integrator: Integrator::QuasiStatic,
            gravity: [0.0, -0.1, 0.0],
            tolerance: Length::Absolute(1e-9 / time_step),
            ..Settings::default()
        };
        let mut simulation = Simulation::new(system, settings).unwrap();
        let start = center(&simulation).y;
        assert!(simulation.step().unwrap().converged);
        start - center(&simulation).y
    };
    let expected = deflection(1e3);
    assert!(expected > 1e-3, "{expected}");
    for time_step in [1e-3, 1.0] {
        let found = deflection(time_step);
        assert!(
            (found / expected - 1.0).abs() < 1e-4,
            "{time_step}: {found}, {expected}"
        );
    }
}

/// A cube that nothing holds falls in one quasi-static step until it rests on the floor.
#[test]
fn a_free_body_comes_to_rest_in_a_quasi_static_step() {
    let cube = shapes::solid_box([1, 1, 1], [0.3; 3]).placed(|[x, y, z]| [x + 0.3, y + 0.4, z + 0.3]);
    let system = System::new(&[cube, shapes::floor([1, 1], [1.0, 1.0])], &[]).unwrap();
    let settings = Settings {
        integrator: Integrator::QuasiStatic,
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings).unwrap();
    let statistics = simulation.step().unwrap();
    assert!(statistics.converged && statistics.contacts > 0, "{statistics:?}");
    assert!(center(&simulation).y < 0.16);
}

/// The center and the mean height of the top of a body that is held at the bottom, in equilibrium.
fn equilibrium(body: Body, load: Load) -> (Vector3<f64>, f64) {
    let bottom: Vec<u32> = (0..body.points.len() as u32)
        .filter(|&v| body.points[v as usize][1] == 0.0)
        .collect();
    let top: Vec<usize> = (0..body.points.len())
        .filter(|&v| body.points[v][1] == 1.0)
        .collect();
    let system = System::new(&[body], &[Script::Fixed.on(bottom)]).unwrap();
    let settings = Settings {
        time_step: 1e3,
        gravity: [0.0; 3],
        integrator: Integrator::QuasiStatic,
        tolerance: Length::Absolute(1e-13),
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system.with_loads(vec![load]).unwrap(), settings).unwrap();
    for _ in 0..3 {
        assert!(simulation.step().unwrap().converged);
    }
    let positions = &simulation.state().positions;
    let height = top.iter().map(|&vertex| positions[vertex][1]).sum::<f64>() / top.len() as f64;
    (center(&simulation), height)
}

/// A column under the traction t stretches by the strain t / E.
#[test]
fn a_column_stretches_under_traction() {
    let column = column();
    let load = on(&column, Force::Traction([0.0, 1e-4 * YOUNG, 0.0]), |[_, y, _]| {
        y == 1.0
    });
    let (_, height) = equilibrium(column, load);
    assert!(((height - 1.0) / 1e-4 - 1.0).abs() < 1e-3, "{height}");
}

/// A vertex that a load names twice is loaded once, as beside an affine body.
#[test]
fn a_vertex_counts_once() {
    let column = column();
    let once = on(&column, Force::Acceleration([0.0, 10.0, 0.0]), |[_, y, _]| {
        y == 1.0
    });
    let twice = Load {
        vertices: [once.vertices.clone(), once.vertices.clone()].concat(),
        ..once.clone()
    };
    assert_eq!(equilibrium(column.clone(), once), equilibrium(column, twice));
}

/// A pressure acts against the normal, and a cube under it in all directions keeps its momentum.
#[test]
fn pressure_compresses() {
    let column = column();
    let load = on(&column, Force::Pressure(1e-4 * YOUNG), |[_, y, _]| y == 1.0);
    let (_, height) = equilibrium(column.clone(), load);
    assert!(((1.0 - height) / 1e-4 - 1.0).abs() < 1e-3, "{height}");

    let load = on(&column, Force::Pressure(1e4), |_| true);
    let system = System::new(&[column], &[])
        .unwrap()
        .with_loads(vec![load])
        .unwrap();
    let settings = Settings {
        gravity: [0.0; 3],
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings).unwrap();
    let mut fastest = 0.0_f64;
    for _ in 0..5 {
        simulation.step().unwrap();
        let speeds = simulation
            .state()
            .velocities
            .iter()
            .map(|v| Vector3::from(*v).norm());
        fastest = speeds.fold(fastest, f64::max);
    }
    assert!(fastest > 0.01 && momentum(&simulation).norm() < 1e-9, "{fastest}");
}

/// An acceleration acts like gravity, from its beginning to its end.
#[test]
fn accelerations_begin_and_end() {
    let cube = shapes::solid_box([1, 1, 1], [0.5; 3]);
    let load = Load {
        from: 0.02,
        until: Some(0.05),
        ..on(&cube, Force::Acceleration([3.0, 0.0, 0.0]), |_| true)
    };
    let system = System::new(&[cube], &[])
        .unwrap()
        .with_loads(vec![load.clone()])
        .unwrap();
    let settings = Settings {
        gravity: [0.0; 3],
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system.clone(), settings).unwrap();
    let speeds: Vec<f64> = (0..7)
        .map(|_| {
            simulation.step().unwrap();
            simulation.state().velocities[0][0]
        })
        .collect();
    let expected = [0.0, 0.0, 0.03, 0.06, 0.09, 0.09, 0.09];
    assert!(
        speeds
            .iter()
            .zip(expected)
            .all(|(speed, expected)| (speed - expected).abs() < 1e-9),
        "{speeds:?}"
    );
    for (field, load) in [
        (
            "force",
            Load {
                force: Force::Pressure(f64::NAN),
                ..load.clone()
            },
        ),
        (
            "until",
            Load {
                until: Some(0.01),
                ..load.clone()
            },
        ),
        (
            "vertices",
            Load {
                vertices: vec![8],
                ..load
            },
        ),
    ] {
        let error = system.clone().with_loads(vec![load]).unwrap_err();
        assert!(
            matches!(&error, SystemError::Load { source, .. } if source.field == field),
            "{error}"
        );
    }
}

/// At the start, a body has the angular momentum of a rotation about its center of mass.
#[test]
fn a_body_starts_with_its_angular_velocity() {
    let cube = shapes::solid_box([2, 2, 2], [0.5; 3]).placed(|[x, y, z]| [x + 7.0, y, z - 3.0]);
    let body = Body {
        velocity: [1.0, 0.0, 0.0],
        angular_velocity: [0.0, 0.0, 4.0],
        ..cube
    };
    let system = System::new(&[body], &[]).unwrap();
    let mass = system.masses().iter().sum::<f64>();
    let settings = Settings {
        gravity: [0.0; 3],
        ..Settings::default()
    };
    let simulation = Simulation::new(system, settings).unwrap();
    assert!((momentum(&simulation) - Vector3::x() * mass).norm() < 1e-9 * mass);
    let at = center(&simulation);
    let masses = simulation
        .system()
        .masses()
        .iter()
        .zip(&simulation.state().positions);
    let inertia: f64 = masses
        .map(|(m, x)| m * (Vector3::from(*x) - at).xy().norm_squared())
        .sum();
    let spin = angular_momentum(&simulation) - at.cross(&momentum(&simulation));
    assert!((spin.z / (4.0 * inertia) - 1.0).abs() < 1e-9, "{spin}");
}

/// The velocity of a free body decays by 1 + damping · time step in each time step.
#[test]
fn damping_is_exponential() {
    let cube = Body {
        velocity: [0.0, 2.0, 0.0],
        ..shapes::solid_box([1, 1, 1], [0.5; 3])
    };
    let settings = Settings {
        gravity: [0.0; 3],
        damping: 3.0,
        ..Settings::default()
    };
    let mut simulation = Simulation::new(System::new(&[cube], &[]).unwrap(), settings).unwrap();
    for _ in 0..10 {
        simulation.step().unwrap();
    }
    let speed = simulation.state().velocities[0][1];
    assert!((speed / (2.0 * 1.03_f64.powi(-10)) - 1.0).abs() < 1e-9, "{speed}");
}

/// Key frames are interpolated, and held before the first and after the last.
#[test]
fn key_frames_are_interpolated() {
    let frame = |time, translate, degrees| KeyFrame {
        time,
        translate,
        degrees,
    };
    let script = Script::KeyFrames {
        frames: vec![
            frame(1.0, [0.0; 3], 0.0),
            frame(2.0, [0.0, 4.0, 0.0], 0.0),
            frame(4.0, [0.0, 4.0, 2.0], 90.0),
        ],
        center: [1.0, 0.0, 0.0],
        axis: [0.0, 2.0, 0.0],
    };
    script.check().unwrap();
    let at = |time| Vector3::from(script.position([2.0, 0.0, 0.0], 0.0, time));
    for (time, expected) in [
        (0.0, [2.0, 0.0, 0.0]),
        (1.25, [2.0, 1.0, 0.0]),
        (3.0, [1.0 + 0.5_f64.sqrt(), 4.0, 1.0 - 0.5_f64.sqrt()]),
        (9.0, [1.0, 4.0, 1.0]),
    ] {
        assert!(
            (at(time) - Vector3::from(expected)).norm() < 1e-12,
            "{time}: {}",
            at(time)
        );
    }
    let bad = Script::KeyFrames {
        frames: vec![frame(1.0, [0.0; 3], 0.0); 2],
        center: [0.0; 3],
        axis: [0.0, 1.0, 0.0],
    };
    assert_eq!(bad.check().unwrap_err().field, "key-frames.frames");
}
