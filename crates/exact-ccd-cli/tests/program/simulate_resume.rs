//! Interrupted and resumed simulations.

use std::collections::BTreeMap;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::Stdio;

use crate::folder::Folder;
use crate::simulate::folder;

/// The contents of all files in a folder and its subfolders, by name. The statistics are without the run
/// times, which are the last five columns.
fn files(folder: &Folder, name: &str) -> BTreeMap<String, Vec<u8>> {
    fn collect(folder: &Path, prefix: &str, files: &mut BTreeMap<String, Vec<u8>>) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = format!("{prefix}{}", path.file_name().unwrap().to_str().unwrap());
            if path.is_dir() {
                collect(&path, &format!("{name}/"), files);
            } else {
                files.insert(name, fs::read(path).unwrap());
            }
        }
    }
    let mut files = BTreeMap::new();
    collect(&folder.path(name), "", &mut files);
    let statistics = files.get_mut("statistics.csv").unwrap();
    let text = String::from_utf8(std::mem::take(statistics)).unwrap();
    for line in text.lines() {
        statistics.extend(line.rsplitn(6, ',').last().unwrap().bytes());
        statistics.push(b'\n');
    }
    files
}

#[track_caller]
fn assert_same(folder: &Folder, found: &str, expected: &str) {
    let (found, expected) = (files(folder, found), files(folder, expected));
    assert_eq!(
        found.keys().collect::<Vec<_>>(),
        expected.keys().collect::<Vec<_>>()
    );
    for (name, contents) in &expected {
        assert!(found[name] == *contents, "{name}");
    }
}

/// The arguments for all results of `scene.toml` except pictures.
fn arguments<'a>(out: &'a str, queries: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    let all = [
        "simulate",
        "scene.toml",
        "--out",
        out,
        "--path",
        "--dump-queries",
        queries,
    ];
    [all.as_slice(), more].concat()
}

/// Starts the program, and kills it after a number of time steps.
fn kill_after(folder: &Folder, arguments: &[&str], steps: usize) {
    let mut program = folder.program(arguments).stdout(Stdio::piped()).spawn().unwrap();
    let mut output = BufReader::new(program.stdout.take().unwrap());
    // The program prints one line for the scene and one for each time step.
    for _ in 0..=steps {
        output.read_line(&mut String::new()).unwrap();
    }
    program.kill().unwrap();
    program.wait().unwrap();
}

#[test]
fn a_killed_and_resumed_simulation_has_the_same_bytes() {
    let folder = folder();
    let run = folder.run(&arguments("whole", "whole/queries", &["--threads", "1"]));
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    for threads in ["1", "2"] {
        for steps in [1, 4, 5, 9] {
            let out = format!("{threads}-{steps}");
            let queries = format!("{out}/queries");
            let threads = ["--threads", threads];
            kill_after(&folder, &arguments(&out, &queries, &threads), steps);
            // All files of the collection exist at any time.
            let frames = exact_ccd_files::read_pvd(folder.path(&format!("{out}/motion.pvd"))).unwrap();
            assert!(frames.len() > steps && frames.iter().all(|(_, file)| file.is_file()));

            let resume = ["--resume", threads[0], threads[1]];
            let run = folder.run(&arguments(&out, &queries, &resume));
            assert_eq!((run.status, run.stderr.as_str()), (0, ""));
            assert_same(&folder, &out, "whole");
        }
    }
}

#[test]
fn a_simulation_can_be_killed_repeatedly() {
    let folder = folder();
    assert_eq!(folder.run(&arguments("whole", "whole/queries", &[])).status, 0);
    kill_after(&folder, &arguments("parts", "parts/queries", &[]), 1);
    for _ in 0..4 {
        kill_after(&folder, &arguments("parts", "parts/queries", &["--resume"]), 2);
    }
    let run = folder.run(&arguments("parts", "parts/queries", &["--resume"]));
    assert_eq!(run.status, 0);
    assert_same(&folder, "parts", "whole");
}

#[test]
fn files_later_than_the_checkpoint_are_removed() {
    let folder = folder();
    for out in ["whole", "parts"] {
        let queries = format!("{out}/queries");
        let run = folder.run(&arguments(out, &queries, &["--steps", "4"]));
        assert_eq!(run.status, 0);
    }
    // A run can end at any point of a time step. Here it ends after the frames, in the middle of a row.
    for later in [
        "frames/000005.ply",
        "vtu/000005.vtu",
        "vtu/.000005.vtu.4711",
        "path/000005-000.ply",
        "path/000005-001.ply",
        "queries/edge-edge/000005.csv",
        ".checkpoint.json.4711",
        "motion.pvd",
    ] {
        folder.write(&format!("parts/{later}"), "later");
    }
    let statistics = folder.read("parts/statistics.csv");
    folder.write("parts/statistics.csv", statistics + "5,0.1,tru");
    let run = folder.run(&arguments(
        "parts",
        "parts/queries",
        &["--steps", "4", "--resume"],
    ));
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    assert_same(&folder, "parts", "whole");
}

#[test]
fn overwriting_replaces_an_earlier_simulation() {
    let folder = folder();
    let runs: [(&str, &[&str]); 3] = [
        ("whole", &["--steps", "3"]),
        ("again", &["--steps", "6", "--render"]),
        ("again", &["--steps", "3", "--overwrite"]),
    ];
    for (out, more) in runs {
        let queries = format!("{out}/queries");
        let run = folder.run(&arguments(out, &queries, more));
        assert_eq!(run.status, 0);
    }
    assert_same(&folder, "again", "whole");
    // Files of other origin stay.
    folder.write("again/frames/notes.txt", "mine");
    folder.write("again/.notes.7", "mine");
    let run = folder.run(&arguments(
        "again",
        "again/queries",
        &["--steps", "1", "--overwrite"],
    ));
    assert_eq!(run.status, 0);
    assert_eq!(folder.read("again/frames/notes.txt"), "mine");
    assert_eq!(folder.read("again/.notes.7"), "mine");
}

#[test]
fn a_broken_row_is_an_error() {
    let folder = folder();
    let simulate = |more: &[&str]| folder.run(&arguments("result", "result/queries", more));
    assert_eq!(simulate(&["--steps", "2"]).status, 0);
    let statistics = folder.read("result/statistics.csv");
    let broken = statistics.replacen("\n2,", "\ntwo,", 1);
    folder.write("result/statistics.csv", broken);
    let run = simulate(&["--resume"]);
    assert!(
        run.error()
            .starts_with("result/statistics.csv: CSV deserialize error: record 2 (line: 3, "),
        "{run:?}"
    );
}
