//! The command line.

use crate::folder::Folder;

#[test]
fn wrong_usage_has_status_2() {
    for arguments in [
        &[][..],
        &["collide"],
        &["step"],
        &["step", "start.ply", "end.ply", "--xml"],
        &["step", "start.ply", "end.ply", "--min-distance"],
        &["step", "start.ply", "end.ply", "--inner-distance", "1"],
        &["step", "start.ply", "end.ply", "--threads"],
        &["step", "start.ply", "end.ply", "--threads", "0"],
        &["step", "start.ply", "end.ply", "--threads", "-1"],
        &["step", "start.ply", "end.ply", "--threads", "many"],
        &["step", "start.ply", "end.ply", "--threads", "1025"],
        &["step", "start.ply", "end.ply", "--all", "contacts.txt"],
        &["step", "start.ply", "end.ply", "--ignore", "start"],
        &["step", "start.ply", "end.ply", "--ignore", "a:b", "--only", "a:b"],
        &["audit"],
        &["audit", "start.ply", "--xml"],
        &["queries"],
        &["queries", "--kind", "vf"],
        &["queries", "--kind", "fv", "vf.csv"],
        &["queries", "--kind", "vf", "--method", "odd", "vf.csv"],
        &["bench"],
        &["bench", "data", "--budget", "0"],
        &["bench", "data", "--budget", "long"],
        &["bench", "data", "--sample", "-1"],
        &["bench", "data", "--sample", "1"],
        &["simulate"],
        &["simulate", "scene.toml", "--resume"],
        &["simulate", "scene.toml", "--path"],
        &["simulate", "scene.toml", "--steps", "-1"],
        &["round"],
        &["round", "--kind", "vf"],
        &["round", "--per-query", "mesh.ply"],
        &["round", "--roots", "mesh.ply"],
        &["round", "--kind", "vf", "--roots", "vf.csv"],
        &["convert", "--kind", "vf", "vf.csv"],
        &["convert", "--kind", "vf", "--output", "vf.parquet"],
    ] {
        let run = Folder::new().run(arguments);
        assert_eq!((run.status, run.stdout.as_str()), (2, ""), "{arguments:?}");
        assert!(
            run.stderr.contains("Usage") || run.stderr.contains("--help"),
            "{run:?}"
        );
    }
}

#[test]
fn the_version_has_the_name_of_the_program() {
    for option in ["--version", "-V"] {
        let run = Folder::new().run(&[option]);
        let expected = format!("exact-ccd {}\n", env!("CARGO_PKG_VERSION"));
        assert_eq!((run.status, run.stdout), (0, expected));
    }
}

#[test]
fn help_documents_the_exit_status() {
    for command in ["step", "audit", "queries", "round", "convert"] {
        let run = Folder::new().run(&[command, "--help"]);
        assert_eq!((run.status, run.stderr.as_str()), (0, ""));
        assert!(run.stdout.contains("Exit status"), "{command}");
    }
}

/// The help of a command on one line.
fn help(command: &str) -> String {
    let run = Folder::new().run(&[command, "--help"]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    run.stdout.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn help_names_all_methods() {
    let names = exact_ccd_methods::names().join(", ");
    assert!(help("bench").contains(&names));
    assert!(help("queries").contains(&format!("{names}, parity-rational")));
}

/// Scenes say which direction is upwards; meshes do not.
#[test]
fn help_has_the_direction_upwards_of_each_command() {
    for (command, default) in [
        ("step", "[default: z]"),
        ("audit", "[default: z]"),
        (
            "simulate",
            "[default: `up` of the scene's table `[render]`, or else opposite to gravity, or y without gravity]",
        ),
    ] {
        let help = help(command);
        let (_, option) = help.split_once("--view-up").unwrap();
        let (_, found) = option.split_once("three numbers ").unwrap();
        assert!(found.starts_with(default), "{command}: {found}");
    }
}
