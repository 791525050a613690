//! The line search by vertex.

use std::sync::Arc;

use exact_ccd_methods::parity::RootParity;
use exact_ccd_sim::{
    Body, LineSearch, Settings, Simulation, SimulationError, Statistics, StepFilter, System, shapes,
};

/// A cube that hits a floor in the first time step, and one that falls freely.
fn cubes() -> System {
    let cube = |x: f64, y: f64| Body {
        velocity: [0.0, -2.0, 0.0],
        ..shapes::solid_box([2, 2, 2], [0.3; 3]).placed(|p| [p[0] + x, p[1] + y, p[2] + 0.3])
    };
    let bodies = [cube(0.3, 0.01), cube(1.3, 2.0), shapes::floor([1, 1], [1.0, 1.0])];
    System::new(&bodies, &[]).unwrap()
}

fn first_step(line_search: LineSearch) -> (Simulation, Statistics) {
    let settings = Settings {
        line_search,
        ..Settings::default()
    };
    let mut simulation = Simulation::new(cubes(), settings).unwrap();
    let statistics = simulation.step().unwrap();
    assert!(statistics.converged && statistics.contacts > 0);
    (simulation, statistics)
}

/// The contact of one cube holds the other one back in the common line search, and not in that by vertex. Both
/// minimise the same potential: the cube that falls freely ends at the same place.
#[test]
fn a_contact_holds_back_the_vertices_near_it() {
    let (common, before) = first_step(LineSearch::Common);
    let (vertex, after) = first_step(LineSearch::Vertex);
    // The first directions are the same, and the floor limits them.
    assert!(before.step_sizes[0] < 0.9, "{:?}", before.step_sizes);
    assert!(
        after.step_sizes[0] > before.step_sizes[0],
        "{:?} {:?}",
        after.step_sizes,
        before.step_sizes
    );
    // Each cube has 27 vertices.
    for at in 27..54 {
        let [a, b] = [&common, &vertex].map(|simulation| simulation.state().positions[at]);
        let fallen = common.system().start()[at][1] - a[1];
        assert!((fallen - (0.02 + 9.81e-4)).abs() < 1e-6, "{fallen}");
        assert!((a[1] - b[1]).abs() < 1e-6, "{a:?} {b:?}");
    }
}

/// A method without exact times cannot decide the steps of vertices.
#[test]
fn a_method_that_is_not_exact_is_an_error() {
    let filter = StepFilter::new("parity", Arc::new(RootParity::default()));
    let simulation = |line_search| {
        let settings = Settings {
            line_search,
            ..Settings::default()
        };
        let simulation = Simulation::new(cubes(), settings).unwrap();
        simulation.with_filter(filter.clone()).err()
    };
    let name = "parity".to_owned();
    assert_eq!(simulation(LineSearch::Common), None);
    assert_eq!(
        simulation(LineSearch::Vertex),
        Some(SimulationError::ByVertex { name })
    );
}
