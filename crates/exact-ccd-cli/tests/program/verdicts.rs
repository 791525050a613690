//! Verdicts that say what they are about: points alone, bodies that turn, bodies inside of others.

use serde_json::{Value, json};

use crate::folder::{Folder, Run};
use crate::scenes::note;
use crate::schema::Schema;

fn json_of(run: &Run) -> Value {
    let report = serde_json::from_str(&run.stdout).unwrap();
    Schema::of_reports().assert("motion", &report);
    report
}

/// A box around the origin with half the sides a, b, c, turned about z by an angle in degrees, as OBJ.
pub(crate) fn cuboid([a, b, c]: [f64; 3], degrees: f64, shift: f64) -> String {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    let sign = |k: usize, bit: usize| if k >> bit & 1 == 0 { -1.0 } else { 1.0 };
    let corner = |k: usize| {
        let (x, y, z) = (a * sign(k, 0), b * sign(k, 1), c * sign(k, 2));
        format!(
            "v {} {} {z}\n",
            cosine * x - sine * y + shift,
            sine * x + cosine * y
        )
    };
    let faces = "f 1 3 2\nf 2 3 4\nf 5 6 7\nf 6 8 7\nf 1 2 5\nf 2 6 5\nf 3 7 4\nf 4 7 8\nf 1 5 3\nf 3 5 7\nf 2 4 6\nf 4 8 6\n";
    (0..8).map(corner).collect::<String>() + faces
}

#[test]
fn points_alone_are_refused_unless_meant() {
    let folder = Folder::new();
    folder.write("a.obj", "v 0 0 0\nv 1 0 0\n");
    folder.write("b.obj", "v 0 0 1\nv 1 0 1\n");
    for command in [["step", "a.obj", "b.obj"], ["audit", "a.obj", "b.obj"]] {
        let error = folder.run(&command);
        assert_eq!(
            error.error(),
            "a.obj: 2 points, and neither a face nor an edge: a verdict about points alone says nothing about surfaces; \
             name a file that has the faces, or add --points if points are meant"
        );
        let run = folder.run(&[&command[..], &["--points"]].concat());
        assert_eq!((run.status, run.stderr.as_str()), (0, ""));
        assert!(
            run.stdout
                .starts_with("points alone: there is neither a face nor an edge"),
            "{run:?}"
        );
        assert!(
            run.stdout.contains("\nfree of contact of points alone\n"),
            "{run:?}"
        );
        let report = json_of(&folder.run(&[&command[..], &["--points", "--json"]].concat()));
        assert_eq!(report["points_only"], json!(true));
    }
    // A part of points beside a mesh is a warning.
    folder.write("box.obj", cuboid([0.1; 3], 0.0, 0.5));
    let run = folder.run(&["step", "a.obj", "b.obj", "--with", "box.obj"]);
    assert_eq!(run.status, 0);
    assert!(
        note(&run).contains("the part a has neither a face nor an edge"),
        "{run:?}"
    );
    let run = folder.run(&["step", "a.obj", "b.obj", "--with", "box.obj", "--points"]);
    assert_eq!(run.stderr, "");
}

#[test]
fn a_body_that_turns_is_noted_with_angle_and_shrinkage() {
    let folder = Folder::new();
    for degrees in [0, 5, 158, 160] {
        folder.write(
            &format!("arm{degrees}.obj"),
            cuboid([4.0, 0.5, 0.5], f64::from(degrees), 0.0),
        );
    }
    let run = folder.run(&["step", "arm0.obj", "arm160.obj", "--json"]);
    let report = json_of(&run);
    let text = report["notes"][0].as_str().unwrap();
    // 1 − cos 80° of 4.06 of 4.09.
    assert!(
        text.contains("turns by 160.0° from frame 0 (arm0.obj) to frame 1 (arm160.obj)"),
        "{text}"
    );
    assert!(text.contains("up to 82.0 % of its size"), "{text}");
    assert_eq!(folder.run(&["step", "arm0.obj", "arm5.obj"]).stderr, "");
    // Once, with the worst step.
    let run = folder.run(&["audit", "arm0.obj", "arm5.obj", "arm158.obj", "arm160.obj"]);
    assert!(
        note(&run).contains("turns by 153.0° from frame 1 (arm5.obj)"),
        "{run:?}"
    );
    // A bar that turns about itself loses nothing of its length, and what changes its shape does not turn.
    folder.write("thin0.obj", cuboid([1e-4, 1e-4, 4.0], 0.0, 0.0));
    folder.write("thin1.obj", cuboid([1e-4, 1e-4, 4.0], 120.0, 0.0));
    assert_eq!(folder.run(&["step", "thin0.obj", "thin1.obj"]).stderr, "");
    folder.write("other.obj", cuboid([3.0, 0.75, 0.5], 160.0, 0.0));
    assert_eq!(folder.run(&["step", "arm0.obj", "other.obj"]).stderr, "");
    // Each part by its name; an obstacle rests.
    let run = folder.run(&[
        "step",
        "left=arm0.obj",
        "arm160.obj",
        "--with",
        "wall=arm0.obj",
        "--ignore",
        "left:wall",
    ]);
    assert!(
        note(&run).contains("left (with vertex 0) turns by 160.0°"),
        "{run:?}"
    );
}

#[test]
fn a_body_inside_of_a_closed_one_is_noted() {
    let folder = Folder::new();
    folder.write("outer.obj", cuboid([2.0; 3], 0.0, 0.0));
    folder.write("cavity.obj", cuboid([1.0; 3], 0.0, 0.0));
    folder.write("inner.obj", cuboid([0.5; 3], 0.0, 0.0));
    folder.write("beside.obj", cuboid([0.5; 3], 0.0, 9.0));
    let step = |inner: &str| folder.run(&["step", inner, inner, "--with", "outer.obj"]);
    let run = step("inner.obj");
    assert_eq!(run.status, 0);
    assert!(
        note(&run)
            .contains("inner (with vertex 0) lies inside of the closed surface of outer (with vertex 0): "),
        "{run:?}"
    );
    assert_eq!(step("beside.obj").stderr, "");
    let run = folder.run(&["audit", "inner.obj", "--with", "outer.obj"]);
    assert!(note(&run).contains("lies inside"), "{run:?}");
    let ignored = [
        "step",
        "inner.obj",
        "inner.obj",
        "--with",
        "outer.obj",
        "--ignore",
        "inner:outer",
    ];
    assert_eq!(folder.run(&ignored).stderr, "");
    // A body with a cavity is around what its faces enclose an odd number of times.
    let shell = folder.read("cavity.obj").replace("f ", "f  ");
    let from_8 = |line: &str| match line.strip_prefix("f  ") {
        Some(corners) => {
            let corners = corners
                .split(' ')
                .map(|corner| (corner.parse::<u32>().unwrap() + 8).to_string());
            format!("f {}\n", corners.collect::<Vec<_>>().join(" "))
        }
        None => format!("{line}\n"),
    };
    let shell: String = shell.lines().map(from_8).collect();
    folder.write("shell.obj", folder.read("outer.obj") + &shell);
    let run = folder.run(&["step", "inner.obj", "inner.obj", "--with", "shell.obj"]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
}

#[test]
fn times_of_files_are_reported() {
    let folder = Folder::new();
    for frame in 0..3 {
        folder.write(&format!("f{frame}.obj"), cuboid([1.0; 3], 0.0, f64::from(frame)));
    }
    folder.write(
        "f.obj.series",
        r#"{"file-series-version": "1.0", "files": [{"name": "f0.obj", "time": 0.5}, {"name": "f1.obj", "time": 0.75}, {"name": "f2.obj", "time": 1.5}]}"#,
    );
    let run = folder.run(&["audit", "f.obj.series"]);
    assert!(
        run.stdout
            .contains("\nframes: 3 of 3 examined, from time 0.5 to 1.5\n"),
        "{run:?}"
    );
    let report = json_of(&folder.run(&["audit", "f.obj.series", "--json"]));
    assert_eq!(report["times"], json!([0.5, 1.5]));
}

/// `step f f` and `audit f` list the same pairs of a mesh that touches itself at rest.
#[test]
fn one_list_of_a_state() {
    let folder = Folder::new();
    // Boxes face to face, and one with a corner in another one.
    let second = cuboid([1.0; 3], 0.0, 2.0);
    folder.write("a.obj", cuboid([1.0; 3], 0.0, 0.0));
    folder.write("b.obj", second);
    folder.write("c.obj", cuboid([1.0; 3], 45.0, 4.25));
    let parts = ["a.obj", "a.obj", "b.obj", "b.obj", "c.obj", "c.obj"];
    let step = folder.run(&[&["step"], &parts[..], &["--all", "step.csv"]].concat());
    assert_eq!(step.status, 1);
    let all = ["a.obj", "b.obj", "c.obj"].map(|file| folder.read(file));
    let mut first = 0;
    let joined: String = all
        .iter()
        .map(|text| {
            let line = |line: &str| match line.strip_prefix("f ") {
                Some(corners) => {
                    let corner = |corner: &str| (corner.parse::<u32>().unwrap() + first).to_string();
                    format!(
                        "f {}\n",
                        corners.split(' ').map(corner).collect::<Vec<_>>().join(" ")
                    )
                }
                None => format!("{line}\n"),
            };
            let text: String = text.lines().map(line).collect();
            first += 8;
            text
        })
        .collect();
    folder.write("all.obj", joined);
    let rows = |run: &[&str]| {
        folder.run(&[run, &["--all", "all.csv"]].concat());
        let text = folder.read("all.csv");
        let pair = |row: &str| {
            row.split(',')
                .skip(1)
                .take(8)
                .map(str::to_owned)
                .collect::<Vec<_>>()
        };
        let mut rows: Vec<_> = text.lines().skip(1).map(pair).collect();
        rows.sort();
        rows
    };
    let of_step = rows(&["step", "all.obj", "all.obj"]);
    assert!(of_step.len() > 10, "{of_step:?}");
    assert!(of_step.iter().any(|row| row[0] == "ef"));
    assert_eq!(rows(&["audit", "all.obj"]), of_step);
}
