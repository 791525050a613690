//! The line search by vertex.

use std::sync::Arc;

use exact_ccd_methods::parity::RootParity;
use exact_ccd_sim::{
    Body, LineSearch, Settings, Simulation, SimulationError, Statistics, StepFilter, System, shapes,
};

/// A particle that hits a floor in the first time step, and one that falls past it.
fn particles() -> System {
    let falling = Body {
        velocity: [0.0, -2.0, 0.0],
        ..shapes::particles([2, 1, 1], [1.0, 0.0, 0.0]).placed(|[x, y, z]| [x + 0.3, y + 0.01, z + 0.3])
    };
    System::new(&[falling, shapes::floor([1, 1], [1.0, 1.0])], &[]).unwrap()
}

fn first_step(line_search: LineSearch) -> (Simulation, Statistics) {
    let settings = Settings {
        line_search,
        ..Settings::default()
    };
    let mut simulation = Simulation::new(particles(), settings).unwrap();
    let statistics = simulation.step().unwrap();
    assert!(statistics.converged && statistics.contacts > 0);
    (simulation, statistics)
}

/// The contact of one particle holds the other one back in the common line search, and not in that by
/// vertex. Both minimise the same potential: the particle that falls freely ends at the same place.
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
    for simulation in [common, vertex] {
        let fallen = 0.01 - simulation.state().positions[1][1];
        assert!((fallen - (0.02 + 9.81e-4)).abs() < 1e-6, "{fallen}");
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
        let simulation = Simulation::new(particles(), settings).unwrap();
        simulation.with_filter(filter.clone()).err()
    };
    let name = "parity".to_owned();
    assert_eq!(simulation(LineSearch::Common), None);
    assert_eq!(
        simulation(LineSearch::Vertex),
        Some(SimulationError::ByVertex { name })
    );
}
