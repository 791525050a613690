//! Answers that are the same each time, with any number of threads.

use std::path::PathBuf;

use crate::folder::{Folder, Run};
use crate::meshes::{ply, tip_above_square};
use crate::simulate;

/// The bytes of standard output and of all files in the folder after a command.
fn bytes(folder: &Folder, command: &[&str], threads: &str) -> (Run, Vec<(PathBuf, Vec<u8>)>) {
    let run = folder.run(&[command, &["--no-seconds", "--threads", threads]].concat());
    let entries = std::fs::read_dir(folder.path(".")).unwrap();
    let files = entries
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.is_file());
    let mut files: Vec<_> = files
        .map(|path| (path.clone(), std::fs::read(path).unwrap()))
        .collect();
    files.sort_unstable();
    (run, files)
}

#[test]
fn reports_have_the_same_bytes_each_time_on_any_number_of_threads() {
    let folder = simulate::folder();
    for (name, height) in [("0.ply", 1.0), ("1.ply", 0.5), ("2.ply", -2.0)] {
        folder.write(name, ply(&tip_above_square(height)));
    }
    for command in [
        &["step", "1.ply", "2.ply", "--json"][..],
        &[
            "step",
            "1.ply",
            "2.ply",
            "--half-space",
            "0,0,0.25,0,0,1",
            "--all",
            "all.csv",
        ],
        &["audit", "0.ply", "1.ply", "2.ply", "--json", "--all", "all.jsonl"],
        &[
            "audit",
            "0.ply",
            "1.ply",
            "2.ply",
            "--view",
            "page.html",
            "--output",
            "report.txt",
        ],
        &["simulate", "scene.toml", "--json", "--steps", "3"],
        &["simulate", "scene.toml", "--steps", "3"],
    ] {
        let first = bytes(&folder, command, "1");
        assert!(first.0.status < 2 && first.0.stderr.is_empty(), "{first:?}");
        for threads in ["1", "2", "7"] {
            assert_eq!(
                bytes(&folder, command, threads),
                first,
                "{command:?}, {threads} threads"
            );
        }
    }
}

#[test]
fn an_answer_in_a_file_is_that_on_standard_output() {
    let folder = Folder::new();
    for (name, height) in [("0.ply", 1.0), ("1.ply", -2.0)] {
        folder.write(name, ply(&tip_above_square(height)));
    }
    for command in [
        &["step", "0.ply", "1.ply", "--no-seconds"][..],
        &["audit", "0.ply", "1.ply", "--no-seconds", "--json"],
        &["completions", "bash"],
        &["completions", "zsh"],
        &["completions", "fish"],
        &["completions", "powershell"],
        &["man"],
        &["man", "step"],
    ] {
        let printed = folder.run(command);
        let written = folder.run(&[command, &["--output", "answer"]].concat());
        assert_eq!((written.status, written.stdout.as_str()), (printed.status, ""));
        assert_eq!(folder.read("answer"), printed.stdout, "{command:?}");
        assert!(printed.stdout.len() > 100, "{command:?}");
        assert_eq!(folder.run(&[command, &["--output", "-"]].concat()), printed);
    }
}
