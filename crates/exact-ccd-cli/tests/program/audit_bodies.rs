//! `exact-ccd audit --poses`: rigid bodies that move from pose to pose.

use serde_json::{Value, json};

use crate::folder::{Folder, Run};
use crate::schema::Schema;
use crate::verdicts::cuboid;

const HEADER: &str = "frame,body,x,y,z,qw,qx,qy,qz\n";

/// A bar along the x axis, which turns about its end, and a post at a distance of 3 from there.
fn bar_and_post() -> Folder {
    let folder = Folder::new();
    folder.write("bar.obj", cuboid([2.0, 0.1, 0.1], 0.0, 2.0));
    std::fs::create_dir(folder.path("parts")).unwrap();
    folder.write("parts/post.v2.obj", cuboid([0.1, 0.1, 1.0], 0.0, 0.0));
    folder
}

/// The poses of a bar that turns by right angles about the z axis, and of a post that rests.
fn turning(post: &str) -> String {
    let bar = ["1,0,0,0", "1,0,0,1", "0,0,0,-5"];
    let rows = bar.iter().enumerate().map(|(frame, quaternion)| {
        format!("{frame},bar,0,0,0,{quaternion}\n{frame},post.v2,{post},2,0,0,0\n")
    });
    HEADER.to_owned() + &rows.collect::<String>()
}

const AUDIT: [&str; 5] = ["audit", "bar.obj", "parts/post.v2.obj", "--poses", "poses.csv"];

fn json_of(run: &Run) -> Value {
    let report = serde_json::from_str(&run.stdout).unwrap();
    Schema::of_reports().assert("motion", &report);
    report
}

#[test]
fn a_bar_that_swings_through_a_post_between_two_free_poses_touches_it() {
    let folder = bar_and_post();
    // The bar touches the edge of the post at (2.5, 2.3), at the distance r = 3.397: its angle is
    // arctan(2.3 / 2.5) - arcsin(0.1 / r), and the tangent of the half is t.
    folder.write("poses.csv", turning("2.4,2.4,0"));
    let run = folder.run(&AUDIT);
    assert_eq!((run.status, run.stderr.as_str()), (1, ""), "{run:?}");
    let contact = "\ncontact between frame 0 (poses.csv) and frame 1 (poses.csv) at t = 0.373";
    assert!(run.stdout.contains(contact), "{run:?}");
    assert!(
        run.stdout.contains("bar: ") && run.stdout.contains("post.v2: "),
        "{run:?}"
    );
    assert!(run.stdout.contains("\nframes: 2 of 3 examined\n"), "{run:?}");
    let report = json_of(&folder.run(&[&AUDIT[..], &["--json"]].concat()));
    let toi = report["toi"].as_f64().unwrap();
    assert!((0.373..0.374).contains(&toi), "{toi}");
    let mut parts: Vec<_> = report["contact"]["parts"].as_array().unwrap().iter().collect();
    parts.sort_by_key(|part| part.as_str());
    assert_eq!(parts, ["bar", "post.v2"]);
    // Both poses are free at rest.
    for quaternion in ["1,0,0,0", "1,0,0,1"] {
        let rows = format!("{HEADER}0,bar,0,0,0,{quaternion}\n0,post.v2,2.4,2.4,0,1,0,0,0\n");
        folder.write("poses.csv", rows);
        assert_eq!(folder.run(&AUDIT).status, 0);
    }
}

#[test]
fn a_bar_that_passes_beside_a_post_is_free() {
    let folder = bar_and_post();
    folder.write("poses.csv", turning("3,3,0"));
    let run = folder.run(&AUDIT);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{run:?}");
    assert!(
        run.stdout
            .contains("\nfree of contact\nframes: 3 of 3 examined\n"),
        "{run:?}"
    );
    let report = json_of(&folder.run(&[&AUDIT[..], &["--json"]].concat()));
    assert_eq!(
        (&report["collision_free"], &report["contact"]),
        (&json!(true), &Value::Null)
    );
    // The corner of the bar comes within 0.15 of the edge of the post: |(2.9, 2.9)| - |(4, 0.1)| is 0.1.
    assert_eq!(
        folder
            .run(&[&AUDIT[..], &["--min-distance", "0.15"]].concat())
            .status,
        1
    );
    assert_eq!(
        folder
            .run(&[&AUDIT[..], &["--min-distance", "0.05"]].concat())
            .status,
        0
    );
}

#[test]
fn bodies_that_intersect_in_the_first_frame_are_named() {
    let folder = bar_and_post();
    folder.write("poses.csv", turning("2,0.05,0"));
    let run = folder.run(&AUDIT);
    assert_eq!(run.status, 1, "{run:?}");
    assert!(
        run.stdout.contains("\nintersection in frame 0 (poses.csv): "),
        "{run:?}"
    );
}

#[test]
fn errors_name_the_line_and_the_remedy() {
    let folder = bar_and_post();
    let bar = "0,bar,0,0,0,1,0,0,0\n";
    for (rows, error) in [
        (
            "time,body\n".to_owned(),
            "line 1: expected the header frame,body,x,y,z,qw,qx,qy,qz",
        ),
        (
            HEADER.to_owned(),
            "there is no pose: expected a row for each body in each frame",
        ),
        (
            format!("{HEADER}{bar}0,lid,0,0,0,1,0,0,0\n"),
            "line 3: there is no body lid; the files are of bar, post.v2: a body has the name of its file without the extension",
        ),
        (
            format!("{HEADER}{bar}1,bar,0,0,0,1,0,0,0\n"),
            "frame 0 has no pose of the body post.v2: add its row, also if it rests",
        ),
        (
            format!("{HEADER}{bar}{bar}"),
            "line 3: a second pose of the body bar in frame 0: leave one out",
        ),
        (
            format!("{HEADER}1,bar,0,0,0,1,0,0,0\n"),
            "line 2: frame 1, expected 0: number the frames 0, 1, 2, ... and sort the rows by them",
        ),
        (
            format!("{HEADER}0,bar,0,0,0,0,0,0,0\n"),
            "line 2: the quaternion is 0; a rotation is any other quaternion, of any length",
        ),
        (
            format!("{HEADER}0,bar,0,0,0,1,0,nan,0\n"),
            "line 2: component 2 of the quaternion is NaN, not a finite number",
        ),
        (
            format!("{HEADER}0,bar,0,0,up,1,0,0,0\n"),
            "line 2: z is \"up\", expected a number",
        ),
        (
            format!("{HEADER}0,bar,0,0,0,1,0,0\n"),
            "line 2: 8 fields, expected 9: frame,body,x,y,z,qw,qx,qy,qz",
        ),
    ] {
        folder.write("poses.csv", rows);
        let run = folder.run(&AUDIT);
        assert_eq!(
            (run.status, run.error()),
            (2, format!("poses.csv: {error}").as_str()),
            "{run:?}"
        );
    }
    folder.write("poses.csv", turning("3,3,0"));
    let run = folder.run(&[&AUDIT[..], &["bar.obj"]].concat());
    assert_eq!(
        run.error(),
        "bar.obj: bar.obj is a body of the name bar, too: rename one of the files"
    );
    for option in [
        &["--with", "bar.obj"][..],
        &["--all", "all.csv"],
        &["--as-given"],
        &["--view", "page.html"],
    ] {
        let run = folder.run(&[&AUDIT[..], option].concat());
        assert_eq!(run.status, 2);
        assert!(run.stderr.contains("cannot be used with"), "{run:?}");
    }
}
