//! The tests, once for each mutation.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::error::Error;
use std::fs::{self, File};
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::{Duration, Instant};

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

#[derive(Clone, PartialEq)]
enum Outcome {
    /// The name of a test that fails.
    Fails(String),
    /// The tests take longer than eight times their time, and two seconds more.
    NoEnd,
    Survives,
}

/// A test without a mutation may take this multiple of the time of a round.
const SLOWEST: f64 = 10.0;

/// The outcome of each mutation, and the time of its tests in seconds, as the round has it.
type Results<'a> = BTreeMap<&'a str, (Outcome, f64)>;

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
    }
    write(folder, &mutations, &lock(&results))
}

fn file_of(mutation: &str) -> &str {
    mutation.split(['\t', ':']).nth(1).unwrap_or_default()
}

/// The results of earlier runs, if there are any.
fn read<'a>(folder: &Path, mutations: &[&'a str]) -> Result<Results<'a>, Box<dyn Error>> {
    let path = folder.join("results.tsv");
    let text = if path.exists() {
        fs::read_to_string(path)?
    } else {
        String::new()
    };
    let places: HashMap<&str, &str> = mutations.iter().map(|mutation| (*mutation, *mutation)).collect();
    let mut results = Results::new();
    for line in text.lines() {
        let columns = line.splitn(3, '\t').collect::<Vec<_>>();
        let [outcome, seconds, mutation] = columns[..] else {
            return Err("results.tsv is damaged".into());
        };
        let mutation = places
            .get(mutation)
            .ok_or("results.tsv is of other mutations: remove it")?;
        let outcome = match outcome.strip_prefix("fails ") {
            Some(test) => Outcome::Fails(test.to_owned()),
            None if outcome == "no end" => Outcome::NoEnd,
            None => Outcome::Survives,
        };
        results.insert(mutation, (outcome, seconds.parse()?));
    }
    Ok(results)
}

/// Writes the results, and prints the number of each outcome by file.
fn write(folder: &Path, mutations: &[&str], results: &Results) -> Result<(), Box<dyn Error>> {
    let mut file = File::create(folder.join("results.tsv"))?;
    for (mutation, (outcome, seconds)) in results {
        match outcome {
            Outcome::Fails(test) => writeln!(file, "fails {test}\t{seconds}\t{mutation}")?,
            Outcome::NoEnd => writeln!(file, "no end\t{seconds}\t{mutation}")?,
            Outcome::Survives => writeln!(file, "survives\t{seconds}\t{mutation}")?,
        }
    }
    println!("| file | mutations | run | a test fails | no end | survive |\n|---|---:|---:|---:|---:|---:|");
    let files: BTreeSet<&str> = mutations.iter().map(|mutation| file_of(mutation)).collect();
    for name in files {
        let all = mutations
            .iter()
            .filter(|mutation| file_of(mutation) == name)
            .count();
        let of_file = || {
            results
                .iter()
                .filter(|(mutation, _)| file_of(mutation) == name)
                .map(|(_, (outcome, _))| outcome)
        };
        let count = |is: fn(&Outcome) -> bool| of_file().filter(|outcome| is(outcome)).count();
        println!(
            "| `{name}` | {all} | {} | {} | {} | {} |",
            of_file().count(),
            count(|outcome| matches!(outcome, Outcome::Fails(_))),
            count(|outcome| *outcome == Outcome::NoEnd),
            count(|outcome| *outcome == Outcome::Survives),
        );
    }
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

fn started(program: &Path, tests: &[&str], mutation: Option<&str>, place: &Path) -> std::io::Result<Child> {
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
fn watched(mut program: Child, limit: Duration) -> Result<Outcome, Box<dyn Error + Send + Sync>> {
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

fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
}
