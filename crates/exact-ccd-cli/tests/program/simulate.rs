//! What `exact-ccd simulate` prints and leaves.

use std::fs;

use serde_json::Value;

use crate::folder::{Folder, Run};

/// A cube falls on a grid.
const SCENE: &str = "
duration = 0.2

[settings]
time-step = 0.02
contact-distance = { absolute = 2e-3 }

[[body]]
shape = { box = { cells = [1, 1, 1], size = [0.5, 0.5, 0.5] } }
solid = { density = 1000.0, young = 1e6, poisson = 0.4 }
translate = [0.2, 0.05, 0.2]

[[body]]
shape = { grid = { cells = [1, 1], size = [1.0, 1.0] } }
";

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("scene.toml", SCENE);
    folder
}

#[track_caller]
fn assert_error(run: &Run, error: &str) {
    assert_eq!((run.status, run.stdout.as_str()), (2, ""));
    assert!(
        run.stderr.starts_with(&format!("exact-ccd: error: {error}")),
        "{run:?}"
    );
}

#[test]
fn every_step_is_printed_and_free_of_contact() {
    let folder = folder();
    let run = folder.run(&["simulate", "scene.toml", "--out", "result"]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    let lines: Vec<&str> = run.stdout.lines().collect();
    assert_eq!(lines.len(), 10);
    assert!(lines[9].starts_with("step 10, 0.2000 s: "), "{}", lines[9]);

    let statistics = folder.read("result/statistics.jsonl");
    let statistics: Vec<Value> = statistics
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    assert_eq!(statistics.len(), 10);
    assert!(statistics.iter().any(|step| step["contacts"] != 0));
    assert_eq!(statistics[4]["step"], 5);

    assert_eq!(fs::read_dir(folder.path("result/frames")).unwrap().count(), 11);
    let audit = folder.run(&["audit", "result/frames"]);
    assert_eq!(audit.status, 0, "{audit:?}");
}

#[test]
fn the_way_is_free_of_contact() {
    let folder = folder();
    let run = folder.run(&["simulate", "scene.toml", "--out", "result", "--path"]);
    assert_eq!(run.status, 0);
    let files = fs::read_dir(folder.path("result/path")).unwrap().count();
    assert!(files > 20, "{files} files for 10 time steps");
    let audit = folder.run(&["audit", "result/path"]);
    assert_eq!(audit.status, 0, "{audit:?}");
}

#[test]
fn a_resumed_simulation_comes_to_the_same_bytes() {
    let folder = folder();
    assert_eq!(
        folder.run(&["simulate", "scene.toml", "--out", "whole"]).status,
        0
    );
    assert_eq!(
        folder
            .run(&["simulate", "scene.toml", "--out", "parts", "--steps", "6"])
            .status,
        0
    );
    let run = folder.run(&[
        "simulate",
        "scene.toml",
        "--out",
        "parts",
        "--resume",
        "--threads",
        "2",
    ]);
    assert_eq!((run.status, run.stdout.lines().count()), (0, 4));
    for file in ["checkpoint.json", "frames/000010.ply"] {
        assert!(
            fs::read(folder.path(&format!("whole/{file}"))).unwrap()
                == fs::read(folder.path(&format!("parts/{file}"))).unwrap()
        );
    }
    assert_eq!(folder.read("parts/statistics.jsonl").lines().count(), 10);
}

#[test]
fn pictures_are_of_all_times() {
    let folder = folder();
    let run = |more: &[&str]| {
        let arguments = ["simulate", "scene.toml", "--out", "result", "--render"];
        let run = folder.run(&[arguments.as_slice(), more].concat());
        assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    };
    let pictures = || fs::read_dir(folder.path("result/pictures")).unwrap().count();
    let read = |name: &str| fs::read(folder.path(&format!("result/{name}"))).unwrap();
    run(&["--steps", "4"]);
    assert_eq!(pictures(), 5);
    run(&["--resume"]);
    assert_eq!(pictures(), 11);
    assert_eq!(frames_of(&read("motion.png")), Some(11));
    assert_eq!(frames_of(&read("pictures/000010.png")), None);
    // The cube falls.
    assert_ne!(read("pictures/000000.png"), read("pictures/000005.png"));
}

/// How many frames an animated PNG file has, by its acTL chunk; `None` if it is a still.
fn frames_of(png: &[u8]) -> Option<u32> {
    assert!(png.starts_with(b"\x89PNG\r\n\x1a\n"));
    let control = png.windows(4).position(|name| name == b"acTL")?;
    let count = png.get(control + 4..control + 8)?;
    Some(u32::from_be_bytes(count.try_into().unwrap()))
}

#[test]
fn the_method_can_be_chosen() {
    let folder = folder();
    for ccd in ["bisection", "parity", "ti"] {
        let run = folder.run(&["simulate", "scene.toml", "--ccd", ccd, "--steps", "6"]);
        assert_eq!((run.status, run.stdout.lines().count()), (0, 6), "{ccd}");
    }
    let run = folder.run(&["simulate", "scene.toml", "--ccd", "luck"]);
    assert_error(
        &run,
        "there is no method `luck` of continuous collision detection, expected one of: exact, ",
    );
}

#[test]
fn errors_say_where() {
    let folder = folder();
    folder.write("typo.toml", SCENE.replace("time-step", "timestep"));
    let run = folder.run(&["simulate", "typo.toml"]);
    assert_error(
        &run,
        "typo.toml, line 5, settings.timestep: unknown field `timestep`, expected ",
    );
    let run = folder.run(&["simulate", "missing.toml"]);
    assert_error(&run, "missing.toml: ");
    let run = folder.run(&["simulate", "scene.toml", "--out", "empty", "--resume"]);
    assert_error(&run, "empty/checkpoint.json: ");
    folder.write("empty/checkpoint.json", "{\"step\": 3}");
    let run = folder.run(&["simulate", "scene.toml", "--out", "empty", "--resume"]);
    assert_error(&run, "empty/checkpoint.json: missing field `positions`");
}
