//! The exact step along a direction and bisection, on the generated examples and on steps of known size.

use exact_ccd::{Ccd, Exact};
use exact_ccd_mesh::{
    Bvh, Candidates, Detector, Frame, FreeStepOptions, Motion, Point, Step, Tolerance, TriangleMesh, advance,
    bisect, step,
};
use exact_ccd_testing::meshes::drape;

use super::odd::Odd;

fn example(end: &str) -> Motion {
    let frame = |name: &str| {
        let (_, (positions, faces)) = drape::frames().into_iter().find(|(of, _)| *of == name)?;
        Frame::new(positions, faces).ok()
    };
    let [start, end] = ["drape_start.ply", end].map(|name| frame(name).expect("there is such an example"));
    Motion::new(start, end).expect("the examples are sound")
}

fn direction(motion: &Motion) -> Vec<Point> {
    let minus = |(a, b): (&Point, &Point)| core::array::from_fn(|axis| b[axis] - a[axis]);
    motion.x0.iter().zip(&motion.x1).map(minus).collect()
}

/// The exact step along the direction of a motion.
fn exact(motion: &Motion) -> f64 {
    let mut detector = Detector::new(motion.mesh.clone());
    let options = FreeStepOptions::default().with_keep(1.0);
    let taken = detector.free_step_along(&motion.x0, &direction(motion), &options);
    taken.expect("the motion is sound").size
}

/// The step along the direction of a motion by bisection, with the candidates of the full step.
fn bisection(motion: &Motion, tolerance: f64, method: &dyn Ccd) -> f64 {
    let (x0, direction) = (&motion.x0, direction(motion));
    let full = advance(x0, &direction, 1.0);
    let full = Step::new(&motion.mesh, x0, &full).expect("the motion is sound");
    let candidates = Candidates::new(full, &Bvh);
    bisect(Tolerance::Absolute(tolerance), |size| {
        let end = advance(x0, &direction, size);
        let step = Step::new(&motion.mesh, x0, &end).expect("the step is sound");
        !candidates.collides_by(step, method)
    })
}

/// Returns true if a step along the direction of a motion is free, exactly.
fn is_free(motion: &Motion, size: f64) -> bool {
    let end = advance(&motion.x0, &direction(motion), size);
    let report = step(&motion.mesh, &motion.x0, &end).expect("the step is sound");
    report.is_free()
}

#[test]
fn the_exact_step_is_next_to_the_time_of_impact() {
    let motion = example("drape_contact.ply");
    let size = exact(&motion);
    assert!(is_free(&motion, size));
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
    let exact = exact(&motion);
    let methods: [&dyn Ccd; 2] = [&Exact, &Odd];
    for method in methods {
        for tolerance in [0.1, 1e-3, 1e-6] {
            let size = bisection(&motion, tolerance, method);
            assert!(is_free(&motion, size));
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
    assert!(is_free(&motion, 1.0));
    assert_eq!(exact(&motion), 1.0);
    assert_eq!(bisection(&motion, 1e-3, &Exact), 1.0);
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
    let size = exact(&motion);
    assert!(
        is_free(&motion, size) && (1.0 / 3.0 - 64.0 * f64::EPSILON..=1.0 / 3.0).contains(&size),
        "{size}"
    );
    assert_eq!(bisection(&motion, 1e-3, &Odd), 1.0);
    assert!(!is_free(&motion, 1.0));
}

#[test]
fn a_mesh_in_contact_cannot_move() {
    let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let at = |height: f64| [&corners[..], &[[0.25, 0.25, height]]].concat();
    let motion = Motion {
        mesh: TriangleMesh::new(4, vec![[0, 1, 2]]).expect("indices are in range"),
        x0: at(0.0),
        x1: at(1.0),
    };
    assert_eq!(exact(&motion), 0.0);
    assert_eq!(bisection(&motion, 0.5, &Exact), 0.0);
}

#[test]
fn errors_name_the_wrong_part_of_the_direction() {
    let mesh = TriangleMesh::new(3, vec![[0, 1, 2]]).expect("indices are in range");
    let x = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let message = |direction: &[Point]| {
        let taken = Detector::new(mesh.clone()).free_step_along(&x, direction, &FreeStepOptions::default());
        taken.map_err(|error| error.to_string())
    };
    let infinite = [[0.0, 0.0, f64::INFINITY], [0.0; 3], [0.0; 3]];
    assert_eq!(
        message(&x[..2]),
        Err("in the direction, 2 positions, expected one for each of 3 vertices".to_owned())
    );
    assert_eq!(
        message(&infinite),
        Err("in the direction, vertex 0 has z = inf, expected a finite number".to_owned())
    );
}
