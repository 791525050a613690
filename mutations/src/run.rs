//! The tests, once for each mutation.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use crate::process::{lock, started, watched};
use crate::results::{Outcome, file_of, print_table, read, write};

/// The choice of tests and mutations.
pub struct Limits {
    /// The number of mutations that run at a time.
    pub threads: usize,
    /// The time of all tests of a mutation in the first round; each following round has four times as much.
    pub seconds: f64,
    /// The time after which no mutation begins.
    pub end: Instant,
    /// The seed of the order.
    pub seed: u64,
    /// The beginnings of the names of the files whose mutations come first.
    pub first: Vec<String>,
}

/// A test that no mutation has changed, with its time.
struct Test {
    program: PathBuf,
    name: String,
    time: Duration,
}

/// A test without a mutation may take this multiple of the time of a round.
const SLOWEST: f64 = 10.0;

/// Runs the mutations of `folder`, continues `results.tsv` there, and prints a table.
pub fn run(package: &str, folder: &Path, limits: &Limits) -> Result<(), Box<dyn Error>> {
    let folder = &folder.canonicalize()?;
    let place = &folder.join("tree").join("crates").join(package);
    let list = fs::read_to_string(folder.join("mutations.tsv"))?;
    let mut mutations: Vec<&str> = list.lines().collect();
    fastrand::Rng::with_seed(limits.seed).shuffle(&mut mutations);
    let is_first = |mutation: &str| {
        limits
            .first
            .iter()
            .any(|name| file_of(mutation).starts_with(name))
    };
    mutations.sort_by_key(|mutation| !is_first(mutation));

    let results = Mutex::new(read(folder, &mutations)?);
    let mut tests = timed(folder, place, limits)?;
    tests.sort_by_key(|test| test.time);
    let mut spent = 0.0;
    let ends: Vec<f64> = tests
        .iter()
        .map(|test| {
            spent += test.time.as_secs_f64();
            spent
        })
        .collect();
    let (mut used, mut seconds) = (0, limits.seconds);
    while used < tests.len() && Instant::now() < limits.end {
        let end = ends.partition_point(|&end| end <= seconds);
        let round = &tests[used..end];
        let known = lock(&results).clone();
        let is_left = |mutation: &&&str| match known.get(**mutation) {
            Some((outcome, time)) => *outcome == Outcome::Survives && *time < seconds,
            None => true,
        };
        let left: Vec<&str> = mutations.iter().filter(is_left).copied().collect();
        let (count, next) = (left.len(), AtomicUsize::new(0));
        eprintln!(
            "{count} mutations, {} tests of up to {seconds} s in all",
            round.len()
        );
        each(limits.threads, || {
            while Instant::now() < limits.end {
                let index = next.fetch_add(1, Ordering::Relaxed);
                let Some(mutation) = left.get(index) else { break };
                if index > 0 && index % 100 == 0 {
                    eprintln!("  {index} of {count}");
                }
                let Some(outcome) = tested(mutation, round, place, limits.end)? else {
                    break;
                };
                lock(&results).insert(*mutation, (outcome, seconds));
            }
            Ok(())
        })?;
        used = end;
        seconds *= 4.0;
        write(folder, &lock(&results))?;
    }
    print_table(&mutations, &lock(&results));
    Ok(())
}

/// All tests but the slowest, with the time of each. A test that fails without a mutation is an error.
fn timed(folder: &Path, place: &Path, limits: &Limits) -> Result<Vec<Test>, Box<dyn Error>> {
    let mut tests = Vec::new();
    for program in fs::read_dir(folder.join("programs"))? {
        let program = program?.path();
        let listed = Command::new(&program)
            .args(["--list", "--format", "terse"])
            .current_dir(place)
            .output()?;
        for line in String::from_utf8(listed.stdout)?.lines() {
            if let Some(name) = line.strip_suffix(": test") {
                tests.push(Test {
                    program: program.clone(),
                    name: name.to_owned(),
                    time: Duration::ZERO,
                });
            }
        }
    }
    eprintln!("{} tests without mutations", tests.len());
    let (next, done) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    each(limits.threads, || {
        while let Some(test) = tests.get(next.fetch_add(1, Ordering::Relaxed)) {
            let began = Instant::now();
            let limit = Duration::from_secs_f64(SLOWEST * limits.seconds);
            match watched(started(&test.program, &[&test.name], None, place)?, limit)? {
                Outcome::Survives => {
                    let time = began.elapsed();
                    lock(&done).push(Test {
                        program: test.program.clone(),
                        name: test.name.clone(),
                        time,
                    });
                }
                Outcome::NoEnd => eprintln!("{} takes longer than {limit:?}, and is left out", test.name),
                Outcome::Fails(_) => return Err(format!("{} fails without a mutation", test.name).into()),
            }
        }
        Ok(())
    })?;
    Ok(done.into_inner().unwrap_or_default())
}

/// The outcome of a mutation; none if it is not known at the end.
fn tested(
    mutation: &str,
    tests: &[Test],
    place: &Path,
    end: Instant,
) -> Result<Option<Outcome>, Box<dyn Error + Send + Sync>> {
    let number = mutation.split('\t').next();
    let mut programs: Vec<(&Path, Vec<&str>, Duration)> = Vec::new();
    for test in tests {
        match programs.iter_mut().find(|(program, ..)| *program == test.program) {
            Some((_, names, time)) => {
                names.push(&test.name);
                *time += test.time;
            }
            None => programs.push((&test.program, vec![&test.name], test.time)),
        }
    }
    for (program, names, time) in programs {
        let limit = 8 * time + Duration::from_secs(2);
        let left = end.saturating_duration_since(Instant::now());
        match watched(started(program, &names, number, place)?, limit.min(left))? {
            Outcome::Survives => {}
            Outcome::NoEnd if left < limit => return Ok(None),
            outcome => return Ok(Some(outcome)),
        }
    }
    Ok(Some(Outcome::Survives))
}

/// Calls a function on each of several threads.
fn each(
    threads: usize,
    work: impl Fn() -> Result<(), Box<dyn Error + Send + Sync>> + Sync,
) -> Result<(), Box<dyn Error>> {
    std::thread::scope(|scope| {
        let running: Vec<_> = (0..threads).map(|_| scope.spawn(&work)).collect();
        running.into_iter().try_for_each(|thread| {
            thread
                .join()
                .map_err(|_| "a thread panicked")?
                .map_err(|e| e.to_string())
        })
    })?;
    Ok(())
}
