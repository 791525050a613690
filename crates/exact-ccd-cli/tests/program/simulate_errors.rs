//! Errors of `exact-ccd simulate`.

use std::fs;

use crate::folder::Run;
use crate::simulate::{SCENE, folder};

#[track_caller]
fn assert_error(run: &Run, error: &str) {
    assert_eq!((run.status, run.stdout.as_str()), (2, ""));
    assert!(
        run.stderr.starts_with(&format!("exact-ccd: error: {error}")),
        "{run:?}"
    );
}

#[test]
fn an_unknown_method_is_an_error() {
    let folder = folder();
    let run = folder.run(&["simulate", "scene.toml", "--method", "luck"]);
    assert_error(
        &run,
        "there is no method luck; there are exact, bisection, parity, ",
    );
}

#[test]
fn errors_name_the_file_and_the_field() {
    let folder = folder();
    folder.write("typo.toml", SCENE.replace("time-step", "timestep"));
    let run = folder.run(&["simulate", "typo.toml"]);
    assert_error(
        &run,
        "typo.toml, line 5, settings.timestep: unknown field `timestep`, expected ",
    );
    let run = folder.run(&["simulate", "missing.toml"]);
    assert_error(&run, "missing.toml: ");
    let run = folder.run(&["simulate", "scene.toml", "--output", "empty", "--resume"]);
    assert_error(&run, "empty/checkpoint.json: the file does not exist");
    fs::create_dir(folder.path("empty")).unwrap();
    folder.write("empty/checkpoint.json", "{\"step\": 3}");
    let run = folder.run(&["simulate", "scene.toml", "--output", "empty", "--resume"]);
    assert_error(&run, "empty/checkpoint.json: missing field `settings`");
}

/// A checkpoint can only be resumed with its own scene.
#[test]
fn a_checkpoint_of_another_scene_is_an_error() {
    let folder = folder();
    let simulate = |scene: &str, more: &[&str]| {
        let arguments = ["simulate", scene, "--output", "out", "--steps", "2"];
        folder.run(&[arguments.as_slice(), more].concat())
    };
    assert_eq!(simulate("scene.toml", &[]).status, 0);
    assert_eq!(simulate("scene.toml", &["--resume"]).status, 0);
    let changes = [
        (
            "time-step = 0.02",
            "time-step = 0.01",
            "has `time-step` = 0.02, expected 0.01",
        ),
        (
            "young = 1e6",
            "young = 2e6",
            "belongs to a system with other materials",
        ),
        (
            "translate = [0.2, 0.05",
            "translate = [0.2, 0.06",
            "belongs to a system with other positions",
        ),
    ];
    for (from, to, what) in changes {
        assert!(SCENE.contains(from), "{from}");
        folder.write("other.toml", SCENE.replace(from, to));
        let run = simulate("other.toml", &["--resume"]);
        let expected = format!("out/checkpoint.json: the checkpoint {what}");
        assert_error(&run, &expected);
    }
    let run = simulate("scene.toml", &["--resume", "--method", "bisection"]);
    assert_error(
        &run,
        "out/checkpoint.json: the checkpoint has `ccd` = exact, expected bisection",
    );
}

/// A checkpoint is invalid if the files of its time step are missing.
#[test]
fn a_checkpoint_without_the_files_of_its_step_is_an_error() {
    let folder = folder();
    let arguments = ["simulate", "scene.toml", "--output", "out", "--steps", "2"];
    assert_eq!(folder.run(&arguments).status, 0);
    let checkpoint = folder.read("out/checkpoint.json");
    assert!(checkpoint.contains("\"step\":2,"));
    for (step, error) in [
        (
            "1000000000000000",
            "the checkpoint has time step 1000000000000000, expected the file out/vtu/1000000000000000.vtu",
        ),
        (
            "18446744073709551615",
            "the state is invalid: `step` is 18446744073709551615, expected a number below",
        ),
    ] {
        folder.write(
            "out/checkpoint.json",
            checkpoint.replace("\"step\":2,", &format!("\"step\":{step},")),
        );
        let run = folder.run(&[arguments.as_slice(), &["--resume"]].concat());
        assert_error(&run, &format!("out/checkpoint.json: {error}"));
    }
}

/// Results are replaced only with `--overwrite`, and resumed only if they are complete.
#[test]
fn results_are_kept_and_complete() {
    let folder = folder();
    let simulate = |more: &[&str]| {
        let arguments = ["simulate", "scene.toml", "--output", "out", "--steps", "3"];
        folder.run(&[arguments.as_slice(), more].concat())
    };
    assert_eq!(simulate(&[]).status, 0);
    assert_error(
        &simulate(&[]),
        "out: the folder has the results of an earlier run: continue it with --resume",
    );
    assert_eq!(simulate(&["--overwrite"]).status, 0);
    assert_eq!(simulate(&["--resume"]).status, 0);
    let statistics = folder.read("out/statistics.csv");
    let rows: Vec<&str> = statistics.lines().collect();
    folder.write(
        "out/statistics.csv",
        format!("{}\n{}\n{}\n", rows[0], rows[1], rows[3]),
    );
    let error = "out/checkpoint.json: the checkpoint has time step 3, but the row of time step 2 in ";
    assert_error(&simulate(&["--resume"]), error);
    folder.write("out/statistics.csv", &statistics);
    assert_eq!(simulate(&["--resume"]).status, 0);
    fs::remove_file(folder.path("out/frames/000001.ply")).unwrap();
    let error =
        "out/checkpoint.json: the checkpoint has time step 3, but the file out/frames/000001.ply is missing";
    assert_error(&simulate(&["--resume"]), error);
}

/// A name that no file of results could have is refused before an earlier run is replaced.
#[test]
fn a_control_character_in_a_name_is_an_error() {
    let folder = folder();
    let run = folder.run(&["simulate", "scene.toml", "--steps", "1", "--output", "result"]);
    assert_eq!(run.status, 0, "{run:?}");
    let before = fs::read(folder.path("result/frames/000001.ply")).unwrap();
    folder.write(
        "tab.toml",
        SCENE.replacen("[[body]]", "[[body]]\nname = \"a\\tb\"", 1),
    );
    let run = folder.run(&["simulate", "tab.toml", "--output", "result", "--overwrite"]);
    assert!(
        run.stderr.contains("has a control character, expected none"),
        "{run:?}"
    );
    assert_eq!(fs::read(folder.path("result/frames/000001.ply")).unwrap(), before);
}
