//! The program of `docs/solver.md`, which is a separate workspace.

use std::path::Path;
use std::process::Command;

#[test]
fn the_program_of_a_user_takes_certified_steps() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let source = std::fs::read_to_string(root.join("docs/solver/src/main.rs")).unwrap();
    assert!(source.lines().count() < 60, "the program is meant to be short");
    let output = Command::new(env!("CARGO"))
        .args(["run", "--quiet", "--locked", "--release", "--manifest-path"])
        .arg(root.join("docs/solver/Cargo.toml"))
        .arg("--target-dir")
        .arg(Path::new(env!("CARGO_TARGET_TMPDIR")).join("solver"))
        // The compilation takes longer than the run.
        .args(["--config", "profile.release.opt-level=1"])
        .output()
        .unwrap();
    let [stdout, stderr] = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
    assert!(output.status.success(), "{stderr}");
    assert_eq!(stdout, "100 frames free of contact\n");
}
