//! Interrupted and resumed simulations.

use std::collections::BTreeMap;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};

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
        "--output",
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

/// A path goes on with or without --path, and has no gap.
#[test]
fn a_path_is_continued() {
    let folder = folder();
    let simulate = |out: &str, more: &[&str]| {
        folder.run(&[&["simulate", "scene.toml", "--output", out][..], more].concat())
    };
    let names = || {
        let files = files(&folder, "parts").into_keys();
        files.filter(|name| name.starts_with("path/")).collect::<Vec<_>>()
    };
    assert_eq!(simulate("whole", &["--path", "--steps", "4"]).status, 0);
    assert_eq!(simulate("parts", &["--path", "--steps", "2"]).status, 0);
    let run = simulate("parts", &["--resume", "--steps", "4"]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{run:?}");
    assert_same(&folder, "parts", "whole");

    // A time step of the path that is missing, as after a run of another version.
    for name in names().iter().filter(|name| name.starts_with("path/000003-")) {
        fs::remove_file(folder.path(&format!("parts/{name}"))).unwrap();
    }
    assert_eq!(
        simulate("parts", &["--resume"]).error(),
        "parts/path: the checkpoint has time step 4, but the path has none of the files of time step 3: restore \
         them, or remove this folder to continue without the path"
    );
    fs::remove_dir_all(folder.path("parts/path")).unwrap();
    assert_eq!(simulate("parts", &["--resume", "--steps", "5"]).status, 0);
    assert_eq!(names(), [""; 0]);
    // A path may begin later.
    assert_eq!(
        simulate("parts", &["--resume", "--steps", "6", "--path"]).status,
        0
    );
    assert_eq!(names()[0], "path/000006-000.ply");
    assert_eq!(simulate("parts", &["--overwrite", "--steps", "1"]).status, 0);
    assert!(!folder.path("parts/path").exists());
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

/// Ctrl-C drops the time step in progress, saves the last complete one, and prints the command that continues
/// the run.
#[cfg(target_os = "linux")]
#[test]
fn an_interrupted_simulation_says_how_to_continue() {
    let folder = folder();
    let run = folder.run(&[
        "simulate",
        "scene.toml",
        "--output",
        "whole",
        "--path",
        "--threads",
        "1",
    ]);
    assert_eq!(run.status, 0, "{run:?}");
    let long = ["simulate", "scene.toml", "--threads", "1", "--steps", "20000"];
    let interrupt = |more: &[&str]| {
        // Background jobs of scripts ignore SIGINT, and so does a test that runs in one.
        let mut program = Command::new("env");
        program.args(["--default-signal=INT", env!("CARGO_BIN_EXE_exact-ccd")]);
        program.args(long).args(more).current_dir(folder.path(""));
        let mut child = program
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut output = BufReader::new(child.stdout.take().unwrap());
        // The line of the scene, and one for each of two time steps.
        for _ in 0..3 {
            output.read_line(&mut String::new()).unwrap();
        }
        let pid = child.id().to_string();
        let sent = Command::new("sh")
            .args(["-c", &format!("kill -INT {pid}")])
            .status();
        assert!(sent.unwrap().success());
        // The pipe must not fill up.
        std::io::copy(&mut output, &mut std::io::sink()).unwrap();
        let ended = child.wait_with_output().unwrap();
        assert_eq!(ended.status.code(), Some(130));
        String::from_utf8(ended.stderr).unwrap()
    };
    let nothing = interrupt(&[]);
    assert!(
        nothing.ends_with("; without --output, the run cannot be continued\n"),
        "{nothing}"
    );

    let message = interrupt(&["--path", "--output", "a result", "--overwrite"]);
    let (first, command) = message.trim_end().split_once('\n').unwrap();
    let step: u64 = first
        .strip_prefix("exact-ccd: interrupted after time step ")
        .and_then(|rest| rest.strip_suffix(", which is saved; this command continues the run:"))
        .unwrap()
        .parse()
        .unwrap();
    assert!(step >= 2, "{message}");
    assert!(
        command.ends_with(&format!(
            " {} --path --output 'a result' --resume",
            long.join(" ")
        )),
        "{command}"
    );
    let rows = fs::read_to_string(folder.path("a result/statistics.csv")).unwrap();
    assert_eq!(rows.lines().count() as u64, step + 1);
    assert!(folder.path(&format!("a result/vtu/{step:06}.vtu")).is_file());
    // The path has no part of the time step that was dropped, and the run continues after the last one.
    for file in fs::read_dir(folder.path("a result/path")).unwrap() {
        let name = file.unwrap().file_name().into_string().unwrap();
        assert!(name[..6].parse::<u64>().unwrap() <= step, "{name}");
    }
    let last = (step + 1).max(12).to_string();
    let resume = [
        "simulate",
        "scene.toml",
        "--output",
        "a result",
        "--path",
        "--resume",
        "--steps",
        &last,
    ];
    let run = folder.run(&resume);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{run:?}");
    for step in 0..=10 {
        let frame = |out: &str| fs::read(folder.path(&format!("{out}/frames/{step:06}.ply"))).unwrap();
        assert!(frame("a result") == frame("whole"), "{step}");
    }
}
