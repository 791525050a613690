//! The program of `docs/solver.md`.

use std::process::Command;

#[test]
fn the_program_of_a_user_takes_certified_steps() {
    let source = include_str!("../src/main.rs");
    assert!(source.lines().count() < 60, "the program is meant to be short");
    let output = Command::new(env!("CARGO_BIN_EXE_cloth")).output().unwrap();
    let [stdout, stderr] = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
    assert!(output.status.success(), "{stderr}");
    assert_eq!(stdout, "100 frames free of contact\n");
}
