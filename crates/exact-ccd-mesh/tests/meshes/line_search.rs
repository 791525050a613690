//! The line search on the generated examples, and on steps of known size.

use exact_ccd::{Ccd, Exact};
use exact_ccd_mesh::{
    LineSearch, LineSearchError, Motion, Point, Tolerance, TriangleMesh, advance, step, step_size,
};

use super::drape;
use super::odd::Odd;

fn example(end: &str) -> Motion {
    let frames = drape::frames().expect("the examples are sound");
    let frame = |name: &str| {
        frames
            .iter()
            .find(|frame| frame.0 == name)
            .map(|frame| frame.1.clone())
    };
    let [start, end] = ["drape_start.ply", end].map(|name| frame(name).expect("there is such an example"));
    Motion::new(start, end).expect("the examples are sound")
}

fn bisection(tolerance: f64, method: &dyn Ccd) -> LineSearch<'_> {
    let tolerance = Tolerance::Absolute(tolerance);
    LineSearch::Bisection { tolerance, method }
}

fn direction(motion: &Motion) -> Vec<Point> {
    let minus = |(a, b): (&Point, &Point)| core::array::from_fn(|axis| b[axis] - a[axis]);
    motion.x0.iter().zip(&motion.x1).map(minus).collect()
}

/// The largest step that the search allows on a motion, and true if the motion up to there is free,
/// exactly.
fn search(motion: &Motion, search: LineSearch<'_>) -> (f64, bool) {
    let direction = direction(motion);
    let size = step_size(&motion.mesh, &motion.x0, &direction, search).expect("the motion is sound");
    let end = advance(&motion.x0, &direction, size);
    let report = step(&motion.mesh, &motion.x0, &end).expect("the step is sound");
    (size, report.is_free())
}

#[test]
fn the_exact_step_is_next_to_the_time_of_impact() {
    let motion = example("drape_contact.ply");
    let (size, is_free) = search(&motion, LineSearch::Exact);
    assert!(is_free);
    let end = advance(&motion.x0, &direction(&motion), 1.0);
    let report = step(&motion.mesh, &motion.x0, &end).expect("the step is sound");
    let impact = report.time_of_impact().expect("the end is beyond the sphere");
    // The rounded positions are off by some units in the last place of coordinates around 1.
    assert!(
        size <= impact && impact - size <= 64.0 * f64::EPSILON,
        "{size} and {impact}"
    );
}

#[test]
fn bisection_ends_within_its_tolerance_below_the_exact_step() {
    let motion = example("drape_contact.ply");
    let (exact, _) = search(&motion, LineSearch::Exact);
    let methods: [&dyn Ccd; 2] = [&Exact, &Odd];
    for method in methods {
        for tolerance in [0.1, 1e-3, 1e-6] {
            let (size, is_free) = search(&motion, bisection(tolerance, method));
            assert!(is_free);
            assert!(
                size <= exact && exact - size <= tolerance,
                "{size}, exactly {exact}, within {tolerance}"
            );
        }
    }
}

#[test]
fn a_free_step_is_taken_in_full() {
    let motion = example("drape_free.ply");
    assert_eq!(search(&motion, LineSearch::Exact), (1.0, true));
    assert_eq!(search(&motion, bisection(1e-3, &Exact)), (1.0, true));
}

/// An edge that passes through another edge at t = 1/3 and back at t = 1/2: an even number of
/// contacts.
#[test]
fn a_method_that_misses_two_contacts_takes_the_full_step() {
    let flat = vec![[0, 1, 1], [2, 3, 3]];
    let motion = Motion {
        mesh: TriangleMesh::new(4, flat).expect("indices are in range"),
        x0: vec![
            [-2.0, 0.0, 1.0],
            [-1.0, -2.0, -1.0],
            [-2.0, 0.0, 0.0],
            [2.0, 0.0, 0.0],
        ],
        x1: vec![
            [0.0, 1.0, -2.0],
            [1.0, 1.0, 2.0],
            [-2.0, 0.0, 0.0],
            [2.0, 0.0, 0.0],
        ],
    };
    let (size, is_free) = search(&motion, LineSearch::Exact);
    assert!(
        is_free && (1.0 / 3.0 - 64.0 * f64::EPSILON..=1.0 / 3.0).contains(&size),
        "{size}"
    );
    assert_eq!(search(&motion, bisection(1e-3, &Odd)), (1.0, false));
}

#[test]
fn a_mesh_in_contact_cannot_move() {
    let mesh = TriangleMesh::new(4, vec![[0, 1, 2]]).expect("indices are in range");
    let start = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.25, 0.25, 0.0],
    ];
    let direction = [[0.0; 3], [0.0; 3], [0.0; 3], [0.0, 0.0, 1.0]];
    assert_eq!(step_size(&mesh, &start, &direction, LineSearch::Exact), Ok(0.0));
    let search = bisection(0.5, &Exact);
    assert_eq!(step_size(&mesh, &start, &direction, search), Ok(0.0));
}

#[test]
fn errors_name_the_wrong_input() {
    let mesh = TriangleMesh::new(3, vec![[0, 1, 2]]).expect("indices are in range");
    let x = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let message = |direction: &[Point], search| {
        step_size(&mesh, &x, direction, search).map_err(|error| error.to_string())
    };
    let infinite = [[0.0, 0.0, f64::INFINITY], [0.0; 3], [0.0; 3]];
    for search in [LineSearch::Exact, bisection(0.5, &Exact)] {
        assert_eq!(
            message(&x[..2], search),
            Err("in the direction, 2 positions, expected one for each of 3 vertices".to_owned())
        );
        assert_eq!(
            message(&infinite, search),
            Err("in the direction, vertex 0 has z = inf, expected a finite number".to_owned())
        );
    }
    let search = bisection(0.0, &Exact);
    assert_eq!(
        step_size(&mesh, &x, &x, search),
        Err(LineSearchError::Tolerance(0.0))
    );
}
