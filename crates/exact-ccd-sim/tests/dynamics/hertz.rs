//! A rigid sphere that is pressed into an elastic block, against the theory of Hertz.

use exact_ccd_sim::{BodyKind, Integrator, Length, Script, Settings, Simulation, System, shapes};

const RADIUS: f64 = 0.3;
const DEPTH: f64 = 0.02;

/// The time steps of an indentation: their number, and the duration of each, in s.
#[derive(Clone, Copy, Debug)]
struct Steps {
    count: u32,
    duration: f64,
}

/// The force of a sphere in quasi-static steps, divided by Hertz's, 4/3 E / (1 − ν²) √R δ^(3/2). The
/// block is a quarter, with symmetry at x = 0 and z = 0, of `cells` cells along each axis; they are smallest
/// at the sphere.
fn force(cells: u8, steps: Steps) -> f64 {
    let square = |x: f64| x * x;
    let mut block =
        shapes::solid_box([cells; 3], [1.0; 3]).placed(|[x, y, z]| [square(x), -square(1.0 - y), square(z)]);
    let poisson = 0.3;
    if let BodyKind::Solid { material, .. } = &mut block.kind {
        material.poisson = poisson;
    }
    let at = |axis: usize, value: f64| {
        let vertices = 0..block.points.len() as u32;
        let points = &block.points;
        vertices.filter(move |&vertex| points[vertex as usize][axis] == value)
    };
    let mut scripts = vec![
        Script::Fixed.on(at(1, -1.0)),
        Script::Fixed.on(at(0, 0.0)).along([true, false, false]),
        Script::Fixed.on(at(2, 0.0)).along([false, false, true]),
    ];
    let distance = 1e-4;
    let sphere = shapes::sphere(3, RADIUS);
    let lowest = sphere.points.iter().map(|point| point[1]).fold(0.0, f64::min);
    let sphere = sphere.placed(|[x, y, z]| [x, y - lowest + 1.0001 * distance, z]);
    let bodies = [block, sphere];
    let down = Script::Moving {
        velocity: [0.0, -DEPTH / (f64::from(steps.count) * steps.duration), 0.0],
        until: None,
    };
    scripts.push(down.on(System::ranges(&bodies)[1].clone()));
    let system = System::new(&bodies, &scripts).unwrap();
    let settings = Settings {
        time_step: steps.duration,
        gravity: [0.0; 3],
        integrator: Integrator::QuasiStatic,
        contact_distance: Length::Absolute(distance),
        tolerance: Length::Absolute(1e-6 / steps.duration),
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings).unwrap();
    for _ in 0..steps.count {
        let statistics = simulation.step().unwrap();
        assert!(
            statistics.converged && statistics.script_lag == 0.0,
            "{statistics:?}"
        );
    }
    let contacts = simulation.contacts();
    let force: f64 = contacts.iter().map(|contact| contact.force[1].abs()).sum();
    let modulus = shapes::RUBBER.young / (1.0 - poisson * poisson);
    force / (modulus * RADIUS.sqrt() * DEPTH.powf(1.5) / 3.0)
}

/// Neither the duration nor the number of quasi-static steps matters.
#[test]
fn one_step_of_a_hertz_contact_is_that_of_several() {
    let several = force(
        6,
        Steps {
            count: 4,
            duration: 1.0,
        },
    );
    for duration in [0.01, 1.0, 100.0] {
        let one = force(6, Steps { count: 1, duration });
        assert!(
            (one / several - 1.0).abs() < 1e-4,
            "{duration} s: {one}, {several}"
        );
    }
}

/// The force approaches the theory from above: linear tetrahedra are too stiff.
#[test]
fn finer_blocks_approach_the_theory_of_hertz() {
    let steps = Steps {
        count: 4,
        duration: 1.0,
    };
    let forces = [6, 9].map(|cells| force(cells, steps));
    assert!(forces[0] > forces[1] && forces[1] > 1.0, "{forces:?}");
}
