//! What `exact-ccd simulate` prints and leaves.

use std::fs;

use crate::folder::{Folder, Run};

/// A cube falls on a grid.
pub(crate) const SCENE: &str = "
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

pub(crate) fn folder() -> Folder {
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
    assert_eq!(lines.len(), 11);
    assert_eq!(
        lines[0],
        "12 vertices, 14 faces, 1.517e0 m across; contact distance 2.00e-3 m; 10 time steps of 0.02 s"
    );
    assert!(lines[10].starts_with("step 10, 0.2000 s: "), "{}", lines[10]);

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

/// The columns of the statistics, from the first row after the header.
fn columns(statistics: &str) -> Vec<(&str, Vec<&str>)> {
    let mut lines = statistics.lines().map(|line| line.split(','));
    let names = lines.next().unwrap();
    let rows: Vec<Vec<&str>> = lines.map(Iterator::collect).collect();
    names
        .enumerate()
        .map(|(column, name)| (name, rows.iter().map(|row| row[column]).collect()))
        .collect()
}

#[test]
fn statistics_are_columns_with_units() {
    let folder = folder();
    assert_eq!(
        folder.run(&["simulate", "scene.toml", "--out", "result"]).status,
        0
    );
    let statistics = folder.read("result/statistics.csv");
    assert!(
        statistics.starts_with(
            "step,time_s,converged,iterations,step_size_min,step_size_mean,contacts,minimal_distance_m,\
             stiffness_kg_per_m2,script_lag_m,kinetic_J,elastic_J,barrier_J,friction_J,gravity_J,\
             assembly_s,solve_s,ccd_s,line_search_s,total_s\n1,0.02,true,"
        ),
        "{statistics}"
    );
    let columns = columns(&statistics);
    let text = |name: &str| -> &[&str] { &columns.iter().find(|(column, _)| *column == name).unwrap().1 };
    let numbers = |name: &str| -> Vec<f64> { text(name).iter().map(|x| x.parse().unwrap()).collect() };
    let steps: Vec<f64> = (1..=10).map(f64::from).collect();
    assert_eq!(numbers("step"), steps);
    let (least, mean) = (numbers("step_size_min"), numbers("step_size_mean"));
    assert!((0..10).all(|i| 0.0 < least[i] && least[i] <= mean[i] && mean[i] <= 1.0));
    // There is a distance where there are contacts, below the contact distance.
    let contacts = numbers("contacts");
    assert!(contacts[0] == 0.0 && contacts[9] > 0.0);
    for (contacts, distance) in contacts.iter().zip(text("minimal_distance_m")) {
        match distance.parse::<f64>() {
            Ok(distance) => assert!(*contacts > 0.0 && 0.0 < distance && distance < 2e-3),
            Err(_) => assert_eq!((*contacts, *distance), (0.0, "")),
        }
    }
    // In free fall, what gravity loses is kinetic energy, but for what implicit Euler damps.
    let (kinetic, gravity) = (numbers("kinetic_J"), numbers("gravity_J"));
    assert!(kinetic[1] > kinetic[0] && gravity[1] < gravity[0]);
    let parts: Vec<f64> = (0..10)
        .map(|i| ["assembly_s", "solve_s", "ccd_s", "line_search_s"].map(|part| numbers(part)[i]))
        .map(|parts| parts.iter().sum())
        .collect();
    assert!(
        parts
            .iter()
            .zip(numbers("total_s"))
            .all(|(parts, total)| *parts <= total)
    );
}

#[test]
fn paraview_gets_tetrahedra_and_triangles_over_time() {
    let folder = folder();
    let run = folder.run(&["simulate", "scene.toml", "--out", "result", "--steps", "3"]);
    assert_eq!(run.status, 0);
    let collection = exact_ccd_files::read_pvd(folder.path("result/motion.pvd")).unwrap();
    let file = |step: u32| folder.path(&format!("result/vtu/00000{step}.vtu"));
    let expected: Vec<_> = (0..=3).map(|step| (f64::from(step) * 0.02, file(step))).collect();
    assert_eq!(collection, expected);
    let grid = folder.read("result/vtu/000003.vtu");
    // The cube is cut into six tetrahedra, the grid into two triangles.
    assert!(
        grid.contains(r#"<Piece NumberOfPoints="12" NumberOfCells="8">"#),
        "{grid}"
    );
    assert!(grid.contains(r#"<PointData Vectors="velocity">"#));

    // It reads back as the surface.
    let audit = folder.run(&["audit", "result/motion.pvd"]);
    assert!(
        audit.stdout.starts_with("free of contact\nframes: 4 of 4"),
        "{audit:?}"
    );
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
    for (plot, names) in [
        ("energies.svg", ["energy / J", "kinetic", "gravity"]),
        (
            "minimal-distance.svg",
            ["distance / m", "minimal distance", "time / s"],
        ),
    ] {
        let plot = folder.read(&format!("result/{plot}"));
        assert!(plot.starts_with("<svg ") && names.iter().all(|name| plot.contains(name)));
    }
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
        assert_eq!((run.status, run.stdout.lines().count()), (0, 7), "{ccd}");
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
    assert_error(&run, "empty/checkpoint.json: there is no run to go on with");
    fs::create_dir(folder.path("empty")).unwrap();
    folder.write("empty/checkpoint.json", "{\"step\": 3}");
    let run = folder.run(&["simulate", "scene.toml", "--out", "empty", "--resume"]);
    assert_error(&run, "empty/checkpoint.json: missing field `settings`");
}

/// A checkpoint goes on with the scene of which it is, and with no other.
#[test]
fn a_checkpoint_of_another_scene_is_refused() {
    let folder = folder();
    let simulate = |scene: &str, more: &[&str]| {
        let arguments = ["simulate", scene, "--out", "out", "--steps", "2"];
        folder.run(&[arguments.as_slice(), more].concat())
    };
    assert_eq!(simulate("scene.toml", &[]).status, 0);
    assert_eq!(simulate("scene.toml", &["--resume"]).status, 0);
    let changes = [
        (
            "time-step = 0.02",
            "time-step = 0.01",
            "`time-step` = 0.02, now it is 0.01",
        ),
        ("young = 1e6", "young = 2e6", "other materials"),
        (
            "translate = [0.2, 0.05",
            "translate = [0.2, 0.06",
            "other positions",
        ),
    ];
    for (from, to, what) in changes {
        assert!(SCENE.contains(from), "{from}");
        folder.write("other.toml", SCENE.replace(from, to));
        let run = simulate("other.toml", &["--resume"]);
        let expected = format!("out/checkpoint.json: the checkpoint is of a run with {what}");
        assert_error(&run, &expected);
    }
    let run = simulate("scene.toml", &["--resume", "--ccd", "bisection"]);
    assert_error(
        &run,
        "out/checkpoint.json: the checkpoint is of a run with `ccd` = \"exact\", now it is \"bisection\"",
    );
}

#[test]
fn what_is_there_already_is_not_done_again() {
    let folder = folder();
    let arguments = ["simulate", "scene.toml", "--out", "out", "--steps", "2"];
    assert_eq!(folder.run(&arguments).status, 0);
    let run = folder.run(&[arguments.as_slice(), &["--resume"]].concat());
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    assert!(
        run.stdout
            .ends_with("; time step 2 is there already, up to 2 nothing is left to do\n"),
        "{run:?}"
    );
}

/// A checkpoint stands for files: one that says more than there is would be counted up to.
#[test]
fn a_checkpoint_of_a_step_that_is_not_there_is_refused() {
    let folder = folder();
    let arguments = ["simulate", "scene.toml", "--out", "out", "--steps", "2"];
    assert_eq!(folder.run(&arguments).status, 0);
    let checkpoint = folder.read("out/checkpoint.json");
    assert!(checkpoint.contains("\"step\":2,"));
    for (step, error) in [
        (
            "1000000000000000",
            "it is of time step 1000000000000000, but out/vtu/1000000000000000.vtu",
        ),
        (
            "18446744073709551615",
            "the state is after 18446744073709551615 steps",
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

/// Whatever numbers a table holds, the plots come to an end.
#[test]
fn plots_of_any_numbers_are_drawn() {
    let folder = folder();
    let arguments = [
        "simulate",
        "scene.toml",
        "--out",
        "out",
        "--steps",
        "2",
        "--render",
    ];
    assert_eq!(folder.run(&arguments).status, 0);
    let statistics = folder.read("out/statistics.csv");
    let row = statistics.lines().nth(1).unwrap();
    for number in ["inf", "-inf", "NaN", "1e308", "-1e308", "1e-320", "-0"] {
        // Time, minimal distance, and energies.
        let changed = row.split(',').enumerate().map(|(column, value)| match column {
            1 | 7 | 10..=14 => number,
            _ => value,
        });
        let changed: Vec<&str> = changed.collect();
        folder.write("out/statistics.csv", statistics.replace(row, &changed.join(",")));
        let run = folder.run(&[arguments.as_slice(), &["--resume"]].concat());
        assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{number}");
        assert!(folder.read("out/energies.svg").ends_with("</svg>\n"));
    }
}
