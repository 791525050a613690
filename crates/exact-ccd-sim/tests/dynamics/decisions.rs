//! The line search takes only steps that the filter has accepted.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use exact_ccd::{CONTACT, Ccd, Decide, Guarantees, Kind, Query, TimeGuarantee};
use exact_ccd_mesh::{Audit, Frame, Point, Violation};
use exact_ccd_sim::{
    Script, Settings, Simulation, SimulationError, State, Statistics, StepFilter, System, shapes,
};

/// A method whose time of impact is always just below 1. Its decision is exact if `decides`, else always
/// free.
struct Hasty {
    decides: bool,
}

impl<K: Kind> Decide<K> for Hasty {
    fn collides(&self, query: &Query<K>) -> bool {
        self.decides && query.collides(CONTACT)
    }

    fn time_of_impact(&self, _: &Query<K>) -> Option<f64> {
        Some(1.0_f64.next_down())
    }
}

impl Ccd for Hasty {
    fn name(&self) -> &'static str {
        "hasty"
    }

    fn guarantees(&self) -> Guarantees {
        Guarantees {
            false_negatives: !self.decides,
            false_positives: false,
            time: TimeGuarantee::Approximate,
        }
    }
}

/// The first violation in the increments of two time steps.
fn violation(system: System, method: Hasty) -> Option<Violation> {
    let faces = system.surface().faces().to_vec();
    let frame = |positions: &[Point]| Frame::new(positions.to_vec(), faces.clone()).unwrap();
    let simulation = Simulation::new(system, Settings::default()).unwrap();
    let mut simulation = simulation
        .with_filter(StepFilter::new("hasty", Arc::new(method)))
        .unwrap();
    let mut audit = Audit::default();
    let mut violation = audit.examine(frame(&simulation.state().positions)).unwrap();
    for _ in 0..2 {
        let mut visit = |positions: &[Point]| {
            let found = audit.examine(frame(positions)).unwrap();
            violation = violation.or(found);
        };
        simulation.step_along(&mut visit).unwrap();
    }
    assert!(audit.frames() > 2);
    violation
}

/// The decision of the filter applies to every step, whatever the step size that the filter returns.
#[test]
fn no_step_is_taken_without_a_decision() {
    let mut cloth = shapes::cloth([2, 2], [1.0, 1.0]).placed(|[x, y, z]| [x, y + 0.05, z]);
    let floor = shapes::floor([1, 1], [3.0, 3.0]).placed(|[x, y, z]| [x - 0.9, y, z - 1.1]);
    // In one time step, the cloth moves by six times its distance to the floor.
    cloth.velocity = [0.0, -30.0, 0.0];
    let system = || System::new(&[cloth.clone(), floor.clone()], &[]).unwrap();
    assert_eq!(violation(system(), Hasty { decides: true }), None);
    assert!(violation(system(), Hasty { decides: false }).is_some());
}

/// The decision of the filter also applies to steps that set scripted vertices to their targets.
#[test]
fn no_scripted_step_is_taken_without_a_decision() {
    let cloth = shapes::cloth([2, 2], [1.0, 1.0]).placed(|[x, y, z]| [x, y + 0.05, z]);
    let floor = shapes::floor([1, 1], [3.0, 3.0]).placed(|[x, y, z]| [x - 0.9, y, z - 1.1]);
    let rising = Script::Moving {
        velocity: [0.0, 30.0, 0.0],
        until: None,
    };
    let system = || System::new(&[cloth.clone(), floor.clone()], &[rising.clone().on(9..13)]).unwrap();
    assert_eq!(violation(system(), Hasty { decides: true }), None);
    assert!(violation(system(), Hasty { decides: false }).is_some());
}

/// A method that finds contact in everything while the flag is true, and is exact otherwise.
struct Stuck(Arc<AtomicBool>);

/// A method that finds contact of all points with this coordinate, and is exact otherwise.
struct Picky(f64);

impl<K: Kind> Decide<K> for Picky {
    fn collides(&self, query: &Query<K>) -> bool {
        let mut points = query.points()[0].as_ref().iter().flatten();
        points.any(|&coordinate| coordinate == self.0) || query.collides(CONTACT)
    }

    fn time_of_impact(&self, _: &Query<K>) -> Option<f64> {
        None
    }
}

impl<K: Kind> Decide<K> for Stuck {
    fn collides(&self, query: &Query<K>) -> bool {
        self.0.load(Ordering::Relaxed) || query.collides(CONTACT)
    }

    fn time_of_impact(&self, _: &Query<K>) -> Option<f64> {
        None
    }
}

impl Ccd for Stuck {
    fn name(&self) -> &'static str {
        "stuck"
    }

    fn guarantees(&self) -> Guarantees {
        Guarantees {
            false_negatives: false,
            false_positives: true,
            time: TimeGuarantee::Absent,
        }
    }
}

impl Ccd for Picky {
    fn name(&self) -> &'static str {
        "picky"
    }

    fn guarantees(&self) -> Guarantees {
        Guarantees {
            false_negatives: false,
            false_positives: true,
            time: TimeGuarantee::Absent,
        }
    }
}

/// The result of a time step with at most 8 parts, if the method blocks at most this many attempts, and the
/// number of blocked attempts.
fn blocked_step(most: usize) -> (Result<Statistics, SimulationError>, usize, [State; 2]) {
    let cube = shapes::solid_box([1, 1, 1], [0.5; 3]).placed(|[x, y, z]| [x + 0.3, y + 5e-4, z + 0.2]);
    let system = System::new(&[cube, shapes::floor([1, 1], [1.1, 1.2])], &[]).unwrap();
    let is_stuck = Arc::new(AtomicBool::new(most > 0));
    let attempts = Arc::new(AtomicUsize::new(0));
    let filter = StepFilter::new("stuck", Arc::new(Stuck(Arc::clone(&is_stuck))));
    let count = Arc::clone(&attempts);
    // An attempt that is blocked ends with its first step.
    let filter = filter.observed(move |candidates, _| {
        assert!(!candidates.is_empty());
        if is_stuck.load(Ordering::Relaxed) && count.fetch_add(1, Ordering::Relaxed) == most {
            is_stuck.store(false, Ordering::Relaxed);
        }
    });
    let simulation = Simulation::new(system, Settings::default()).unwrap();
    let mut simulation = simulation.with_filter(filter).unwrap();
    let before = simulation.state().clone();
    let mut increments = 0;
    let result = simulation.step_along(&mut |_| increments += 1);
    assert_eq!(increments > 0, result.is_ok());
    let attempts = attempts.load(Ordering::Relaxed).min(most);
    (result, attempts, [before, simulation.state().clone()])
}

/// A blocked time step is repeated in 2, 4 and 8 parts. If all of them are blocked, the error leaves the
/// state as it was, and no increment is visited.
#[test]
fn a_blocked_step_is_repeated_in_parts() {
    for most in 0..4 {
        let (result, attempts, [_, after]) = blocked_step(most);
        assert!(result.unwrap().converged);
        assert_eq!((attempts, after.step), (most, 1));
    }
    let (result, attempts, [before, after]) = blocked_step(usize::MAX);
    assert_eq!(
        result.unwrap_err().to_string(),
        "step 1: the CCD method `stuck` rejects a Newton step of any length because of vertex 0 \
         of body[0] and face [0, 3, 1] of body[1], expected a positive step size; the method `exact` has no false positives"
    );
    assert_eq!((attempts, before), (4, after));
}

/// The error names a pair that the method rejects, and not the nearest one.
#[test]
fn a_blocked_step_names_the_rejected_pair() {
    let cube = |x: f64, height: f64| {
        shapes::solid_box([1, 1, 1], [0.5; 3]).placed(|at| [at[0] + x, at[1] + height, at[2] + 0.2])
    };
    let bodies = [
        cube(0.3, 5e-4),
        cube(2.0, 6e-4),
        shapes::floor([1, 1], [3.3, 1.2]),
    ];
    let system = System::new(&bodies, &[]).unwrap();
    let starts = system.start().to_vec();
    let first = system.body_vertices()[1].start;
    let filter = StepFilter::new("picky", Arc::new(Picky(2.0)));
    let simulation = Simulation::new(system, Settings::default()).unwrap();
    let error = simulation.with_filter(filter).unwrap().step().unwrap_err();
    let SimulationError::Blocked { pair: Some(pair), .. } = error else {
        panic!("{error}")
    };
    assert_eq!([pair[0].body.place(), pair[1].body.place()], [1, 2]);
    let vertices = pair[0].primitive.vertices().iter();
    let mut positions = vertices.map(|&vertex| starts[(first + vertex) as usize]);
    assert!(positions.any(|position| position[0] == 2.0), "{pair:?}");
}
