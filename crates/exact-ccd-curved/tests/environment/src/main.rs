//! A program for x86-64 Linux that uses meshes, curves and half spaces on threads in all floating-point
//! environments, and compares the answers with those in the default one.
//!
//! It runs itself once for each environment of the threads of rayon, which a process sets once, and once with
//! threads in different ones. The status is 0 if all answers are equal.

mod control;
mod curves;
mod meshes;
mod random;

use std::hint::black_box;
use std::process::{Command, ExitCode};

use control::{ENVIRONMENTS, set};
use exact_ccd_curved::Trajectory;
use exact_ccd_mesh::{HalfSpace, Separation, Welding};
use meshes::Scene;
use random::Random;

/// The argument for threads in different environments.
const MIXED: usize = ENVIRONMENTS.len();

/// The number of threads.
const THREADS: usize = 4;

fn main() -> ExitCode {
    match std::env::args().nth(1) {
        Some(of_threads) => check(of_threads.parse().expect("an index of an environment")),
        None => {
            let program = std::env::current_exe().expect("the program has a path");
            let failed = (0..=MIXED).filter(|index| {
                let status = Command::new(&program).arg(index.to_string()).status();
                !status.expect("the program runs").success()
            });
            ExitCode::from(failed.count() as u8)
        }
    }
}

/// Checks the answers with the threads of rayon in an environment: with the main thread in the default one,
/// and with the main thread in the same one.
fn check(of_threads: usize) -> ExitCode {
    let scenes = Scene::all();
    let default = rayon::ThreadPoolBuilder::new().num_threads(THREADS).build();
    let default = default.expect("threads can be made");
    let expected = default.install(|| scenes.each_ref().map(Scene::contacts));
    let curved = default.install(|| (curves::step(), curves::points()));
    let sides = sides();
    let environment = move |thread: usize| match of_threads {
        MIXED => ENVIRONMENTS[1 + thread],
        index => ENVIRONMENTS[index],
    };
    rayon::ThreadPoolBuilder::new()
        .num_threads(THREADS)
        .start_handler(move |thread| set(environment(thread)))
        .build_global()
        .expect("the threads are made once");

    let mut wrong = 0;
    let mut expect = |is_right: bool, what: &str| {
        if !is_right {
            eprintln!("threads in environment {of_threads}: {what}");
            wrong += 1;
        }
    };
    for of_main in [0, ENVIRONMENTS[of_threads % MIXED]] {
        set(of_main);
        let contacts = scenes.each_ref().map(Scene::contacts);
        let steps = (curves::step(), curves::points());
        let here = self::sides();
        let curve = curves::curve();
        let (constant, turning) = curves::subnormal();
        let low = meshes::low_step();
        let welded = welded();
        set(0);
        let is_free = low.is_some_and(|positions| default.install(|| meshes::is_free(&positions)));
        expect(is_free, "free step");
        for ((scene, contacts), expected) in scenes.iter().zip(&contacts).zip(&expected) {
            for (index, (contacts, expected)) in contacts.iter().zip(expected).enumerate() {
                let what = format!(
                    "main {of_main:x}, {}, list {index}: {} contacts, expected {}",
                    scene.name(),
                    contacts.len(),
                    expected.len()
                );
                expect(contacts == expected && !expected.is_empty(), &what);
            }
        }
        let is_default = of_main == 0;
        let refused = |is_default: bool, answer: Result<u64, ()>| if is_default { answer } else { Err(()) };
        let step = refused(is_default && of_threads == 0, curved.0);
        expect(curved.0.is_ok() && steps.0 == step, "curved step");
        expect(steps.1 == refused(is_default, curved.1), "curved motion");
        let is_known = curves::deviation(&curve).is_finite();
        expect(is_known == is_default, "deviation of a curve");
        let errors = [constant.at(0.5).error, turning.at(0.5).error];
        expect(errors.map(f64::is_finite) == [is_default; 2], "subnormal curves");
        expect(here == sides, "half space");
        expect(welded == [0, 1, 2], "welding");
    }
    ExitCode::from(u8::from(wrong > 0))
}

/// The sides of points near planes: points at a boundary through subnormal numbers, and random ones.
fn sides() -> Vec<bool> {
    let m = f64::MIN_POSITIVE;
    let [a, b, c] = [5.75, 3.0625, 3.0625].map(|x| black_box(x) * m);
    let mut sides = vec![HalfSpace::new([4.0 * m; 3], [1.0; 3]).is_apart([a, b, c], Separation::ZERO)];
    let mut random = Random(4);
    for _ in 0..2000 {
        let [x, y, z] = [0; 3].map(|_| random.integer(1 << 20));
        let unit = f64::from_bits((1023 - random.bits() % 1022) << 52);
        let point = [x, y, z].map(|x| x * unit);
        let normal = [y + z, z - x, -x - y].map(|n| n * 0.5);
        sides.push(HalfSpace::new([0.0; 3], normal).is_apart(point, Separation::ZERO));
    }
    sides
}

/// The first vertices after welding of two subnormal numbers and both zeros.
fn welded() -> Vec<usize> {
    let mut welding = Welding::default();
    welding.restrict(&[1, 2, 0, 1 << 63].map(|bits| [black_box(f64::from_bits(bits)), 0.0, 0.0]));
    welding.first_vertices().to_vec()
}
