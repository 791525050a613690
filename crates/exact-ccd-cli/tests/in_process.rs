//! The program as a function: a process calls it several times.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use std::path::Path;
use std::process::ExitCode;
use std::{fs, thread};

use tempfile::TempDir;

/// A tip that falls through a face, between two files.
fn fall() -> TempDir {
    let folder = TempDir::new().unwrap();
    for (name, height) in [("start.obj", 1.0), ("end.obj", -1.0)] {
        let mesh = format!("v 0 0 0\nv 8 0 0\nv 0 8 0\nv 1 1 {height}\nv 1 2 9\nv 2 1 9\nf 1 2 3\nf 4 5 6\n");
        fs::write(folder.path().join(name), mesh).unwrap();
    }
    folder
}

/// Writes the contacts of the fall to a file, on this many threads; returns the exit status.
fn step(folder: &Path, threads: &str, contacts: &str) -> ExitCode {
    let file = |name: &str| folder.join(name).into_os_string();
    exact_ccd_cli::main([
        "exact-ccd".into(),
        "--threads".into(),
        threads.into(),
        "step".into(),
        file("start.obj"),
        file("end.obj"),
        "--all".into(),
        file(contacts),
    ])
}

#[test]
fn a_process_runs_the_program_again_with_another_number_of_threads() {
    let folder = fall();
    let folder = folder.path();
    let contact = ExitCode::from(1);
    for (threads, contacts) in [("1", "one.csv"), ("3", "three.csv"), ("2", "two.csv")] {
        assert_eq!(step(folder, threads, contacts), contact, "{threads} threads");
    }
    // At the same time.
    thread::scope(|scope| {
        let runs = [("2", "four.csv"), ("1", "five.csv")]
            .map(|(threads, contacts)| scope.spawn(move || step(folder, threads, contacts)));
        for run in runs {
            assert_eq!(run.join().unwrap(), contact);
        }
    });
    let read = |name: &str| fs::read_to_string(folder.join(name)).unwrap();
    let first = read("one.csv");
    assert!(first.lines().count() > 1, "{first}");
    for name in ["two.csv", "three.csv", "four.csv", "five.csv"] {
        assert_eq!(read(name), first, "{name}");
    }
}
