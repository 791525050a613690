//! Scripts along some of the axes, and until a time.

use exact_ccd_sim::{
    BodyKind, Integrator, KeyFrame, Length, ParticleProperties, Script, Settings, Simulation, System, shapes,
};

use crate::measure::is_free_since;

const GRAVITY: f64 = -9.81;

/// Three particles that are a metre apart.
pub(crate) fn particles() -> exact_ccd_sim::Body {
    let mut body = shapes::particles([3, 1, 1], [2.0, 0.0, 0.0]);
    let (density, radius) = (1000.0, 0.01);
    let material = ParticleProperties { density, radius };
    body.kind = BodyKind::Particles { material };
    body
}

/// The height after a number of steps of implicit Euler in free fall.
pub(crate) fn fallen(steps: u32, time_step: f64) -> f64 {
    0.5 * GRAVITY * time_step * time_step * f64::from(steps * (steps + 1))
}

/// A coordinate that no script holds moves as of a free body; the last script of a coordinate counts.
#[test]
fn each_coordinate_has_its_own_script() {
    let along_x = Script::Moving {
        velocity: [2.0, 7.0, 7.0],
        until: None,
    };
    let frame = |time, degrees| KeyFrame {
        time,
        translate: [0.0, 0.0, 3.0 * time],
        degrees,
    };
    let along_z = Script::KeyFrames {
        frames: vec![frame(0.0, 0.0), frame(1.0, 0.0)],
        center: [0.0; 3],
        axis: [0.0, 1.0, 0.0],
    };
    let scripts = [
        Script::Fixed.on([0, 1]).along([false, true, true]),
        along_x.on([0, 1]).along([true, false, false]),
        along_z.on([1]).along([false, false, true]),
    ];
    let system = System::new(&[particles()], &scripts).unwrap();
    assert!(system.is_free(2) && !system.is_free(0) && !system.is_free(1));
    let scripts = &scripts[1..];
    let system = System::new(&[particles()], scripts).unwrap();
    assert!((0..3).all(|vertex| system.is_free(vertex)));
    let mut simulation = Simulation::new(system, Settings::default()).unwrap();
    for _ in 0..10 {
        let statistics = simulation.step().unwrap();
        assert!(
            statistics.converged && statistics.script_lag == 0.0,
            "{statistics:?}"
        );
    }
    let positions = &simulation.state().positions;
    let expected = [
        [0.2, fallen(10, 0.01), 0.0],
        [1.2, fallen(10, 0.01), 0.3],
        [2.0, fallen(10, 0.01), 0.0],
    ];
    for (found, expected) in positions.as_flattened().iter().zip(expected.as_flattened()) {
        assert!((found - expected).abs() < 1e-12, "{positions:?}");
    }
}

/// A released particle falls from the place and with the velocity of its script.
#[test]
fn released_vertices_are_free() {
    let script = Script::Moving {
        velocity: [2.0, 0.0, 0.0],
        until: None,
    };
    let floor = shapes::floor([1, 1], [1.0, 1.0]).placed(|[x, _, z]| [x, 9.0, z]);
    let scripts = [
        script.clone().on([0]).until(0.05),
        script.clone().on([1]),
        script.on(3..7).until(0.05),
    ];
    let system = System::new(&[particles(), floor], &scripts).unwrap();
    assert!(system.is_free(0) && !system.is_free(1) && !system.is_free(3));
    let mut simulation = Simulation::new(system, Settings::default()).unwrap();
    for _ in 0..15 {
        simulation.step().unwrap();
    }
    let positions = &simulation.state().positions;
    let expected = [
        (0, [0.3, fallen(10, 0.01), 0.0]),
        (1, [1.3, 0.0, 0.0]),
        (2, [2.0, fallen(15, 0.01), 0.0]),
        // An obstacle rests where it has been released.
        (3, [0.1, 9.0, 0.0]),
    ];
    for (vertex, expected) in expected {
        let found: [f64; 3] = positions[vertex];
        let error = (0..3).map(|axis| (found[axis] - expected[axis]).abs());
        assert!(error.fold(0.0, f64::max) < 1e-12, "{vertex}: {found:?}");
    }
}

/// A bar whose ends are pulled apart along x only contracts sideways by Poisson's ratio. If its ends are held
/// along all axes, they do not contract.
#[test]
fn a_bar_contracts_sideways_if_only_its_axis_is_held() {
    let (strain, poisson) = (1e-4, 0.3);
    let width = |axes: [bool; 3]| {
        let mut bar = shapes::solid_box([4, 2, 2], [1.0, 0.5, 0.5]);
        if let BodyKind::Solid { material, .. } = &mut bar.kind {
            material.poisson = poisson;
        }
        let at = |x: f64| -> Vec<u32> {
            let vertices = 0..bar.points.len() as u32;
            vertices.filter(|&v| bar.points[v as usize][0] == x).collect()
        };
        let pull = Script::Moving {
            velocity: [strain, 0.0, 0.0],
            until: Some(1.0),
        };
        let center = bar.points.iter().position(|x| *x == [0.0, 0.25, 0.25]).unwrap() as u32;
        let corners: Vec<usize> = at(1.0).into_iter().map(|v| v as usize).collect();
        let scripts = [
            Script::Fixed.on(at(0.0)).along([true, false, false]),
            // The rotation about x stays as at the start.
            Script::Fixed.on([center]),
            pull.on(at(1.0)).along(axes),
        ];
        let system = System::new(&[bar], &scripts).unwrap();
        let settings = Settings {
            gravity: [0.0; 3],
            time_step: 1.0,
            integrator: Integrator::QuasiStatic,
            tolerance: Length::Absolute(1e-10),
            ..Settings::default()
        };
        let mut simulation = Simulation::new(system, settings).unwrap();
        for _ in 0..3 {
            assert!(simulation.step().unwrap().converged);
        }
        let heights = corners
            .iter()
            .map(|&corner| simulation.state().positions[corner][1]);
        let (least, greatest) = heights.fold((f64::MAX, f64::MIN), |(a, b), y| (a.min(y), b.max(y)));
        greatest - least
    };
    let free = (width([true, false, false]) / 0.5 - 1.0) / strain;
    assert!((free + poisson).abs() < 1e-3 * poisson, "{free}");
    let held = (width([true; 3]) / 0.5 - 1.0) / strain;
    assert!(held.abs() < 1e-9, "{held}");
}

/// Where a ceiling obstructs the script along y, the corner of the cloth moves on along x as any free vertex,
/// and the lag is that along y.
#[test]
fn an_obstruction_acts_along_the_scripted_axes_only() {
    let ceiling = shapes::floor([2, 2], [3.0, 2.0]).placed(|[x, y, z]| [x - 0.5, y + 0.05, z - 0.5]);
    let mut cloth = shapes::cloth([4, 4], [1.0, 1.0]);
    cloth.velocity = [1.0, 0.0, 0.0];
    let up = Script::Moving {
        velocity: [0.0, 10.0, 0.0],
        until: None,
    };
    let scripts = [up.on(0..25).along([false, true, false])];
    let system = System::new(&[cloth, ceiling], &scripts).unwrap();
    let settings = Settings {
        contact_distance: Length::Absolute(0.005),
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings).unwrap();
    let before = simulation.state().positions.clone();
    let statistics = simulation.step().unwrap();
    assert!(is_free_since(&simulation, &before));
    assert!((0.05..0.06).contains(&statistics.script_lag), "{statistics:?}");
    for (now, before) in simulation.state().positions.iter().zip(before).take(25) {
        assert!((0.04..0.05).contains(&now[1]), "{now:?}");
        // But for the forces of the contact.
        assert!((now[0] - before[0] - 0.01).abs() < 1e-3, "{now:?}");
    }
}

#[test]
fn scripts_without_an_axis_or_released_before_the_start_are_errors() {
    let error = |scripted: exact_ccd_sim::ScriptedVertices| scripted.check().unwrap_err().field;
    assert_eq!(error(Script::Fixed.on([0]).along([false; 3])), "axes");
    assert_eq!(error(Script::Fixed.on([0]).until(-1.0)), "release");
    assert_eq!(error(Script::Fixed.on([0]).until(f64::NAN)), "release");
}
