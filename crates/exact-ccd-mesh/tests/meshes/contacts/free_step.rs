//! Free steps are free, as large as they may be, and the same on any number of threads.

use std::sync::atomic::{AtomicUsize, Ordering};

use exact_ccd::{CONTACT, Separation};
use exact_ccd_mesh::{
    CanCollide, Detector, FreeStep, FreeStepOptions, LineSearchError, Point, PositionsError, Step, StepError,
    TriangleMesh, advance,
};
use fastrand::Rng;

use super::scene::{Scene, contacts, moved, on_threads};

/// True if no pair touches, one query at a time.
fn is_free(mesh: &TriangleMesh, x0: &[Point], x1: &[Point]) -> bool {
    let (mesh, x0, x1) = (mesh.clone(), x0.to_vec(), x1.to_vec());
    let scene = Scene { mesh, x0, x1 };
    contacts(scene.step(), &scene.pairs()).is_empty()
}

/// Checks a step against the exact detector and all pairs.
fn check(
    mesh: &TriangleMesh,
    [x0, x1]: [&[Point]; 2],
    keep: f64,
    found: &FreeStep,
    at: impl Fn(f64) -> Vec<Point>,
) {
    let mut detector = Detector::new(mesh.clone());
    assert_eq!(found.contact, detector.collision(x0, x1, CONTACT).unwrap());
    let Some(contact) = found.contact else {
        assert_eq!((found.size, &found.positions[..]), (1.0, x1));
        assert!(is_free(mesh, x0, x1));
        return;
    };
    let largest = keep * contact.impact.time.lower();
    assert!((0.0..=largest).contains(&found.size));
    let places = largest.to_bits() - found.size.to_bits();
    assert!(
        found.size == 0.0 || places == 0 || places.is_power_of_two(),
        "{places}"
    );
    if found.size < largest {
        // Rounding forbids the largest size.
        assert!(!is_free(mesh, x0, &at(largest)), "{largest} is free");
    }
    if found.size == 0.0 {
        assert_eq!(found.positions, x0);
        return;
    }
    assert_eq!(found.positions, at(found.size));
    assert_eq!(detector.collides(x0, &found.positions, CONTACT), Ok(false));
    assert!(is_free(mesh, x0, &found.positions));
}

/// Sheets that crumple in successive steps, each from the end of the one before. Nearly all pairs are
/// close to contact.
#[test]
fn steps_of_crumpling_sheets_are_free() {
    let mut random = Rng::with_seed(20);
    let (mut blocked, mut nearly) = (0, 0);
    for case in 0..9 {
        let scene = Scene::sheets(&mut random, 4, 0.0, 1.0);
        let mut detector = Detector::new(scene.mesh.clone());
        let mut x = scene.x0.clone();
        let keep = [0.9, 1.0, 0.25][case % 3];
        let options = FreeStepOptions::default().with_keep(keep);
        for _ in 0..6 {
            let end = moved(&mut random, &x, 1.5);
            let free = detector.free_step(&x, &end, &options).unwrap();
            let step = Step::new(&scene.mesh, &x, &end).unwrap();
            check(&scene.mesh, [&x, &end], keep, &free, |size| step.at(size));
            blocked += usize::from(free.contact.is_some());
            nearly += usize::from(free.size > 0.0 && free.size < 0.1);
            x = free.positions;
        }
    }
    assert!(blocked > 30 && nearly > 3, "{blocked} {nearly}");
}

/// Sheets at such a distance from the origin that their motion is a few units in the last place.
/// Rounded positions at the exact time of impact are often in contact there.
#[test]
fn rounding_reduces_a_step_where_necessary() {
    let mut random = Rng::with_seed(21);
    let mut smaller = 0;
    for case in 0..60 {
        let offset = [1e14, 2e14, 4e14][case % 3];
        let scene = Scene::sheets(&mut random, 2, offset, 6.0);
        let (x0, x1) = (&scene.x0, &scene.x1);
        for keep in [0.9, 1.0] {
            let mut detector = Detector::new(scene.mesh.clone());
            let options = FreeStepOptions::default().with_keep(keep);
            let free = detector.free_step(x0, x1, &options).unwrap();
            check(&scene.mesh, [x0, x1], keep, &free, |size| scene.step().at(size));
            let largest = free
                .contact
                .map_or(1.0, |contact| keep * contact.impact.time.lower());
            smaller += usize::from(0.0 < free.size && free.size < largest);
        }
    }
    assert!(smaller > 3, "{smaller}");
}

#[test]
fn a_step_along_a_direction_has_the_positions_of_advance() {
    let mut random = Rng::with_seed(22);
    for case in 0..8 {
        let scene = Scene::sheets(&mut random, 3, [0.0, 1e6][case % 2], 1.0);
        let direction = moved(&mut random, &vec![[0.0; 3]; scene.x0.len()], 3.0);
        let end = advance(&scene.x0, &direction, 1.0);
        let mut detector = Detector::new(scene.mesh.clone());
        for keep in [0.5, 1.0] {
            let options = FreeStepOptions::default().with_keep(keep);
            let free = detector.free_step_along(&scene.x0, &direction, &options).unwrap();
            check(&scene.mesh, [&scene.x0, &end], keep, &free, |size| {
                advance(&scene.x0, &direction, size)
            });
        }
    }
}

/// A vertex that falls through a face at t = 1/2, from the height of 1.
fn falling(height: f64) -> (TriangleMesh, Vec<Point>) {
    let mesh = TriangleMesh::new(4, vec![[0, 1, 2]]).unwrap();
    let x = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.25, 0.25, height]];
    (mesh, x)
}

#[test]
fn a_mesh_that_touches_itself_does_not_move() {
    let (mesh, x0) = falling(0.0);
    let (_, x1) = falling(1.0);
    let mut detector = Detector::new(mesh);
    let free = detector.free_step(&x0, &x1, &FreeStepOptions::default()).unwrap();
    assert_eq!((free.size, free.positions), (0.0, x0));
    assert!(free.contact.unwrap().impact.touching_at_start());
}

#[test]
fn pairs_that_cannot_collide_do_not_stop_a_step() {
    let (mesh, x0) = falling(1.0);
    let (_, x1) = falling(-1.0);
    let mut detector = Detector::new(mesh).with_can_collide(CanCollide::not_two_obstacles(vec![true; 4]));
    let free = detector.free_step(&x0, &x1, &FreeStepOptions::default()).unwrap();
    assert_eq!((free.size, free.positions, free.contact), (1.0, x1, None));
}

#[test]
fn the_number_of_threads_does_not_matter() {
    let mut random = Rng::with_seed(23);
    for _ in 0..5 {
        let scene = Scene::sheets(&mut random, 12, 0.0, 2.0);
        let steps = [1, 2, 5].map(|threads| {
            on_threads(threads, || {
                let mut detector = Detector::new(scene.mesh.clone());
                let options = FreeStepOptions::default();
                detector.free_step(&scene.x0, &scene.x1, &options).unwrap()
            })
        });
        assert!(steps[0].contact.is_some());
        assert_eq!(steps[0], steps[1]);
        assert_eq!(steps[0], steps[2]);
    }
}

#[test]
fn a_search_can_be_cancelled_at_any_time_and_the_detector_used_again() {
    let scene = Scene::sheets(&mut Rng::with_seed(24), 12, 0.0, 2.0);
    let (x0, x1) = (&scene.x0, &scene.x1);
    let mut detector = Detector::new(scene.mesh.clone());
    let expected = detector.free_step(x0, x1, &FreeStepOptions::default()).unwrap();

    let calls = AtomicUsize::new(0);
    let never = || {
        calls.fetch_add(1, Ordering::Relaxed);
        false
    };
    let options = FreeStepOptions::default().with_cancel(&never);
    assert_eq!(detector.free_step(x0, x1, &options), Ok(expected.clone()));
    let total = calls.into_inner();
    assert!(total > 3);

    for after in [0, 1, total / 2] {
        let calls = AtomicUsize::new(0);
        // Once is enough.
        let cancel = || calls.fetch_add(1, Ordering::Relaxed) == after;
        let options = FreeStepOptions::default().with_cancel(&cancel);
        assert_eq!(
            detector.free_step(x0, x1, &options),
            Err(LineSearchError::Cancelled)
        );
        assert_eq!(
            detector.free_step(x0, x1, &FreeStepOptions::default()),
            Ok(expected.clone())
        );
    }
}

#[test]
fn progress_is_the_number_of_examined_pairs() {
    let scene = Scene::sheets(&mut Rng::with_seed(25), 12, 0.0, 2.0);
    let done = AtomicUsize::new(0);
    let progress = |count| {
        done.fetch_add(count, Ordering::Relaxed);
    };
    let mut detector = Detector::new(scene.mesh.clone());
    let options = FreeStepOptions::default().with_progress(&progress);
    detector.free_step(&scene.x0, &scene.x1, &options).unwrap();
    assert!(done.into_inner() > 100);
}

#[test]
fn wrong_input_is_an_error() {
    let (mesh, x0) = falling(1.0);
    let (_, x1) = falling(-1.0);
    let mut detector = Detector::new(mesh);
    for keep in [0.0, -0.5, 1.0_f64.next_up(), f64::INFINITY] {
        let options = FreeStepOptions::default().with_keep(keep);
        assert_eq!(
            detector.free_step(&x0, &x1, &options),
            Err(LineSearchError::Keep(keep))
        );
    }
    let options = FreeStepOptions::default().with_keep(f64::NAN);
    assert!(matches!(
        detector.free_step(&x0, &x1, &options),
        Err(LineSearchError::Keep(_))
    ));
    let options = FreeStepOptions::default();
    let count = PositionsError::Count {
        positions: 3,
        vertex_count: 4,
    };
    assert_eq!(
        detector.free_step(&x0, &x1[..3], &options),
        Err(LineSearchError::Step(StepError::End(count)))
    );
    assert_eq!(
        detector.free_step_along(&x0, &x1[..3], &options),
        Err(LineSearchError::Direction(count))
    );
}

/// The vertex falls from two units of the least f64 to −1: contact is a little before t = 2 · 2⁻¹⁰⁷⁴.
#[test]
fn the_least_f64_is_a_size() {
    let least = f64::from_bits(1);
    let (mesh, x0) = falling(2.0 * least);
    let (_, x1) = falling(-1.0);
    let options = FreeStepOptions::default().with_keep(1.0);
    let free = Detector::new(mesh).free_step(&x0, &x1, &options).unwrap();
    assert_eq!((free.size, free.positions[3][2]), (least, least));
}

#[test]
fn all_is_within_the_largest_distance() {
    let (mesh, x0) = falling(1.0);
    let (_, x1) = falling(2.0);
    let options = FreeStepOptions::default().with_min_distance(Separation::new(f64::MAX).unwrap());
    let free = Detector::new(mesh).free_step(&x0, &x1, &options).unwrap();
    assert_eq!((free.size, free.positions), (0.0, x0));
}

/// Contact is at t = 1/2.
#[test]
fn the_fraction_to_keep_is_one_of_the_time_of_impact() {
    let (mesh, x0) = falling(1.0);
    let (_, x1) = falling(-1.0);
    let mut detector = Detector::new(mesh);
    let mut at = |keep| {
        let options = FreeStepOptions::default().with_keep(keep);
        let free = detector.free_step(&x0, &x1, &options).unwrap();
        (free.size, free.positions[3][2])
    };
    assert_eq!(at(0.5), (0.25, 0.5));
    let (size, height) = at(1.0);
    assert_eq!(size, 0.5_f64.next_down());
    assert!(height > 0.0);
    assert_eq!(FreeStepOptions::default().keep, 0.9);
}

/// A vertex just above a tilted face that moves with it. Wherever it is rounded, its height is lost, and it
/// is in the face.
#[test]
fn a_height_below_all_roundings_leaves_no_step() {
    let mesh = TriangleMesh::new(4, vec![[0, 1, 2]]).unwrap();
    let x0 = [
        [-1.0, -1.0, -1.0],
        [1.0, -1.0, 1.0],
        [0.0, 2.0, 0.0],
        [0.0, 0.0, 1e-200],
    ];
    let x1 = x0.map(|[x, y, z]| [x + 1.0 / 3.0, y, z + 1.0 / 3.0]);
    let free = Detector::new(mesh)
        .free_step(&x0, &x1, &FreeStepOptions::default())
        .unwrap();
    assert_eq!((free.size, free.touching.total()), (0.0, 0));
    assert_eq!(free.contact.unwrap().impact.time.lower(), 1.0);
}
