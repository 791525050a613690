//! Free steps whose ends are in single precision: the motion to the rounded positions is free.

use exact_ccd::{Separation, with_kind};
use exact_ccd_mesh::{Detector, FreeStepOptions, LineSearchError, Pair, Point, Precision, TriangleMesh};
use fastrand::Rng;

use super::scene::{Scene, allowed, moved};

/// The number of random steps. With 10,000, the test takes minutes.
const STEPS: usize = 600;

fn single(x: &[Point]) -> Vec<Point> {
    x.iter().map(|&point| Precision::Single.round(point)).collect()
}

fn is_single(x: &[Point]) -> bool {
    x.as_flattened().iter().all(|&x| f64::from(x as f32) == x)
}

/// Sheets at one of the scales from 1e-6 to 1e6, at rest near each other, some so far from the origin that a
/// unit in the last place of `f32` is as long as their gaps.
fn scene(random: &mut Rng) -> Scene {
    let Scene { mesh, x0, x1 } = match random.usize(..3) {
        0 => Scene::pieces(random).0,
        1 => Scene::mixed(random).0,
        _ => Scene::sheets(random, 1, 0.0, 2.0),
    };
    let scale = 10_f64.powi(random.i32(-6..=6));
    let offset = [0.0, 0.0, 1e3, 1e5, 1e6][random.usize(..5)];
    let place = |x: &[Point]| -> Vec<Point> {
        x.iter()
            .map(|point| point.map(|x| scale * (x + offset)))
            .collect()
    };
    Scene {
        mesh,
        x0: single(&place(&x0)),
        x1: place(&x1),
    }
}

/// True if no pair of the step touches, in integers.
fn is_free(mesh: &TriangleMesh, x0: &[Point], x1: &[Point], options: &FreeStepOptions<'_>) -> bool {
    let scene = Scene {
        mesh: mesh.clone(),
        x0: x0.to_vec(),
        x1: x1.to_vec(),
    };
    let step = scene.step();
    let touches = |pair: Pair| {
        with_kind!(pair.kind(), K => {
            let query = step.query::<K>(pair.ids()).unwrap();
            query.exactly().collides(allowed::<K>(step, pair.ids(), &options.min_distance))
        })
    };
    !scene.pairs().pairs().any(touches)
}

#[test]
fn random_steps_to_rounded_positions_are_free() {
    let count = std::env::var("EXACT_CCD_STEPS").map_or(STEPS, |count| count.parse().unwrap());
    let mut random = Rng::with_seed(30);
    let (mut held, mut smaller, mut whole) = (0, 0, 0);
    for _ in 0..count {
        let Scene { mesh, x0, x1 } = scene(&mut random);
        let keep = [0.9, 1.0, 0.5][random.usize(..3)];
        let mut options = FreeStepOptions::default()
            .with_keep(keep)
            .with_precision(Precision::Single);
        if random.u8(..4) == 0 {
            let size = x0
                .as_flattened()
                .iter()
                .fold(0.0, |most: f64, x| most.max(x.abs()));
            options = options.with_min_distance(Separation::new(1e-7 * size).unwrap());
        }
        let mut detector = Detector::new(mesh.clone());
        let free = detector.free_step(&x0, &x1, &options).unwrap();
        assert!(is_single(&free.positions));
        if free.size > 0.0 {
            assert!(
                is_free(&mesh, &x0, &free.positions, &options),
                "size {}",
                free.size
            );
        } else {
            assert_eq!(free.positions, x0);
        }
        let largest = free
            .contact
            .map_or(1.0, |contact| keep * contact.impact.time.lower());
        assert!(free.size <= largest);
        held += usize::from(free.contact.is_some() && free.size > 0.0);
        smaller += usize::from(free.size < largest);
        whole += usize::from(free.size == 1.0);

        let steps = detector.free_steps(&x0, &x1, &[], &options).unwrap();
        assert!(is_single(&steps.positions));
        if steps.blocked.is_empty() {
            assert!(is_free(&mesh, &x0, &steps.positions, &options));
        } else {
            assert_eq!(free.size, 0.0);
        }
    }
    assert!(
        held > count / 20 && smaller > count / 50 && whole > count / 50,
        "{held} {smaller} {whole}"
    );
}

/// The gap is a quarter of the distance of two `f32` near 1: rounding closes it.
#[test]
fn rounding_alone_makes_contact() {
    let mesh = TriangleMesh::new(4, vec![[0, 1, 2]]).unwrap();
    let ulp = f64::from(f32::EPSILON);
    let x0 = [
        [0.0, 0.0, 1.0],
        [1.0, 0.0, 1.0],
        [0.0, 1.0, 1.0],
        [0.25, 0.25, 2.0],
    ];
    let mut x1 = x0;
    x1[3][2] = 1.0 + 0.25 * ulp;
    let mut detector = Detector::new(mesh);
    let double = detector.free_step(&x0, &x1, &FreeStepOptions::default()).unwrap();
    assert_eq!((double.size, double.contact), (1.0, None));
    let options = FreeStepOptions::default().with_precision(Precision::Single);
    let free = detector.free_step(&x0, &x1, &options).unwrap();
    assert_eq!(free.contact, None);
    // The next `f32` above the face is the nearest one of a height of at least half a unit more.
    assert!(free.size < 1.0 && free.size > 1.0 - 4.0 * ulp, "{}", free.size);
    assert_eq!(free.positions[3], [0.25, 0.25, 1.0 + ulp]);
    let steps = detector.free_steps(&x0, &x1, &[], &options).unwrap();
    assert!(steps.positions[3][2] > 1.0 && steps.blocked.is_empty());
}

#[test]
fn a_start_of_another_precision_is_an_error() {
    let mesh = TriangleMesh::new(2, Vec::new()).unwrap();
    let mut detector = Detector::new(mesh);
    let options = FreeStepOptions::default().with_precision(Precision::Single);
    let x0 = [[0.5; 3], [0.1, 0.0, 0.0]];
    let error = LineSearchError::Precision { vertex: 1 };
    assert_eq!(detector.free_step(&x0, &x0, &options).unwrap_err(), error);
    assert_eq!(detector.free_steps(&x0, &x0, &[], &options).unwrap_err(), error);
    assert!(
        error
            .to_string()
            .starts_with("vertex 1 at the start is not in single precision")
    );
}

/// Beyond the range of `f32`, a vertex stays in the range.
#[test]
fn positions_stay_in_the_range_of_single_precision() {
    let mesh = TriangleMesh::new(4, vec![[0, 1, 2]]).unwrap();
    let x0 = moved(&mut Rng::with_seed(31), &[[0.0; 3]; 4], 1.0);
    let x0 = single(&x0);
    let x1: Vec<Point> = x0.iter().map(|[x, y, _]| [*x, *y, 1e300]).collect();
    let options = FreeStepOptions::default().with_precision(Precision::Single);
    let free = Detector::new(mesh.clone()).free_step(&x0, &x1, &options).unwrap();
    assert!(is_single(&free.positions) && free.positions.as_flattened().iter().all(|x| x.is_finite()));
    assert!(free.size == 0.0 || is_free(&mesh, &x0, &free.positions, &options));
}
