//! All filters of the line search.

use std::sync::{Arc, Mutex};

use exact_ccd::Exact;
use exact_ccd_mesh::{Bvh, Candidates, MinDistance, Point, Step, TriangleMesh};
use exact_ccd_methods::parity::RootParity;
use exact_ccd_sim::{
    Body, BodyKind, Checkpoint, Settings, ShellProperties, Simulation, SimulationError, StepFilter, System,
    shapes,
};

/// A vertex that passes through a triangle at t = ¾.
fn falling() -> (TriangleMesh, [Vec<Point>; 2]) {
    falling_to(-1.0)
}

/// A vertex that falls from the height 3 to the height `end`, with a triangle at the height 0.
fn falling_to(end: f64) -> (TriangleMesh, [Vec<Point>; 2]) {
    let mesh = TriangleMesh::new(6, vec![[0, 1, 2], [3, 4, 5]]).unwrap();
    let at = |height: f64| {
        vec![
            [0.0, 0.0, 0.0],
            [4.0, 0.0, 0.0],
            [0.0, 4.0, 0.0],
            [1.0, 1.0, height],
            [1.0, 1.2, height + 9.0],
            [1.2, 1.0, height + 9.0],
        ]
    };
    (mesh, [at(3.0), at(end)])
}

/// Filters by times of impact and by bisection, of methods without false answers and of parity.
fn filters() -> [StepFilter; 3] {
    [
        StepFilter::default(),
        StepFilter::by_bisection("bisection", Arc::new(Exact)),
        StepFilter::new("parity", Arc::new(RootParity::default())),
    ]
}

#[test]
fn every_filter_stops_short_of_the_contact() {
    let (mesh, [start, end]) = falling();
    let step = Step::new(&mesh, &start, &end).unwrap();
    let candidates = Candidates::new(step, &Bvh);
    for filter in filters() {
        let name = filter.name();
        let size = filter.free_part(&candidates, step, &MinDistance::default());
        assert!((0.5..=0.75).contains(&size), "{name}: {size}");
        assert!(
            !filter.is_free(&candidates, step, &MinDistance::default()),
            "{name}"
        );
        let middle = step.at(0.5);
        let half = Step::new(&mesh, &start, &middle).unwrap();
        assert!(
            filter.is_free(&candidates, half, &MinDistance::default()),
            "{name}"
        );
        assert_eq!(
            filter.free_part(&candidates, half, &MinDistance::default()),
            1.0,
            "{name}"
        );
    }
}

#[test]
fn the_exact_filter_stops_at_the_time_of_impact() {
    let (mesh, [start, end]) = falling();
    let step = Step::new(&mesh, &start, &end).unwrap();
    let candidates = Candidates::new(step, &Bvh);
    assert_eq!(
        StepFilter::default().free_part(&candidates, step, &MinDistance::default()),
        0.75
    );
}

/// A motion that ends in contact is not free, and its step size is below 1.
#[test]
fn a_contact_at_the_end_counts() {
    for height in [0.0, -f64::MIN_POSITIVE] {
        let (mesh, [start, end]) = falling_to(height);
        let step = Step::new(&mesh, &start, &end).unwrap();
        let candidates = Candidates::new(step, &Bvh);
        for filter in filters() {
            let name = filter.name();
            let is_free = filter.is_free(&candidates, step, &MinDistance::default());
            // Parity may miss this contact. The step size and the decision of a filter agree.
            assert_eq!(
                filter.free_part(&candidates, step, &MinDistance::default()) == 1.0,
                is_free,
                "{name}"
            );
            assert!(!is_free || name == "parity", "{name}");
        }
    }
}

/// The observer of a filter is called for each step, with the candidates.
#[test]
fn a_filter_is_observed() {
    let (mesh, [start, end]) = falling();
    let step = Step::new(&mesh, &start, &end).unwrap();
    let candidates = Candidates::new(step, &Bvh);
    let seen = Arc::new(Mutex::new(Vec::new()));
    let log = Arc::clone(&seen);
    let filter = StepFilter::default().observed(move |candidates, step| {
        log.lock()
            .unwrap()
            .push((candidates.counts().total(), step.positions()[1][3][2]));
    });
    let _ = filter.free_part(&candidates, step, &MinDistance::default());
    let _ = filter.is_free(
        &candidates,
        Step::new(&mesh, &start, &start).unwrap(),
        &MinDistance::default(),
    );
    let count = candidates.counts().total();
    assert_eq!(*seen.lock().unwrap(), [(count, end[3][2]), (count, start[3][2])]);
}

/// The line search takes no step that ends in contact. Without contact, the falling vertex would end exactly
/// on the slope.
#[test]
fn no_step_ends_in_contact() {
    let corners = [[-10.0, -1.0, -7.0], [11.0, 3.0, -6.0], [-1.0, -2.0, 13.0]];
    let material = ShellProperties {
        density: 1.5,
        // The material is so soft that the vertices move independently.
        young: 1e-30,
        poisson: 0.25,
        thickness: 0.5,
        strain_limit: None,
    };
    let faces = vec![[0, 1, 2]];
    let points = vec![[0.0, 3.0, 0.0], [0.0, 7.0, 1.0], [0.0, 7.0, -1.0]];
    let mut falling = Body::new(points, BodyKind::Shell { faces, material });
    falling.velocity = [0.0, -6.0, 0.0];
    for scale in 1..20 {
        let points = corners
            .map(|corner| corner.map(|x| x * f64::from(scale)))
            .to_vec();
        let faces = vec![[0, 1, 2]];
        let slope = Body::new(points, BodyKind::Obstacle { faces });
        let system = System::new(&[falling.clone(), slope], &[]).unwrap();
        let settings = Settings {
            time_step: 0.5,
            gravity: [0.0; 3],
            ..Settings::default()
        };
        let surface = system.surface().clone();
        let mut simulation = Simulation::new(system, settings).unwrap();
        let mut at = simulation.state().positions.clone();
        let mut visit = |positions: &[Point]| {
            assert!(exact_ccd_mesh::step(&surface, &at, positions).unwrap().is_free());
            at = positions.to_vec();
        };
        simulation.step_along(&mut visit).unwrap();
        // The height without contact is 0.
        let height = simulation.state().positions[0][1];
        assert!(height > 0.0 && height < 1.0, "{height}");
    }
}

/// Methods without exact times decide contact, not offsets: bodies could come nearer than these.
#[test]
fn bodies_with_offsets_need_an_exact_method() {
    let cloth = shapes::cloth([2, 2], [1.0; 2]);
    let parity = || StepFilter::new("parity", Arc::new(RootParity::default()));
    for (offset, is_accepted) in [(0.0, true), (1e-3, false)] {
        let system = System::new(&[cloth.clone().with_offset(offset)], &[]).unwrap();
        let settings = Settings {
            gravity: [0.0; 3],
            ..Settings::default()
        };
        let simulation = || Simulation::new(system.clone(), settings.clone()).unwrap();
        let checkpoint = Checkpoint {
            settings: Settings {
                ccd: "parity".to_owned(),
                ..settings.clone()
            },
            ..simulation().checkpoint()
        };
        let resumed = checkpoint.resume(system.clone(), settings.clone(), parity());
        for result in [simulation().with_filter(parity()), resumed] {
            let name = "parity".to_owned();
            match result {
                Ok(_) => assert!(is_accepted),
                Err(error) => assert_eq!((is_accepted, error), (false, SimulationError::Offset { name })),
            }
        }
    }
}
