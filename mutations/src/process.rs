//! A test program that runs, until its first failure or for a limited time.

use std::error::Error;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use crate::results::Outcome;

/// Starts some tests of a program, with a mutation or none.
pub fn started(
    program: &Path,
    tests: &[&str],
    mutation: Option<&str>,
    place: &Path,
) -> std::io::Result<Child> {
    let mut command = Command::new(program);
    command
        .arg("--exact")
        .args(tests)
        .current_dir(place)
        .stdout(Stdio::piped())
        .stderr(Stdio::null());
    command.envs([
        ("RUST_TEST_THREADS", "1"),
        ("RAYON_NUM_THREADS", "1"),
        ("PROPTEST_RNG_SEED", "0"),
    ]);
    command.envs(mutation.map(|number| ("EXACT_CCD_MUTATION", number)));
    command.spawn()
}

/// Waits for the first failure of a test program, or for its end.
pub fn watched(mut program: Child, limit: Duration) -> Result<Outcome, Box<dyn Error + Send + Sync>> {
    let output = program.stdout.take().ok_or("the output is a pipe")?;
    let (program, end) = (Mutex::new(program), Instant::now() + limit);
    let (ended, late) = (AtomicBool::new(false), AtomicBool::new(false));
    let failure = std::thread::scope(|threads| {
        let watch = threads.spawn(|| {
            while !ended.load(Ordering::Relaxed) {
                let left = end.saturating_duration_since(Instant::now());
                if left.is_zero() {
                    late.store(true, Ordering::Relaxed);
                    // A program that has ended by itself cannot be killed.
                    let _ = lock(&program).kill();
                    return;
                }
                std::thread::park_timeout(left);
            }
        });
        let mut begun = None;
        let mut failure = None;
        for line in BufReader::new(output).lines().map_while(Result::ok) {
            if let Some(name) = line.strip_suffix(" ... FAILED") {
                failure = Some(name.trim_start_matches("test ").to_owned());
                let _ = lock(&program).kill();
                break;
            }
            begun = line.split_whitespace().nth(1).map(str::to_owned);
        }
        ended.store(true, Ordering::Relaxed);
        watch.thread().unpark();
        (failure, begun)
    });
    let status = program
        .into_inner()
        .unwrap_or_else(std::sync::PoisonError::into_inner)
        .wait()?;
    Ok(match failure {
        (Some(test), _) => Outcome::Fails(test),
        _ if late.into_inner() => Outcome::NoEnd,
        (None, begun) if !status.success() => Outcome::Fails(format!("after {}", begun.unwrap_or_default())),
        _ => Outcome::Survives,
    })
}

pub fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
}
