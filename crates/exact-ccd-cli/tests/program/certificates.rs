//! Certificates that `exact-ccd step` and `exact-ccd audit` write, verified by the checker.

use std::fs;

use exact_ccd_check::check::Proved;
use exact_ccd_check::{Failure, Kind, check, ply};

use crate::folder::Folder;
use crate::meshes::{self, tip_above_square};
use crate::start_check::moving_rod_through_box;

/// The statements about these frames that the certificate in `proof` proves.
fn verify(folder: &Folder, frames: &[&str]) -> Result<Proved, Failure> {
    let certificate = fs::read(folder.path("proof")).unwrap();
    let frame = |name: &&str| ply::read(&fs::read(folder.path(name)).unwrap());
    check(&certificate, frames.iter().map(frame))
}

/// A folder with `0.ply`, `1.ply` and so on, the tip at these heights.
fn heights(heights: &[f64]) -> Folder {
    let folder = Folder::new();
    for (frame, &height) in heights.iter().enumerate() {
        folder.write(&format!("{frame}.ply"), meshes::ply(&tip_above_square(height)));
    }
    folder
}

#[test]
fn a_free_step_is_proved_free_to_its_end() {
    let folder = heights(&[2.0, 0.5]);
    let run = folder.run(&["step", "0.ply", "1.ply", "--certificate", "proof"]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    let proved = verify(&folder, &["0.ply", "1.ply"]).unwrap();
    let [step] = &proved.steps[..] else {
        panic!("one step has {} statements", proved.steps.len())
    };
    assert_eq!(
        (step.head.rest, step.head.free, step.contact),
        (true, Some(1.0), None)
    );
    // It proves nothing about another step.
    assert!(matches!(
        verify(&folder, &["1.ply", "0.ply", "1.ply"]),
        Err(Failure::Refused(_) | Failure::Unreadable(_))
    ));
    folder.write("1.ply", meshes::ply(&tip_above_square(-0.5)));
    assert!(matches!(
        verify(&folder, &["0.ply", "1.ply"]),
        Err(Failure::Refused(_))
    ));
}

#[test]
fn a_contact_is_proved_to_be_the_earliest() {
    // The tip is at the height 1 - 3 t.
    let folder = heights(&[1.0, -2.0]);
    let run = folder.run(&["step", "0.ply", "1.ply", "--certificate", "proof"]);
    assert_eq!((run.status, run.stderr.as_str()), (1, ""));
    let proved = verify(&folder, &["0.ply", "1.ply"]).unwrap();
    let step = proved.steps[0];
    let third = 1.0_f64 / 3.0;
    assert_eq!(
        (step.head.free, step.head.contact),
        (Some(third), Some(third.next_up()))
    );
    assert_eq!(step.contact, Some((Kind::VertexFace, [4, 1])));
}

#[test]
fn a_distance_is_part_of_the_statement() {
    let folder = heights(&[1.0, 0.0]);
    let run = folder.run(&[
        "step",
        "0.ply",
        "1.ply",
        "--min-distance",
        "0.25",
        "--certificate",
        "proof",
    ]);
    assert_eq!((run.status, run.stderr.as_str()), (1, ""));
    let proved = verify(&folder, &["0.ply", "1.ply"]).unwrap();
    let head = proved.steps[0].head;
    assert_eq!(
        (proved.distance, head.free, head.contact),
        (0.25, Some(0.75_f64.next_down()), Some(0.75))
    );
}

#[test]
fn an_audit_is_proved_up_to_its_first_contact() {
    let folder = heights(&[3.0, 1.0, -2.0, 5.0]);
    let frames = ["0.ply", "1.ply", "2.ply", "3.ply"];
    let run = folder.run(&[&["audit"], &frames[..], &["--certificate", "proof"]].concat());
    assert_eq!((run.status, run.stderr.as_str()), (1, ""));
    let proved = verify(&folder, &frames[..3]).unwrap();
    let statements: Vec<_> = proved
        .steps
        .iter()
        .map(|step| (step.head.rest, step.head.free, step.contact))
        .collect();
    assert_eq!(
        statements,
        [
            (true, Some(1.0), None),
            (false, Some(1.0 / 3.0), Some((Kind::VertexFace, [4, 1])))
        ]
    );
}

#[test]
fn without_a_proof_the_status_is_3_and_there_is_no_file() {
    let pierced = moving_rod_through_box();
    // The tip of this frame touches the square.
    let touching = heights(&[0.0, 1.0]);
    for (folder, arguments) in [
        (&pierced, &["step", "start.ply", "end.ply"][..]),
        (&pierced, &["audit", "start.ply", "end.ply"]),
        (&touching, &["audit", "0.ply", "1.ply"]),
        (&touching, &["audit", "1.ply"]),
    ] {
        let run = folder.run(&[arguments, &["--certificate", "proof"]].concat());
        assert_eq!(run.status, 3, "{arguments:?}");
        assert!(
            run.stderr.starts_with("exact-ccd: no certificate: "),
            "{}",
            run.stderr
        );
        assert!(!folder.path("proof").exists());
    }
    // Without the statement about the start, the step of the rod has a proof.
    let run = pierced.run(&[
        "step",
        "start.ply",
        "end.ply",
        "--no-start-check",
        "--certificate",
        "proof",
    ]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    let proved = verify(&pierced, &["start.ply", "end.ply"]).unwrap();
    assert_eq!(
        (proved.steps[0].head.rest, proved.steps[0].head.free),
        (false, Some(1.0))
    );
}

/// The checker reads uncompressed PLY files alone.
#[test]
fn frames_that_the_checker_does_not_read_have_no_certificate() {
    let folder = heights(&[2.0, 0.5]);
    fs::create_dir(folder.path("frames")).unwrap();
    for frame in ["frames/0.obj", "frames/1.obj"] {
        folder.write(frame, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    }
    fs::copy(folder.path("0.ply"), folder.path("0.ply.gz")).unwrap();
    for arguments in [&["audit", "frames"][..], &["step", "0.ply.gz", "1.ply"]] {
        let run = folder.run(&[arguments, &["--certificate", "proof"]].concat());
        assert!(run.error().contains("uncompressed PLY files"), "{run:?}");
        assert!(!folder.path("proof").exists());
    }
}
