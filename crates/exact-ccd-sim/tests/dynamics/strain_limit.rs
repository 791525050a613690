//! The limit of the stretches of a shell.

use exact_ccd_mesh::Point;
use exact_ccd_sim::{
    Body, BodyKind, Integrator, Script, Settings, ShellProperties, Simulation, System, shapes,
};
use nalgebra::{Matrix2, Matrix3x2, Vector3};

const LIMIT: f64 = 0.05;

/// A cloth of 1 m × 1 m with a limit of its strain.
fn cloth(cells: [u16; 2], limit: Option<f64>) -> Body {
    let mut cloth = shapes::cloth(cells, [1.0; 2]);
    if let BodyKind::Shell { material, .. } = &mut cloth.kind {
        *material = ShellProperties {
            young: 1e4,
            poisson: 0.0,
            strain_limit: limit,
            ..*material
        };
    }
    cloth
}

/// The largest principal stretch of a face: the largest singular value of the map from its shape at rest.
fn stretch(face: [u32; 3], rest: &[Point], positions: &[Point]) -> f64 {
    let edges = |points: &[Point]| {
        let [a, b, c] = face.map(|vertex| Vector3::from(points[vertex as usize]));
        Matrix3x2::from_columns(&[b - a, c - a])
    };
    let (before, now) = (edges(rest), edges(positions));
    let first = before.column(0).normalize();
    let normal = before.column(0).cross(&before.column(1));
    let second = normal.cross(&first).normalize();
    let plane = Matrix2::from_fn(|row, column| [first, second][row].dot(&before.column(column)));
    (now * plane.try_inverse().unwrap()).singular_values().max()
}

/// The largest stretch of a cloth that hangs by two corners, over all increments.
fn hanging(limit: Option<f64>) -> f64 {
    let system = System::new(&[cloth([8, 8], limit)], &[Script::Fixed.on([0, 8])]).unwrap();
    let (faces, rest) = (system.surface().faces().to_vec(), system.start().to_vec());
    let settings = Settings {
        time_step: 0.02,
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings).unwrap();
    let mut most = 0.0_f64;
    for _ in 0..40 {
        let visit = &mut |positions: &[Point]| {
            let stretches = faces.iter().map(|face| stretch(*face, &rest, positions));
            most = stretches.fold(most, f64::max);
        };
        let statistics = simulation.step_along(visit).unwrap();
        assert!(statistics.converged, "{statistics:?}");
    }
    most
}

#[test]
fn a_hanging_cloth_stays_below_its_limit() {
    let (free, limited) = (hanging(None), hanging(Some(LIMIT)));
    // Without a limit, its weight stretches it three times as much.
    assert!(free > 1.0 + 3.0 * LIMIT, "{free}");
    assert!(1.0 + 0.8 * LIMIT < limited && limited < 1.0 + LIMIT, "{limited}");
}

/// A cloth is stretched along x by scripts. Its energy agrees with the theory, and it stops at the limit.
#[test]
fn a_stretched_cloth_has_the_energy_of_the_theory() {
    let body = cloth([4, 4], Some(LIMIT));
    let side = |x: f64| {
        let numbered = (0..).zip(&body.points);
        let at = numbered.filter(move |(_, point)| point[0] == x);
        at.map(|(vertex, _)| vertex).collect::<Vec<u32>>()
    };
    let pull = Script::Moving {
        velocity: [0.01, 0.0, 0.0],
        until: None,
    };
    let scripts = [Script::Fixed.on(side(0.0)), pull.on(side(1.0))];
    let system = System::new(std::slice::from_ref(&body), &scripts).unwrap();
    let settings = Settings {
        gravity: [0.0; 3],
        time_step: 0.5,
        integrator: Integrator::QuasiStatic,
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings).unwrap();
    for step in 1..=12 {
        let statistics = simulation.step().unwrap();
        let strain = simulation.state().positions[side(1.0)[0] as usize][0] - 1.0;
        assert!(strain < LIMIT, "{strain}");
        if step < 10 {
            assert!((strain - 0.005 * f64::from(step)).abs() < 1e-12, "{strain}");
        } else {
            assert!(strain > 0.99 * LIMIT && statistics.script_lag > 0.0, "{strain}");
        }
        // E h A (ε²/2 of the Green strain, and the barrier of the stretch), for ν = 0.
        let green = 0.5 * ((1.0 + strain).powi(2) - 1.0);
        let density = 0.5 * green * green - strain * strain * (1.0 - strain / LIMIT).ln();
        let expected = 1e4 * 1e-3 * density;
        let found = statistics.energies.elastic;
        assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
    }
}
