//! Audits that are killed and go on, and audits in parts: their reports are the report of one process.

use std::fs;
use std::process::{Child, Stdio};
use std::thread;
use std::time::Duration;

use exact_ccd_mesh::Frame;

use crate::folder::{Folder, Run};
use crate::meshes::{ply, tip_above_square};

const AUDIT: &[&str] = &["audit", "frames", "--no-seconds"];

/// The number of frames.
const FRAMES: usize = 24;

/// Two bodies: a flat square, and a wavy sheet that turns and falls through it. Most steps have contacts.
fn frame(number: usize) -> Frame {
    let side = 24;
    let mut positions = vec![
        [-9.0, -9.0, 0.0],
        [9.0, -9.0, 0.0],
        [-9.0, 9.0, 0.0],
        [9.0, 9.0, 0.0],
    ];
    let mut faces = vec![[0, 1, 2], [2, 1, 3]];
    let (height, angle) = (3.0 - 0.25 * number as f64, 0.3 * number as f64);
    let (sine, cosine) = angle.sin_cos();
    for vertex in 0..side * side {
        let [x, y] = [vertex % side, vertex / side].map(|k| 0.25 * f64::from(k) - 3.0);
        positions.push([
            cosine * x - sine * y,
            sine * x + cosine * y,
            height + 0.1 * (7.0 * x).sin(),
        ]);
    }
    for square in (0..side * side).filter(|v| v % side + 1 < side && v / side + 1 < side) {
        let corner = 4 + square as u32;
        let row = side as u32;
        faces.push([corner, corner + 1, corner + row]);
        faces.push([corner + row, corner + 1, corner + row + 1]);
    }
    Frame::new(positions, faces).unwrap()
}

/// A folder with frames, whose vertices are named as two bodies.
fn recording() -> Folder {
    let folder = Folder::new();
    fs::create_dir(folder.path("frames")).unwrap();
    for number in 0..FRAMES {
        let frame = frame(number);
        let end = frame.positions.len();
        let parts = format!("ply\ncomment part 0 4 floor\ncomment part 4 {end} sheet\n");
        let bytes = ply(&frame);
        let named = [parts.as_bytes(), bytes.strip_prefix(b"ply\n").unwrap()].concat();
        folder.write(&format!("frames/{number}.ply"), named);
    }
    folder
}

/// The report and the list of an audit of all violations in one process.
fn expected(folder: &Folder) -> (Run, String) {
    let run = folder.run(&[AUDIT, &["--all", "whole.jsonl"]].concat());
    assert_eq!(run.status, 1, "{}", run.stderr);
    (run, folder.read("whole.jsonl"))
}

fn with_results<'a>(list: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    [AUDIT, &["--all", list, "--results", "results"], more].concat()
}

/// The number of whole lines in the file of results.
fn lines(folder: &Folder) -> usize {
    let file = fs::read(folder.path("results/part-1-of-1.jsonl")).unwrap_or_default();
    file.iter().filter(|&&byte| byte == b'\n').count()
}

/// Kills the process, as `kill -9` does, once there are so many lines. Returns false if it ended before.
fn kill_after(folder: &Folder, mut process: Child, count: usize) -> bool {
    while lines(folder) < count {
        if process.try_wait().unwrap().is_some() {
            return false;
        }
        thread::sleep(Duration::from_micros(200));
    }
    process.kill().unwrap();
    process.wait().unwrap().code().is_none()
}

#[test]
fn a_killed_audit_goes_on_to_the_same_report() {
    let folder = recording();
    let (whole, list) = expected(&folder);
    let mut killed = 0;
    for count in [1, 2, 3, 6, 11, 17, 22] {
        let arguments = with_results("list.jsonl", &[]);
        let process = folder
            .program(&arguments)
            .stderr(Stdio::null())
            .stdout(Stdio::null())
            .spawn();
        killed += usize::from(kill_after(&folder, process.unwrap(), count));
        assert!(!folder.path("list.jsonl").exists() || killed < 7);
    }
    assert!(killed >= 3, "{killed}");
    let run = folder.run(&with_results("list.jsonl", &[]));
    assert_eq!(run, whole);
    assert_eq!(folder.read("list.jsonl"), list);
    assert_eq!(lines(&folder), 1 + FRAMES);
    // Nothing is examined once more.
    assert_eq!(folder.run(&with_results("list.jsonl", &[])), whole);
    assert_eq!(lines(&folder), 1 + FRAMES);
}

#[test]
fn an_unfinished_line_is_examined_again() {
    let folder = recording();
    let (whole, list) = expected(&folder);
    folder.run(&with_results("list.jsonl", &[]));
    let file = "results/part-1-of-1.jsonl";
    let results = folder.read(file);
    let first = results.find('\n').unwrap() + 1;
    for length in [
        0,
        first - 1,
        first,
        first + 9,
        results.len() / 2,
        results.len() - 1,
    ] {
        folder.write(file, &results[..length]);
        assert_eq!(folder.run(&with_results("list.jsonl", &[])), whole, "{length}");
        assert_eq!(folder.read("list.jsonl"), list);
        assert_eq!(folder.read(file), results);
    }
    // So is a line that the system has lost, and all lines after it.
    let half = results.len() / 2;
    let damaged = [
        &results.as_bytes()[..half],
        &[0; 64],
        &results.as_bytes()[half + 64..],
    ]
    .concat();
    folder.write(file, damaged);
    assert_eq!(folder.run(&with_results("list.jsonl", &[])), whole);
    assert_eq!(folder.read(file), results);
}

#[test]
fn parts_have_the_report_of_one_process() {
    let folder = recording();
    let (whole, list) = expected(&folder);
    for count in [1, 3, 5] {
        fs::remove_dir_all(folder.path("results")).ok();
        let share = |number: usize| format!("--part={number}/{count}");
        let shares: Vec<String> = (1..=count).map(share).collect();
        let start = |share: &String| {
            let arguments = with_results("part.jsonl", &[]);
            let command = folder
                .program(&[&arguments[..], &[share.as_str()]].concat())
                .stdout(Stdio::piped())
                .spawn();
            command.unwrap().wait_with_output().unwrap()
        };
        let ends: Vec<Run> = thread::scope(|scope| {
            let runs: Vec<_> = shares
                .iter()
                .map(|share| scope.spawn(|| Run::from(start(share))))
                .collect();
            runs.into_iter().map(|run| run.join().unwrap()).collect()
        });
        for (number, run) in (1..).zip(&ends) {
            let line = format!("part {number} of {count}: ");
            assert!(run.stdout.starts_with(&line), "{} {}", run.stdout, run.stderr);
        }
        let arguments = with_results("list.jsonl", &[]);
        let merge = [&["merge"], &arguments[1..]].concat();
        assert_eq!(folder.run(&merge), whole);
        assert_eq!(folder.read("list.jsonl"), list);
    }
    // Without a part, the merge names its first frame; an audit examines the rest.
    fs::remove_file(folder.path("results/part-3-of-5.jsonl")).unwrap();
    let arguments = with_results("list.jsonl", &[]);
    let run = folder.run(&[&["merge"], &arguments[1..]].concat());
    let message = "results: no result of frame 9 (frames/9.ply): run the parts to their ends, or \
                   `exact-ccd audit --results` for the rest";
    assert!(run.status == 2 && run.stderr.contains(message), "{}", run.stderr);
    assert_eq!(folder.run(&arguments), whole);
}

/// Without `--all`, each part ends with its first violation, and the report with the first one of all.
#[test]
fn the_first_violation_of_all_parts_is_reported() {
    let folder = Folder::new();
    fs::create_dir(folder.path("frames")).unwrap();
    for (number, height) in [3.0, 1.0, 2.0, -2.0, 5.0, 4.0, -1.0, 1.0].into_iter().enumerate() {
        folder.write(&format!("frames/{number}.ply"), ply(&tip_above_square(height)));
    }
    let whole = folder.run(AUDIT);
    assert!(
        whole
            .stdout
            .contains("between frame 2 (frames/2.ply) and frame 3"),
        "{}",
        whole.stdout
    );
    for number in 1..=3 {
        let share = format!("{number}/3");
        let run = folder.run(&[AUDIT, &["--results", "results", "--part", &share]].concat());
        assert_eq!(run.status, i32::from(number > 1), "{}", run.stderr);
    }
    let merge = folder.run(&["merge", "frames", "--no-seconds", "--results", "results"]);
    assert_eq!(merge, whole);
}

#[test]
fn results_of_another_audit_are_refused() {
    let folder = recording();
    let results = ["--results", "results"];
    folder.run(&[AUDIT, &results].concat());
    let refused = |arguments: &[&str]| {
        let run = folder.run(arguments);
        let message = "results of other frames, of other options or of another version: name another folder";
        assert!(
            run.status == 2 && run.stderr.contains(message),
            "{arguments:?} {}",
            run.stderr
        );
    };
    refused(&[AUDIT, &results, &["--min-distance", "0.5"]].concat());
    refused(&[AUDIT, &results, &["--all", "list.csv"]].concat());
    refused(&[AUDIT, &results, &["--ignore", "floor:sheet"]].concat());
    refused(&[
        "merge",
        "frames",
        "--no-seconds",
        "--results",
        "results",
        "--half-space",
        "0,0,-9,0,0,1",
    ]);
    folder.write("frames/5.ply", ply(&frame(0)));
    refused(&[AUDIT, &results].concat());
}

#[test]
fn wrong_arguments_of_parts_are_errors() {
    let folder = recording();
    for (arguments, message) in [
        (&["audit", "frames", "--part", "1/2"][..], "--results"),
        (
            &["audit", "frames", "--results", "results", "--part", "3/2"],
            "expected a part of several",
        ),
        (
            &["audit", "frames", "--results", "results", "--view", "page.html"],
            "cannot be used with",
        ),
        (&["merge", "frames"], "expected --results DIR"),
        (
            &["merge", "frames", "--results", "results"],
            "results: no result of frame 0 (frames/0.ply)",
        ),
    ] {
        let run = folder.run(arguments);
        assert!(run.status == 2 && run.stderr.contains(message), "{}", run.stderr);
    }
}

#[test]
fn the_violations_of_each_pair_of_bodies_are_counted() {
    let folder = recording();
    let (whole, list) = expected(&folder);
    let count = list.lines().count();
    let line = format!("\n  floor and sheet: {count}, the first after frame ");
    assert!(whole.stdout.contains(&line), "{}", whole.stdout);
}
