//! The output of `exact-ccd repair` for the frames of a recording.

use std::fmt::Write;
use std::fs;

use serde_json::Value;

use crate::folder::{Folder, Run};
use crate::schema::Schema;
use crate::verdicts::cuboid;

const FRAMES: usize = 12;

/// The vertices on a side of the sheet.
const SIDE: usize = 7;

/// A sheet above a box that rests, as an OBJ file of two groups. The sheet sinks into the box in a third of
/// the frames.
fn frame(index: usize) -> String {
    let turn = std::f64::consts::TAU * (index as f64 - 1.5) / FRAMES as f64;
    let height = 0.25 + 0.1 * turn.cos();
    let mut text = format!(
        "# a sheet and a box\ng body\n{}g sheet\n",
        cuboid([0.5, 0.2, 0.2], 0.0, 0.0)
    );
    for k in 0..SIDE * SIDE {
        let place = |i: usize| 1.5 * i as f64 / (SIDE - 1) as f64 - 0.77;
        writeln!(text, "v {} {} {height}", place(k % SIDE), place(k / SIDE)).unwrap();
    }
    for k in (0..SIDE * (SIDE - 1)).filter(|k| k % SIDE + 1 < SIDE) {
        // From 1, behind the corners of the box.
        let [a, b, c, d] = [k, k + 1, k + SIDE, k + SIDE + 1].map(|vertex| vertex + 9);
        writeln!(text, "f {a} {b} {d}\nf {a} {d} {c}").unwrap();
    }
    text
}

fn recording() -> Folder {
    let folder = Folder::new();
    fs::create_dir(folder.path("frames")).unwrap();
    for index in 0..FRAMES {
        folder.write(&format!("frames/f{index}.obj"), frame(index));
    }
    folder
}

fn json_of(run: &Run) -> Value {
    let report = serde_json::from_str(&run.stdout).unwrap();
    Schema::of_reports().assert("repaired_recording", &report);
    report
}

#[test]
fn a_sheet_that_sinks_into_a_body_is_free_in_all_frames_and_between_them() {
    let folder = recording();
    let intersects = |index: &usize| folder.run(&["audit", &format!("frames/f{index}.obj")]).status == 1;
    assert_eq!((0..FRAMES).filter(intersects).count(), FRAMES / 3);
    let command = ["repair", "frames", "-o", "free", "--pin", "body"];
    let run = folder.run(&command);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{run:?}");
    let verdict =
        "\nrepaired: all frames and the straight motion between them are certified to be free of contact\n";
    assert!(run.stdout.contains(verdict), "{run:?}");
    assert!(run.stdout.contains("\nframes: 12 of 12 repaired\n"), "{run:?}");
    assert!(
        run.stdout.contains("\n  frame 11 (frames/f11.obj): moved by "),
        "{run:?}"
    );
    let audit = folder.run(&["audit", "free"]);
    assert_eq!(audit.status, 0, "{audit:?}");
    assert!(
        audit.stdout.contains("\nframes: 12 of 12 examined\n"),
        "{audit:?}"
    );
    // The text of each file is the one of its source, but for coordinates; the body stays.
    for index in 0..FRAMES {
        let of = |folder_name: &str| folder.read(&format!("{folder_name}/f{index}.obj"));
        let (before, after) = (of("frames"), of("free"));
        let rest = |text: &str| -> Vec<String> {
            text.lines()
                .filter(|line| !line.starts_with('v'))
                .map(str::to_owned)
                .collect()
        };
        assert_eq!(rest(&before), rest(&after));
        let body = |text: &str| -> Vec<f64> {
            let corners = text.lines().filter_map(|line| line.strip_prefix("v ")).take(8);
            corners
                .flat_map(|line| line.split(' '))
                .map(|x| x.parse().unwrap())
                .collect()
        };
        assert_eq!(body(&before), body(&after));
    }
    let report = json_of(&folder.run(&[&command[..], &["--json"]].concat()));
    assert_eq!(report["repaired_frames"].as_array().unwrap().len(), FRAMES);
    assert!(report["repaired_frames"][6]["max"].as_f64() > Some(0.0));
    assert_eq!(report.get("blocked"), None);
}

#[test]
fn a_frame_without_a_free_motion_is_named_with_its_pairs() {
    let folder = recording();
    let command = [
        "repair", "frames", "-o", "free", "--pin", "body", "--pin", "sheet",
    ];
    let run = folder.run(&command);
    assert_eq!((run.status, run.stderr.as_str()), (1, ""), "{run:?}");
    let report = json_of(&folder.run(&[&command[..], &["--json"]].concat()));
    let frame = report["blocked"]["frame"].as_u64().unwrap() as usize;
    assert_eq!(folder.run(&["audit", &format!("frames/f{frame}.obj")]).status, 1);
    let line = format!("\nnot repaired: no free motion was found to frame {frame} (frames/f{frame}.obj)\n");
    assert!(run.stdout.contains(&line), "{run:?}");
    let pair = report["blocked"]["contacts"][0].as_str().unwrap();
    assert!(pair.contains("sheet: ") && pair.contains("body: "), "{pair}");
    assert!(run.stdout.contains(&format!("\n  contact: {pair}\n")), "{run:?}");
    assert_eq!(report["output"], Value::Null);
    assert!(!folder.path("free").exists());
    // The frames before it are written on request.
    let run = folder.run(&[&command[..], &["--partial"]].concat());
    assert_eq!(run.status, 1);
    assert_eq!(fs::read_dir(folder.path("free")).unwrap().count(), frame);
    assert_eq!(folder.run(&["audit", "free"]).status, 0);
}

#[test]
fn the_folder_and_the_options_of_a_recording_are_checked_first() {
    let folder = recording();
    for (arguments, error) in [
        (
            &["-o", "free.obj"][..],
            "free.obj: 12 frames need a folder: name one in place of a mesh file",
        ),
        (
            &["-o", "frames"],
            "frames: the answer would replace this input: name another file",
        ),
        (
            &["-o", "free", "--f32"],
            "--f32: this option is about one mesh, not a recording: leave it out",
        ),
        (
            &["-o", "free", "--view", "page.html"],
            "--view: `exact-ccd audit` of the repaired frames has this option",
        ),
    ] {
        let run = folder.run(&[&["repair", "frames"], arguments].concat());
        assert_eq!((run.status, run.error()), (2, error), "{run:?}");
    }
    fs::create_dir(folder.path("old")).unwrap();
    folder.write("old/f99.obj", frame(0));
    let run = folder.run(&["repair", "frames", "-o", "old"]);
    assert!(
        run.error()
            .starts_with("old/f99.obj: this mesh in the folder of the answer "),
        "{run:?}"
    );
    // Time that is spent at once.
    let run = folder.run(&["repair", "frames", "-o", "free", "--max-seconds", "0"]);
    assert_eq!(run.status, 1);
    assert!(
        run.stdout
            .contains("\nnot repaired: --max-seconds ended it before frame 0\n"),
        "{run:?}"
    );
}
