//! Scripts that begin later than the simulation.

use exact_ccd_mesh::Point;
use exact_ccd_sim::{
    Body, Force, Integrator, KeyFrame, Length, Load, Script, ScriptedVertices, Settings, Simulation, State,
    System, shapes,
};

use crate::scripted_axes::{fallen, particles};

fn up(speed: f64, until: Option<f64>) -> Script {
    let velocity = [0.0, speed, 0.0];
    Script::Moving { velocity, until }
}

fn simulation(bodies: &[Body], scripts: &[ScriptedVertices], settings: Settings) -> Simulation {
    Simulation::new(System::new(bodies, scripts).unwrap(), settings).unwrap()
}

fn steps(simulation: &mut Simulation, count: usize) {
    for _ in 0..count {
        let statistics = simulation.step().unwrap();
        assert_eq!(statistics.script_lag, 0.0, "{statistics:?}");
    }
}

fn assert_near(found: Point, expected: Point) {
    let error = (0..3).map(|axis| (found[axis] - expected[axis]).abs());
    assert!(error.fold(0.0, f64::max) < 1e-12, "{found:?} {expected:?}");
}

/// A particle falls, is caught after 5 time steps where it is, moves by each kind of motion from there, and
/// falls again.
#[test]
fn a_falling_particle_is_caught() {
    let frame = |time, x, degrees| KeyFrame {
        time,
        translate: [x, 0.0, 0.0],
        degrees,
    };
    let turning = Script::Twisting {
        center: [2.0, 0.0, 0.5],
        axis: [0.0, 1.0, 0.0],
        rate: core::f64::consts::PI / 0.05,
        until: Some(0.1),
    };
    let frames = Script::KeyFrames {
        frames: vec![frame(0.05, 0.0, 0.0), frame(0.1, 3.0, 180.0)],
        center: [2.0, 0.0, 0.5],
        axis: [0.0, 1.0, 0.0],
    };
    let (fall, height) = (|steps| fallen(steps, 0.01), fallen(5, 0.01));
    let cases: [(Script, Point); 4] = [
        (Script::Fixed, [2.0, height, 0.0]),
        (up(3.0, Some(0.08)), [2.0, height + 3.0 * 0.03, 0.0]),
        (turning, [2.0, height, 1.0]),
        (frames, [5.0, height, 1.0]),
    ];
    for (script, caught) in cases {
        let scripts = [script.on([2]).from(0.05).until(0.12)];
        let mut simulation = simulation(&[particles()], &scripts, Settings::default());
        assert!((0..3).all(|vertex| simulation.system().is_free(vertex)));
        steps(&mut simulation, 5);
        assert_near(simulation.state().positions[2], [2.0, height, 0.0]);
        steps(&mut simulation, 7);
        assert_near(simulation.state().positions[2], caught);
        assert_near(simulation.state().positions[0], [0.0, fall(12), 0.0]);
        // The script has come to rest.
        steps(&mut simulation, 4);
        assert_near(
            simulation.state().positions[2],
            [caught[0], caught[1] + fall(4), caught[2]],
        );
    }
}

/// A time between two time steps: the first motion lasts until then, and the second one begins there.
#[test]
fn a_script_that_begins_within_a_time_step_continues_the_earlier_one() {
    let scripts = [
        up(1.0, None).on([0, 1, 2]),
        up(-2.0, None).on([0]).from(0.105),
        up(1.0, None).on([1]).from(0.0333),
        Script::Fixed.on([2]).from(0.1999),
    ];
    let mut simulation = simulation(&[particles()], &scripts, Settings::default());
    let start = simulation.state().positions.clone();
    steps(&mut simulation, 20);
    for (vertex, height) in [0.105 - 2.0 * (0.2 - 0.105), 0.2, 0.1999].into_iter().enumerate() {
        let [x, y, z] = start[vertex];
        assert_near(simulation.state().positions[vertex], [x, y + height, z]);
    }
}

/// Of the scripts of a coordinate, the one that began last counts, wherever it is in the list. An obstacle
/// rests before and between its scripts.
#[test]
fn scripts_follow_each_other_along_each_axis() {
    let right = Script::Moving {
        velocity: [2.0, 5.0, 5.0],
        until: None,
    };
    let floor = shapes::floor([1, 1], [1.0, 1.0]).placed(|[x, _, z]| [x, 9.0, z]);
    let x = [true, false, false];
    let scripts = [
        up(-1.0, None).on([0, 3]).from(0.08),
        right.clone().on([0]).along(x),
        Script::Fixed.on([0]).from(0.05).along(x),
        right.on([3]).along(x).from(0.02).until(0.05),
    ];
    let mut simulation = simulation(&[particles(), floor], &scripts, Settings::default());
    steps(&mut simulation, 2);
    assert_near(simulation.state().positions[3], [0.0, 9.0, 0.0]);
    steps(&mut simulation, 6);
    // Along y, the particle falls.
    assert_near(simulation.state().positions[0], [0.1, fallen(8, 0.01), 0.0]);
    assert_near(simulation.state().positions[3], [0.06, 9.0, 0.0]);
    steps(&mut simulation, 2);
    assert_near(
        simulation.state().positions[0],
        [0.1, fallen(8, 0.01) - 0.02, 0.0],
    );
    assert_near(simulation.state().positions[3], [0.06, 8.98, 0.0]);
}

/// A vertex is held at all times if one script begins where another ends.
#[test]
fn vertices_without_a_gap_between_their_scripts_are_not_free() {
    let scripts = |from| [Script::Fixed.on([0]).until(0.5), up(1.0, None).on([0]).from(from)];
    let is_free = |from| System::new(&[particles()], &scripts(from)).unwrap().is_free(0);
    assert!(!is_free(0.5) && !is_free(0.25) && is_free(0.75));
}

/// The floating-point number 3 · 0.1 is greater than 0.3.
#[test]
fn rounding_errors_of_times_do_not_shift_a_script_or_a_load() {
    let time_step = 0.1;
    let scripts = [Script::Fixed.on([0]).from(0.3), Script::Fixed.on([1]).until(0.3)];
    let load = |vertex, from, until| Load {
        vertices: vec![vertex],
        force: Force::Acceleration([0.0, -20.0, 0.0]),
        from,
        until,
    };
    let system = System::new(&[particles()], &scripts).unwrap();
    let system = system.with_loads(vec![load(2, 0.3, Some(0.7))]).unwrap();
    let settings = Settings {
        time_step,
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings).unwrap();
    steps(&mut simulation, 8);
    let heights = [0, 1, 2].map(|vertex: usize| simulation.state().positions[vertex][1]);
    // Steps 4 to 7 accelerate, and step 8 has the velocity of all.
    let loaded = -20.0 * time_step * time_step * f64::from(1 + 2 + 3 + 4 + 4);
    let expected = [
        fallen(3, time_step),
        fallen(5, time_step),
        fallen(8, time_step) + loaded,
    ];
    for (found, expected) in heights.into_iter().zip(expected) {
        assert!((found - expected).abs() < 1e-12, "{heights:?} {expected}");
    }
}

/// A script begins where the vertices are, not where the script before could not bring them.
#[test]
fn a_script_begins_where_an_obstruction_left_the_vertices() {
    let ceiling = shapes::floor([2, 2], [2.0, 2.0]).placed(|[x, y, z]| [x - 0.5, y + 0.05, z - 0.5]);
    let cloth = shapes::cloth([4, 4], [1.0, 1.0]);
    let scripts = [up(10.0, None).on([0, 4]), Script::Fixed.on([0, 4]).from(0.02)];
    let settings = Settings {
        contact_distance: Length::Absolute(0.005),
        ..Settings::default()
    };
    let mut simulation = simulation(&[cloth, ceiling], &scripts, settings);
    simulation.step().unwrap();
    assert!(simulation.step().unwrap().script_lag > 0.1);
    let caught = simulation.state().positions[0];
    steps(&mut simulation, 3);
    assert_eq!(simulation.state().positions[0], caught);
}

/// A body that falls is caught at one side, which then moves, and is released. A simulation that is resumed
/// before, at, or after these times has the same bits.
#[test]
fn a_simulation_that_is_resumed_at_the_start_of_a_script_has_the_same_bits() {
    for (integrator, max_substeps) in [(Integrator::Bdf2, 1), (Integrator::ImplicitEuler, 4)] {
        let system = || {
            let cube = shapes::solid_box([1, 1, 1], [0.5; 3]).placed(|[x, y, z]| [x, y + 0.5, z]);
            let side: Vec<u32> = (0..8).filter(|&v| cube.points[v as usize][0] == 0.0).collect();
            let scripts = [
                up(1.0, None).on(side.clone()).from(0.05),
                Script::Fixed.on(side).from(0.07).until(0.1),
            ];
            System::new(&[cube], &scripts).unwrap()
        };
        let settings = || Settings {
            integrator,
            max_substeps,
            max_iterations: 3,
            ..Settings::default()
        };
        let mut whole = Simulation::new(system(), settings()).unwrap();
        let mut saved = Vec::new();
        for _ in 0..13 {
            saved.push(serde_json::to_string(whole.state()).unwrap());
            whole.step().unwrap();
        }
        assert!(saved[5].len() < saved[6].len());
        let last = serde_json::to_string(whole.state()).unwrap();
        for step in [0, 4, 5, 6, 7, 8, 10, 11] {
            let state: State = serde_json::from_str(&saved[step]).unwrap();
            let mut resumed = Simulation::resume(system(), settings(), state).unwrap();
            for _ in step..13 {
                resumed.step().unwrap();
            }
            // Compared as text, where −0.0 differs from 0.0.
            let resumed = serde_json::to_string(resumed.state()).unwrap();
            assert_eq!(resumed, last, "from step {step}");
        }
    }
}

/// Scripts that begin at time 0 need no origins.
#[test]
fn origins_are_those_of_later_scripts() {
    let scripts = [up(1.0, None).on([0]), up(1.0, None).on([1]).from(0.01)];
    let mut simulation = simulation(&[particles()], &scripts, Settings::default());
    steps(&mut simulation, 2);
    let origins = &simulation.state().origins;
    assert_eq!(origins.keys().copied().collect::<Vec<u32>>(), [1]);
    assert_near(origins[&1][0], [1.0, fallen(1, 0.01), 0.0]);
}

#[test]
fn scripts_that_begin_after_their_end_are_errors() {
    let error = |scripted: ScriptedVertices| scripted.check().unwrap_err().field;
    let fixed = || Script::Fixed.on([0]);
    assert_eq!(error(fixed().from(f64::NAN)), "from");
    assert_eq!(error(fixed().from(-1.0)), "from");
    assert_eq!(error(fixed().from(f64::INFINITY)), "from");
    assert_eq!(error(fixed().from(2.0).until(1.0)), "release");
    assert_eq!(error(up(1.0, Some(1.0)).on([0]).from(2.0)), "from");
    fixed().from(1.0).until(1.0).check().unwrap();
}
