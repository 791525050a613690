//! The output of `exact-ccd simulate`.

use std::fs;

use crate::folder::Folder;

/// A scene with a cube that falls on a grid.
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

#[test]
fn every_step_is_printed_and_free_of_contact() {
    let folder = folder();
    let run = folder.run(&["simulate", "scene.toml", "--output", "result"]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    let lines: Vec<&str> = run.stdout.lines().collect();
    assert_eq!(lines.len(), 11);
    assert_eq!(
        lines[0],
        "12 vertices, 14 faces, 0.866 m across; contact distance 0.002 m; 10 time steps of 0.02 s"
    );
    assert!(lines[10].starts_with("step 10, 0.2000 s: "), "{}", lines[10]);

    assert_eq!(fs::read_dir(folder.path("result/frames")).unwrap().count(), 11);
    let audit = folder.run(&["audit", "result/frames"]);
    assert_eq!(audit.status, 0, "{audit:?}");
}

#[test]
fn the_path_is_free_of_contact() {
    let folder = folder();
    let run = folder.run(&["simulate", "scene.toml", "--output", "result", "--path"]);
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
        folder
            .run(&["simulate", "scene.toml", "--output", "result"])
            .status,
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
    // The minimal distance is below the contact distance, and empty without contacts.
    let contacts = numbers("contacts");
    assert!(contacts[0] == 0.0 && contacts[9] > 0.0);
    for (contacts, distance) in contacts.iter().zip(text("minimal_distance_m")) {
        match distance.parse::<f64>() {
            Ok(distance) => assert!(*contacts > 0.0 && 0.0 < distance && distance < 2e-3),
            Err(_) => assert_eq!((*contacts, *distance), (0.0, "")),
        }
    }
    // In free fall, the energy of gravity decreases and the kinetic energy increases.
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
fn vtu_files_have_tetrahedra_and_triangles_of_all_time_steps() {
    let folder = folder();
    let run = folder.run(&["simulate", "scene.toml", "--output", "result", "--steps", "3"]);
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

    // The collection reads back as the surface.
    let audit = folder.run(&["audit", "result/motion.pvd"]);
    assert!(
        audit.stdout.contains("\nfree of contact\nframes: 4 of 4"),
        "{audit:?}"
    );
}

/// Rods and particles are in the summary, in both formats, and in the motion that an audit reads.
#[test]
fn rods_and_particles_are_written() {
    let folder = Folder::new();
    let scene = r#"
duration = 0.02

[[body]]
shape = { line = { edges = 4, length = 1.0 } }
rod = { density = 1000.0, young = 1e6, radius = 0.01 }
offset = 0.01

[[body]]
shape = { points = { counts = [2, 1, 1], size = [0.5, 0.0, 0.0] } }
particles = { density = 1000.0, radius = 0.01 }
translate = [0.2, 0.5, 0.0]
"#;
    folder.write("rod.toml", scene);
    let run = folder.run(&["simulate", "rod.toml", "--output", "result", "--path", "--render"]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    let summary = "7 vertices, 0 faces, 4 rod edges, 2 particles, ";
    assert!(run.stdout.starts_with(summary), "{run:?}");
    let grid = folder.read("result/vtu/000002.vtu");
    assert!(
        grid.contains(r#"<Piece NumberOfPoints="7" NumberOfCells="6">"#),
        "{grid}"
    );
    let frame = exact_ccd_files::read_frame(folder.path("result/frames/000002.ply")).unwrap();
    assert_eq!((frame.positions.len(), frame.mesh.loose_edges().len()), (7, 4));
    for motion in ["result/path", "result/motion.pvd"] {
        let audit = folder.run(&["audit", motion]);
        assert!(audit.stdout.contains("\nfree of contact\n"), "{audit:?}");
    }
}

#[test]
fn the_method_can_be_chosen() {
    let folder = folder();
    for ccd in ["bisection", "parity", "ti"] {
        let run = folder.run(&["simulate", "scene.toml", "--method", ccd, "--steps", "6"]);
        assert_eq!((run.status, run.stdout.lines().count()), (0, 7), "{ccd}");
    }
}

/// Options replace the settings before these are checked.
#[test]
fn a_line_search_for_a_method_without_exact_times_can_be_chosen() {
    let folder = folder();
    let scene = SCENE.replace("[settings]", "[settings]\nline-search = \"vertex\"");
    folder.write("scene.toml", scene);
    let arguments = ["simulate", "scene.toml", "--steps", "1", "--method", "parity"];
    assert_eq!(folder.run(&arguments).status, 2);
    let run = folder.run(&[&arguments[..], &["--line-search", "common"]].concat());
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
}

#[test]
fn a_complete_run_has_nothing_to_resume() {
    let folder = folder();
    let arguments = ["simulate", "scene.toml", "--output", "out", "--steps", "2"];
    assert_eq!(folder.run(&arguments).status, 0);
    let run = folder.run(&[arguments.as_slice(), &["--resume"]].concat());
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    assert!(
        run.stdout
            .ends_with("; nothing to do: the results have time step 2, the last step is 2\n"),
        "{run:?}"
    );
}

#[test]
fn one_time_step_is_singular() {
    let folder = folder();
    let run = |more: &[&str]| {
        let arguments = ["simulate", "scene.toml", "--output", "out"];
        let run = folder.run(&[arguments.as_slice(), more].concat());
        assert_eq!((run.status, run.stderr.as_str()), (0, ""));
        run.stdout.lines().next().unwrap().to_owned()
    };
    let one = run(&["--steps", "1"]);
    assert!(one.ends_with("; 1 time step of 0.02 s"), "{one}");
    let last = run(&["--steps", "2", "--resume"]);
    assert!(last.ends_with("; time step 2 of 0.02 s"), "{last}");
    let two = run(&["--steps", "4", "--resume"]);
    assert!(two.ends_with("; time steps 3 to 4 of 0.02 s"), "{two}");
}

/// Without a file to write, the first line says that nothing is saved.
#[test]
fn a_run_without_a_folder_is_not_saved() {
    let folder = folder();
    let run = folder.run(&["simulate", "scene.toml", "--steps", "1"]);
    let line = run.stdout.lines().next().unwrap();
    assert!(
        line.ends_with("; 1 time step of 0.02 s; without --output, nothing is saved"),
        "{run:?}"
    );
    for written in [["--view", "page.html"], ["--dump-queries", "queries"]] {
        let run = folder.run(&[&["simulate", "scene.toml", "--steps", "1"][..], &written].concat());
        let line = run.stdout.lines().next().unwrap();
        assert!(line.ends_with("; 1 time step of 0.02 s"), "{run:?}");
    }
}

/// Every Nth time step has files, and the last one. The statistics have all.
#[test]
fn files_of_some_time_steps_are_written() {
    let folder = folder();
    let arguments = [
        "simulate",
        "scene.toml",
        "--output",
        "out",
        "--every",
        "4",
        "--render",
    ];
    let run = folder.run(&[arguments.as_slice(), &["--steps", "6"]].concat());
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    let run = folder.run(&[arguments.as_slice(), &["--resume"]].concat());
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    let collection = exact_ccd_files::read_pvd(folder.path("out/motion.pvd")).unwrap();
    let times: Vec<f64> = collection.iter().map(|(time, _)| *time).collect();
    assert_eq!(times, [0.0, 0.08, 0.12, 0.16, 0.2]);
    assert_eq!(fs::read_dir(folder.path("out/frames")).unwrap().count(), 5);
    assert_eq!(fs::read_dir(folder.path("out/pictures")).unwrap().count(), 5);
    assert_eq!(folder.read("out/statistics.csv").lines().count(), 11);
}

/// Warnings go to standard error: of a contact distance that is too large, and of steps without convergence.
#[test]
fn warnings_are_printed() {
    let folder = folder();
    folder.write("far.toml", SCENE.replace("2e-3", "0.1"));
    let run = folder.run(&["simulate", "far.toml", "--steps", "1"]);
    let warning =
        "exact-ccd: warning: the contact distance, 1.000e-1 m, is more than a tenth of the size of body[0], ";
    assert!(run.status == 0 && run.stderr.starts_with(warning), "{run:?}");
    let near =
        "exact-ccd: warning: body[0] and body[1] start 5.000e-2 m apart, less than the contact distance";
    assert!(run.stderr.lines().any(|line| line.starts_with(near)), "{run:?}");

    folder.write(
        "short.toml",
        SCENE.replace("[settings]", "[settings]\nmax-iterations = 1"),
    );
    let run = folder.run(&["simulate", "short.toml", "--output", "out"]);
    let found = run.stderr.starts_with("exact-ccd: warning: ")
        && run
            .stderr
            .contains(" of 10 time steps did not converge, the first is ");
    assert!(run.status == 0 && found, "{run:?}");
    let run = folder.run(&[
        "simulate",
        "short.toml",
        "--output",
        "out",
        "--overwrite",
        "--strict",
    ]);
    assert!(
        run.status == 2
            && run
                .stderr
                .contains(" did not converge, expected convergence with --strict"),
        "{run:?}"
    );
}

/// Half spaces, loads and key frames of a scene.
#[test]
fn a_half_space_stops_a_body() {
    let folder = Folder::new();
    let scene = r#"
duration = 0.1

[[half-space]]
normal = [0.0, 2.0, 0.0]

[[body]]
shape = { box = { cells = [1, 1, 1], size = [0.5, 0.5, 0.5] } }
solid = { density = 1000.0, young = 1e6, poisson = 0.4 }
translate = [0.0, 0.002, 0.0]
angular-velocity = [0.0, 1.0, 0.0]

[[body.load]]
force = { acceleration = [0.0, -1.0, 0.0] }
until = 0.05

[[body]]
shape = { grid = { cells = [1, 1], size = [0.3, 0.3] } }
translate = [0.0, 2.0, 0.0]

[[body.script]]
motion = { key-frames = { frames = [{ time = 0.0 }, { time = 0.1, translate = [0.0, 1.0, 0.0], degrees = 9.0 }] } }
"#;
    folder.write("ground.toml", scene);
    let run = folder.run(&[
        "simulate",
        "ground.toml",
        "--output",
        "out",
        "--render",
        "--strict",
    ]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    let frame = exact_ccd_files::read_frame(folder.path("out/frames/000010.ply")).unwrap();
    assert!(frame.positions[..8].iter().all(|x| x[1] > 0.0) && frame.positions[8][1] == 3.0);
    let bodies = folder.read("out/bodies.csv");
    assert_eq!(bodies.lines().last(), Some("2,half-space-0,half-space,12,0"));

    for (from, to, error) in [
        (
            "normal = [0.0, 2.0, 0.0]",
            "normal = [0.0, 0.0, 0.0]",
            "line 5, half-space[0].normal: ",
        ),
        ("0.002", "-0.002", "body[0]: vertex "),
        ("until = 0.05", "until = -1.0", "body[0].load[0].until: "),
        (
            "time = 0.1",
            "time = -0.1",
            "body[1].script[0].motion.key-frames.frames: ",
        ),
    ] {
        assert!(scene.contains(from), "{from}");
        folder.write("wrong.toml", scene.replace(from, to));
        let run = folder.run(&["simulate", "wrong.toml"]);
        assert!(run.status == 2 && run.stderr.contains(error), "{error}: {run:?}");
    }
}

/// Bodies have names in the files of the path, by which an audit selects pairs, and contacts are points.
#[test]
fn bodies_have_names_and_contacts_are_written() {
    let folder = Folder::new();
    folder.write(
        "scene.toml",
        SCENE.replacen("[[body]]", "[[body]]\nname = \"cube\"", 1),
    );
    let run = folder.run(&[
        "simulate",
        "scene.toml",
        "--output",
        "result",
        "--path",
        "--every",
        "5",
    ]);
    assert_eq!(run.status, 0, "{run:?}");
    for pair in ["cube:body-1", "cube:cube"] {
        let run = folder.run(&["audit", "result/path", "--only", pair]);
        assert_eq!(run.status, 0, "{run:?}");
    }
    let run = folder.run(&["audit", "result/frames", "--ignore", "cube:floor"]);
    assert!(run.error().ends_with("cube, body-1"), "{run:?}");
    let names: Vec<String> = ["000000", "000005", "000010"]
        .map(|step| format!("{step}.vtp"))
        .to_vec();
    let mut found: Vec<String> = fs::read_dir(folder.path("result/contacts"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    found.sort_unstable();
    assert_eq!(found, names);
    let collection = fs::read_to_string(folder.path("result/contacts.pvd")).unwrap();
    assert!(
        names
            .iter()
            .all(|name| collection.contains(&format!("\"contacts/{name}\"")))
    );
    let grid = fs::read_to_string(folder.path("result/vtu/000010.vtu")).unwrap();
    assert!(grid.contains("Name=\"body\"") && !grid.contains("String"));
    let bodies = fs::read_to_string(folder.path("result/bodies.csv")).unwrap();
    assert_eq!(
        bodies,
        "body,name,kind,first_vertex,vertex_count\n0,cube,solid,0,8\n1,body-1,obstacle,8,4\n"
    );
}
