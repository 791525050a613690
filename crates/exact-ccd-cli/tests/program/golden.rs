//! The texts of `step` and `audit` against the files in `tests/golden`: help, reports, errors.
//!
//! `UPDATE_EXPECT=1 cargo test -p exact-ccd-cli --test program golden` writes these files anew.

use std::path::Path;

use exact_ccd_mesh::Frame;
use expect_test::expect_file;

use crate::folder::Folder;
use crate::meshes::{fall, ply, tip_above_square};

/// A command line, with the status if it is not 0, and all that the program writes, without durations.
fn transcript(folder: &Folder, line: &str) -> String {
    let arguments: Vec<&str> = line.split(' ').filter(|word| !word.is_empty()).collect();
    let run = folder.run(&arguments);
    let status = match run.status {
        0 => String::new(),
        status => format!("[status {status}]\n"),
    };
    let output = run.stdout + &run.stderr;
    let lines = output.split_inclusive('\n').map(without_numbers_of_seconds);
    format!("$ exact-ccd {line}\n{}{status}", lines.collect::<String>())
}

fn without_numbers_of_seconds(line: &str) -> String {
    if !line.starts_with("seconds: ") {
        return line.to_owned();
    }
    let words = line
        .split(' ')
        .map(|word| if word.contains('.') { "#" } else { word });
    words.collect::<Vec<_>>().join(" ")
}

/// Compares the transcripts of command lines with a file.
#[track_caller]
fn assert_golden(name: &str, folder: &Folder, lines: &[&str]) {
    let texts: Vec<String> = lines.iter().map(|line| transcript(folder, line)).collect();
    let file = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/golden")
        .join(name);
    expect_file![file].assert_eq(&texts.join("\n"));
}

/// Falls of a tip onto a square, as files named by its heights, and other meshes.
fn meshes() -> Folder {
    let folder = Folder::new();
    for height in [3.0, 1.0, 0.5, 0.25, 0.0, -1.0, -2.0] {
        folder.write(&format!("at{height}.ply"), ply(&tip_above_square(height)));
    }
    for (name, z) in [("above.ply", 1.0), ("below.ply", -1.0)] {
        let across = [[0.0, -1.0, z], [0.0, 1.0, z], [0.0, 0.0, z + 1.0]];
        let along = [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]];
        let frame = Frame::new([along, across].concat(), vec![[0, 1, 2], [3, 4, 5]]).unwrap();
        folder.write(name, ply(&frame));
    }
    folder
}

#[test]
fn help() {
    assert_golden("help.txt", &Folder::new(), &["step --help", "audit --help"]);
}

#[test]
fn steps() {
    assert_golden(
        "step.txt",
        &meshes(),
        &[
            "step at1.ply at0.5.ply",
            "step at1.ply at-2.ply",
            "step at1.ply at-2.ply --toi",
            "step at1.ply at0.5.ply --toi",
            "step at1.ply at-2.ply --any",
            "step at1.ply at0.5.ply --any",
            "step at1.ply at-2.ply --min-distance 0.125",
            "step at1.ply at-2.ply --all all.csv",
            "step at1.ply at-2.ply --half-space 0,0,0.5,0,0,1",
            "step at1.ply at-2.ply --half-space 0,0,0.5,0,0,1 --any",
            "step at0.ply at0.5.ply",
            "step at-1.ply at1.ply",
            "step at-1.ply at1.ply --no-start-check",
            "step at-1.ply at-1.ply",
            "step above.ply below.ply",
            "step at1.ply at0.5.ply --json --no-seconds",
            "step at1.ply at-2.ply --json --no-seconds",
            "step at1.ply at-2.ply --json --no-seconds --any",
            "step at-1.ply at1.ply --json --no-seconds --all all.jsonl",
        ],
    );
}

#[test]
fn audits() {
    assert_golden(
        "audit.txt",
        &meshes(),
        &[
            "audit --as-given at1.ply at3.ply at0.5.ply at0.25.ply",
            "audit --as-given at3.ply at1.ply at-2.ply at0.5.ply",
            "audit --as-given at-1.ply at3.ply",
            "audit at1.ply",
            "audit at0.ply",
            "audit --as-given at3.ply at1.ply at-2.ply at0.5.ply --all all.csv",
            "audit at0.25.ply --min-distance 0.25",
            "audit --as-given at1.ply at0.25.ply --half-space 0,0,0.25,0,0,1 --with floor=at1.ply",
            "audit --as-given at3.ply at1.ply --json --no-seconds",
            "audit --as-given at3.ply at1.ply at-2.ply --json --no-seconds",
            "audit at-1.ply --json --no-seconds --all all.jsonl",
        ],
    );
}

#[test]
fn usage() {
    assert_golden(
        "usage.txt",
        &Folder::new(),
        &[
            "step",
            "step start.ply end.ply --xml",
            "step start.ply end.ply --min-distance",
            "step start.ply end.ply --min-distance -1",
            "step start.ply end.ply --inner-distance 1",
            "step start.ply end.ply --any --toi",
            "step start.ply end.ply --threads",
            "step start.ply end.ply --threads 0",
            "step start.ply end.ply --threads -1",
            "step start.ply end.ply --threads many",
            "step start.ply end.ply --threads 1025",
            "step start.ply end.ply --all contacts.txt",
            "step start.ply end.ply --ignore start",
            "step start.ply end.ply --ignore a:b --only a:b",
            "step start.ply end.ply --half-space 0,0,0",
            "step start.ply end.ply --half-space 0,0,0,0,0,NaN",
            "audit",
            "audit start.ply --xml",
        ],
    );
}

#[test]
fn errors() {
    let folder = fall(1.0, -2.0);
    std::fs::create_dir(folder.path("folder.ply")).unwrap();
    std::fs::create_dir(folder.path("empty")).unwrap();
    folder.write("broken.ply", "ply\n");
    folder.write("mesh.txt", "");
    let Frame { mesh, positions } = tip_above_square(-2.0);
    let fewer = Frame::new(positions, mesh.faces()[..2].to_vec()).unwrap();
    folder.write("fewer.ply", ply(&fewer));
    assert_golden(
        "errors.txt",
        &folder,
        &[
            "step start.ply missing.ply",
            "step missing.ply end.ply",
            "step start.ply folder.ply",
            "step start.ply mesh.txt",
            "step start.ply broken.ply --json",
            "step start.ply fewer.ply",
            "step start.ply end.ply end.ply",
            "step start.ply",
            "step start.ply end.ply --paraview broken.ply",
            "step start.ply end.ply --all missing/all.csv",
            "step start.ply end.ply --output missing/report.txt",
            "step start.ply end.ply --max-size 100",
            "step start.ply end.ply --only a:b",
            "audit missing.ply",
            "audit start.ply fewer.ply",
            "audit empty",
        ],
    );
}
