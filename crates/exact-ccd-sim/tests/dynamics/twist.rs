//! A mat that is twisted by scripts.

use exact_ccd_mesh::Point;
use exact_ccd_sim::{Length, LineSearch, Script, Settings, Simulation, State, System, shapes};

fn system() -> System {
    let mat = shapes::cloth([10, 6], [1.0, 0.4]);
    let side = |end: f64| {
        let at_end = |&vertex: &u32| mat.points[vertex as usize][0] == end;
        (0..mat.points.len() as u32).filter(at_end).collect::<Vec<u32>>()
    };
    let twist = |rate: f64| Script::Twisting {
        center: [0.0, 0.0, 0.2],
        axis: [1.0, 0.0, 0.0],
        rate,
        until: None,
    };
    let scripts = [twist(4.0).on(side(0.0)), twist(-4.0).on(side(1.0))];
    System::new(&[mat], &scripts).unwrap()
}

fn settings(line_search: LineSearch) -> Settings {
    Settings {
        line_search,
        time_step: 0.04,
        gravity: [0.0; 3],
        contact_distance: Length::Absolute(2e-3),
        ..Settings::default()
    }
}

const LINE_SEARCHES: [LineSearch; 2] = [LineSearch::Common, LineSearch::Vertex];

/// The state after 20 steps. `visit` gets the positions before and after each increment.
fn twisted(line_search: LineSearch, mut visit: impl FnMut(&[Point], &[Point]) + Send) -> State {
    let mut simulation = Simulation::new(system(), settings(line_search)).unwrap();
    let mut at = simulation.state().positions.clone();
    let mut contacts = 0;
    for _ in 0..20 {
        let statistics = simulation
            .step_along(&mut |positions: &[Point]| {
                visit(&at, positions);
                at = positions.to_vec();
            })
            .unwrap();
        assert_eq!(statistics.script_lag, 0.0);
        assert_eq!(at, simulation.state().positions);
        contacts += statistics.contacts;
    }
    assert!(contacts > 0, "nothing came near");
    simulation.state().clone()
}

/// The filter applies to each increment, and the increments connect the time steps.
#[test]
fn every_increment_is_free_of_contact() {
    let surface = system().surface().clone();
    for line_search in LINE_SEARCHES {
        let mut increments = 0;
        let state = twisted(line_search, |from, to| {
            increments += 1;
            assert!(exact_ccd_mesh::step(&surface, from, to).unwrap().is_free());
        });
        assert!(increments > 40);
        // The scripts rotate the ends by 3.2 rad in opposite directions.
        let moved = state.positions[0];
        assert!((moved[1] - 0.2 * 3.2_f64.sin()).abs() < 1e-12, "{moved:?}");
    }
}

#[test]
fn results_do_not_depend_on_the_number_of_threads() {
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| LINE_SEARCHES.map(|line_search| twisted(line_search, |_, _| ())))
    };
    let states = on(1);
    assert_eq!(states, on(2));
    assert_ne!(states[0], states[1], "the line searches took the same steps");
}
