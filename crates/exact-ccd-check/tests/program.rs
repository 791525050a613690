//! The program: its statements and its reasons, with a status each.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use std::path::PathBuf;
use std::process::Command;

/// A vertex that falls on a slope, which docs/certificates.md of the repository has byte by byte.
const CERTIFICATE: &[u8] = b"exact-ccd certificate 1\n\
    \0\0\0\0\0\0\0\0\x07\xff\xff\xff\xff\xff\xff\xe7\x3f\0\0\0\0\0\0\xe8\x3f\0\x01\x03\0\0\xff\0\x01\0\0\0\
    \0\x03\0\0\x04\x01\x08\x01\x06\x01\x01\x01\x01";

/// The slope with the vertex at this height, or far away.
fn frame(x: f64, z: f64) -> String {
    format!(
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n\
         element face 1\nproperty list uchar int vertex_indices\nend_header\n\
         0 0 0\n8 0 8\n0 8 0\n{x} 1 {z}\n3 0 1 2\n"
    )
}

/// Runs the program on a certificate and frames, in a folder of this name.
fn run(name: &str, certificate: &[u8], frames: &[String]) -> (i32, String) {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("proof"), certificate).unwrap();
    let names: Vec<String> = (0..frames.len()).map(|number| format!("{number}.ply")).collect();
    for (name, frame) in names.iter().zip(frames) {
        std::fs::write(folder.join(name), frame).unwrap();
    }
    program(Command::new(env!("CARGO_BIN_EXE_exact-ccd-check")).current_dir(folder).arg("proof").args(names))
}

fn program(command: &mut Command) -> (i32, String) {
    let output = command.output().unwrap();
    assert!(output.stderr.is_empty());
    (output.status.code().unwrap(), String::from_utf8(output.stdout).unwrap())
}

#[test]
fn proved_statements() {
    let (status, text) = run("proved", CERTIFICATE, &[frame(1.0, 4.0), frame(1.0, 0.0)]);
    assert_eq!(
        text,
        "proved, in integers:\n\
         step from frame 0 to frame 1 (pairs next to each other: 1):\n  \
         No edge pierces a face at t = 0.\n  \
         No two primitives that count are in contact at any time of [0, 0.7499999999999999].\n  \
         Then vertex 3 and face 0 are in contact, at a time after 0.7499999999999999 \
         and not after 0.75.\n"
    );
    assert_eq!(status, 0);
}

#[test]
fn reasons() {
    let frames = [frame(1.0, 4.0), frame(1.0, 0.0)];
    let [start, end] = frames.clone();
    let far = [frame(99.0, 4.0), frame(99.0, 0.0)];
    // The first line and the distance.
    let first = 32;
    // Free until T = 1, with the number of rows 0 of each kind; twice.
    let step = [&[2][..], &1.0_f64.to_le_bytes(), &[0; 4]].concat();
    let free = [&CERTIFICATE[..first], &step, &step].concat();
    let many = start.replace("vertex 4", "vertex 5");
    let few = start.replace("vertex 4", "vertex 3");
    let words = start.replace("8 0 8", "8 0 eight");
    let deceiving = start.replace("format ascii", "x\r\u{1b}[2Kproved, in integers:\u{1b}E");
    let infinite = start.replace("8 0 8", "8 0 inf");
    let other = start.replace("3 0 1 2", "3 0 2 1");
    let two = start.replace("3 0 1 2", "2 0 1");
    let order = "are these its meshes, in its order?";
    for (name, certificate, frames, status, reason) in [
        (
            "swapped",
            CERTIFICATE,
            &[end.clone(), start.clone()][..],
            1,
            "refused: step 0: vertex 3 and face 0 are not proved to be apart until t = 0.7499999999999999",
        ),
        (
            "after contact",
            CERTIFICATE,
            &[start.clone(), end.clone(), start.clone()],
            1,
            "refused: the certificate ends with the contact in step 0, before all frames: leave out those after frame 1",
        ),
        (
            "after the end",
            &free[..first + step.len()],
            &[far[0].clone(), far[1].clone(), far[0].clone()],
            1,
            "refused: the certificate ends with the end of step 0, before all frames: leave out those after frame 1",
        ),
        (
            "before the end",
            &free,
            &far,
            1,
            "refused: the certificate has more steps than these frames, or none",
        ),
        (
            "more",
            &free,
            &frames,
            1,
            &format!(
                "refused: step 0: more pairs of vertex and face need a proof than the 0 of the certificate: {order}"
            ),
        ),
        (
            "fewer",
            CERTIFICATE,
            &far,
            1,
            &format!(
                "refused: step 0: fewer pairs of vertex and face need a proof than the 1 of the certificate: {order}"
            ),
        ),
        ("cut", &CERTIFICATE[..50], &frames, 2, "unreadable: step 0: the file ends too early"),
        (
            "no certificate",
            b"ply",
            &frames,
            2,
            "unreadable: the first line of the certificate is not `exact-ccd certificate 1`",
        ),
        (
            "a word",
            CERTIFICATE,
            &[words, end.clone()],
            2,
            "unreadable: 0.ply: vertex 2 of 4: a number is expected, not `eight`",
        ),
        (
            "control characters",
            CERTIFICATE,
            &[deceiving, end.clone()],
            2,
            "unreadable: 0.ply: a line of a PLY header is not covered: x??[2Kproved, in integers:?E 1.0",
        ),
        (
            "an infinite coordinate",
            CERTIFICATE,
            &[infinite, end.clone()],
            2,
            "unreadable: step 0: a coordinate, or the distance, is infinite or not a number",
        ),
        (
            "another mesh",
            CERTIFICATE,
            &[start.clone(), other],
            1,
            "refused: frames 0 and 1 are not of one mesh",
        ),
        (
            "two corners",
            CERTIFICATE,
            &[start.clone(), two],
            2,
            "unreadable: 1.ply: face 1 of 1: a face has fewer than three corners, or its lowest vertex twice",
        ),
        (
            "many",
            CERTIFICATE,
            &[many, end.clone()],
            2,
            "unreadable: 0.ply: face 1 of 1: a number is expected, not ``",
        ),
        (
            "few",
            CERTIFICATE,
            &[few, end.clone()],
            2,
            "unreadable: 0.ply: face 1 of 1: a face has fewer than three corners, or its lowest vertex twice",
        ),
        (
            "one frame",
            CERTIFICATE,
            &frames[..1],
            2,
            "usage: exact-ccd-check CERTIFICATE START END, or more frames",
        ),
    ] {
        assert_eq!(run(name, certificate, frames), (status, format!("{reason}\n")), "{name}");
    }
}

/// A vertex and a loose edge that an edge connects are not apart by a distance, and the sentence says so.
#[test]
fn connected_rods_within_a_distance() {
    let frame = "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n\
        element edge 3\nproperty int vertex1\nproperty int vertex2\nend_header\n\
        0 0 0\n1 0 0\n0 1 0\n0 1\n1 2\n0 2\n";
    // No rows of the first two kinds, then a row for each vertex and the opposite edge.
    let tables = b"\0\0\x03\0\x02\0\xff\xff\0\x01\x01\0\x01\0\0\x01\0\0\0\x01\0\0";
    let until = 1.0_f64.to_le_bytes();
    let certificate = [&CERTIFICATE[..24], &10.0_f64.to_le_bytes(), &[2], &until, tables].concat();
    let (status, text) = run("connected rods", &certificate, &[frame.to_owned(), frame.to_owned()]);
    assert_eq!(
        text,
        "proved, in integers:\n\
         step from frame 0 to frame 1 (pairs next to each other: 3):\n  \
         No two primitives that count are within 10.0 of each other (a vertex and an edge that an edge connects: \
         in contact) at any time of [0, 1.0].\n"
    );
    assert_eq!(status, 0);
}

#[test]
fn usage() {
    for (arguments, expected) in [(&["--help"][..], 0), (&["-h"], 0), (&[], 2), (&["--version"], 2)] {
        let (status, text) = program(Command::new(env!("CARGO_BIN_EXE_exact-ccd-check")).args(arguments));
        assert_eq!(text, "usage: exact-ccd-check CERTIFICATE START END, or more frames\n");
        assert_eq!(status, expected, "{arguments:?}");
    }
}
